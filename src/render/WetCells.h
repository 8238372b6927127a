// Where the atlas is wet, coarsely: cells of which any texel of the mask is, or lies down by the water
// round it. Tells which patches of the coat can be drawn as dry fur.
#pragma once

#include <cstdint>
#include <vector>

#include "wet/MaskTexels.h"

namespace fur::render {

class WetCells {
 public:
  static constexpr int kAcross = 64;

  // What SurfaceMaps::updateMask() uploads.
  void update(const wet::MaskTexels& mask);
  // `cell`: row by row.
  bool isWet(std::uint32_t cell) const { return !wet_.empty() && wet_[cell] > 0; }
  // Another number whenever another cell is wet.
  unsigned long revision() const { return revision_; }

 private:
  int size_ = 0;
  std::vector<std::uint8_t> texels_;  // of the mask: 1 is wet
  std::vector<std::uint8_t> wet_;
  unsigned long revision_ = 0;
};

// The cells that touch the box from `low` to `high` in the atlas.
void addCells(const Vec2& low, const Vec2& high, std::vector<std::uint16_t>& cells);

}  // namespace fur::render
