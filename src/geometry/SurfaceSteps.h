// The derivatives of a surface's coordinates: gradS, gradT and atlasFromFur of every vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Area-weighted means over `triangles`. All vertices of one fur chart at one position get the same gradients. `furChartOf`:
// one for each vertex; `weld`: over the surface's vertices. `turned`: fur leans over hard edges (HardEdges.h); then each
// triangle is first rotated to the vertex's normal, which keeps lengths along the skin.
void computeSteps(Surface& surface, const std::vector<std::uint32_t>& triangles,
                  const std::vector<std::uint32_t>& furChartOf, const Weld& weld, bool turned = false);

}  // namespace fur::geometry
