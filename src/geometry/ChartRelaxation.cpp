#include "geometry/ChartRelaxation.h"

#include <algorithm>
#include <cmath>

#include "core/Sort.h"
#include "geometry/TriangleGrid.h"

namespace fur::geometry {

namespace {

constexpr int kRounds = 80;
constexpr int kRoundsPerCheck = 8;
// Part of an edge's error that one move corrects: stiffer springs overshoot and fold steep rims.
constexpr float kStiffness = 0.4f;
// What every triangle keeps of its area.
constexpr float kLeastArea = 0.3f;

struct Spring {
  std::uint32_t a, b;
  float length;
};

// One chart with shared corners.
class Cloth {
 public:
  // `pointOf` has one slot for every welded position, kNone before and after.
  Cloth(const Charts& charts, const std::vector<std::uint32_t>& triangles, const std::vector<Vec3>& positions,
        const std::vector<std::uint32_t>& indices, const Weld& weld, std::vector<std::uint32_t>& pointOf) {
    std::vector<Spring> springs;
    for (const std::uint32_t t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& point = pointOf[weld.idOf[indices[3 * t + k]]];
        if (point == kNone) {
          point = static_cast<std::uint32_t>(points_.size());
          points_.push_back(charts.corners[3 * t + k]);
        }
        corners_.push_back(point);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners_[corners_.size() - 3 + k], b = corners_[corners_.size() - 3 + (k + 1) % 3];
        const Vec3 d = positions[indices[3 * t + k]] - positions[indices[3 * t + (k + 1) % 3]];
        springs.push_back({std::min(a, b), std::max(a, b), std::sqrt(glm::dot(d, d))});
      }
    }
    for (const std::uint32_t t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) pointOf[weld.idOf[indices[3 * t + k]]] = kNone;
    }
    const auto same = [](const Spring& x, const Spring& y) { return x.a == y.a && x.b == y.b; };
    sortStably(springs.begin(), springs.end(), [](const Spring& x, const Spring& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    springs.erase(std::unique(springs.begin(), springs.end(), same), springs.end());
    springs_ = std::move(springs);
  }

  // Goes on while no triangle turns over or becomes a needle.
  void relax() {
    const std::vector<Vec2> projected = points_;
    for (int round = 0; round < kRounds; round += kRoundsPerCheck) {
      const std::vector<Vec2> before = points_;
      relaxSomeRounds();
      if (keepsAreas(projected)) continue;
      points_ = before;
      return;
    }
  }

  bool liesFlat() const {
    Vec2 low(1e30f), high(-1e30f);
    for (const Vec2& p : points_) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const std::size_t count = corners_.size() / 3;
    TriangleGrid grid(low, high, count, kTouching);
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      const FlatTriangle flat{points_[corners_[i]], points_[corners_[i + 1]], points_[corners_[i + 2]]};
      if (!grid.tryAdd(flat)) return false;
    }
    return true;
  }

  const Vec2& corner(std::size_t i) const { return points_[corners_[i]]; }

 private:
  void relaxSomeRounds() {
    for (int round = 0; round < kRoundsPerCheck; ++round) {
      for (const Spring& spring : springs_) {
        const Vec2 d = points_[spring.b] - points_[spring.a];
        const float length = std::sqrt(glm::dot(d, d));
        if (!(length > 1e-12f)) continue;
        const Vec2 move = d * (0.5f * kStiffness * (1.0f - spring.length / length));
        points_[spring.a] += move;
        points_[spring.b] -= move;
      }
    }
  }

  // Twice the area of a triangle, whose first corner is the i-th; below 0 where it lies on its face.
  float area(const std::vector<Vec2>& points, std::size_t i) const {
    const Vec2 a = points[corners_[i + 1]] - points[corners_[i]], b = points[corners_[i + 2]] - points[corners_[i]];
    return a.x * b.y - a.y * b.x;
  }

  bool keepsAreas(const std::vector<Vec2>& projected) const {
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      if (!(area(points_, i) > kLeastArea * area(projected, i))) return false;
    }
    return true;
  }

  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<Vec2> points_;
  std::vector<std::uint32_t> corners_;  // three a triangle
  std::vector<Spring> springs_;
};

}  // namespace

ChartRelaxation::ChartRelaxation(Charts& charts, const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices,
                                 const Weld& weld)
    : charts_(charts), positions_(positions), indices_(indices), weld_(weld), trianglesOf_(charts.count), pointOf_(weld.count, 0xffffffffu) {
  for (std::uint32_t t = 0; t < charts.chartOf.size(); ++t) trianglesOf_[charts.chartOf[t]].push_back(t);
}

bool ChartRelaxation::step() {
  // One triangle lies in its own plane already.
  while (chart_ < trianglesOf_.size() && trianglesOf_[chart_].size() < 2) ++chart_;
  if (chart_ == trianglesOf_.size()) return true;
  const std::vector<std::uint32_t>& triangles = trianglesOf_[chart_++];
  Cloth cloth(charts_, triangles, positions_, indices_, weld_, pointOf_);
  cloth.relax();
  if (!cloth.liesFlat()) return false;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) charts_.corners[3 * triangles[i] + k] = cloth.corner(3 * i + k);
  }
  return false;
}

}  // namespace fur::geometry
