#include "geometry/CoatThickness.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

float shareOf(const Mesh& mesh, float furLength) {
  const Surface surface = built(mesh);
  return grazingShare(surface, SurfaceQuery(surface), furLength);
}

TEST(CoatThickness, IsThatOfTheStrandsWhereNothingIsInTheirWay) {
  for (const SurfaceVertex& vertex : built(makeSphere()).vertices) EXPECT_EQ(coatThickness(vertex, 0.3f), 0.3f);
}

TEST(CoatThickness, EndsInACreaseBeforeItsStrandsCross) {
  SurfaceVertex vertex;
  vertex.curvature = Vec3(-4, 0, 1);  // hollow, of radius 0.25
  EXPECT_FLOAT_EQ(coatThickness(vertex, 1), 0.65f * 0.25f);
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
