#include "geometry/Curvature.h"

#include <algorithm>
#include <cmath>

namespace fur::geometry {

namespace {

using Matrix = glm::dmat3;

// Of a triangle whose fur leans, and the least of what it weighs: beside others that do not it says nothing of the skin.
constexpr double kUprightCosine = 0.9986, kLeaningWeight = 1e-6;

// A ray goes over several triangles by the curvature where it enters the coat: by that of one vertex alone tips moved to and fro from
// triangle to triangle, and rays left the coat too early on ridges, where sky showed. With six rounds pictures are further from the reference.
constexpr int kSmoothings = 2;

struct Plane {
  glm::dvec3 facing;
  double area;
};
Plane planeOf(const SurfaceVertex* const v[3]) {
  const glm::dvec3 p(v[0]->position);
  const glm::dvec3 cross = glm::cross(glm::dvec3(v[1]->position) - p, glm::dvec3(v[2]->position) - p);
  const double length = glm::length(cross);
  return {cross / length, 0.5 * length};
}

// The symmetric operator S in the triangle's plane for which S e is how `vectors`, one a corner, change along its three sides e, least
// squares.
Matrix fit(const SurfaceVertex* const v[3], const glm::dvec3& facing, const glm::dvec3 vectors[3]) {
  const glm::dvec3 p[3] = {v[0]->position, v[1]->position, v[2]->position};
  const glm::dvec3 axisX = glm::normalize(p[1] - p[0]), axisY = glm::cross(facing, axisX);
  // Normal equations for (a, b, c) of S = (a b; b c).
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 side = p[(k + 1) % 3] - p[k];
    const glm::dvec3 turn = vectors[(k + 1) % 3] - vectors[k];
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

// Of normals. `turned` as in the header; `leans`: what it is for is so.
Matrix curvatureOf(const SurfaceVertex* const v[3], const glm::dvec3& facing, bool turned, bool& leans) {
  const glm::dvec3 mean = glm::dvec3(v[0]->normal) + glm::dvec3(v[1]->normal) + glm::dvec3(v[2]->normal);
  const Matrix upright = turned && glm::dot(mean, mean) > 1e-6 ? turnBetween(glm::normalize(mean), facing) : Matrix(1.0);
  leans = turned && glm::dot(mean, facing) < kUprightCosine * glm::length(mean);
  glm::dvec3 normals[3];
  for (int k = 0; k < 3; ++k) normals[k] = upright * glm::dvec3(v[k]->normal);
  return fit(v, facing, normals);
}

// Gives each point what the corners of the triangles round it have: sums and the areas they are of. Points on whose triangles fur leans, which
// weigh next to nothing beside others, keep what they have.
void smooth(std::vector<Matrix>& sums, std::vector<double>& areas, const std::vector<std::uint32_t>& triangles, const Weld& weld) {
  std::vector<Matrix> smoothSums(sums.size(), Matrix(0.0));
  std::vector<double> smoothAreas(sums.size(), 0.0);
  // From each corner of a triangle to each: nine pairs.
  for (std::size_t i = 0; i < 9 * (triangles.size() / 3); ++i) {
    const std::uint32_t to = weld.idOf[triangles[i / 9 * 3 + i % 3]], from = weld.idOf[triangles[i / 3]];
    smoothSums[to] += sums[from];
    smoothAreas[to] += areas[from];
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (smoothAreas[i] * std::sqrt(kLeaningWeight) < areas[i]) sums[i] = smoothSums[i], areas[i] = smoothAreas[i];
}

// What of `matrix` lies along the axes, and both at once: (ss, st, tt).
Vec3 inAxes(const Matrix& matrix, const SurfaceVertex& v) {
  Vec3 s, t;
  tangentAxes(v, s, t);
  const glm::dvec3 ds(s), dt(t);
  return Vec3(glm::dot(ds, matrix * ds), glm::dot(ds, matrix * dt), glm::dot(dt, matrix * dt));
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
    auto [facing, area] = planeOf(v);
    bool leans = false;
    const Matrix matrix = curvatureOf(v, facing, turned, leans);
    if (leans) area *= kLeaningWeight;
    for (std::size_t k = 0; k < 3; ++k) {
      const Matrix turn = turned ? turnBetween(facing, glm::dvec3(v[k]->normal)) : Matrix(1.0);
      sums[weld.idOf[triangles[i + k]]] += (turned ? turn * matrix * glm::transpose(turn) : matrix) * area;
      areas[weld.idOf[triangles[i + k]]] += area;
    }
  }
  for (int round = 0; round < kSmoothings; ++round) smooth(sums, areas, triangles, weld);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    SurfaceVertex& v = surface.vertices[i];
    const std::uint32_t id = weld.idOf[i];
    v.curvature = inAxes(areas[id] > 0.0 ? sums[id] / areas[id] : Matrix(0.0), v);
  }
}

MovingCurvature::MovingCurvature(std::span<const std::uint32_t> triangles, const std::vector<Vec3>& positions)
    : triangles_(triangles.begin(), triangles.end()), weld_(weldPositions(positions)) {}

void MovingCurvature::update(std::span<const Vec3> positions, std::span<const Vec3> normals) {
  sums_.assign(4 * std::size_t{weld_.count}, Vec3(0));
  for (std::size_t i = 0; i < triangles_.size(); i += 3) {
    const std::uint32_t* const corner = &triangles_[i];
    const Vec3 ab = positions[corner[1]] - positions[corner[0]], ac = positions[corner[2]] - positions[corner[0]], across = glm::cross(ab, ac);
    const float twice = glm::length(across);
    if (!(twice > 0.0f)) continue;
    // The reciprocal basis of the sides within their plane, times twice the area.
    const Vec3 ofAb = glm::cross(ac, across) / twice, ofAc = glm::cross(across, ab) / twice;
    const Vec3 turnedAb = normals[corner[1]] - normals[corner[0]], turnedAc = normals[corner[2]] - normals[corner[0]];
    Vec3 columns[3];
    for (int column = 0; column < 3; ++column) columns[column] = turnedAb * ofAb[column] + turnedAc * ofAc[column];
    for (int k = 0; k < 3; ++k) {
      Vec3* const sum = &sums_[4 * std::size_t{weld_.idOf[corner[k]]}];
      for (int column = 0; column < 3; ++column) sum[column] += columns[column];
      sum[3].x += twice;
    }
  }
}

Vec3 MovingCurvature::along(std::uint32_t vertex, const Vec3& s, const Vec3& t) const {
  const Vec3* const sum = &sums_[4 * std::size_t{weld_.idOf[vertex]}];
  const Vec3 ofS = sum[0] * s.x + sum[1] * s.y + sum[2] * s.z, ofT = sum[0] * t.x + sum[1] * t.y + sum[2] * t.z;
  return Vec3(glm::dot(s, ofS), 0.5f * (glm::dot(s, ofT) + glm::dot(t, ofS)), glm::dot(t, ofT)) / std::max(sum[3].x, 1e-30f);
}

void computeHessians(Surface& surface, const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& pointOf) {
  struct Sum {
    Matrix s{0.0}, t{0.0};
    double area = 0.0;
  };
  std::vector<Sum> sums(surface.vertices.size());
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const SurfaceVertex* v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = &surface.vertices[triangles[i + k]];
    const Plane plane = planeOf(v);
    glm::dvec3 s[3], t[3];
    for (int k = 0; k < 3; ++k) {
      const Matrix turn = turnBetween(glm::dvec3(v[k]->normal), plane.facing);
      s[k] = turn * glm::dvec3(v[k]->gradS);
      t[k] = turn * glm::dvec3(v[k]->gradT);
    }
    const Matrix ofS = fit(v, plane.facing, s), ofT = fit(v, plane.facing, t);
    for (std::size_t k = 0; k < 3; ++k) {
      Sum& sum = sums[pointOf[triangles[i + k]]];
      sum.s += ofS * plane.area;
      sum.t += ofT * plane.area;
      sum.area += plane.area;
    }
  }
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    SurfaceVertex& v = surface.vertices[i];
    const Sum& sum = sums[pointOf[i]];
    const double share = sum.area > 0.0 ? 1.0 / sum.area : 0.0;
    v.hessianS = inAxes(sum.s * share, v);
    v.hessianT = inAxes(sum.t * share, v);
  }
}

}  // namespace fur::geometry
