#include "wet/MaskEncoding.h"

#include <gtest/gtest.h>

#include "core/Random.h"
#include "geometry/Adjacency.h"
#include "wet/Clump.h"
#include "wet/SurfaceWetting.h"

namespace fur::wet {
namespace {

constexpr int kMaskSize = 96;
constexpr TexelRect kWhole{0, 0, kMaskSize, kMaskSize};

// A mask whose texels are all of one chart, unless a test says otherwise.
struct Atlas {
  WetnessMask mask{kMaskSize};
  std::vector<std::uint16_t> charts = std::vector<std::uint16_t>(kMaskSize * kMaskSize, 0);
  std::vector<std::uint32_t> triangles = std::vector<std::uint32_t>(kMaskSize * kMaskSize, 0);

  // Clumps of that radius, whose water is `waterAt` the texel: up to 1 in the fur, the rest as a film.
  template <class WaterAt>
  void wet(float radius, WaterAt waterAt) {
    std::vector<Vec4> texels(kMaskSize * kMaskSize, Vec4(0));
    std::vector<float> film(kMaskSize * kMaskSize, 0.0f);
    for (int i = 0; i < kMaskSize * kMaskSize; ++i) {
      const float water = waterAt(i % kMaskSize, i / kMaskSize);
      if (water <= 0) continue;
      texels[i] = Vec4(mask.texelCentre(i), radius, std::min(water, 1.0f));
      film[i] = std::max(water - 1, 0.0f);
    }
    mask.restore(std::move(texels), std::move(film));
  }
  MaskTexels encoded(const TexelRect& changed = kWhole) const { return encodeMask(mask, changed, {charts, triangles}); }
  float waterAt(const MaskTexels& encoded, int x, int y) const {
    return encoded.texels[static_cast<std::size_t>((y - encoded.rect.y0) * (encoded.rect.x1 - encoded.rect.x0) + x - encoded.rect.x0)].w;
  }
};

void rainOn(WetnessMask& mask, Random& random, int drops, Vec2 from = Vec2(-0.1f), Vec2 to = Vec2(1.1f)) {
  for (int i = 0; i < drops; ++i)
    mask.addDroplet({Vec2(random.uniform(from.x, to.x), random.uniform(from.y, to.y)), random.uniform(0.02f, 0.15f), random.uniform(0.1f, 1.0f)});
}

TEST(MaskEncoding, KeepsEveryClumpAndTellsItsChart) {
  Atlas atlas;
  Random random(3);
  rainOn(atlas.mask, random, 60);  // some centres lie beside the atlas
  for (int i = 0; i < kMaskSize * kMaskSize; ++i) atlas.charts[i] = static_cast<std::uint16_t>(i % kMaskSize / 8 * 12 + i / kMaskSize / 8);  // 144 charts
  const MaskTexels encoded = atlas.encoded();
  ASSERT_EQ(encoded.texels.size(), atlas.charts.size());
  for (int i = 0; i < kMaskSize * kMaskSize; ++i) {
    const Vec4 &from = atlas.mask.texels()[i], &to = encoded.texels[i];
    const float chart = std::floor(to.x / static_cast<float>(FUR_CHART_STEP));
    EXPECT_EQ(chart, atlas.charts[i] % FUR_CHART_NUMBERS);
    // The last bit of a float near FUR_CHART_STEP * FUR_CHART_NUMBERS = 256.
    EXPECT_NEAR(to.x - static_cast<float>(FUR_CHART_STEP) * (chart + 0.5f), from.x, 1 / 32768.0f);
    EXPECT_EQ(Vec2(to.y, to.z), Vec2(from.y, from.z));
    EXPECT_EQ(to.w > 0, from.w > 0) << "dry stays dry, wet stays wet";
  }
}

TEST(MaskEncoding, LeavesEvenlyWetFurAsItIs) {
  Atlas atlas;
  for (const float water : {0.1f, 0.6f, 0.85f, 0.9f, 1.0f, 1.5f}) {
    atlas.wet(0.05f, [&](int, int) { return water; });
    const MaskTexels encoded = atlas.encoded();
    // A film is counted in 255ths.
    for (const Vec4& texel : encoded.texels) EXPECT_NEAR(texel.w, water, water > 1 ? 1 / 255.0f : 1e-6f);
  }
}

TEST(MaskEncoding, RunsClumpsDryTowardsDryFurOverAPartOfThem) {
  Atlas atlas;
  constexpr int kBorder = 40, kReach = 6;  // 0.6 of a radius of 10 texels
  atlas.wet(10.5f / kMaskSize, [](int x, int) { return x < kBorder ? 0.7f : 0.0f; });
  const MaskTexels encoded = atlas.encoded();
  const int y = kMaskSize / 2;
  for (int x = 1; x < kBorder; ++x) EXPECT_LE(atlas.waterAt(encoded, x, y), atlas.waterAt(encoded, x - 1, y) + 1e-6f) << x;
  // Of the 13 columns round the last wet one 7 are wet: it is inside by 2.4 * 7/13 - 1.1 = 0.19.
  EXPECT_LT(atlas.waterAt(encoded, kBorder - 1, y), 0.36f * 0.7f);
  EXPECT_GT(atlas.waterAt(encoded, kBorder - 1, y), 0);
  EXPECT_LT(atlas.waterAt(encoded, kBorder - kReach / 2, y), 0.9f * 0.7f);
  EXPECT_NEAR(atlas.waterAt(encoded, kBorder - kReach - 1, y), 0.7f, 1e-6f);
  EXPECT_EQ(atlas.waterAt(encoded, kBorder, y), 0);
}

TEST(MaskEncoding, MakesNoSheetOfAStreak) {
  for (const int width : {4, 8, 12, 40}) {
    Atlas atlas;
    atlas.wet(0.05f, [&](int x, int) { return std::abs(2 * x + 1 - kMaskSize) < width ? 1.5f : 0.0f; });
    const MaskTexels encoded = atlas.encoded();
    float most = 0;
    for (const Vec4& texel : encoded.texels) most = std::max(most, texel.w);
    if (width <= 12) {
      EXPECT_LE(most, kSheetFrom) << width;
      EXPECT_EQ(sheetOf(most), 0) << width;
    } else {
      EXPECT_NEAR(most, 1.5f, 0.01f) << "a wide one has its film in the middle";
    }
  }
}

TEST(MaskEncoding, PartsASheetIntoClumpsTowardsDryFur) {
  Atlas atlas;
  atlas.wet(0.05f, [](int x, int) { return x < kMaskSize / 2 ? 1.4f : 0.0f; });
  const MaskTexels encoded = atlas.encoded();
  for (int x = 1; x < kMaskSize / 2; ++x) EXPECT_LE(atlas.waterAt(encoded, x, 50), atlas.waterAt(encoded, x - 1, 50) + 1e-6f) << x;
  EXPECT_NEAR(atlas.waterAt(encoded, 30, 50), 1.4f, 0.01f);
  EXPECT_LE(atlas.waterAt(encoded, kMaskSize / 2 - 1, 50), kSheetFrom);
}

TEST(MaskEncoding, ClosesARowThatTheFlowHasMissed) {
  Atlas atlas;
  atlas.wet(0.05f, [](int, int y) { return y == 50 ? 0.3f : 1.0f; });
  EXPECT_GT(atlas.waterAt(atlas.encoded(), 50, 50), 0.9f);
  // As wet as those round it, and not wetter.
  EXPECT_LE(atlas.waterAt(atlas.encoded(), 50, 50), 1.0f);
}

TEST(MaskEncoding, TellsTexelsBesideChartsOfTheWaterNextToThem) {
  Atlas atlas;
  constexpr int kEnd = 30;
  atlas.wet(0.05f, [](int x, int) { return x < kEnd ? 0.6f : 0.0f; });
  for (int i = 0; i < kMaskSize * kMaskSize; ++i)
    if (i % kMaskSize >= kEnd) atlas.charts[i] = SurfaceWetting::kNoChart, atlas.triangles[i] = geometry::kNoTriangle;
  const MaskTexels encoded = atlas.encoded();
  for (int x = kEnd; x < kEnd + 3; ++x) EXPECT_NEAR(atlas.waterAt(encoded, x, 50), -1.6f, 1 / 255.0f) << x;
  for (int x = kEnd + 3; x < kMaskSize; ++x) EXPECT_EQ(atlas.waterAt(encoded, x, 50), -1) << x;
  // There is no dry fur beyond the border: up to there it is as wet as inside.
  for (int x = 0; x < kEnd; ++x) EXPECT_NEAR(atlas.waterAt(encoded, x, 50), 0.6f, 1e-6f) << x;
}

TEST(MaskEncoding, IsNotSoftenedByGutters) {
  Atlas bare, repeated;
  for (Atlas* atlas : {&bare, &repeated}) {
    atlas->wet(0.1f, [&](int x, int) { return x < 30 || (x < 32 && atlas == &repeated) ? 0.6f : 0.0f; });
    for (int i = 0; i < kMaskSize * kMaskSize; ++i)
      if (i % kMaskSize >= 30) atlas->triangles[i] = geometry::kNoTriangle;
  }
  for (int x = 0; x < 30; ++x) EXPECT_EQ(bare.waterAt(bare.encoded(), x, 50), repeated.waterAt(repeated.encoded(), x, 50)) << x;
}

TEST(MaskEncoding, HoldsAllThatAChangeAltersAndIsTheSameAsOfTheWhole) {
  Atlas atlas;
  Random random(5);
  rainOn(atlas.mask, random, 30);
  for (int round = 0; round < 20; ++round) {
    const MaskTexels before = atlas.encoded();
    const TexelRect changed = atlas.mask.addDroplet({Vec2(random.uniform(), random.uniform()), random.uniform(0.01f, 0.1f), random.uniform(0.1f, 1.0f)});
    const MaskTexels after = atlas.encoded(), part = atlas.encoded(changed);
    int at = 0;
    for (int y = 0; y < kMaskSize; ++y)
      for (int x = 0; x < kMaskSize; ++x) {
        const auto i = static_cast<std::size_t>(y * kMaskSize + x);
        const bool in = x >= part.rect.x0 && x < part.rect.x1 && y >= part.rect.y0 && y < part.rect.y1;
        ASSERT_EQ(after.texels[i], in ? part.texels[static_cast<std::size_t>(at++)] : before.texels[i]) << x << ", " << y;
      }
  }
}

TEST(MaskEncoding, OfNoChangeIsNothing) {
  const Atlas atlas;
  EXPECT_TRUE(atlas.encoded({}).rect.empty());
  EXPECT_TRUE(atlas.encoded({}).texels.empty());
}

}  // namespace
}  // namespace fur::wet
