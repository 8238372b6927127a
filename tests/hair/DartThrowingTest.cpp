#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hair/TestScalps.h"
#include "geometry/Solids.h"

namespace fur::hair {
namespace {

using test::TestScalp;
using Texel = groom::GroomMap::Texel;

// As far apart as discs can be that fill the area.
float packed(double area, double count) { return static_cast<float>(std::sqrt(area * 2 / (std::sqrt(3.0) * count))); }

std::vector<float> toNext(const std::vector<Dart>& darts) {
  std::vector<float> out;
  for (const Dart& a : darts) {
    float nearest = 1e9f;
    for (const Dart& b : darts)
      if (&a != &b && glm::dot(a.normal, b.normal) > 0) nearest = std::min(nearest, glm::length(a.position - b.position));
    out.push_back(nearest);
  }
  return out;
}

TEST(DartThrowing, ThereAreAsManyAsAskedAndTheyLieOnTheirTriangles) {
  const TestScalp sphere(geometry::makeSphere());
  for (const int count : {0, 1, 2, 5, 300}) {
    const auto darts = throwDarts(sphere.scalp(), count, 1);
    ASSERT_EQ(darts.size(), static_cast<std::size_t>(count));
    for (const Dart& dart : darts) {
      const geometry::SurfacePoint at{dart.triangle, dart.weights, 0};
      EXPECT_NEAR(dart.weights.x + dart.weights.y + dart.weights.z, 1, 1e-5);
      EXPECT_GE(std::min({dart.weights.x, dart.weights.y, dart.weights.z}), 0.0f);
      EXPECT_LT(glm::length(positionAt(sphere.surface, at) - dart.position), 1e-5f);
      EXPECT_LT(glm::length(atlasAt(sphere.surface, at) - dart.atlas), 1e-5f);
      EXPECT_NEAR(glm::length(dart.normal), 1, 1e-5);
    }
  }
}

TEST(DartThrowing, TheyKeepApartAlsoWhereTheyAreFew) {
  const TestScalp few(geometry::makePlane(2)), many(geometry::makePlane(40)), sphere(geometry::makeSphere());
  for (const TestScalp* scalp : {&few, &many, &sphere})
    for (const int count : {8, 16, 60, 500}) {
      const auto darts = throwDarts(scalp->scalp(), count, 3);
      const auto next = toNext(darts);
      EXPECT_GT(*std::min_element(next.begin(), next.end()), 0.55f * packed(areaOf(scalp->scalp()), count)) << count;
    }
}

TEST(DartThrowing, NoPlaceIsFarFromOneAlsoWhereTheyAreFew) {
  const TestScalp plane(geometry::makePlane(2));
  for (const int count : {8, 16, 60}) {
    const auto darts = throwDarts(plane.scalp(), count, 5);
    float farthest = 0;
    for (const Dart& probe : throwDarts(plane.scalp(), 400, 99)) {
      float nearest = 1e9f;
      for (const Dart& dart : darts) nearest = std::min(nearest, glm::length(dart.position - probe.position));
      farthest = std::max(farthest, nearest);
    }
    EXPECT_LT(farthest, 1.05f * packed(areaOf(plane.scalp()), count)) << count;
  }
}

TEST(DartThrowing, BordersOfTrianglesShowNoPattern) {
  // A plane of four squares: as many darts stand along the border in the middle as elsewhere.
  const TestScalp plane(geometry::makePlane(2));
  const float band = 0.03f;
  int border = 0, elsewhere = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed)
    for (const Dart& d : throwDarts(plane.scalp(), 200, seed)) {
      if (std::abs(d.position.x) > 0.45f) continue;
      border += std::abs(d.position.z) < band;
      elsewhere += std::abs(std::abs(d.position.z) - 0.2f) < band / 2;
    }
  EXPECT_GT(elsewhere, 300);
  EXPECT_NEAR(border, elsewhere, 0.15 * elsewhere);
}

TEST(DartThrowing, TheyFollowTheDensityAndStandNowhereElse) {
  TestScalp plane(geometry::makePlane(20));
  plane.paint([](const Vec3& p) -> Texel { return {static_cast<std::uint8_t>(p.x > 0.02f ? 252 : p.x < -0.02f ? 63 : 0), 0, 0, 0}; });
  std::size_t dense = 0, thin = 0;
  for (const Dart& dart : throwDarts(plane.scalp(), 1000, 2)) {
    dense += dart.position.x > 0;
    thin += dart.position.x <= 0;
    EXPECT_GT(plane.map.at(dart.atlas).x, 0.0f);
  }
  EXPECT_NEAR(static_cast<double>(dense) / static_cast<double>(thin), 4, 0.5);
}

TEST(DartThrowing, GreyScalpsHaveAsManyAsWhiteOnes) {
  TestScalp plane(geometry::makePlane(8));
  plane.paint([](const Vec3&) { return Texel{20, 0, 0, 0}; });
  EXPECT_EQ(throwDarts(plane.scalp(), 100, 1).size(), 100u);
  const auto next = toNext(throwDarts(plane.scalp(), 100, 1));
  EXPECT_GT(*std::min_element(next.begin(), next.end()), 0.5f * packed(1.0 * areaOf(plane.scalp()) / (20 / 255.0), 100));
}

TEST(DartThrowing, AScalpThatCoversNothingHasNone) {
  TestScalp sphere(geometry::makeSphere());
  sphere.paint([](const Vec3&) { return groom::GroomMap::kBlank; });
  EXPECT_EQ(areaOf(sphere.scalp()), 0.0);
  EXPECT_TRUE(throwDarts(sphere.scalp(), 100, 1).empty());
}

TEST(DartThrowing, TheSidesOfAThinPlateDoNotKnowOfEachOther) {
  const TestScalp plate(geometry::test::makePlate());
  const auto darts = throwDarts(plate.scalp(), 200, 4);
  ASSERT_EQ(darts.size(), 200u);
  int closer = 0, front = 0;
  for (const Dart& a : darts) {
    front += a.normal.z > 0.5f;
    for (const Dart& b : darts) closer += a.normal.z > 0.5f && b.normal.z < -0.5f && glm::length(a.position - b.position) < 0.1f;
  }
  EXPECT_NEAR(front, 96, 10);
  EXPECT_GT(closer, 10);
}

TEST(DartThrowing, TheFirstFewOfManyAreSpreadAsWell) {
  const TestScalp sphere(geometry::makeSphere());
  auto darts = throwDarts(sphere.scalp(), 1000, 6);
  for (const std::size_t count : {500u, 100u, 20u}) {
    darts.resize(count);
    const auto next = toNext(darts);
    EXPECT_GT(*std::min_element(next.begin(), next.end()), 0.5f * packed(areaOf(sphere.scalp()), static_cast<double>(count))) << count;
  }
}

TEST(DartThrowing, ASeedGivesTheSameOnesAgainAndAnotherOthers) {
  const TestScalp sphere(geometry::makeSphere());
  const auto one = throwDarts(sphere.scalp(), 50, 1), again = throwDarts(sphere.scalp(), 50, 1), other = throwDarts(sphere.scalp(), 50, 2);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(one[i].position, again[i].position);
    EXPECT_NE(one[i].position, other[i].position);
  }
}

}  // namespace
}  // namespace fur::hair
