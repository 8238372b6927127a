// How far rays may march without asking the groom's map.
#include "groom/EvenReach.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "groom/GroomBrush.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

bool onChart(const Setting& one, std::size_t texel) { return one.atlas.triangleOf()[texel] != geometry::kNoTriangle; }

TEST(EvenReach, OfAPlainGroomIsTheMostEverywhere) {
  const Setting one(64);
  for (const EvenTexel& texel : evenReach(one.groom.map, one.surface, one.atlas)) { EXPECT_EQ(texel[0], 4 * kMostReach); EXPECT_EQ(texel[1], 255); }
}

// The promise that the shader relies on.
TEST(EvenReach, AllTexelsOfChartsWithinItAreEqual) {
  Setting one(96);
  paintType(one.groom, one.groomSurface(), {{1, 0, 0}, {1, 0, 0}, 0.4f, 1}, 2);
  paintType(one.groom, one.groomSurface(), {{0, 0, 1}, {0, 0, 1}, 0.2f, 1}, 4);
  setLength(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.4f, 1, Falloff::Flat}, 0.5f);
  const std::vector<EvenTexel> reach = evenReach(one.groom.map, one.surface, one.atlas);
  const int size = one.groom.map.size();
  int longest = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto at = static_cast<std::size_t>(y * size + x);
      const int steps = reach[at][0] >> 2;
      if (!onChart(one, at) || steps == 0) continue;
      const GroomMap::Texel& here = one.groom.map.texels()[at];
      const int type = reach[at][0] & 3;
      ASSERT_EQ(type == 0 ? 255 - here[1] - here[2] - here[3] : here[static_cast<std::size_t>(type)], 255) << x << ' ' << y;
      ASSERT_EQ(reach[at][1], here[0]);
      longest = std::max(longest, steps);
      // Paths within it that stay on the chart: here all of what touches.
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size - 1); ++u) {
          const auto beside = static_cast<std::size_t>(v * size + u);
          if (!onChart(one, beside) || reach[beside][2] != reach[at][2]) continue;
          ASSERT_EQ(one.groom.map.texels()[beside], here) << x << ' ' << y;
          ASSERT_GE(reach[beside][0] >> 2, steps - 1) << "it falls by one a texel at most";
        }
    }
  EXPECT_GT(longest, 3);
}

// A long strand over the border of its chart would be what grows in another place.
TEST(EvenReach, OtherChartsDoNotCount) {
  Setting one(96);
  const auto chartOf = [&](std::size_t texel) { return one.surface.vertices[one.surface.indices[3 * one.atlas.triangleOf()[texel]]].chart; };
  for (std::uint32_t texel = 0; texel < one.groom.map.texels().size(); ++texel)
    if (onChart(one, texel) && chartOf(texel) == 0) one.groom.map.set(texel, {200, 255, 0, 0});
  const std::vector<EvenTexel> reach = evenReach(one.groom.map, one.surface, one.atlas);
  ASSERT_GT(one.surface.chartCount, 1u);
  for (std::size_t i = 0; i < reach.size(); ++i) {
    if (!onChart(one, i)) continue;
    EXPECT_EQ(reach[i][0] >> 2, kMostReach);
    EXPECT_EQ(reach[i][2], chartOf(i) + 1);
  }
}

// What shaders of a coat of one type tell a ray by that leaves its chart.
TEST(WithCharts, KeepsLengthsAndTellsChartsApartInTheirGuttersToo) {
  Setting one(96);
  ASSERT_GT(one.surface.chartCount, 1u);
  setLength(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.4f, 1, Falloff::Flat}, 0.5f);
  const GroomMap map = withCharts(one.groom.map, one.surface, one.atlas);
  const std::vector<GroomMap::Texel>& texels = map.texels();
  for (std::uint32_t i = 0; i < texels.size(); ++i) {
    EXPECT_EQ(texels[i], (GroomMap::Texel{one.groom.map.texels()[i][0], 0, 0, texels[i][3]}));
    if (onChart(one, i)) { EXPECT_EQ(texels[i][3], one.surface.vertices[one.surface.indices[3 * one.atlas.triangleOf()[i]]].chart + 1); }
  }
  for (const auto& [texel, source] : one.atlas.gutter()) EXPECT_EQ(texels[texel][3], texels[source][3]);
}

TEST(EvenReach, IsNoneWhereTypesShareATexel) {
  Setting one(64);
  paintType(one.groom, one.groomSurface(), {{1, 0, 0}, {1, 0, 0}, 0.5f, 0.5f}, 3);
  const std::vector<EvenTexel> reach = evenReach(one.groom.map, one.surface, one.atlas);
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const std::uint8_t share = one.groom.map.texels()[i][2];
    EXPECT_TRUE(!onChart(one, i) || share == 0 || share == 255 || reach[i][0] == 0);
  }
}

TEST(EvenReach, CountsNothingBesideTheCharts) {
  Setting one(64);
  for (std::uint32_t texel = 0; texel < one.groom.map.texels().size(); ++texel)
    if (onChart(one, texel)) one.groom.map.set(texel, {200, 0, 255, 0});
  const std::vector<EvenTexel> reach = evenReach(one.groom.map, one.surface, one.atlas);
  for (std::size_t i = 0; i < reach.size(); ++i)
    EXPECT_TRUE(!onChart(one, i) || (reach[i][0] == 2 + 4 * kMostReach && reach[i][1] == 200));
}

}  // namespace
}  // namespace fur::groom
