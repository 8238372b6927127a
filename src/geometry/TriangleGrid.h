// Finds overlaps of triangles in a plane: a uniform grid over their bounding box, and an exact test of two triangles by
// separating axes. Touching corners and shared edges do not count as overlap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::geometry {

using FlatTriangle = std::array<Vec2, 3>;

// Pairs of triangles that may be compared, for each triangle. A few dozen is usual; a fan of many thousands round one vertex
// would take all pairs: charts end as single triangles there, and uv of a file are not worth keeping.
inline constexpr std::size_t kComparisonsPerTriangle = 100;

// Rounding of coordinates of size 1 or less, times four.
inline constexpr float kTouching = 5e-7f;

// True when a and b overlap by more than `tolerance` (a length).
bool trianglesOverlap(const FlatTriangle& a, const FlatTriangle& b, float tolerance);

class TriangleGrid {
 public:
  // For about `expected` triangles inside [low, high].
  TriangleGrid(const Vec2& low, const Vec2& high, std::size_t expected, float tolerance);

  // Adds the triangle and returns true, or returns false when it overlaps one that was added before.
  bool tryAdd(const FlatTriangle& triangle);

  // Pairs of triangles compared so far, for callers that limit their work.
  std::size_t comparisons() const { return comparisons_; }

 private:
  struct Link { std::uint32_t triangle, next; };
  struct Box { Vec2 low, high; };

  template <class Visit>
  bool visitCells(const FlatTriangle& triangle, Visit visit) const;

  Vec2 low_;
  Vec2 cellsPerUnit_;
  IVec2 size_;
  float tolerance_;
  std::size_t comparisons_ = 0;
  std::uint32_t trials_ = 0;
  std::vector<std::uint32_t> heads_;  // one a cell
  std::vector<Link> links_;
  std::vector<FlatTriangle> triangles_;
  std::vector<Box> boxes_;  // of each, as most pairs are apart by their boxes
  std::vector<std::uint32_t> lastCompared_;  // the trial that last compared this triangle
};

}  // namespace fur::geometry
