#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/Adjacency.h"
#include "geometry/HardEdges.h"
#include "geometry/Primitives.h"
#include "geometry/Weld.h"
#include "tests/geometry/Solids.h"
#include "tests/geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

struct HardShape {
  const char* name;
  Mesh mesh;
};
std::vector<HardShape> solids() {
  return {{"cube", test::makeCube()}, {"plate", test::makePlate()}, {"rod", test::makeRod()}, {"L", test::makeL()},
          {"cylinder", test::makeCylinder()}, {"faceted cylinder", test::makeCylinder(12, false)}};
}

Weld weldOf(const Surface& surface) {
  std::vector<Vec3> positions;
  for (const SurfaceVertex& v : surface.vertices) positions.push_back(v.position);
  return weldPositions(positions);
}

double areaOf(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices) {
  double sum = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec3& a = positions[indices[i]];
    sum += 0.5 * glm::length(glm::cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a));
  }
  return sum;
}

TEST(HardEdges, OutsidesOfNeighboursMeetAlongEveryEdge) {
  for (const HardShape& shape : solids()) {
    const Surface surface = built(shape.mesh);
    const Weld weld = weldOf(surface);
    const auto sides = sortedSides(surface.indices, weld);
    ASSERT_EQ(sides.size() % 2, 0u) << shape.name;
    for (std::size_t i = 0; i < sides.size(); i += 2) {
      ASSERT_TRUE(sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high) << shape.name << " has a crack";
      // The outside is a straight line between what stands on its ends.
      for (const std::size_t end : {0u, 1u}) {
        const auto normalAt = [&](const TriangleSide& s) {
          return surface.vertices[surface.indices[3 * s.triangle + (s.side + (s.forwards ? end : 1 - end)) % 3]].normal;
        };
        ASSERT_EQ(normalAt(sides[i]), normalAt(sides[i + 1])) << shape.name;
      }
    }
  }
}

TEST(HardEdges, TheSkinKeepsItsShapeAndItsArea) {
  for (const HardShape& shape : solids()) {
    const RoundedMesh rounded = roundHardEdges(shape.mesh);
    ASSERT_TRUE(rounded.changed) << shape.name;
    const double area = areaOf(shape.mesh.positions, shape.mesh.indices);
    EXPECT_NEAR(areaOf(rounded.mesh.positions, rounded.mesh.indices), area, 1e-5 * area) << shape.name;
    // Corners lie where their weights say, in triangles of the same facing.
    const auto places = ofRoundedCorners(rounded, [&] {
      std::vector<Vec3> corners;
      for (const std::uint32_t v : shape.mesh.indices) corners.push_back(shape.mesh.positions[v]);
      return corners;
    }());
    for (std::size_t i = 0; i < places.size(); ++i)
      ASSERT_LT(glm::distance(places[i], rounded.mesh.positions[rounded.mesh.indices[i]]), 1e-5f) << shape.name;
  }
}

TEST(HardEdges, FacesKeepTheirNormalFurtherThanTheReachFromEveryEdge) {
  const Mesh cube = test::makeCube();
  const RoundedMesh rounded = roundHardEdges(cube);
  const float half = cube.positions[0].x < 0 ? -cube.positions[0].x : cube.positions[0].x;
  int beyond = 0, leaning = 0;
  for (std::size_t t = 0; t < rounded.triangleOf.size(); ++t) {
    const Vec3 face = cube.normals[cube.indices[3 * std::size_t{rounded.triangleOf[t]}]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = rounded.mesh.indices[3 * t + k];
      const Vec3 inside = half - glm::abs(rounded.mesh.positions[v]) + glm::abs(face) * 2.0f;
      const float distance = std::min({inside.x, inside.y, inside.z});
      if (distance > 0.99f * kEdgeReach) {
        ++beyond;
        ASSERT_LT(glm::distance(rounded.mesh.normals[v], face), 1e-6f);
      } else {
        ++leaning;
        EXPECT_LT(glm::dot(rounded.mesh.normals[v], face), 0.9999f);
      }
    }
  }
  EXPECT_GT(beyond, 0);
  EXPECT_GT(leaning, 0);
}

