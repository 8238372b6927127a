#include "geometry/AtlasOutlines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace fur::geometry {

namespace {

// Vertices of one place in the atlas are told by its bits: hard edges split vertices within a chart.
std::uint64_t bitsOf(Vec2 place) {
  place += 0.0f;  // -0 is 0
  std::uint64_t bits;
  static_assert(sizeof bits == sizeof place);
  std::memcpy(&bits, &place, sizeof bits);
  return bits;
}

struct Edge {
  std::uint64_t low, high;
  std::uint32_t first;  // of its corners in the indices
  bool same(const Edge& other) const { return low == other.low && high == other.high; }
};

}  // namespace

std::vector<Vec4> atlasOutlines(const Surface& surface) {
  const auto next = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  const auto place = [&](std::uint32_t corner) { return surface.vertices[surface.indices[corner]].atlas; };
  std::vector<Edge> edges;
  edges.reserve(surface.indices.size());
  for (std::uint32_t corner = 0; corner < surface.indices.size(); ++corner) {
    const std::uint64_t a = bitsOf(place(corner)), b = bitsOf(place(next(corner)));
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b), corner});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.first < b.first;
  });
  std::vector<std::uint32_t> alone;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].same(edges[i])) ++end;
    if (end - i == 1) alone.push_back(edges[i].first);
    i = end;
  }
  std::sort(alone.begin(), alone.end());
  std::vector<Vec4> out;
  out.reserve(alone.size());
  for (const std::uint32_t corner : alone) out.emplace_back(place(corner), place(next(corner)));
  return out;
}

}  // namespace fur::geometry
