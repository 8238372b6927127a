#include "geometry/SurfaceEdges.h"

#include "core/Random.h"
#include "geometry/Adjacency.h"

namespace fur::geometry {

std::vector<SurfaceEdge> findEdges(const std::vector<SurfaceVertex>& vertices,
                                   const std::vector<std::uint32_t>& indices, const Weld& weld) {
  const auto normalOf = [&](std::uint32_t triangle) {
    const Vec3& a = vertices[indices[3 * triangle]].position;
    const Vec3& b = vertices[indices[3 * triangle + 1]].position;
    const Vec3& c = vertices[indices[3 * triangle + 2]].position;
    const glm::dvec3 cross = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    return Vec3(cross / std::sqrt(glm::dot(cross, cross)));
  };
  const std::vector<TriangleSide> sides = sortedSides(indices, weld);
  std::vector<SurfaceEdge> edges;
  edges.reserve(sides.size() / 2);
  Random random(0x66696e73);
  for (std::size_t i = 0; i < sides.size();) {
    const TriangleSide& first = sides[i];
    const bool paired = i + 1 < sides.size() && sides[i + 1].low == first.low && sides[i + 1].high == first.high;
    const Vec3 normal = normalOf(first.triangle);
    edges.push_back({indices[3 * first.triangle + first.side], indices[3 * first.triangle + (first.side + 1) % 3],
                     normal, paired ? normalOf(sides[i + 1].triangle) : -normal, random.uniform()});
    i += paired ? 2 : 1;
  }
  return edges;
}

}  // namespace fur::geometry
