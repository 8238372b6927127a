#include "geometry/FurCharts.h"

#include <algorithm>
#include <cmath>

#include "core/Sort.h"
#include "geometry/Adjacency.h"
#include "geometry/AtlasUv.h"
#include "geometry/CubeMapping.h"

namespace fur::geometry {

namespace {

// Tiles along a model unit that half of the surface stays below; 0 when half of it has no area in furUv.
float medianDensity(const Mesh& mesh) {
  std::vector<std::pair<float, double>> scales;  // of a triangle, and its area
  double total = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t* v = &mesh.indices[i];
    const glm::dvec3 p(mesh.positions[v[0]]);
    const glm::dvec3 cross = glm::cross(glm::dvec3(mesh.positions[v[1]]) - p, glm::dvec3(mesh.positions[v[2]]) - p);
    const glm::dvec2 a(mesh.furUv[v[1]] - mesh.furUv[v[0]]), b(mesh.furUv[v[2]] - mesh.furUv[v[0]]);
    const double area = std::sqrt(glm::dot(cross, cross));
    scales.emplace_back(static_cast<float>(std::sqrt(std::abs(a.x * b.y - a.y * b.x) / area)), area);
    total += area;
  }
  sortStably(scales.begin(), scales.end());
  double sum = 0.0;
  for (const auto& [scale, area] : scales)
    if ((sum += area) >= 0.5 * total) return scale;
  return 0.0f;
}

// medianDensity() of coordinates that can serve, else 0.
float ownDensity(const Mesh& mesh) {
  if (mesh.furUv.size() != mesh.positions.size()) return 0.0f;
  const auto sane = [](const Vec2& uv) { return std::abs(uv.x) < 1e6f && std::abs(uv.y) < 1e6f; };
  if (!std::all_of(mesh.furUv.begin(), mesh.furUv.end(), sane)) return 0.0f;
  const float density = medianDensity(mesh);
  return density > 1e-6f ? density : 0.0f;
}

Charts ownCharts(const Mesh& mesh, float density, const std::vector<std::uint32_t>& across) {
  Charts charts;
  charts.chartOf = uvIslands(mesh.positions, mesh.furUv, mesh.indices, across, charts.count);
  const float tilesPerUnit = 1.0f / density;
  charts.corners.reserve(mesh.indices.size());
  for (const std::uint32_t vertex : mesh.indices) charts.corners.push_back(mesh.furUv[vertex] * tilesPerUnit);
  return charts;
}

}  // namespace

std::optional<Charts> givenFurCharts(const Mesh& mesh, const Weld& weld, FurMapping mapping) {
  const float density = ownDensity(mesh);
  if (density == 0.0f && mapping == FurMapping::Charts) return std::nullopt;
  const auto across = neighboursAcrossSides(sortedSides(mesh.indices, weld), mesh.triangleCount());
  return density > 0.0f ? ownCharts(mesh, density, across) : cubeCharts(mesh, across);
}

}  // namespace fur::geometry
