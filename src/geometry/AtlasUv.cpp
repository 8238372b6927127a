#include "geometry/AtlasUv.h"

#include <cmath>

#include "geometry/Adjacency.h"
#include "geometry/TriangleGrid.h"

namespace fur::geometry {

namespace {

constexpr float kTolerance = 0.1f / 1024.0f;

}  // namespace

bool isUniqueAtlas(const Mesh& mesh, const std::vector<std::uint32_t>& indices) {
  if (mesh.uv.size() != mesh.positions.size()) return false;
  double area = 0.0, lost = 0.0;
  Vec2 low(2.0f), high(-1.0f);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const std::uint32_t* v = &indices[i];
    for (int k = 0; k < 3; ++k) {
      const Vec2& uv = mesh.uv[v[k]];
      if (!(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f)) return false;
      low = glm::min(low, uv);
      high = glm::max(high, uv);
    }
    const Vec3 cross = glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
    const Vec2 a = mesh.uv[v[1]] - mesh.uv[v[0]], b = mesh.uv[v[2]] - mesh.uv[v[0]];
    const double part = std::sqrt(glm::dot(cross, cross));
    area += part;
    if (std::abs(a.x * b.y - a.y * b.x) < 1e-10f) lost += part;
  }
  if (lost > 0.001 * area) return false;
  TriangleGrid grid(low, high, indices.size() / 3, kTolerance);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    if (!grid.tryAdd({mesh.uv[indices[i]], mesh.uv[indices[i + 1]], mesh.uv[indices[i + 2]]})) return false;
    if (grid.comparisons() > kComparisonsPerTriangle * (indices.size() / 3 + 1000)) return false;
  }
  return true;
}

std::vector<std::uint32_t> uvIslands(const std::vector<Vec3>& positions, const std::vector<Vec2>& uv,
                                     const std::vector<std::uint32_t>& indices,
                                     const std::vector<std::uint32_t>& across, std::uint32_t& count) {
  return connectedPieces(across, [&](std::uint32_t from, std::size_t side, std::uint32_t to) {
    const std::uint32_t a = indices[3 * from + side], b = indices[3 * from + (side + 1) % 3];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t c = indices[3 * to + k], d = indices[3 * to + (k + 1) % 3];
      if (positions[c] != positions[b] || positions[d] != positions[a]) continue;
      return uv[c] == uv[b] && uv[d] == uv[a];
    }
    return false;
  }, count);
}

}  // namespace fur::geometry
