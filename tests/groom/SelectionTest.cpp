// Selecting for the brushes: what the mask leaves free.
#include "groom/Selection.h"

#include <gtest/gtest.h>

#include "groom/GroomBrush.h"
#include "groom/GroomFilters.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

// Two spheres side by side.
geometry::Surface twoSpheres() {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  const std::size_t count = mesh.positions.size();
  const std::vector<std::uint32_t> indices = mesh.indices;
  for (std::size_t i = 0; i < count; ++i) {
    mesh.positions.push_back(0.4f * mesh.positions[i] + Vec3(0.55f, 0, 0));
    mesh.positions[i] = 0.4f * mesh.positions[i] - Vec3(0.55f, 0, 0);
    if (!mesh.normals.empty()) mesh.normals.push_back(mesh.normals[i]);
  }
  for (const std::uint32_t index : indices) mesh.indices.push_back(index + static_cast<std::uint32_t>(count));
  return geometry::buildSurface(mesh).value();
}

int maskAt(const Setting& one, std::uint32_t texel) { return one.groom.mask.texels()[texel][3]; }

// Share of the surface's texels that are protected.
double protectedShare(const Setting& one) {
  double sum = 0, count = 0;
  one.forTexels([&](std::uint32_t texel, const Vec3&) { sum += maskAt(one, texel), ++count; });
  return sum / (255 * count);
}

Setting withCap() {
  Setting one;
  for (int i = 0; i < 12; ++i) protect(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.5f, 1, Falloff::Flat});
  return one;
}

TEST(Selection, WhatHangsTogetherIsFreeAndAllElseIsProtected) {
  Setting two(256, twoSpheres());
  const auto hit = two.query.castRay(Vec3(0.55f, 0, 3), Vec3(0, 0, -1));
  ASSERT_TRUE(hit);
  selectConnected(two.groom, two.groomSurface(), hit->triangle);
  two.forTexels([&](std::uint32_t texel, const Vec3& at) { ASSERT_EQ(maskAt(two, texel), at.x > 0 ? 0 : 255) << at.x; });
}

TEST(Selection, OneSphereInManyChartsIsOnePart) {
  Setting one;
  ASSERT_GT(one.surface.chartCount, 1u);
  protect(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.5f, 1, Falloff::Flat});
  selectConnected(one.groom, one.groomSurface(), 0);
  EXPECT_EQ(protectedShare(one), 0);
}

TEST(Selection, ByTypeTheMaskIsWhatTheTypeLeaves) {
  Setting one;
  paintType(one.groom, one.groomSurface(), {{0, 1, 0}, {0, 1, 0}, 0.6f, 0.8f, Falloff::Smooth}, 3);
  for (const int type : {1, 2, 3}) {
    selectType(one.groom, one.groomSurface(), type);
    one.forTexels([&](std::uint32_t texel, const Vec3&) {
      const GroomMap::Texel& t = one.groom.map.texels()[texel];
      ASSERT_EQ(255 - maskAt(one, texel), type == 1 ? 255 - t[1] - t[2] - t[3] : t[static_cast<std::size_t>(type) - 1]);
    });
  }
}

TEST(Selection, ByLengthBothEndsCount) {
  Setting one;
  for (std::uint32_t i = 0; i < one.groom.map.texels().size(); ++i) one.groom.map.set(i, {static_cast<std::uint8_t>(i % 256), 0, 0, 0});
  selectLength(one.groom, one.groomSurface(), 51 / 255.0f, 102 / 255.0f);
  one.forTexels([&](std::uint32_t texel, const Vec3&) {
    const int length = one.groom.map.texels()[texel][0];
    ASSERT_EQ(maskAt(one, texel) == 0, length >= 51 && length <= 102) << length;
  });
}

