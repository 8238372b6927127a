// Shapes and measures that several geometry tests share.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/Random.h"
#include "geometry/Primitives.h"
#include "geometry/Surface.h"

namespace fur::geometry {

// A closed lump with ears-like bulges, no uv: what a scan looks like.
inline Mesh makeLump(int around = 96, int down = 48) {
  Mesh mesh = makeSphere(around, down);
  mesh.uv.clear();
  for (Vec3& p : mesh.positions) {
    const Vec3 q = p * 3.0f;
    p *= 1.0f + 0.25f * std::sin(q.x) * std::cos(1.7f * q.y) + 0.15f * std::sin(2.3f * q.z + q.x);
  }
  mesh.normals.clear();
  fitToUnitSphere(mesh);
  return mesh;
}

inline Mesh withoutUv(Mesh mesh) {
  mesh.uv.clear();
  return mesh;
}

inline Surface built(const Mesh& mesh) { return buildSurface(mesh).value(); }

inline std::array<const SurfaceVertex*, 3> cornersOf(const Surface& surface, std::size_t triangle) {
  return {&surface.vertices[surface.indices[3 * triangle]], &surface.vertices[surface.indices[3 * triangle + 1]],
          &surface.vertices[surface.indices[3 * triangle + 2]]};
}

inline float areaOf(const Surface& surface, std::size_t triangle) {
  const auto v = cornersOf(surface, triangle);
  return 0.5f * glm::length(glm::cross(v[1]->position - v[0]->position, v[2]->position - v[0]->position));
}

// How often each texel centre of a size x size atlas lies inside a triangle.
inline std::vector<int> coverage(const Surface& surface, int size, std::vector<std::uint32_t>* charts = nullptr) {
  std::vector<int> counts(static_cast<std::size_t>(size * size), 0);
  if (charts) charts->assign(counts.size(), 0xffffffffu);
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto v = cornersOf(surface, t);
    glm::dvec2 p[3];
    for (int k = 0; k < 3; ++k) p[k] = glm::dvec2(v[static_cast<std::size_t>(k)]->atlas) * static_cast<double>(size);
    const glm::dvec2 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
    for (int y = std::max(0, static_cast<int>(low.y)); y < std::min(size, static_cast<int>(high.y) + 1); ++y) {
      for (int x = std::max(0, static_cast<int>(low.x)); x < std::min(size, static_cast<int>(high.x) + 1); ++x) {
        int left = 0, right = 0;
        for (int k = 0; k < 3; ++k) {
          const glm::dvec2 &a = p[k], &b = p[(k + 1) % 3];
          const double turn = (b.x - a.x) * (y + 0.5 - a.y) - (b.y - a.y) * (x + 0.5 - a.x);
          left += turn > 1e-6;
          right += turn < -1e-6;
        }
        if (left != 3 && right != 3) continue;
        const auto texel = static_cast<std::size_t>(y * size + x);
        ++counts[texel];
        if (charts) (*charts)[texel] = v[0]->chart;
      }
    }
  }
  return counts;
}

}  // namespace fur::geometry
