// The directions in which fur grows beside the normals of the model.
#include <gtest/gtest.h>

#include "geometry/FurDirections.h"
#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

std::vector<Vec3> directionsOf(const Mesh& mesh) {
  FurDirections directions(mesh, {});
  while (!directions.step()) {}
  return directions.directions();
}

// Each normal turned by up to so much, those of one position alike.
Mesh rough(Mesh mesh, float radians) {
  const Weld places = weldPositions(mesh.positions);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    Random random(places.idOf[i]);
    const Vec3 aside(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    mesh.normals[i] = glm::normalize(mesh.normals[i] + radians * aside);
  }
  return mesh;
}

// How far the directions' differences along edges are, root mean square, from those of a sphere, a share of these.
float crimp(const Mesh& mesh, const std::vector<Vec3>& directions) {
  float apart = 0, all = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    const Vec3 turns = glm::normalize(mesh.positions[b]) - glm::normalize(mesh.positions[a]);
    const Vec3 wrong = directions[b] - directions[a] - turns;
    apart += glm::dot(wrong, wrong), all += glm::dot(turns, turns);
  }
  return std::sqrt(apart / all);
}

TEST(FurDirections, AreWithoutWhatTurnsFromOneVertexToTheNext) {
  const Mesh mesh = rough(makeSphere(), 0.05f);
  EXPECT_GT(crimp(mesh, mesh.normals), 0.5f);
  // What is left is longer than five edges.
  EXPECT_LT(crimp(mesh, directionsOf(mesh)), 0.4f * crimp(mesh, mesh.normals));
}

TEST(FurDirections, OfARoundBodyAreItsNormals) {
  for (const Mesh& mesh : {makeSphere(), makeTorus()}) {
    const std::vector<Vec3> directions = directionsOf(mesh);
    // Beside a sphere's poles triangles are slivers, whose weights are limited.
    for (std::size_t i = 0; i < directions.size(); ++i) ASSERT_GT(glm::dot(directions[i], mesh.normals[i]), 0.9999f) << i;
  }
}

TEST(FurDirections, OfARidgeAndOfARimAreTheNormalsThere) {
  // A roof of 90 degrees; its ridge has normals of its own for either side.
  Mesh roof;
  for (int side = 0; side < 2; ++side)
    for (int row = 0; row <= 8; ++row)
      for (int along = 0; along <= 8; ++along) {
        const float out = (side == 0 ? -1.0f : 1.0f) * static_cast<float>(row) / 8;
        roof.positions.push_back(Vec3(out, 1 - std::abs(out), static_cast<float>(along) / 8));
        roof.normals.push_back(glm::normalize(Vec3(side == 0 ? -1 : 1, 1, 0)));
        if (row == 8 || along == 8) continue;
        const auto at = static_cast<std::uint32_t>((9 * side + row) * 9 + along);
        for (const std::uint32_t corner : {at, at + 1, at + 9, at + 1, at + 10, at + 9}) roof.indices.push_back(corner);
      }
  const std::vector<Vec3> directions = directionsOf(roof);
  for (std::size_t i = 0; i < directions.size(); ++i) ASSERT_LT(glm::length(directions[i] - roof.normals[i]), 1e-5f) << i;

  const Mesh plane = rough(makePlane(), 0.05f);
  const std::vector<Vec3> ofPlane = directionsOf(plane);
  for (std::size_t i = 0; i < ofPlane.size(); ++i)
    if (std::max(std::abs(plane.positions[i].x), std::abs(plane.positions[i].z)) > 0.99f * plane.positions.back().x) ASSERT_EQ(ofPlane[i], plane.normals[i]) << i;
}

TEST(FurDirections, AreNotWrittenToFiles) {
  const Mesh mesh = rough(makeSphere(), 0.05f);
  const Surface surface = built(mesh);
  const OwnSurface own = ownSurface(surface, mesh);
  float moved = 0;
  for (std::size_t i = 0; i < own.surface.vertices.size(); ++i) {
    ASSERT_LT(glm::length(own.surface.vertices[i].normal - mesh.normals[own.surface.vertices[i].source]), 1e-6f);
    moved = std::max(moved, glm::length(surface.vertices[own.vertexOf[i]].normal - own.surface.vertices[i].normal));
  }
  EXPECT_GT(moved, 0.01f);
}

}  // namespace
}  // namespace fur::geometry
