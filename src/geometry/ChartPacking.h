// Puts charts into the unit square, all at one scale, with a gutter between them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "geometry/Charts.h"

namespace fur::geometry {

struct Placement {
  // atlas = turn * flat * scale + offset, turn = (c, s; -s, c) by rows.
  float c = 1.0f, s = 0.0f;
  float scale = 1.0f;
  Vec2 offset{0.0f};

  Vec2 apply(const Vec2& flat) const { return Vec2(c * flat.x + s * flat.y, c * flat.y - s * flat.x) * scale + offset; }
};

// The gutter, in the unit square: two texels of a 256^2 map between charts, one along the border.
inline constexpr float kGutter = 2.0f / 256.0f;

// One placement for each chart. The gutter is halved until all charts fit (a surface in thousands of pieces).
std::vector<Placement> packCharts(const Charts& charts);

}  // namespace fur::geometry