TEST(Selection, ByPaintWhatIsNearlyOfTheSameColour) {
  Setting one;
  const Brush top{{0, 1, 0}, {0, 1, 0}, 0.5f, 1, Falloff::Flat}, foot{{0, -1, 0}, {0, -1, 0}, 0.5f, 1, Falloff::Flat};
  paint(one.groom, one.groomSurface(), top, 0xff0000);
  paint(one.groom, one.groomSurface(), foot, 0xf00808);
  const auto hit = one.query.castRay(Vec3(0, 3, 0), Vec3(0, -1, 0));
  ASSERT_TRUE(hit);
  const Vec2 at = atlasAt(one.surface, *hit);
  const auto freeOf = [&](float tolerance, bool upper) {
    selectPaint(one.groom, one.groomSurface(), at, tolerance);
    int count = 0;
    one.forTexels([&](std::uint32_t texel, const Vec3& place) { count += maskAt(one, texel) == 0 && (place.y > 0) == upper; });
    return count;
  };
  EXPECT_GT(freeOf(0.02f, true), 100);
  EXPECT_EQ(freeOf(0.02f, false), 0) << "another red";
  EXPECT_GT(freeOf(0.1f, false), 100) << "nearly the same red";
  // Nor is what nobody painted.
  selectPaint(one.groom, one.groomSurface(), at, 0.1f);
  EXPECT_GT(protectedShare(one), 0.5);
}

TEST(Selection, AMaskGrowsAndShrinksByTheRadiusAcrossCharts) {
  constexpr float kStep = 0.08f;
  const Setting before = withCap();
  // How far down the mask reaches round the pole: the lowest protected place of each direction.
  const auto reach = [](const Setting& one) {
    std::array<float, 16> lowest;
    lowest.fill(1);
    one.forTexels([&](std::uint32_t texel, const Vec3& at) {
      const auto way = static_cast<std::size_t>((std::atan2(at.z, at.x) + kPi) / (2 * kPi) * 15.999f);
      if (maskAt(one, texel) > 127) lowest[way] = std::min(lowest[way], at.y);
    });
    return lowest;
  };
  Setting grown = withCap(), shrunk = withCap();
  growMask(grown.groom, grown.groomSurface(), kStep);
  shrinkMask(shrunk.groom, shrunk.groomSurface(), kStep);
  const auto first = reach(before), lower = reach(grown), higher = reach(shrunk);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const auto angle = [](float y) { return std::acos(std::min(y, 1.0f)); };
    EXPECT_NEAR(angle(lower[i]) - angle(first[i]), kStep, 0.03f) << i;
    EXPECT_NEAR(angle(first[i]) - angle(higher[i]), kStep, 0.03f) << i;
  }
}

TEST(Selection, WhatGrowsAndShrinksAgainIsNearlyWhatItWas) {
  Setting one = withCap();
  const double before = protectedShare(one);
  growMask(one.groom, one.groomSurface(), 0.06f);
  EXPECT_GT(protectedShare(one), 1.2 * before);
  shrinkMask(one.groom, one.groomSurface(), 0.06f);
  EXPECT_NEAR(protectedShare(one), before, 0.02 * before);
}

TEST(Selection, SmoothingMakesASoftBorderAndLeavesTheRest) {
  Setting one = withCap();
  const double before = protectedShare(one);
  smoothMask(one.groom, one.groomSurface(), 0.1f);
  int between = 0;
  one.forTexels([&](std::uint32_t texel, const Vec3& at) {
    const int value = maskAt(one, texel);
    between += value > 20 && value < 235;
    const float off = glm::distance(at, Vec3(0, 1, 0));
    if (off < 0.35f) ASSERT_EQ(value, 255);
    if (off > 0.65f) ASSERT_EQ(value, 0);
  });
  EXPECT_GT(between, 200);
  EXPECT_NEAR(protectedShare(one), before, 0.05 * before);
}

TEST(Selection, OfAPlainMaskNothingGrows) {
  Setting one;
  growMask(one.groom, one.groomSurface(), 0.1f);
  smoothMask(one.groom, one.groomSurface(), std::nanf(""));
  EXPECT_TRUE(one.groom.mask.isPlain());
}

}  // namespace
}  // namespace fur::groom
