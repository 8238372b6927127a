// One id for every distinct position, so that a surface split along uv seams is whole again.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::geometry {

struct Weld {
  std::vector<std::uint32_t> idOf;  // one per position, ids in order of first appearance
  std::uint32_t count = 0;
};

// Positions are the same when all three floats are equal (0 and -0 are): no tolerance, since a
// file that splits a vertex writes the same floats twice.
Weld weldPositions(const std::vector<Vec3>& positions);

}  // namespace fur::geometry