TEST(HardEdges, FurOnAnEdgeStandsHalfwayBetweenItsFacesAndOnACornerBetweenAllThree) {
  const RoundedMesh rounded = roundHardEdges(test::makeCube());
  const float half = glm::length(Vec3(1)) / 3.0f;
  int edges = 0, corners = 0;
  for (std::size_t v = 0; v < rounded.mesh.positions.size(); ++v) {
    const Vec3 p = rounded.mesh.positions[v];
    const Vec3 on(std::abs(p.x) > half - 1e-5f, std::abs(p.y) > half - 1e-5f, std::abs(p.z) > half - 1e-5f);
    const float count = on.x + on.y + on.z;
    // Between corners, away from the reach of both.
    const bool middle = glm::length(p * (1.0f - on)) < half - 1.01f * kEdgeReach;
    if (count < 2 || (count == 2 && !middle)) continue;
    ++(count == 2 ? edges : corners);
    EXPECT_GT(glm::dot(rounded.mesh.normals[v], glm::normalize(on * glm::sign(p))), 0.995f);
  }
  EXPECT_GT(edges + corners, 24 - 1);
}

TEST(HardEdges, FurTurnsByLittleFromOneVertexToTheNext) {
  for (const HardShape& shape : {HardShape{"cube", test::makeCube()}, HardShape{"L", test::makeL()}, HardShape{"cylinder", test::makeCylinder()}}) {
    const RoundedMesh rounded = roundHardEdges(shape.mesh);
    for (std::size_t i = 0; i < rounded.mesh.indices.size(); ++i) {
      const std::uint32_t a = rounded.mesh.indices[i], b = rounded.mesh.indices[i / 3 * 3 + (i + 1) % 3];
      // 45 degrees: what is shorter than two least steps is left as it is.
      ASSERT_GT(glm::dot(rounded.mesh.normals[a], rounded.mesh.normals[b]), 0.7f) << shape.name;
    }
  }
}

TEST(HardEdges, SmoothModelsAreLeftAsTheyAre) {
  for (const Mesh& mesh : {makeSphere(), makeTorus()}) EXPECT_FALSE(roundHardEdges(mesh).changed);
}

TEST(HardEdges, ACoarseSmoothModelIsCutWhereItsNormalsTurn) {
  Mesh cube = test::makeCube();
  computeNormals(cube);  // one a position
  const RoundedMesh rounded = roundHardEdges(cube);
  ASSERT_TRUE(rounded.changed);
  for (std::size_t v = 0; v < cube.positions.size(); ++v) EXPECT_EQ(rounded.mesh.normals[v], cube.normals[v]);
  for (std::size_t i = 0; i < rounded.mesh.indices.size(); ++i) {
    const std::uint32_t a = rounded.mesh.indices[i], b = rounded.mesh.indices[i / 3 * 3 + (i + 1) % 3];
    ASSERT_GT(glm::dot(rounded.mesh.normals[a], rounded.mesh.normals[b]), 0.9f);
  }
}

TEST(HardEdges, ASheetsCoatIsClosedAtItsRimAndAHolesIsNot) {
  const Surface sheet = built(test::makeSheet());
  EXPECT_TRUE(sheet.sheets);
  int rim = 0;
  for (const SurfaceVertex& v : sheet.vertices) {
    const bool onRim = std::abs(v.position.x) > 0.8191f || std::abs(v.position.y) > 0.5733f;
    if (!onRim) continue;
    ++rim;
    EXPECT_NEAR(v.normal.z, 0, 1e-5f) << "down to the skin";
    EXPECT_GT(glm::dot(v.normal, glm::normalize(v.position)), 0.1f) << "outwards";
  }
  EXPECT_GT(rim, 8);
  // A sphere without a cap.
  Mesh open = makeSphere();
  open.uv.clear();
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < open.indices.size(); i += 3)
    if (std::max({open.positions[open.indices[i]].y, open.positions[open.indices[i + 1]].y, open.positions[open.indices[i + 2]].y}) < 0.8f)
      kept.insert(kept.end(), open.indices.begin() + static_cast<std::ptrdiff_t>(i), open.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  open.indices = kept;
  EXPECT_FALSE(roundHardEdges(open).changed);
}

