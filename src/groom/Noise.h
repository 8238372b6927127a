// Smooth noise in space, the same on every platform.
#pragma once

#include <cstdint>

#include "core/Math.h"

namespace fur::groom {

// A number of 0..1 for every cell of space (Wang's integer hash, chained).
inline float cellValue(int x, int y, int z, std::uint32_t seed) {
  std::uint32_t h = seed;
  for (const int c : {x, y, z}) {
    h = (h ^ 61u ^ static_cast<std::uint32_t>(c) * 0x9e3779b9u) * 9u;
    h = (h ^ (h >> 4u)) * 0x27d4eb2du;
    h ^= h >> 15u;
  }
  return static_cast<float>(h >> 8u) * (1.0f / 16777216.0f);
}

// 0..1; cells are 1 wide.
inline float noiseAt(const Vec3& at, std::uint32_t seed) {
  const Vec3 cell = glm::floor(at), part = at - cell, s = part * part * (3.0f - 2.0f * part);
  const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y), z = static_cast<int>(cell.z);
  const auto row = [&](int dy, int dz) {
    return glm::mix(cellValue(x, y + dy, z + dz, seed), cellValue(x + 1, y + dy, z + dz, seed), s.x);
  };
  return glm::mix(glm::mix(row(0, 0), row(1, 0), s.y), glm::mix(row(0, 1), row(1, 1), s.y), s.z);
}

}  // namespace fur::groom
