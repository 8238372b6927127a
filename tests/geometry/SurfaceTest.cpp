// Vertices, gradients and edges of a surface.
#include <gtest/gtest.h>

#include <set>

#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

TEST(Surface, KeepsEveryTriangleInOrder) {
  const Mesh mesh = makeLump();
  const Surface surface = built(mesh);
  ASSERT_EQ(surface.triangleCount(), mesh.triangleCount());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    ASSERT_EQ(surface.vertices[surface.indices[i]].position, mesh.positions[mesh.indices[i]]);
  }
}

TEST(Surface, DropsTrianglesWithoutAreaAndFailsWhenNoneIsLeft) {
  Mesh mesh;
  // Smaller than what is cut for the sake of fur.
  mesh.positions = {Vec3(0), Vec3(0.05f, 0, 0), Vec3(0, 0.05f, 0), Vec3(0.025f, 0, 0)};
  mesh.indices = {0, 1, 2, 0, 1, 3, 2, 2, 1};
  EXPECT_EQ(built(mesh).triangleCount(), 1u);
  mesh.indices = {0, 1, 3, 2, 2, 1};
  const auto none = buildSurface(mesh);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().id, ErrorId::BadFile);
}

TEST(Surface, ComputesNormalsWhereTheyAreMissingOrNotFinite) {
  Mesh mesh = makeSphere();
  mesh.normals.clear();
  // Facets of a sphere of 72 x 36 lie within 2 degrees of it.
  for (const SurfaceVertex& v : built(mesh).vertices) ASSERT_GT(glm::dot(v.normal, v.position), 0.999f);
  mesh = makeSphere();
  mesh.normals[100] = Vec3(NAN);
  mesh.normals[200] = Vec3(0);
  for (const SurfaceVertex& v : built(mesh).vertices) ASSERT_GT(glm::dot(v.normal, v.position), 0.999f);
}

TEST(Surface, ReproducesCoordinateDifferencesAlongEdgesByGradients) {
  const Surface surface = built(makeLump(192, 96));
  double error = 0.0, length = 0.0;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto v = cornersOf(surface, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const SurfaceVertex &a = *v[k], &b = *v[(k + 1) % 3];
      const Vec3 step = b.position - a.position;
      const Vec2 predicted(glm::dot(a.gradS + b.gradS, step) * 0.5f, glm::dot(a.gradT + b.gradT, step) * 0.5f);
      error += glm::length(predicted - (b.fur - a.fur));
      length += glm::length(step);
    }
  }
  EXPECT_LT(error, 0.02 * length);  // the surface curves by a few degrees from one vertex to the next
}

TEST(Surface, HasGradientsPerpendicularToTheNormal) {
  for (const SurfaceVertex& v : built(makeLump()).vertices) {
    ASSERT_NEAR(glm::dot(v.gradS, v.normal), 0.0f, 1e-5f);
    ASSERT_NEAR(glm::dot(v.gradT, v.normal), 0.0f, 1e-5f);
  }
}

TEST(Surface, MapsFurStepsToAtlasSteps) {
  for (const Mesh& mesh : {makeLump(), makePlane(), makeTorus()}) {
    const Surface surface = built(mesh);
    double error = 0.0, length = 0.0;
    for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
      const auto v = cornersOf(surface, t);
      for (std::size_t k = 0; k < 3; ++k) {
        const SurfaceVertex &a = *v[k], &b = *v[(k + 1) % 3];
        const Vec4 m = 0.5f * (a.atlasFromFur + b.atlasFromFur);
        const Vec2 step = b.fur - a.fur;
        error += glm::length(Vec2(m.x, m.y) * step.x + Vec2(m.z, m.w) * step.y - (b.atlas - a.atlas));
        length += glm::length(b.atlas - a.atlas);
      }
    }
    // Exact for charts; a model's own uv bend against the fur coordinates from vertex to vertex.
    EXPECT_LT(error, (mesh.uv.empty() ? 1e-4 : 0.1) * length);
  }
}

TEST(Surface, HasAnInvertibleAtlasStepEverywhere) {
  Mesh folded = makeSphere();
  for (std::size_t i = 0; i < 3; ++i) folded.uv[folded.indices[900 + i]] = folded.uv[folded.indices[900]];
  for (const Mesh& mesh : {makeSphere(), makeLump(), folded}) {
    for (const SurfaceVertex& v : built(mesh).vertices) {
      const float determinant = v.atlasFromFur.x * v.atlasFromFur.w - v.atlasFromFur.y * v.atlasFromFur.z;
      ASSERT_TRUE(std::isfinite(determinant));
      ASSERT_GT(std::abs(determinant), 1e-8f);
    }
  }
}

TEST(Surface, HasTwoFacesAtEveryEdgeWhenClosed) {
  for (const Mesh& mesh : {makeSphere(), makeTorus(), makeLump()}) {
    const Surface surface = built(mesh);
    EXPECT_EQ(surface.edges.size(), surface.triangleCount() * 3 / 2);
    for (const SurfaceEdge& edge : surface.edges) {
      // Neighbours on these shapes never fold by more than 60 degrees; a boundary would have -1.
      ASSERT_GT(glm::dot(edge.faceNormal0, edge.faceNormal1), 0.5f);
      ASSERT_NEAR(glm::length(edge.faceNormal0), 1.0f, 1e-5f);
      ASSERT_NE(surface.vertices[edge.a].position, surface.vertices[edge.b].position);
    }
  }
}

TEST(Surface, MakesBoundaryEdgesSilhouettes) {
  constexpr std::size_t kCells = 40;  // smaller than what is cut for the sake of fur
  const Surface surface = built(makePlane(kCells));
  std::size_t boundary = 0;
  for (const SurfaceEdge& edge : surface.edges) boundary += edge.faceNormal1 == -edge.faceNormal0;
  EXPECT_EQ(boundary, 4 * kCells);
  EXPECT_EQ(surface.edges.size(), 3 * kCells * kCells + 2 * kCells);
}

TEST(Surface, StartsFinsAtManyPlaces) {
  std::set<float> starts;
  for (const SurfaceEdge& edge : built(makeTorus()).edges) {
    ASSERT_GE(edge.finStart, 0.0f);
    ASSERT_LT(edge.finStart, 1.0f);
    starts.insert(edge.finStart);
  }
  EXPECT_GT(starts.size(), 6000u);
}

TEST(Surface, TakesMeshesWithMoreThanTwoFacesAtAnEdge) {
  Mesh mesh;
  // Smaller than what is cut for the sake of fur.
  mesh.positions = {Vec3(0), Vec3(0, 0.05f, 0), Vec3(0.05f, 0, 0), Vec3(-0.05f, 0, 0), Vec3(0, 0, 0.05f)};
  mesh.indices = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  const Surface surface = built(mesh);
  EXPECT_EQ(surface.edges.size(), 8u);  // six of their own, the shared one twice: a pair and an odd one
}

TEST(Surface, IsMadeInManyStepsOfWhichNoneCutsAllOfItsCharts) {
  const Mesh mesh = makeLump(192, 96);
  SurfaceBuilding building(mesh, FurMapping::Charts);
  int steps = 1;
  while (!building.step()) ++steps;
  const auto surface = building.take();
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface.value().triangleCount(), mesh.triangleCount());
  // The steps of SurfaceBuilding, and those of its charts: each relaxation of their borders, and each chart that is flattened.
  EXPECT_GT(steps, 15 + static_cast<int>(surface.value().chartCount) / 2);
}

}  // namespace
}  // namespace fur::geometry
