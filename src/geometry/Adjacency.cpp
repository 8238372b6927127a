#include "geometry/Adjacency.h"

#include <algorithm>

#include "core/Sort.h"

namespace fur::geometry {

std::vector<TriangleSide> sortedSides(const std::vector<std::uint32_t>& indices, const Weld& weld) {
  // A counting sort by the lower end (stable, so triangles stay in order), then short sorts.
  std::vector<std::uint32_t> start(weld.count + 1, 0);
  const std::size_t count = indices.size();
  const auto endsOf = [&](std::size_t i) {
    const std::size_t triangle = i / 3;
    return std::pair(weld.idOf[indices[i]], weld.idOf[indices[3 * triangle + (i + 1) % 3]]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = endsOf(i);
    ++start[std::min(a, b) + 1];
  }
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<TriangleSide> sides(count);
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = endsOf(i);
    sides[next[std::min(a, b)]++] = {std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(i / 3),
                                     static_cast<std::uint32_t>(i % 3), a < b};
  }
  for (std::size_t i = 0; i + 1 < start.size(); ++i) {
    sortStably(sides.begin() + start[i], sides.begin() + start[i + 1], [](const auto& x, const auto& y) {
      return x.high != y.high ? x.high < y.high : x.triangle != y.triangle ? x.triangle < y.triangle : x.side < y.side;
    });
  }
  return sides;
}

std::vector<std::uint32_t> neighboursAcrossSides(const std::vector<TriangleSide>& sides, std::size_t triangles) {
  std::vector<std::uint32_t> across(triangles * 3, kNoTriangle);
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].low == sides[first].low && sides[last].high == sides[first].high) ++last;
    const TriangleSide &a = sides[first], &b = sides[last - 1];
    if (last - first == 2 && a.forwards != b.forwards) {
      across[3 * a.triangle + a.side] = b.triangle;
      across[3 * b.triangle + b.side] = a.triangle;
    }
    first = last;
  }
  return across;
}

std::vector<std::uint32_t> connectedPieces(const std::vector<std::uint32_t>& across, JoinedFunction joined, const void* asked, std::uint32_t& count) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> pieces(across.size() / 3, kNone), stack;
  count = 0;
  for (std::uint32_t seed = 0; seed < pieces.size(); ++seed) {
    if (pieces[seed] != kNone) continue;
    pieces[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t other = across[3 * t + side];
        if (other == kNoTriangle || pieces[other] != kNone || !joined(asked, t, side, other)) continue;
        pieces[other] = count;
        stack.push_back(other);
      }
    }
    ++count;
  }
  return pieces;
}

}  // namespace fur::geometry
