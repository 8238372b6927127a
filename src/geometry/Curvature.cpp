#include "geometry/Curvature.h"

#include <cmath>

namespace fur::geometry {

namespace {

using Matrix = glm::dmat3;

// Of a triangle whose fur leans, and the least of what it weighs: beside others that do not it says nothing of the skin.
constexpr double kUprightCosine = 0.9986, kLeaningWeight = 1e-6;

// The symmetric operator S in the triangle's plane for which S e = dn along its three sides, least squares.
// `turned` as in the header; `leans`: what it is for is so.
Matrix ofTriangle(const SurfaceVertex* const v[3], bool turned, double& area, glm::dvec3& facing, bool& leans) {
  const glm::dvec3 p[3] = {v[0]->position, v[1]->position, v[2]->position};
  const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double length = glm::length(cross);
  area = 0.5 * length;
  facing = cross / length;
  const glm::dvec3 mean = glm::dvec3(v[0]->normal) + glm::dvec3(v[1]->normal) + glm::dvec3(v[2]->normal);
  const Matrix upright = turned && glm::dot(mean, mean) > 1e-6 ? turnBetween(glm::normalize(mean), facing) : Matrix(1.0);
  leans = turned && glm::dot(mean, facing) < kUprightCosine * glm::length(mean);
  const glm::dvec3 axisX = glm::normalize(p[1] - p[0]), axisY = glm::cross(facing, axisX);
  // Normal equations for (a, b, c) of S = (a b; b c).
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 side = p[(k + 1) % 3] - p[k];
    const glm::dvec3 turn = upright * (glm::dvec3(v[(k + 1) % 3]->normal) - glm::dvec3(v[k]->normal));
    const double x = glm::dot(side, axisX), y = glm::dot(side, axisY);
    const glm::dvec3 rows[2] = {{x, y, 0.0}, {0.0, x, y}};
    const double values[2] = {glm::dot(turn, axisX), glm::dot(turn, axisY)};
    for (int r = 0; r < 2; ++r) normal += glm::outerProduct(rows[r], rows[r]), right += rows[r] * values[r];
  }
  const double size = normal[0][0] + normal[2][2];
  if (!(std::abs(glm::determinant(normal)) > 1e-9 * size * size * size)) return Matrix(0.0);
  const glm::dvec3 s = glm::inverse(normal) * right;
  return glm::outerProduct(axisX, axisX) * s.x + (glm::outerProduct(axisX, axisY) + glm::outerProduct(axisY, axisX)) * s.y +
         glm::outerProduct(axisY, axisY) * s.z;
}

}  // namespace

void tangentAxes(const SurfaceVertex& vertex, Vec3& s, Vec3& t) {
  const Vec3 any = std::abs(vertex.normal.x) < 0.6f ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  s = normalizeOr(vertex.gradS, glm::normalize(any - vertex.normal * glm::dot(any, vertex.normal)));
  t = glm::cross(vertex.normal, s);
}

glm::dmat3 turnBetween(const glm::dvec3& from, const glm::dvec3& to) {
  const double cosine = glm::dot(from, to);
  if (cosine < -0.9999) return glm::dmat3(1.0);
  const glm::dvec3 both = from + to;
  return glm::dmat3(1.0) - glm::outerProduct(both, both) / (1.0 + cosine) + 2.0 * glm::outerProduct(to, from);
}

void computeCurvature(Surface& surface, const std::vector<std::uint32_t>& triangles, const Weld& weld, bool turned) {
  std::vector<Matrix> sums(weld.count, Matrix(0.0));
  std::vector<double> areas(weld.count, 0.0);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const SurfaceVertex* v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = &surface.vertices[triangles[i + k]];
    double area = 0.0;
    glm::dvec3 facing;
    bool leans = false;
    const Matrix matrix = ofTriangle(v, turned, area, facing, leans);
    if (leans) area *= kLeaningWeight;
    for (std::size_t k = 0; k < 3; ++k) {
      const Matrix turn = turned ? turnBetween(facing, glm::dvec3(v[k]->normal)) : Matrix(1.0);
      sums[weld.idOf[triangles[i + k]]] += (turned ? turn * matrix * glm::transpose(turn) : matrix) * area;
      areas[weld.idOf[triangles[i + k]]] += area;
    }
  }
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    SurfaceVertex& v = surface.vertices[i];
    const std::uint32_t id = weld.idOf[i];
    const Matrix mean = areas[id] > 0.0 ? sums[id] / areas[id] : Matrix(0.0);
    Vec3 s, t;
    tangentAxes(v, s, t);
    const glm::dvec3 ds(s), dt(t);
    v.curvature = Vec3(glm::dot(ds, mean * ds), glm::dot(ds, mean * dt), glm::dot(dt, mean * dt));
  }
}

}  // namespace fur::geometry
