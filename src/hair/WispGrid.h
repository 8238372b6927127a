// Where hair lies, for what falls on it or is pointed at it: points of its wisps in a coarse grid. The work is bounded: of many
// wisps the first ones, which are a choice by chance, stand for all.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hair/Wisps.h"

namespace fur::hair {

// Hair as it is now; all in one space.
struct ShownHair {
  std::span<const Wisp> wisps;
  std::span<const GuideNode> nodes;  // guide after guide
  int nodesEach = 0;
  WispShape shape;
};

// A point of a wisp's middle line.
struct WispSpot {
  std::uint32_t wisp = 0;
  float height = 0;  // 0 root to 1 tip
  Vec3 position{0};
};

class WispGrid {
 public:
  static constexpr std::size_t kHeights = 8, kMostSpots = 4096;
  void assign(const ShownHair& hair);

  // Calls meets(place in the cell, spots there, the chance 0..1 to hit any of them) for the cells that lie along the way until it
  // returns true.
  template <class Meets>
  void along(const Vec3& from, const Vec3& way, Meets meets) const;
  // The spot nearest to the ray's origin among those that it passes within half their wisp's width; `direction` is unit.
  std::optional<WispSpot> meet(const Vec3& origin, const Vec3& direction) const;
  // Of hair's ascending cells, all of them.
  std::span<const WispSpot> spots() const { return spots_; }

 private:
  static constexpr int kMostCells = 24;  // along a side
  // The cell of a point; none outside of the grid.
  std::optional<std::size_t> cellAt(const Vec3& point) const;

  Vec3 low_{0};
  int cells_[3] = {0, 0, 0};
  float side_ = 1;                     // of a cell
  std::vector<WispSpot> spots_;        // cell by cell
  std::vector<std::uint16_t> starts_;  // of each cell in them, and the end
  std::vector<float> density_;         // hair's area from the side, in a unit of volume
  std::vector<float> reach_;           // of each spot: about it the ray meets its wisp
};

template <class Meets>
void WispGrid::along(const Vec3& from, const Vec3& way, Meets meets) const {
  const float length = glm::length(way);
  const int steps = 1 + static_cast<int>(std::min(length / side_, 64.0f));
  for (int i = 0; i < steps; ++i) {
    const Vec3 at = from + way * ((static_cast<float>(i) + 0.5f) / static_cast<float>(steps));
    const auto cell = cellAt(at);
    if (!cell || starts_[*cell] == starts_[*cell + 1]) continue;
    const std::span<const WispSpot> there(&spots_[starts_[*cell]], static_cast<std::size_t>(starts_[*cell + 1] - starts_[*cell]));
    if (meets(at, there, density_[*cell] * length / static_cast<float>(steps))) return;
  }
}

}  // namespace fur::hair
