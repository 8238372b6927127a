#include "wet/MaskEncoding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/Random.h"
#include "geometry/Primitives.h"
#include "tests/wet/FlatSkin.h"
#include "wet/Clump.h"
#include "wet/SurfaceWetting.h"

namespace fur::wet {
namespace {

constexpr int kMaskSize = 96;
constexpr TexelRect kWhole{0, 0, kMaskSize, kMaskSize};

// A mask on flat skin whose texels are all of one chart, unless a test says otherwise.
struct Atlas {
  WetnessMask mask{kMaskSize};
  std::vector<std::uint16_t> charts = std::vector<std::uint16_t>(kMaskSize * kMaskSize, 0);
  std::vector<std::uint8_t> skin = std::vector<std::uint8_t>(kMaskSize * kMaskSize, 1);  // whether some lies under the texel

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
  MaskTexels encoded() const {
    WaterAround around = test::flatSkin(kMaskSize, skin).around();
    around.update(mask, {});
    return encodeMask(mask, kWhole, charts, &around);
  }
  static float waterAt(const MaskTexels& encoded, int x, int y) { return encoded.texels[static_cast<std::size_t>(y * kMaskSize + x)].w; }
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
    EXPECT_EQ(to.y, from.y);
    // The last bit of a float below FUR_LYING_STEP * (FUR_LYING_STEPS + 1) = 1024.
    EXPECT_NEAR(to.z - static_cast<float>(FUR_LYING_STEP) * std::floor(to.z / static_cast<float>(FUR_LYING_STEP)), from.z, 1 / 16384.0f);
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

TEST(MaskEncoding, RunsClumpsDryTowardsDryFur) {
  Atlas atlas;
  constexpr int kBorder = 40;
  atlas.wet(4.5f / kMaskSize, [](int x, int) { return x < kBorder ? 0.7f : 0.0f; });
  const MaskTexels encoded = atlas.encoded();
  const int y = kMaskSize / 2;
  for (int x = 1; x < kBorder; ++x) EXPECT_LE(atlas.waterAt(encoded, x, y), atlas.waterAt(encoded, x - 1, y) + 1e-6f) << x;
  // A third of what lies round it is dry, as the border runs between cells: it is inside by 2.4 * 2/3 - 1.1 = 0.5.
  EXPECT_LT(atlas.waterAt(encoded, kBorder - 1, y), 0.76f * 0.7f);
  EXPECT_GT(atlas.waterAt(encoded, kBorder - 1, y), 0);
  EXPECT_LT(atlas.waterAt(encoded, kBorder - 2, y), 0.97f * 0.7f);
  EXPECT_NEAR(atlas.waterAt(encoded, kBorder - 9, y), 0.7f, 1e-6f);
  EXPECT_EQ(atlas.waterAt(encoded, kBorder, y), 0);
}

TEST(MaskEncoding, LetsFurLieByTheWaterOfAWiderPlace) {
  Atlas atlas;
  atlas.wet(0.05f, [](int x, int) { return x / 6 % 2 ? 0.9f : 0.0f; });
  const MaskTexels encoded = atlas.encoded();
  const auto lyingAt = [&](int x) {
    return std::floor(encoded.texels[static_cast<std::size_t>(50 * kMaskSize + x)].z / static_cast<float>(FUR_LYING_STEP)) / static_cast<float>(FUR_LYING_STEPS);
  };
  // Strips of half a strand's length, dry and wet in turns: tips would stand over one another.
  for (int x = 16; x < kMaskSize - 16; ++x) EXPECT_NEAR(lyingAt(x), 0.45f, 0.06f) << x;
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
  // It is a fifth of what is near.
  EXPECT_GT(atlas.waterAt(atlas.encoded(), 50, 50), 0.3f + 0.8f * 0.7f);
  // As wet as those round it, and not wetter.
  EXPECT_LE(atlas.waterAt(atlas.encoded(), 50, 50), 1.0f);
}

TEST(MaskEncoding, TellsTexelsBesideChartsOfTheWaterNextToThem) {
  Atlas atlas;
  constexpr int kEnd = 30;
  atlas.wet(0.05f, [](int x, int) { return x < kEnd ? 0.6f : 0.0f; });
  for (int i = 0; i < kMaskSize * kMaskSize; ++i)
    if (i % kMaskSize >= kEnd) atlas.charts[i] = SurfaceWetting::kNoChart, atlas.skin[i] = 0;
  const MaskTexels encoded = atlas.encoded();
  for (int x = kEnd; x < kEnd + 3; ++x) EXPECT_NEAR(atlas.waterAt(encoded, x, 50), -1.6f, 1 / 1024.0f) << x;
  for (int x = kEnd + 3; x < kMaskSize; ++x) EXPECT_EQ(atlas.waterAt(encoded, x, 50), -1) << x;
  // There is no dry fur beyond the border: up to there it is as wet as inside.
  for (int x = 0; x < kEnd; ++x) EXPECT_NEAR(atlas.waterAt(encoded, x, 50), 0.6f, 1e-6f) << x;
}

TEST(MaskEncoding, WithoutMeansKeepsTheWaterOfAlgorithm1) {
  Atlas atlas;
  Random random(5);
  rainOn(atlas.mask, random, 30);
  const MaskTexels encoded = encodeMask(atlas.mask, kWhole, atlas.charts, nullptr);
  for (int i = 0; i < kMaskSize * kMaskSize; ++i) EXPECT_EQ(encoded.texels[i].w, atlas.mask.texels()[i].w) << i;
}

// A gutter repeats the clump of a texel inside: where that did not reach no strand stood, and each chart's border had dark gaps.
TEST(MaskEncoding, AClumpReachesToEachTexelThatHasIt) {
  Atlas atlas;
  constexpr float kRadius = 0.02f;
  atlas.wet(kRadius, [](int, int) { return 0.5f; });
  std::vector<Vec4> texels = atlas.mask.texels();
  const std::size_t far = 10 * kMaskSize + 20, near = far + 5;
  texels[far].x -= 3 * kRadius;
  texels[near].y += 0.5f * kRadius;
  atlas.mask.restore(std::move(texels));
  const MaskTexels encoded = encodeMask(atlas.mask, kWhole, atlas.charts, nullptr);
  const auto way = [&](std::size_t i) { return Vec2(encoded.texels[i]) - Vec2(0.5f * FUR_CHART_STEP, 0) - atlas.mask.texelCentre(i); };
  EXPECT_NEAR(way(far).x, -kRadius, 1e-5f) << "nearer, the same way";
  EXPECT_NEAR(way(far).y, 0, 1e-5f);
  EXPECT_NEAR(way(near).y, 0.5f * kRadius, 1e-5f);
}

TEST(MaskEncoding, TellsGuttersTheBordersBeyondThem) {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  const geometry::Surface surface = geometry::buildSurface(mesh).value();
  const SurfaceWetting wetting(surface, kMaskSize);
  const ChartBorders borders(surface, wetting);
  WetnessMask mask(kMaskSize);
  Random random(3);
  rainOn(mask, random, 30);
  const TexelRect part{8, 16, 56, 40};
  const MaskTexels plain = encodeMask(mask, part, wetting.chartOfTexel(), nullptr), told = encodeMask(mask, part, wetting.chartOfTexel(), nullptr, &borders);
  std::map<std::uint32_t, std::uint32_t> numbers(borders.gutter().begin(), borders.gutter().end());
  int gutters = 0;
  for (int i = 0; i < 48 * 24; ++i) {
    const auto number = static_cast<float>(numbers[static_cast<std::uint32_t>((16 + i / 48) * kMaskSize + 8 + i % 48)]);
    gutters += number > 0;
    EXPECT_EQ(std::floor(told.texels[i].y / static_cast<float>(FUR_BORDER_STEP) + 0.25f), number) << i;
    EXPECT_NEAR(told.texels[i].y - static_cast<float>(FUR_BORDER_STEP) * number, plain.texels[i].y, 1e-3f) << i;
    EXPECT_EQ(Vec3(told.texels[i].x, told.texels[i].z, told.texels[i].w), Vec3(plain.texels[i].x, plain.texels[i].z, plain.texels[i].w)) << i;
  }
  EXPECT_GT(gutters, 20);
}

TEST(MaskEncoding, OfNoChangeIsNothing) {
  const Atlas atlas;
  const MaskTexels encoded = encodeMask(atlas.mask, {}, atlas.charts, nullptr);
  EXPECT_TRUE(encoded.rect.empty());
  EXPECT_TRUE(encoded.texels.empty());
}

}  // namespace
}  // namespace fur::wet
