// Maps tile coordinates and a height in the coat to model space.
//
// This is the mapping of the shells, without layers: at height h the corners of a chart's triangles are at
// dynamics::strandPoint(), and tile coordinates are linear in between. Points outside a triangle are searched in its
// neighbours of the same chart; beyond the chart's border its outermost triangle is extended.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/BendField.h"
#include "geometry/Surface.h"

namespace fur::truth {

// A point of a fur chart: a triangle of Surface::furIndices and barycentric weights, some of which are negative beyond the
// chart's border.
struct ChartPoint {
  std::uint32_t triangle = 0;
  Vec3 weights{1, 0, 0};
};

class FurMap {
 public:
  // `length`: of the fur, model units; `tiles`: tiles per unit of the fur coordinates. Surface and bends must outlive the map.
  FurMap(const geometry::Surface& surface, std::span<const Vec4> bends, float length, float tiles,
         dynamics::BendCurve curve = dynamics::BendCurve::Arc);

  std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(surface_.furIndices.size() / 3); }
  // Tile coordinates of the triangle's corners.
  std::array<glm::dvec2, 3> corners(std::uint32_t triangle) const;
  // The point with those tile coordinates; the search starts at the triangle `from`.
  ChartPoint find(std::uint32_t from, const glm::dvec2& tile) const;

  Vec3 point(const ChartPoint& spot, float h) const;
  Vec3 normal(const ChartPoint& spot) const;  // unit
  // SurfaceVertex::strands there, not clamped.
  Vec2 strands(const ChartPoint& spot) const;
  Vec2 atlas(const ChartPoint& spot) const;
  // Of the atlas.
  std::uint32_t chart(const ChartPoint& spot) const { return corner(spot.triangle, 0).chart; }
  // A step in the atlas as one in tiles, by the triangle; none where that has no area.
  glm::dvec2 tileFromAtlas(std::uint32_t triangle, const Vec2& step) const;
  // A step along the skin, model units, as one in tiles.
  glm::dvec2 tileStep(const ChartPoint& spot, const Vec3& step) const;
  // Model units per atlas unit on the skin: the square root of the ratio of areas.
  float unitsPerAtlas(std::uint32_t triangle) const;
  // Model units per tile unit at that height: the square root of the ratio of areas.
  float scale(const ChartPoint& spot, float h) const;

 private:
  const geometry::SurfaceVertex& corner(std::uint32_t triangle, int k) const {
    return surface_.vertices[surface_.furIndices[3 * triangle + static_cast<std::uint32_t>(k)]];
  }
  Vec3 raised(std::uint32_t triangle, int k, float h) const;
  Vec3 weightsAt(std::uint32_t triangle, const glm::dvec2& tile) const;
  void joinNeighbours();

  const geometry::Surface& surface_;
  std::span<const Vec4> bends_;
  float length_, tiles_;
  dynamics::BendCurve curve_;
  std::vector<std::uint32_t> across_;  // 3 a triangle: the neighbour opposite that corner, or kNone
};

}  // namespace fur::truth
