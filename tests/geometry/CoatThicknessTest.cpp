#include "geometry/CoatThickness.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/Solids.h"
#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

float shareOf(const Mesh& mesh, float furLength) {
  const Surface surface = built(mesh);
  return grazingShare(surface, SurfaceQuery(surface), furLength);
}

// A strip bent to half a turn of that radius, hollow above, from z = -1 to 1.
Mesh trough(float radius, int steps) {
  constexpr int kAlong = 8;
  Mesh mesh;
  for (int i = 0; i <= steps; ++i) {
    const float angle = kPi * (static_cast<float>(i) / static_cast<float>(steps) - 1);
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    for (int j = 0; j <= kAlong; ++j) {
      mesh.positions.push_back(radius * out + Vec3(0, 0, 2.0f * static_cast<float>(j) / kAlong - 1));
      mesh.normals.push_back(-out);
      if (i == steps || j == kAlong) continue;
      const auto at = static_cast<std::uint32_t>((kAlong + 1) * i + j), next = at + kAlong + 1;
      mesh.indices.insert(mesh.indices.end(), {at, at + 1, next, at + 1, next + 1, next});
    }
  }
  return mesh;
}

TEST(CoatThickness, IsThatOfTheStrandsWhereNothingIsInTheirWay) {
  for (const SurfaceVertex& vertex : built(makeSphere()).vertices) EXPECT_EQ(coatThickness(vertex, 0.3f), 0.3f);
}

TEST(CoatThickness, IsHardlyMoreThanTheRadiusOfASlenderBody) {
  const auto longestOn = [](Vec3 scale) {
    Mesh mesh = makeSphere();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      mesh.positions[i] *= scale;
      mesh.normals[i] = glm::normalize(mesh.normals[i] / scale);
    }
    float longest = 0;
    for (const SurfaceVertex& vertex : built(mesh).vertices) longest = std::max(longest, coatThickness(vertex, 2));
    return longest;
  };
  // A spindle is thinner towards its ends; half of its skin is as round as nearly its middle.
  EXPECT_NEAR(longestOn(Vec3(0.25f, 1, 0.25f)), 1.1f * 0.24f, 0.02f);
  EXPECT_NEAR(longestOn(Vec3(1)), 1.1f, 0.01f);
  // Of a plate most is flat; hair on a wire is longer than that is thick.
  EXPECT_EQ(longestOn(Vec3(1, 0.05f, 1)), 2.0f);
  EXPECT_NEAR(longestOn(Vec3(0.03f, 1, 0.03f)), 0.12f, 1e-4f);
}

TEST(CoatThickness, EndsInACreaseBeforeItsStrandsCross) {
  for (const SurfaceVertex& vertex : built(trough(0.25f, 24)).vertices) {
    EXPECT_EQ(coatThickness(vertex, 0.1f), 0.1f);
    // At its rims normals lean outwards.
    if (std::abs(vertex.position.z) < 0.8f && vertex.position.y < -0.1f) EXPECT_NEAR(coatThickness(vertex, 1), 0.65f * 0.25f, 0.01f);
  }
}

// Offset edges keep their direction.
TEST(CoatThickness, TheOutsideOfACoatDoesNotFoldHoweverLongItIs) {
  for (const Mesh& mesh : {makeTorus(), trough(0.25f, 6), test::makePrism({{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}, {{0, 1, 2, 3}, {0, 3, 4, 5}}, 0.5f)}) {
    const Surface surface = built(mesh);
    for (std::size_t i = 0; i < surface.indices.size(); ++i) {
      const SurfaceVertex& a = surface.vertices[surface.indices[i]], &b = surface.vertices[surface.indices[i % 3 == 2 ? i - 2 : i + 1]];
      const Vec3 edge = b.position - a.position;
      const Vec3 outside = edge + coatThickness(b, 2) * b.normal - coatThickness(a, 2) * a.normal;
      ASSERT_GT(glm::dot(edge, outside), 0) << i;
    }
  }
}

TEST(CoatThickness, OfNoConvexBodyIsCrowded) {
  EXPECT_EQ(shareOf(makeSphere(), 0.6f), 0);
  EXPECT_EQ(shareOf(makeSphere(), 0.1f), 0);
}

TEST(CoatThickness, OfARingIsCrowdedWhereLongFurFillsItsHole) {
  EXPECT_EQ(shareOf(makeTorus(), 0.05f), 0);
  EXPECT_GT(shareOf(makeTorus(), 0.4f), 0.05f);
}

TEST(CoatThickness, VerticesAreCrowdedWhereRaysGoOnIntoAnotherPart) {
  const auto crowdedOf = [](const Mesh& mesh, float furLength) {
    const Surface surface = built(mesh);
    const SurfaceQuery query(surface);
    CrowdedSearch search(surface, query, furLength);
    while (!search.step()) {}
    const std::vector<std::uint8_t> crowded = search.take();
    EXPECT_EQ(crowded.size(), surface.vertices.size());
    return std::count(crowded.begin(), crowded.end(), 1);
  };
  EXPECT_EQ(crowdedOf(makeSphere(), 0.3f), 0);
  EXPECT_EQ(crowdedOf(makeTorus(), 0.02f), 0);
  EXPECT_GT(crowdedOf(makeTorus(), 0.3f), 0);
}

}  // namespace
}  // namespace fur::geometry
