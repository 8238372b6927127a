// Which triangles share which edge, by welded positions.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/Weld.h"

namespace fur::geometry {

// One side of one triangle: side k runs from its corner k to its corner k + 1.
struct TriangleSide {
  std::uint32_t low, high;  // welded ends, low < high
  std::uint32_t triangle;
  std::uint32_t side;
  bool forwards;  // the triangle runs from low to high
};

// Every side, ordered by its ends and then by triangle: sides of one edge are neighbours.
std::vector<TriangleSide> sortedSides(const std::vector<std::uint32_t>& indices, const Weld& weld);

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

// 3 a triangle, one a side: the triangle across it. kNoTriangle on a boundary, on an edge of more
// than two triangles and between triangles of opposite winding.
std::vector<std::uint32_t> neighboursAcrossSides(const std::vector<TriangleSide>& sides, std::size_t triangles);

// The piece of every triangle, 0-based in order of first appearance: triangles t and across[3 t + side]
// are of one piece where joined(t, side, across[3 t + side]) says so.
std::vector<std::uint32_t> connectedPieces(const std::vector<std::uint32_t>& across,
                                           const std::function<bool(std::uint32_t, std::size_t, std::uint32_t)>& joined,
                                           std::uint32_t& count);

}  // namespace fur::geometry
