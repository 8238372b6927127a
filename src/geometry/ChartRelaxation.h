// Evens out the scale of flat charts.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "geometry/Charts.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Projection shortens edges that slope. This moves the corners until edges are as long as on the surface, as far as its
// curvature allows (position-based springs, Müller et al. 2007, "Position Based Dynamics"). A chart that would fold or
// overlap is left as it was.
// A chart a step. `charts` and what they are of must outlive it.
class ChartRelaxation {
 public:
  ChartRelaxation(Charts& charts, const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices, const Weld& weld);
  // Whether that was the last.
  bool step();

 private:
  Charts& charts_;
  const std::vector<Vec3>& positions_;
  const std::vector<std::uint32_t>& indices_;
  const Weld& weld_;
  std::vector<std::vector<std::uint32_t>> trianglesOf_;
  std::vector<std::uint32_t> pointOf_;
  std::size_t chart_ = 0;
};

}  // namespace fur::geometry
