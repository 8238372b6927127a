// The shape operator of smooth shapes whose curvature is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "geometry/Curvature.h"
#include "geometry/SurfaceChecks.h"

namespace fur::geometry {
namespace {

// The two principal curvatures, the greater first.
Vec2 principal(const SurfaceVertex& v) {
  const float mean = 0.5f * (v.curvature.x + v.curvature.z), half = 0.5f * (v.curvature.x - v.curvature.z);
  const float apart = std::sqrt(half * half + v.curvature.y * v.curvature.y);
  return {mean + apart, mean - apart};
}

// At the seams of a shape made by rows a fit has triangles on one side only; the rest must be right.
template <class Check>
float shareOf(const Surface& surface, Check check) {
  const auto good = std::count_if(surface.vertices.begin(), surface.vertices.end(), check);
  return static_cast<float>(good) / static_cast<float>(surface.vertices.size());
}

TEST(Curvature, OfASphereIsOneOverItsRadiusEveryWay) {
  const Surface surface = built(makeSphere());
  const float radius = glm::length(surface.vertices[0].position);
  // Facets of 5 degrees: chords are a thousandth shorter than arcs.
  EXPECT_GT(shareOf(surface, [&](const SurfaceVertex& v) {
    return glm::length(principal(v) - Vec2(1.0f / radius)) < 0.02f / radius;
  }), 0.98f);
}

TEST(Curvature, OfAPlaneIsNoneButWhereFurLeansOverItsRim) {
  std::size_t upright = 0;
  for (const SurfaceVertex& v : built(makePlane()).vertices) {
    if (v.normal.y < 0.9999f) continue;
    ASSERT_LT(glm::length(v.curvature), 1e-4f);
    ++upright;
  }
  EXPECT_GT(upright, 100u);
}

TEST(Curvature, OfATorusIsThatOfItsTubeAndTurnsHollowInside) {
  const Surface surface = built(makeTorus(144, 64));
  // The greater principal curvature is 1 / tube radius everywhere.
  std::vector<float> greater, lesser;
  for (const SurfaceVertex& v : surface.vertices) greater.push_back(principal(v).x), lesser.push_back(principal(v).y);
  std::nth_element(greater.begin(), greater.begin() + static_cast<std::ptrdiff_t>(greater.size() / 2), greater.end());
  EXPECT_LT(*std::min_element(lesser.begin(), lesser.end()), -0.5f);
  const float median = greater[greater.size() / 2];
  EXPECT_GT(shareOf(surface, [&](const SurfaceVertex& v) { return std::abs(principal(v).x - median) < 0.03f * median; }), 0.95f);
}

TEST(Curvature, OfOneVertexIsThatOfWhatLiesRoundIt) {
  Surface surface = built(makePlane());
  const auto closer = [](const SurfaceVertex& a, const SurfaceVertex& b) { return glm::length(a.position) < glm::length(b.position); };
  const Vec3 middle = std::min_element(surface.vertices.begin(), surface.vertices.end(), closer)->position;
  float side = 1e9f;
  for (const SurfaceVertex& v : surface.vertices) {
    const float apart = glm::length(v.position - middle);
    if (apart > 1e-5f) side = std::min(side, apart);
  }
  for (SurfaceVertex& v : surface.vertices)
    if (glm::length(v.position - middle) < 1e-5f) v.normal = glm::normalize(Vec3(0.1f, 1, 0));
  computeCurvature(surface, surface.indices, weldVertices(surface.vertices));
  const auto most = [&](float from, float to) {
    float found = 0;
    for (const SurfaceVertex& v : surface.vertices) {
      const float apart = glm::length(v.position - middle) / side;
      if (apart > from && apart < to) found = std::max(found, glm::length(v.curvature));
    }
    return found;
  };
  // A normal that leans by 0.1 says something of the curvature of its own triangles alone. It is shared out: no more than half of
  // 0.1 a side is left anywhere, what is left fades over three rings of vertices, and further off nothing is changed.
  EXPECT_LT(most(0.0f, 3.5f), 0.05f / side);
  EXPECT_GT(most(2.5f, 3.5f), 1e-4f / side);
  EXPECT_LT(most(2.5f, 3.5f), 0.5f * most(0.5f, 1.5f));
  EXPECT_LT(most(4.5f, 6.0f), 1e-4f);
}

TEST(Curvature, OfASurfaceThatMovesIsThatOfWhatItHasBecome) {
  const Surface surface = built(makePlane());
  std::vector<Vec3> positions, normals;
  for (const SurfaceVertex& v : surface.vertices) positions.push_back(v.position);
  MovingCurvature curvature(surface.indices, positions);
  // Rolled up round the axis z.
  constexpr float kRadius = 0.8f;
  for (Vec3& p : positions) {
    const float angle = p.x / kRadius;
    normals.emplace_back(std::sin(angle), std::cos(angle), 0);
    p = kRadius * normals.back() + Vec3(0, -kRadius, p.z);
  }
  curvature.update(positions, normals);
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const Vec3 around(normals[i].y, -normals[i].x, 0), along = curvature.along(i, around, Vec3(0, 0, 1));
    // Facets stand for arcs of a few degrees.
    ASSERT_LT(glm::length(along - Vec3(1 / kRadius, 0, 0)), 0.01f / kRadius);
  }
}

TEST(Hessians, AreTheSecondDerivativesOfFurCoordinates) {
  constexpr int kSide = 16;
  Mesh mesh;
  for (int j = 0; j <= kSide; ++j)
    for (int i = 0; i <= kSide; ++i) {
      const float x = 1.0f * static_cast<float>(i) / kSide - 0.5f, z = 1.0f * static_cast<float>(j) / kSide - 0.5f;
      mesh.positions.push_back({x, 0, z});
      mesh.normals.push_back({0, 1, 0});
      mesh.furUv.push_back({2 * x + 0.2f * x * x, -2 * z + 0.3f * x * z});
    }
  for (std::uint32_t j = 0; j < kSide; ++j)
    for (std::uint32_t i = 0; i < kSide; ++i) {
      const std::uint32_t a = j * (kSide + 1) + i, b = a + 1, c = a + kSide + 1, d = c + 1;
      for (const std::uint32_t v : {a, c, b, b, c, d}) mesh.indices.push_back(v);
    }
  const Surface surface = built(mesh);
  // Fur coordinates are scaled to the surface's size; ratios of derivatives stay.
  std::size_t inside = 0;
  for (const SurfaceVertex& v : surface.vertices) {
    if (std::max(std::abs(v.position.x), std::abs(v.position.z)) > 0.2f || v.normal.y < 0.9999f) continue;
    Vec3 s, t;
    tangentAxes(v, s, t);
    const float scale = glm::length(v.gradS) / (2 + 0.4f * v.position.x);
    const auto along = [&](const Vec3& hessian, const Vec3& way) {
      const float x = glm::dot(way, s), y = glm::dot(way, t);
      return (hessian.x * x * x + 2 * hessian.y * x * y + hessian.z * y * y) / scale;
    };
    const Vec3 diagonal = glm::normalize(Vec3(1, 0, 1));
    ASSERT_NEAR(along(v.hessianS, Vec3(1, 0, 0)), 0.4f, 0.02f);
    ASSERT_NEAR(along(v.hessianS, Vec3(0, 0, 1)), 0, 0.02f);
    ASSERT_NEAR(along(v.hessianT, Vec3(1, 0, 0)), 0, 0.02f);
    ASSERT_NEAR(along(v.hessianT, diagonal), 0.3f, 0.02f);
    ++inside;
  }
  EXPECT_GT(inside, 30u);
}

TEST(Curvature, IsTheSameForAllVerticesOfOnePoint) {
  const Surface surface = built(makeLump());
  std::vector<const SurfaceVertex*> order;
  for (const SurfaceVertex& v : surface.vertices) order.push_back(&v);
  const auto less = [](const SurfaceVertex* a, const SurfaceVertex* b) {
    return std::tie(a->position.x, a->position.y, a->position.z) < std::tie(b->position.x, b->position.y, b->position.z);
  };
  std::sort(order.begin(), order.end(), less);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (order[i]->position == order[i - 1]->position) {
      // Each is given in axes of its own; what they share does not depend on them.
      const Vec2 difference = principal(*order[i]) - principal(*order[i - 1]);
      ASSERT_LT(glm::length(difference), 1e-3f * (1.0f + std::abs(principal(*order[i]).x)));
    }
}

}  // namespace
}  // namespace fur::geometry
