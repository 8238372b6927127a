// Cuts a surface into charts that lie flat without overlapping, with even density and few seams.
//
// Method: regions grow over the surface, each round its own mean normal (as in variational shape approximation,
// Cohen-Steiner, Alliez, Desbrun 2004), take the teeth of their borders from one another, and are flattened by projection
// along it; two regions are joined when their union still projects without overlap. Springs then even out the scale (ChartRelaxation.h), and each chart is scaled to
// the area of its triangles. The number of comparisons is limited: where it runs out (a fan of thousands of triangles
// round one vertex) the triangles that are left become charts of their own.
// Not done: angle-preserving unwrapping; a sphere gets a few round charts, not one.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/Math.h"
#include "geometry/Weld.h"

namespace fur::geometry {

struct Charts {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> chartOf;  // one a triangle, 0-based; no chart is empty
  std::vector<Vec2> corners;           // three a triangle: flat coordinates in model units, counter-clockwise
};

// In steps of some milliseconds.
class ChartMaking {
 public:
  // `indices`: triangles of non-zero area, counter-clockwise. The same input gives the same charts on every platform. All of it must
  // outlive this.
  ChartMaking(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices, const Weld& weld);
  ~ChartMaking();
  // Whether the charts are done. Not to be called after.
  bool step();
  Charts take();

 private:
  class Maker;
  std::unique_ptr<Maker> maker_;
};

}  // namespace fur::geometry
