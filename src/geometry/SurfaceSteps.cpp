#include "geometry/SurfaceSteps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/Sort.h"
#include "geometry/Curvature.h"

namespace fur::geometry {

namespace {

struct Gradients {
  glm::dvec3 s{0.0}, t{0.0};
  double area = 0.0;
};

// The matrix that takes fur steps to atlas steps, by columns, times the surface's area.
struct Step {
  glm::dvec4 matrix{0.0};
  double area = 0.0;
};

void addTriangle(const SurfaceVertex* const v[3], Gradients* const gradients[3], Step* const steps[3], bool turned) {
  const glm::dvec3 e1 = glm::dvec3(v[1]->position) - glm::dvec3(v[0]->position);
  const glm::dvec3 e2 = glm::dvec3(v[2]->position) - glm::dvec3(v[0]->position);
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double squared = glm::dot(normal, normal), area = 0.5 * std::sqrt(squared);
  // The vectors dual to e1 and e2 in the triangle's plane.
  const glm::dvec3 d1 = glm::cross(e2, normal) / squared, d2 = glm::cross(normal, e1) / squared;
  const glm::dvec2 f1 = glm::dvec2(v[1]->fur) - glm::dvec2(v[0]->fur), f2 = glm::dvec2(v[2]->fur) - glm::dvec2(v[0]->fur);
  const glm::dvec2 a1 = glm::dvec2(v[1]->atlas) - glm::dvec2(v[0]->atlas), a2 = glm::dvec2(v[2]->atlas) - glm::dvec2(v[0]->atlas);
  for (int k = 0; k < 3; ++k) {
    const glm::dmat3 turn = turned ? turnBetween(normal / std::sqrt(squared), glm::dvec3(v[k]->normal)) : glm::dmat3(1.0);
    gradients[k]->s += turn * (d1 * f1.x + d2 * f2.x) * area;
    gradients[k]->t += turn * (d1 * f1.y + d2 * f2.y) * area;
    gradients[k]->area += area;
  }
  const double det = f1.x * f2.y - f1.y * f2.x;
  // A triangle with hardly any area in the fur domain says nothing about steps.
  if (!(std::abs(det) > 1e-3 * area)) return;
  const glm::dvec2 perS = (a1 * f2.y - a2 * f1.y) / det, perT = (a2 * f1.x - a1 * f2.x) / det;
  for (int k = 0; k < 3; ++k) {
    steps[k]->matrix += glm::dvec4(perS, perT) * area;
    steps[k]->area += area;
  }
}

// Atlas lengths for one of the fur domain, over the whole surface.
double evenStep(const Surface& surface) {
  double fur = 0.0, atlas = 0.0;
  const auto twice = [](const Vec2& a, const Vec2& b) { return std::abs(static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x); };
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const SurfaceVertex &a = surface.vertices[surface.indices[i]], &b = surface.vertices[surface.indices[i + 1]],
                        &c = surface.vertices[surface.indices[i + 2]];
    fur += twice(b.fur - a.fur, c.fur - a.fur);
    atlas += twice(b.atlas - a.atlas, c.atlas - a.atlas);
  }
  return fur > 0.0 && atlas > 0.0 ? std::sqrt(atlas / fur) : 1.0;
}

}  // namespace

std::vector<std::uint32_t> furPoints(const std::vector<SurfaceVertex>& vertices, const std::vector<std::uint32_t>& furChartOf, const Weld& weld) {
  const auto key = [&](std::uint32_t v) {
    return std::tuple(furChartOf[v], weld.idOf[v], vertices[v].fur.x, vertices[v].fur.y);
  };
  std::vector<std::uint32_t> order(vertices.size()), points(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  sortStably(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::uint32_t point = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && key(order[i]) != key(order[i - 1])) ++point;
    points[order[i]] = point;
  }
  return points;
}

void computeSteps(Surface& surface, const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& points, bool turned) {
  std::vector<Gradients> gradients(surface.vertices.size());
  std::vector<Step> steps(surface.vertices.size());
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const SurfaceVertex* v[3];
    Gradients* gradient[3];
    Step* step[3];
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = &surface.vertices[triangles[i + k]];
      gradient[k] = &gradients[points[triangles[i + k]]];
      step[k] = &steps[triangles[i + k]];
    }
    addTriangle(v, gradient, step, turned);
  }
  const double even = evenStep(surface);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    SurfaceVertex& v = surface.vertices[i];
    const Gradients& g = gradients[points[i]];
    const double share = g.area > 0.0 ? 1.0 / g.area : 0.0;
    v.gradS = Vec3(g.s * share);
    v.gradT = Vec3(g.t * share);
    for (Vec3* gradient : {&v.gradS, &v.gradT}) *gradient -= v.normal * glm::dot(*gradient, v.normal);
    const glm::dvec4 m = steps[i].area > 0.0 ? steps[i].matrix / steps[i].area : glm::dvec4(0.0);
    // Where the coordinates fold or shrink to nothing, a plain step of the mean size stands in.
    const bool invertible = std::abs(m.x * m.w - m.y * m.z) > 1e-4 * even * even;
    v.atlasFromFur = Vec4(invertible ? m : glm::dvec4(even, 0.0, 0.0, even));
  }
}

}  // namespace fur::geometry
