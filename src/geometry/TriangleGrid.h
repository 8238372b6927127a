// Which triangles of a plane overlap: a uniform grid over their bounding box, and an exact test of
// two triangles by separating axes. Corners that touch and shared edges are no overlap.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::geometry {

using FlatTriangle = std::array<Vec2, 3>;

// True when the insides of a and b overlap by more than `tolerance` (a length in their plane).
bool trianglesOverlap(const FlatTriangle& a, const FlatTriangle& b, float tolerance);

class TriangleGrid {
 public:
  // For about `expected` triangles inside [low, high].
  TriangleGrid(const Vec2& low, const Vec2& high, std::size_t expected, float tolerance);

  // Adds the triangle and returns true, or returns false when it overlaps one that is in already.
  bool tryAdd(const FlatTriangle& triangle);

  // Meetings of two triangles in a cell so far: what a caller bounds its work by.
  std::size_t comparisons() const { return comparisons_; }

 private:
  struct Link { std::uint32_t triangle, next; };

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
  std::vector<std::uint32_t> lastCompared_;  // the trial that last met this triangle
};

}  // namespace fur::geometry
