// What the march is told of the fur near a point.
#include "groom/TypesNear.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "groom/GroomBrush.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

struct NearSetting : Setting {
  explicit NearSetting(int size = 64) : Setting(size) {}
  auto levels() const { return typesNear(groom.map, atlas); }
};

TEST(TypesNear, OfAPlainGroomKnowOneTypeEverywhere) {
  for (const auto& level : NearSetting().levels())
    for (const std::uint8_t cell : level) EXPECT_TRUE(cell == 1 || cell == 255) << int{cell};
}

TEST(TypesNear, HaveHalfTheCellsALevelDownToOneThatKnowsAll) {
  NearSetting one;
  paintType(one.groom, one.groomSurface(), {{1, 0, 0}, {1, 0, 0}, 0.3f, 1}, 3);
  const auto levels = one.levels();
  std::size_t side = static_cast<std::size_t>(nearCells(64));
  EXPECT_EQ(side, 32u);
  for (const auto& level : levels) {
    EXPECT_EQ(level.size(), side * side);
    side /= 2;
  }
  EXPECT_EQ(levels.back().at(0), 1 | 4);
}

// The promise that the shader relies on.
TEST(TypesNear, NeverMissAnythingWithinACellsSide) {
  NearSetting one;
  paintType(one.groom, one.groomSurface(), {{1, 0, 0}, {1, 0, 0}, 0.2f, 0.7f}, 2);
  paintType(one.groom, one.groomSurface(), {{0, 0, 1}, {0, 0, 1}, 0.1f, 1}, 4);
  setLength(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.2f, 1}, 0.5f);
  const int size = one.groom.map.size();
  int texelsAside = 1;
  for (const auto& level : one.levels()) {
    texelsAside *= 2;
    const int side = size / texelsAside;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const std::uint8_t cell = level[static_cast<std::size_t>(y / texelsAside * side + x / texelsAside)];
        std::uint8_t types = 0, shortest = 255, longest = 0;
        for (int v = std::max(y - texelsAside, 0); v <= std::min(y + texelsAside, size - 1); ++v)
          for (int u = std::max(x - texelsAside, 0); u <= std::min(x + texelsAside, size - 1); ++u) {
            const auto texel = static_cast<std::size_t>(v * size + u);
            if (one.atlas.triangleOf()[texel] == geometry::kNoTriangle) continue;
            const GroomMap::Texel& t = one.groom.map.texels()[texel];
            types |= static_cast<std::uint8_t>((t[1] + t[2] + t[3] < 255) | (t[1] > 0) << 1 | (t[2] > 0) << 2 | (t[3] > 0) << 3);
            shortest = std::min(shortest, t[0]), longest = std::max(longest, t[0]);
          }
        ASSERT_EQ(types & ~cell, 0) << x << ' ' << y << " level of " << side;
        ASSERT_TRUE(shortest >= longest || (cell & kLengthsDiffer)) << x << ' ' << y << " level of " << side;
      }
  }
}

TEST(TypesNear, CountNothingBesideTheCharts) {
  NearSetting one;
  for (std::uint32_t texel = 0; texel < one.groom.map.texels().size(); ++texel)
    if (one.atlas.triangleOf()[texel] != geometry::kNoTriangle) one.groom.map.set(texel, {255, 255, 0, 0});
  for (const auto& level : one.levels())
    for (const std::uint8_t cell : level) EXPECT_TRUE(cell == 2 || cell == 255) << int{cell};
}

TEST(TypesNear, OfMapsOfAnySizeCoverAllOfThem) {
  for (const int size : {16, 100, 257}) {
    NearSetting one(size);
    one.groom.map.set(static_cast<std::uint32_t>(std::find_if(one.atlas.triangleOf().begin(), one.atlas.triangleOf().end(), [](auto t) { return t != geometry::kNoTriangle; }) -
                                                 one.atlas.triangleOf().begin()), {100, 0, 0, 255});
    EXPECT_EQ(one.levels().back().at(0), 1 | 8 | kLengthsDiffer) << size;
  }
}

}  // namespace
}  // namespace fur::groom
