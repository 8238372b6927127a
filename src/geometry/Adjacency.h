// Which triangles share which edge, by welded positions.
#pragma once

#include <cstdint>
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

// All sides, ordered by their ends and then by triangle, so that the sides of one edge follow each other.
std::vector<TriangleSide> sortedSides(const std::vector<std::uint32_t>& indices, const Weld& weld);

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

// Three for each triangle, one for each side: the triangle across that side. kNoTriangle on a boundary, on an edge of
// more than two triangles and between triangles of opposite winding.
std::vector<std::uint32_t> neighboursAcrossSides(const std::vector<TriangleSide>& sides, std::size_t triangles);

// As below; `asked`: what joined() is given first. A function pointer, as each std::function would add to the download.
using JoinedFunction = bool (*)(const void* asked, std::uint32_t, std::size_t, std::uint32_t);
std::vector<std::uint32_t> connectedPieces(const std::vector<std::uint32_t>& across, JoinedFunction joined, const void* asked, std::uint32_t& count);

// The connected component of each triangle, 0-based in order of first appearance: triangles t and across[3 t + side]
// belong to one component when joined(t, side, across[3 t + side]) is true.
template <class Joined>
std::vector<std::uint32_t> connectedPieces(const std::vector<std::uint32_t>& across, const Joined& joined, std::uint32_t& count) {
  return connectedPieces(across, [](const void* asked, std::uint32_t t, std::size_t side, std::uint32_t other) {
    return (*static_cast<const Joined*>(asked))(t, side, other);
  }, &joined, count);
}

}  // namespace fur::geometry
