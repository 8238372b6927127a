#include "wet/WaterAround.h"

#include <gtest/gtest.h>

#include "core/Random.h"
#include "tests/wet/FlatSkin.h"

namespace fur::wet {
namespace {

constexpr int kSkinSize = 96;

std::vector<std::uint8_t> allSkin() { return std::vector<std::uint8_t>(kSkinSize * kSkinSize, 1); }

// Water by texel, up to 1 in the fur, the rest as a film.
template <class WaterAt>
WetnessMask wetMask(WaterAt waterAt) {
  WetnessMask mask(kSkinSize);
  std::vector<Vec4> texels;
  std::vector<float> film;
  for (int i = 0; i < kSkinSize * kSkinSize; ++i) {
    const float water = waterAt(i % kSkinSize, i / kSkinSize);
    texels.push_back(water > 0 ? Vec4(mask.texelCentre(static_cast<std::size_t>(i)), 0.05f, std::min(water, 1.0f)) : Vec4(0));
    film.push_back(std::max(water - 1, 0.0f));
  }
  mask.restore(std::move(texels), std::move(film));
  return mask;
}

std::size_t texel(int x, int y) { return static_cast<std::size_t>(y * kSkinSize + x); }

TEST(WaterAround, IsTheWaterItselfWhereThatIsTheSameAllRound) {
  WaterAround around = test::flatSkin(kSkinSize, allSkin()).around();
  around.update(wetMask([](int, int) { return 1.5f; }), {});
  for (std::size_t i = 0; i < kSkinSize * kSkinSize; ++i) {
    const WaterAround::Means means = around.at(i);
    for (const float held : {means.held, means.wide, means.widest}) EXPECT_NEAR(held, 1, 1 / 1024.0f);
    EXPECT_NEAR(means.film, 0.5f, 1 / 1024.0f);
  }
}

TEST(WaterAround, SpreadsTheWiderTheMean) {
  WaterAround around = test::flatSkin(kSkinSize, allSkin()).around();
  around.update(wetMask([](int x, int) { return x < kSkinSize / 2 ? 1.0f : 0.0f; }), {});
  // Where a mean over a normal distribution is 0.16, one standard deviation beyond the border. In texels: model units by kWidth.
  const auto reach = [&](float WaterAround::Means::*mean) {
    int x = kSkinSize / 2;
    while (x < kSkinSize && around.at(texel(x, kSkinSize / 2)).*mean > 0.16f) ++x;
    return static_cast<float>(x - kSkinSize / 2) * test::FlatSkin::kWidth;
  };
  // To a texel and a half, 0.017.
  EXPECT_NEAR(reach(&WaterAround::Means::held), 0.026f, 0.017f);
  EXPECT_NEAR(reach(&WaterAround::Means::wide), 0.06f, 0.017f);
  EXPECT_NEAR(reach(&WaterAround::Means::widest), 0.09f, 0.017f);
}

// The right half of the skin lies in the atlas somewhere else: as a chart of its own.
TEST(WaterAround, KnowsNoBorderBetweenCharts) {
  const auto waterAt = [](int x, int y) { return (x / 9 + y / 7) % 3 ? 0.0f : 0.8f; };
  test::FlatSkin whole = test::flatSkin(kSkinSize, allSkin()), cut = whole;
  const auto moved = [](int x, int y) { return x < kSkinSize / 2 ? texel(x, y) : texel(kSkinSize + kSkinSize / 2 - 1 - x, kSkinSize - 1 - y); };  // half a turn
  for (int y = 0; y < kSkinSize; ++y)
    for (int x = 0; x < kSkinSize; ++x) {
      const Vec3 place = whole.places[texel(x, y)].position;
      cut.places[moved(x, y)].position = place;
    }
  WaterAround one = whole.around(), two = cut.around();
  one.update(wetMask(waterAt), {});
  two.update(wetMask([&](int x, int y) { return x < kSkinSize / 2 ? waterAt(x, y) : waterAt(kSkinSize + kSkinSize / 2 - 1 - x, kSkinSize - 1 - y); }), {});
  for (int y = 0; y < kSkinSize; ++y)
    for (int x = 0; x < kSkinSize; ++x) {
      const WaterAround::Means a = one.at(texel(x, y)), b = two.at(moved(x, y));
      // Shares are whole numbers of 255ths, and means of steps of a 1024th.
      EXPECT_NEAR(a.held, b.held, 0.005f) << x << ", " << y;
      EXPECT_NEAR(a.wide, b.wide, 0.005f) << x << ", " << y;
    }
}

TEST(WaterAround, KnowsNothingOfTheOtherSideOfAnEar) {
  test::FlatSkin skin = test::flatSkin(kSkinSize, allSkin());
  for (int y = 0; y < kSkinSize; ++y)
    for (int x = kSkinSize / 2; x < kSkinSize; ++x) {
      auto& place = skin.places[texel(x, y)];
      place.position = skin.places[texel(x - kSkinSize / 2, y)].position - Vec3(0, 0, 0.01f);
      place.normal = Vec3(0, 0, -1);
    }
  WaterAround around = skin.around();
  around.update(wetMask([](int x, int) { return x < kSkinSize / 2 ? 1.0f : 0.0f; }), {});
  for (int x = 0; x < kSkinSize; ++x) {
    EXPECT_NEAR(around.at(texel(x, 50)).held, x < kSkinSize / 2 ? 1 : 0, 1 / 1024.0f) << x;
    EXPECT_NEAR(around.at(texel(x, 50)).widest, x < kSkinSize / 2 ? 1 : 0, 1 / 1024.0f) << x;
  }
}

TEST(WaterAround, IsANumberWhereMoreCellsLieThanCanBeNamedAndWithoutNormals) {
  test::FlatSkin crowded = test::flatSkin(kSkinSize, allSkin()), blank = crowded;
  // One cell, and all others at one point: near enough to be named, too far to count where the one lies.
  for (int i = 0; i < kSkinSize * kSkinSize; ++i)
    crowded.places[static_cast<std::size_t>(i)].position = i % kSkinSize < 4 && i / kSkinSize < 4 ? Vec3(0) : Vec3(1.8f * WaterAround::kCell, 0, 0);
  for (auto& place : blank.places) place.normal = Vec3(0);
  for (const test::FlatSkin* skin : {&crowded, &blank}) {
    WaterAround around = skin->around();
    around.update(wetMask([](int, int) { return 0.8f; }), {});
    for (std::size_t i = 0; i < kSkinSize * kSkinSize; ++i) {
      EXPECT_NEAR(around.at(i).held, 0.8f, 1 / 1024.0f) << i;
      EXPECT_NEAR(around.at(i).widest, 0.8f, 1 / 256.0f) << i;
    }
  }
}

TEST(WaterAround, TellsWhatAChangeAltersAndIsTheSameAsOfTheWhole) {
  const test::FlatSkin skin = test::flatSkin(kSkinSize, allSkin());
  WetnessMask mask(kSkinSize);
  WaterAround followed = skin.around();
  followed.update(mask, {});
  (void)followed.takeChanged();
  Random random(5);
  for (int round = 0; round < 10; ++round) {
    std::vector<WaterAround::Means> before;
    for (std::size_t i = 0; i < kSkinSize * kSkinSize; ++i) before.push_back(followed.at(i));
    const TexelRect changed = mask.addDroplet({Vec2(random.uniform(), random.uniform()), random.uniform(0.01f, 0.05f), random.uniform(0.1f, 1.0f)});
    followed.update(mask, {&changed, 1});
    WaterAround whole = skin.around();
    whole.update(mask, {});
    const std::vector<TexelRect> parts = followed.takeChanged();
    for (int i = 0; i < kSkinSize * kSkinSize; ++i) {
      const WaterAround::Means now = followed.at(static_cast<std::size_t>(i)), all = whole.at(static_cast<std::size_t>(i));
      ASSERT_EQ(now.held, all.held);
      ASSERT_EQ(now.wide, all.wide);
      ASSERT_EQ(now.widest, all.widest);
      const bool told = std::any_of(parts.begin(), parts.end(), [&](const TexelRect& part) { return part.meets({i % kSkinSize, i / kSkinSize, i % kSkinSize + 1, i / kSkinSize + 1}); });
      if (!told) ASSERT_EQ(now.widest, before[static_cast<std::size_t>(i)].widest) << i;
    }
  }
  EXPECT_TRUE(followed.takeChanged().empty());
}

}  // namespace
}  // namespace fur::wet