TEST(HardEdges, ManyFacetsCostNoMoreThanTheBudget) {
  // A model in thousands of boxes, large and small, each with twelve edges.
  Mesh mesh;
  for (int i = 0; i < 4000; ++i) {
    Mesh box = test::makeCube();
    const float size = i < 100 ? 0.5f : 0.02f;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p : box.positions) mesh.positions.push_back(p * size + Vec3(static_cast<float>(i % 20), static_cast<float>(i / 20 % 20), static_cast<float>(i / 400)) * 0.0517f);
    mesh.normals.insert(mesh.normals.end(), box.normals.begin(), box.normals.end());
    for (const std::uint32_t v : box.indices) mesh.indices.push_back(first + v);
  }
  const RoundedMesh rounded = roundHardEdges(mesh);
  EXPECT_GT(rounded.inserted.size(), kMostInserted / 2);
  EXPECT_LE(rounded.inserted.size(), kMostInserted);
  // No faster than a triangle for each side of a triangle that was cut.
  EXPECT_LE(rounded.triangleOf.size(), mesh.triangleCount() + 2 * rounded.inserted.size());
  // What is small is not cut.
  EXPECT_EQ(std::count_if(rounded.triangleOf.begin(), rounded.triangleOf.end(), [](std::uint32_t t) { return t >= 100 * 12; }), 3900 * 12);
}

TEST(HardEdges, CoordinatesAndChartsRunOnOverWhatWasInserted) {
  for (const HardShape& shape : solids()) {
    Mesh mesh = shape.mesh;
    for (const Vec3& p : mesh.positions) mesh.uv.push_back(Vec2(p.x + 0.3f * p.z, p.y));  // linear over every face
    const Surface surface = built(mesh);
    for (const SurfaceVertex& v : surface.vertices)
      ASSERT_LT(glm::distance(v.uv, Vec2(v.position.x + 0.3f * v.position.z, v.position.y)), 1e-5f) << shape.name;
    const OwnSurface own = ownSurface(surface, mesh);
    ASSERT_EQ(own.surface.triangleCount(), mesh.triangleCount()) << shape.name;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const SurfaceVertex& v = own.surface.vertices[own.surface.indices[i]];
      EXPECT_EQ(v.position, mesh.positions[mesh.indices[i]]) << shape.name;
      EXPECT_LT(glm::distance(v.normal, mesh.normals[mesh.indices[i]]), 1e-6f) << shape.name << ": the file's, not the fur's";
    }
    // Each triangle has its place in the atlas within that of its own.
    double atlas = 0, ownAtlas = 0;
    const auto twice = [](const Surface& s, std::size_t i) {
      const Vec2 a = s.vertices[s.indices[i]].atlas, b = s.vertices[s.indices[i + 1]].atlas - a, c = s.vertices[s.indices[i + 2]].atlas - a;
      return static_cast<double>(b.x * c.y - b.y * c.x);
    };
    for (std::size_t i = 0; i < surface.indices.size(); i += 3) atlas += twice(surface, i);
    for (std::size_t i = 0; i < own.surface.indices.size(); i += 3) ownAtlas += twice(own.surface, i);
    EXPECT_NEAR(atlas, ownAtlas, 1e-4 * std::abs(ownAtlas)) << shape.name;
  }
}

TEST(HardEdges, FaceMappedFurIsAsDenseAsOnAPlaneAndCurvesAsMuchAsItTurns) {
  const Surface surface = built(test::makeCube());
  float most = 0;
  for (const SurfaceVertex& v : surface.vertices) {
    // At corners three faces turn to one normal by ways of their own.
    EXPECT_NEAR(glm::length(v.gradS), 1, 0.1f);
    EXPECT_NEAR(glm::length(v.gradT), 1, 0.1f);
    EXPECT_NEAR(glm::dot(v.gradS, v.normal), 0, 1e-4f);
    const float mean = 0.5f * (v.curvature.x + v.curvature.z), apart = 0.5f * (v.curvature.x - v.curvature.z);
    most = std::max(most, mean + std::sqrt(apart * apart + v.curvature.y * v.curvature.y));
  }
  // 45 degrees on either side of an edge, over the reach.
  EXPECT_GT(most, 0.8f * 0.25f * kPi / kEdgeReach);
  EXPECT_LT(most, 2.5f * 0.25f * kPi / kEdgeReach);
}

}  // namespace
}  // namespace fur::geometry
