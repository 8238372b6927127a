// Cuts a surface into charts that lie flat without overlapping, with even density and few seams.
//
// Method: regions grow over the surface, each round its own mean normal (as in variational shape
// approximation, Cohen-Steiner, Alliez, Desbrun 2004), and lie flat by projection along it; regions
// whose union still lies flat are joined. No triangle of a chart overlaps another. Springs then even out
// the scale (ChartRelaxation.h), and each chart has the area that its triangles have. A mesh that needs too many comparisons for that (a fan of thousands of
// triangles round one vertex) ends as single triangles where the work runs out.
// Not done: no angle-preserving unwrapping; a sphere gets a few round charts, not one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "geometry/Weld.h"

namespace fur::geometry {

struct Charts {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> chartOf;  // one a triangle, 0-based, every chart has one or more
  std::vector<Vec2> corners;           // three a triangle: flat coordinates in model units, counter-clockwise
};

// `indices`: triangles of non-zero area, counter-clockwise. The same input gives the same charts on
// every platform.
Charts makeCharts(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices, const Weld& weld);

}  // namespace fur::geometry
