#include "geometry/TriangleGrid.h"

#include <algorithm>
#include <cmath>

namespace fur::geometry {

namespace {

constexpr std::uint32_t kNoLink = 0xffffffffu;

// Is there an edge of `a` that has `b` on its outer side, but for `tolerance`?
bool separatedByAnEdge(const FlatTriangle& a, const FlatTriangle& b, double tolerance) {
  const glm::dvec2 p[3] = {a[0], a[1], a[2]};
  const glm::dvec2 d1 = p[1] - p[0], d2 = p[2] - p[0];
  const double turn = d1.x * d2.y - d1.y * d2.x >= 0.0 ? 1.0 : -1.0;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 edge = p[(k + 1) % 3] - p[k];
    const glm::dvec2 outward = glm::dvec2(edge.y, -edge.x) * turn;
    double nearest = 1e300;
    for (const Vec2& q : b) {
      nearest = std::min(nearest, glm::dot(glm::dvec2(q) - p[k], outward));
    }
    const double squaredLength = glm::dot(edge, edge);
    if (squaredLength > 0.0 && (nearest >= 0.0 || nearest * nearest <= tolerance * tolerance * squaredLength)) return true;
  }
  return false;
}

}  // namespace

bool trianglesOverlap(const FlatTriangle& a, const FlatTriangle& b, float tolerance) {
  return !separatedByAnEdge(a, b, tolerance) && !separatedByAnEdge(b, a, tolerance);
}

TriangleGrid::TriangleGrid(const Vec2& low, const Vec2& high, std::size_t expected, float tolerance)
    : low_(low), tolerance_(tolerance) {
  const Vec2 extent = glm::max(high - low, Vec2(1e-12f));
  const float cells = static_cast<float>(std::clamp<std::size_t>(expected, 1, 1u << 20));
  // Square cells where the box allows it, about one triangle in each.
  const float side = std::sqrt(extent.x * extent.y / cells);
  size_ = glm::clamp(IVec2(glm::min(extent / side, Vec2(4096.0f))) + 1, IVec2(1), IVec2(4096));
  cellsPerUnit_ = Vec2(size_) / extent;
  heads_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), kNoLink);
  triangles_.reserve(expected);
  boxes_.reserve(expected);
  lastCompared_.reserve(expected);
}

// Calls visit(cell) for the cells of every row that the triangle's slice of that row reaches;
// stops and returns false when visit does.
template <class Visit>
bool TriangleGrid::visitCells(const FlatTriangle& triangle, Visit visit) const {
  Vec2 q[3];
  for (int k = 0; k < 3; ++k) q[k] = (triangle[static_cast<std::size_t>(k)] - low_) * cellsPerUnit_;
  const auto cellOf = [](float x, int size) { return glm::clamp(static_cast<int>(std::floor(x)), 0, size - 1); };
  // A thousandth of a cell wider on each side, so that rounding loses no cell.
  const float slack = 1e-3f;
  const int y0 = cellOf(std::min({q[0].y, q[1].y, q[2].y}) - slack, size_.y);
  const int y1 = cellOf(std::max({q[0].y, q[1].y, q[2].y}) + slack, size_.y);
  for (int y = y0; y <= y1; ++y) {
    const float bottom = static_cast<float>(y) - slack, top = static_cast<float>(y + 1) + slack;
    float left = 1e30f, right = -1e30f;
    for (int k = 0; k < 3; ++k) {
      const Vec2 &a = q[k], &b = q[(k + 1) % 3];
      const float from = std::max(bottom, std::min(a.y, b.y)), to = std::min(top, std::max(a.y, b.y));
      if (from > to) continue;
      const float rise = b.y - a.y;
      if (std::abs(rise) < 1e-6f) {
        left = std::min({left, a.x, b.x});
        right = std::max({right, a.x, b.x});
        continue;
      }
      for (const float at : {from, to}) {
        const float x = a.x + (b.x - a.x) * glm::clamp((at - a.y) / rise, 0.0f, 1.0f);
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
    if (left > right) continue;
    const int x1 = cellOf(right + slack, size_.x);
    for (int x = cellOf(left - slack, size_.x); x <= x1; ++x) {
      if (!visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(x))) {
        return false;
      }
    }
  }
  return true;
}

bool TriangleGrid::tryAdd(const FlatTriangle& triangle) {
  const auto self = static_cast<std::uint32_t>(triangles_.size());
  const std::uint32_t mark = ++trials_;
  const Box box{glm::min(glm::min(triangle[0], triangle[1]), triangle[2]), glm::max(glm::max(triangle[0], triangle[1]), triangle[2])};
  const bool free = visitCells(triangle, [&](std::size_t cell) {
    for (std::uint32_t link = heads_[cell]; link != kNoLink; link = links_[link].next) {
      const std::uint32_t other = links_[link].triangle;
      ++comparisons_;
      if (lastCompared_[other] == mark) continue;
      lastCompared_[other] = mark;
      // Triangles whose boxes are apart are apart along an edge, too.
      const Box& with = boxes_[other];
      if (with.high.x < box.low.x || box.high.x < with.low.x || with.high.y < box.low.y || box.high.y < with.low.y) continue;
      if (trianglesOverlap(triangles_[other], triangle, tolerance_)) return false;
    }
    return true;
  });
  if (!free) return false;
  triangles_.push_back(triangle);
  boxes_.push_back(box);
  lastCompared_.push_back(0);
  visitCells(triangle, [&](std::size_t cell) {
    links_.push_back({self, heads_[cell]});
    heads_[cell] = static_cast<std::uint32_t>(links_.size() - 1);
    return true;
  });
  return true;
}

}  // namespace fur::geometry
