// How wet the ground under the model is, for who makes it wet (Water.h) and who draws it.
#pragma once

#include <cstdint>
#include <span>

namespace fur::wet {

// Cells over [-kGroundReach, kGroundReach] in the world's x and z, row by row of z.
inline constexpr int kGroundCells = 128;
inline constexpr float kGroundReach = 3.2f;

// How wet a cell looks, 0..1, that has so much water on a square unit.
inline float seenOfPuddle(float water) { return water < 2 ? 0.5f * water : 1; }

struct Puddles {
  std::span<const std::uint8_t> cells;  // 0..255 each; none: it is dry
  std::uint32_t revision = 0;           // another number when they are others; 0: none yet

  bool empty() const { return cells.empty(); }
};

}  // namespace fur::wet
