// How the coordinates of a surface run over it: gradS, gradT and atlasFromFur of every vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Area-weighted means over `triangles` (three vertices each). The gradients are shared by all vertices of
// one fur chart at one point: across the model's uv seams, and where a chart goes over its border.
// `furChartOf` has one chart a vertex, `weld` is over the surface's vertices. `turned`: fur leans over hard edges
// (HardEdges.h), and each triangle counts as turned to the vertex's normal, so that steps are as long as on the skin.
void computeSteps(Surface& surface, const std::vector<std::uint32_t>& triangles,
                  const std::vector<std::uint32_t>& furChartOf, const Weld& weld, bool turned = false);

}  // namespace fur::geometry
