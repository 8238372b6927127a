#include "groom/Lie.h"

#include <gtest/gtest.h>

#include "core/Fnv1a.h"
#include "groom/GroomBrush.h"
#include "groom/GroomFilters.h"
#include "tests/OnEveryPlatform.h"
#include "tests/geometry/Solids.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

struct Lying : Setting {
  explicit Lying(const geometry::Mesh& mesh) : Setting(64, geometry::buildSurface(mesh).value()), lie(naturalLie(surface, points)) {}
  GroomSurface skin() const { return {surface, query, atlas, points, lie}; }
  // The mean over the points that `of` picks.
  template <class Of>
  Vec3 mean(Of of) const {
    Vec3 sum(0);
    float count = 0;
    for (std::size_t i = 0; i < lie.size(); ++i)
      if (of(points.positions[i], points.normals[i])) sum += lie[i], ++count;
    EXPECT_GT(count, 0);
    return sum / count;
  }
  std::vector<Vec3> lie;
};

// A barrel along z on four legs; all of stretched balls, which are not joined.
geometry::Mesh makeBeast() {
  geometry::Mesh mesh;
  const auto limb = [&](const Vec3& from, const Vec3& to, float radius) {
    geometry::Mesh ball = geometry::makeSphere(24, 24);
    const Vec3 axis = glm::normalize(to - from), middle = (from + to) * 0.5f;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
      const float along = glm::dot(ball.positions[i], axis), half = glm::length(to - from) * 0.5f / radius;
      mesh.positions.push_back(middle + radius * (ball.positions[i] + axis * (along * half)));
      mesh.normals.push_back(glm::normalize(ball.normals[i] - axis * (glm::dot(ball.normals[i], axis) * (1 - 1 / (1 + half)))));
    }
    for (const std::uint32_t index : ball.indices) mesh.indices.push_back(first + index);
  };
  limb({0, 0.2f, 0.6f}, {0, 0.2f, -0.6f}, 0.25f);
  for (const float x : {-0.2f, 0.2f})
    for (const float z : {-0.5f, 0.5f}) limb({x, 0.1f, z}, {x, -0.6f, z}, 0.08f);
  geometry::fitToUnitSphere(mesh);
  return mesh;
}

TEST(Lie, IsAcrossTheNormalsAndAtMostOneLong) {
  for (const geometry::Mesh& mesh : {geometry::makeSphere(), geometry::makeTorus(), geometry::makePlane(), makeBeast(), geometry::test::makeCube(), geometry::test::makeRod()}) {
    const Lying one(mesh);
    ASSERT_EQ(one.lie.size(), one.points.count());
    for (std::size_t i = 0; i < one.lie.size(); ++i) {
      ASSERT_LE(glm::length(one.lie[i]), 1 + 1e-5f);
      ASSERT_NEAR(glm::dot(one.lie[i], one.points.normals[i]), 0, 1e-4f);
    }
  }
}

TEST(Lie, OfABallFallsFromACrownOnItsTop) {
  const Lying ball(geometry::makeSphere());
  float standing = 0;
  for (std::size_t i = 0; i < ball.lie.size(); ++i) {
    const Vec3& n = ball.points.normals[i];
    const float length = glm::length(ball.lie[i]);
    if (std::abs(n.y) < 0.5f) {
      EXPECT_GT(length, 0.95f);
      EXPECT_LT(ball.lie[i].y, -0.35f * std::sqrt(1 - n.y * n.y)) << "nowhere across the way down, though its crown is before the pole";
    }
    standing += length < 0.5f;
  }
  EXPECT_GT(standing, 0) << "a sphere cannot lie everywhere";
  EXPECT_LT(standing / static_cast<float>(ball.lie.size()), 0.1f) << "mostly where points are dense, at its poles";
}

TEST(Lie, GoesBackwardsAlongABodyAndDownItsLegs) {
  const Lying beast(makeBeast());
  const Vec3 back = beast.mean([](const Vec3& p, const Vec3& n) { return n.y > 0.9f && std::abs(p.z) < 0.4f && p.y > 0.1f; });
  EXPECT_LT(back.z, -0.9f);
  const Vec3 flank = beast.mean([](const Vec3& p, const Vec3& n) { return std::abs(n.x) > 0.9f && std::abs(p.z) < 0.4f && p.y > 0.1f; });
  EXPECT_LT(flank.z, -0.7f);
  EXPECT_LT(flank.y, -0.03f);
  for (const float side : {-1.0f, 1.0f}) {
    const Vec3 leg = beast.mean([&](const Vec3& p, const Vec3& n) { return p.y < -0.2f && p.y > -0.5f && n.z * side > 0.7f; });
    EXPECT_LT(leg.y, -0.8f) << side;
  }
}

