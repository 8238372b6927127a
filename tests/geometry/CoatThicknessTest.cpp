#include "geometry/CoatThickness.h"

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

TEST(CoatThickness, OnlyWhereRaysGoOnIntoAnotherPartIsCrowded) {
  const auto crowdedOf = [](const Mesh& mesh, float furLength) {
    const Surface surface = built(mesh);
    std::vector<Vec3> places;
    const std::vector<std::uint8_t> crowded = crowdedVertices(surface, SurfaceQuery(surface), furLength);
    EXPECT_EQ(crowded.size(), surface.vertices.size());
    for (std::size_t i = 0; i < crowded.size(); ++i)
      if (crowded[i]) places.push_back(surface.vertices[i].position);
    return places;
  };
  EXPECT_TRUE(crowdedOf(makeSphere(), 0.3f).empty());
  const std::vector<Vec3> places = crowdedOf(makeTorus(), 0.3f);
  EXPECT_FALSE(places.empty());
  for (const Vec3& place : places) EXPECT_LT(glm::length(place), 0.95f);  // never the outermost rim, of radius 1
}

}  // namespace
}  // namespace fur::geometry
