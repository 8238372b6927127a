// Values on a grid of cubes, and points between them.
#pragma once

#include <cstddef>

#include "core/Math.h"

namespace fur::hair {

struct CellCounts {
  int x = 0, y = 0, z = 0;
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(y) + static_cast<std::size_t>(j)) * static_cast<std::size_t>(x) + static_cast<std::size_t>(i);
  }
  std::size_t all() const { return index(0, 0, z); }
};

// Calls visit(index, weight) for the eight values round a point, which is given in cells from value (0, 0, 0) on and held to the grid;
// the weights are those of trilinear interpolation.
template <class Visit>
void forCorners(const CellCounts& cells, const Vec3& point, Visit visit) {
  const Vec3 p = glm::clamp(point, Vec3(0), Vec3(cells.x, cells.y, cells.z) - 1.001f);
  const int x = static_cast<int>(p.x), y = static_cast<int>(p.y), z = static_cast<int>(p.z);
  const Vec3 high = p - Vec3(x, y, z), low = 1.0f - high;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    visit(cells.index(x + i, y + j, z + k), (i ? high.x : low.x) * (j ? high.y : low.y) * (k ? high.z : low.z));
  }
}

}  // namespace fur::hair
