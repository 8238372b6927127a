#include "geometry/Weld.h"

#include <cstring>

namespace fur::geometry {

namespace {

std::uint64_t hashOf(const Vec3& p) {
  std::uint64_t hash = 0x9e3779b97f4a7c15ull;
  for (int axis = 0; axis < 3; ++axis) {
    const float value = p[axis] + 0.0f;  // -0 becomes 0
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 0xff51afd7ed558ccdull;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

Weld weldPositions(const std::vector<Vec3>& positions) {
  std::size_t capacity = 16;
  while (capacity < positions.size() * 2) capacity *= 2;
  constexpr std::uint32_t kEmpty = 0xffffffffu;
  std::vector<std::uint32_t> slots(capacity, kEmpty);  // the first vertex at a position
  Weld weld;
  weld.idOf.resize(positions.size());
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
    std::size_t slot = hashOf(positions[vertex]) & (capacity - 1);
    while (slots[slot] != kEmpty && positions[slots[slot]] != positions[vertex]) {
      slot = (slot + 1) & (capacity - 1);
    }
    if (slots[slot] == kEmpty) {
      slots[slot] = vertex;
      weld.idOf[vertex] = weld.count++;
    } else {
      weld.idOf[vertex] = weld.idOf[slots[slot]];
    }
  }
  return weld;
}

}  // namespace fur::geometry
