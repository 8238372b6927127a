#include "geometry/Mesh.h"

#include <algorithm>
#include <cmath>

#include "geometry/Weld.h"

namespace fur::geometry {

Bounds bounds(const Mesh& mesh) {
  Bounds box;
  if (mesh.positions.empty()) return box;
  box.low = box.high = mesh.positions[0];
  for (const Vec3& p : mesh.positions) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

bool hasArea(const Mesh& mesh, std::size_t triangle) {
  constexpr double kLeastDoubleArea = 1e-12;
  const std::uint32_t* corner = &mesh.indices[3 * triangle];
  const glm::dvec3 a = mesh.positions[corner[0]];
  const glm::dvec3 cross = glm::cross(glm::dvec3(mesh.positions[corner[1]]) - a, glm::dvec3(mesh.positions[corner[2]]) - a);
  return glm::dot(cross, cross) > kLeastDoubleArea * kLeastDoubleArea;
}

Fit fitToUnitSphere(Mesh& mesh) {
  // In double: the squares of coordinates near the limits of float would overflow.
  const Bounds box = bounds(mesh);
  const glm::dvec3 centre = (glm::dvec3(box.low) + glm::dvec3(box.high)) * 0.5;
  double squared = 0.0;
  for (const Vec3& p : mesh.positions) {
    const glm::dvec3 d = glm::dvec3(p) - centre;
    squared = std::max(squared, glm::dot(d, d));
  }
  // A mesh that was fitted before stays as it is, to the bit: what was planted on it by chance would come elsewhere.
  constexpr double kFitted = 1e-6;
  if (glm::length(centre) < kFitted && std::abs(squared - 1.0) < kFitted) return {glm::dvec3(0.0), 1.0};
  const Fit fit{centre, squared > 0.0 ? 1.0 / std::sqrt(squared) : 1.0};
  for (Vec3& p : mesh.positions) p = fit.of(p);
  return fit;
}

void computeNormals(Mesh& mesh) {
  const Weld weld = weldPositions(mesh.positions);
  std::vector<glm::dvec3> sums(weld.count, glm::dvec3(0.0));
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const std::uint32_t* corner = &mesh.indices[3 * t];
    glm::dvec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = glm::dvec3(mesh.positions[corner[k]]);
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 e1 = p[(k + 1) % 3] - p[k], e2 = p[(k + 2) % 3] - p[k];
      const double lengths = std::sqrt(glm::dot(e1, e1) * glm::dot(e2, e2));
      if (!(lengths > 0.0)) continue;
      const double angle = std::acos(glm::clamp(glm::dot(e1, e2) / lengths, -1.0, 1.0));
      sums[weld.idOf[corner[k]]] += area * angle;
    }
  }
  mesh.normals.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec3& sum = sums[weld.idOf[v]];
    const double length = std::sqrt(glm::dot(sum, sum));
    mesh.normals[v] = length > 0.0 ? Vec3(sum / length) : Vec3(0.0f, 1.0f, 0.0f);
  }
}

}  // namespace fur::geometry