TEST(Lie, OfASheetRunsOneWay) {
  const Lying plane(geometry::makePlane());
  for (std::size_t i = 0; i < plane.lie.size(); ++i)
    if (glm::length(plane.points.positions[i]) < 0.4f) EXPECT_GT(glm::dot(plane.lie[i], Vec3(0, 0, -1)), 0.98f) << "but for its rim, where fur leans outwards";
}

TEST(Lie, NeighboursDifferLittleWhereFurLies) {
  for (const geometry::Mesh& mesh : {geometry::makeSphere(), geometry::makeTorus(), makeBeast()}) {
    const Lying one(mesh);
    std::size_t sides = 0, apart = 0;
    for (std::size_t i = 0; i < one.surface.indices.size(); ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      const std::uint32_t a = one.points.pointOf[one.surface.indices[i]], b = one.points.pointOf[one.surface.indices[next]];
      if (glm::length(one.points.positions[a] - one.points.positions[b]) > 0.1f) continue;
      ++sides;
      apart += glm::length(one.lie[a] - one.lie[b]) > 0.5f;
    }
    EXPECT_LT(static_cast<float>(apart) / static_cast<float>(sides), 0.05f) << "crowns and partings alone";
  }
}

TEST(Lie, IsMirroredAsTheBodyIs) {
  const Lying beast(makeBeast());
  const std::vector<std::uint32_t> other = beast.points.at([&] {
    std::vector<Vec3> places;
    for (const Vec3& p : beast.points.positions) places.push_back(p * Vec3(-1, 1, 1));
    return places;
  }());
  std::size_t found = 0, alike = 0;
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (other[i] == SurfacePoints::kNoPoint) continue;
    ++found;
    alike += glm::length(beast.lie[i] * Vec3(-1, 1, 1) - beast.lie[other[i]]) < 0.3f;
  }
  ASSERT_GT(found, beast.points.count() / 4);
  EXPECT_GT(static_cast<float>(alike) / static_cast<float>(found), 0.95f) << "its triangles are not";
}

TEST(Lie, IsTheSameOnEveryPlatform) {
  Fnv1a hash;
  for (const geometry::Mesh& mesh : {geometry::makeTorus(), geometry::test::makeCube()})
    for (const Vec3& way : Lying(mesh).lie) hash.add(way + 0.0f);
  test::printOnEveryPlatform("how fur lies", hash.value());
}

TEST(Lie, IsWhereNothingIsCombed) {
  Lying ball(geometry::makeSphere());
  EXPECT_EQ(restBends(ball.groom, ball.surface, ball.points), std::vector<Vec3>(ball.surface.vertices.size(), Vec3(0)));
  ball.groom.comb[7] = kMaxComb * normalizeOr(glm::cross(ball.points.normals[7], Vec3(0.3f, 0.1f, 0.9f)), Vec3(0));
  const std::vector<Vec3> bends = restBends(ball.groom, ball.surface, ball.points, ball.lie);
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const std::uint32_t point = ball.points.pointOf[i];
    EXPECT_LT(glm::length(bends[i] - (point == 7 ? ball.groom.comb[7] : ball.lie[point])), 1e-2f);
  }
}

TEST(Lie, BrushesWorkOnFurAsItLies) {
  const Brush brush{Vec3(1, 0, 0), Vec3(1, 0, 0), 0.4f, 0.5f};
  const auto atMiddle = [](const Lying& ball) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < ball.points.count(); ++i)
      if (ball.points.positions[i].x > ball.points.positions[nearest].x) nearest = i;
    return nearest;
  };
  Lying ball(geometry::makeSphere());
  const std::size_t at = atMiddle(ball);
  // Half way from how it lies, not from upright.
  ASSERT_TRUE(comb(ball.groom, ball.skin(), brush, Vec3(0, 0, 1)));
  EXPECT_LT(glm::length(ball.groom.comb[at] - 0.5f * (ball.lie[at] + kMaxComb * Vec3(0, 0, 1))), 0.1f);
  for (std::size_t i = 0; i < ball.points.count(); ++i)
    if (glm::length(ball.points.positions[i] - brush.centre) > 0.4f) ASSERT_EQ(ball.groom.comb[i], Vec3(0));
  // What is raised stands, though nobody sees its bend; it does not lie down again.
  for (int i = 0; i < 40; ++i) raise(ball.groom, ball.skin(), brush);
  EXPECT_NE(ball.groom.comb[at], Vec3(0));
  EXPECT_LT(glm::length(bendAt(ball.groom, ball.lie, at)), 1e-3f);
  letLie(ball.groom);
  EXPECT_EQ(bendAt(ball.groom, ball.lie, at), ball.lie[at]);
  raiseAll(ball.groom, ball.lie);
  for (std::size_t i = 0; i < ball.points.count(); ++i) ASSERT_LT(glm::length(bendAt(ball.groom, ball.lie, i)), 1e-3f);
}

}  // namespace
}  // namespace fur::groom
