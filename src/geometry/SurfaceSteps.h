// The derivatives of a surface's coordinates: gradS, gradT and atlasFromFur of every vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// One id for all vertices of a fur chart with one position and one pair of fur coordinates. `furChartOf`: one for each vertex; `weld`: over
// the surface's vertices.
std::vector<std::uint32_t> furPoints(const std::vector<SurfaceVertex>& vertices, const std::vector<std::uint32_t>& furChartOf, const Weld& weld);

// Area-weighted means over `triangles`. All vertices of one of `points` get the same gradients. `turned`: fur leans over hard edges
// (HardEdges.h); then each triangle is first rotated to the vertex's normal, which keeps lengths along the skin.
void computeSteps(Surface& surface, const std::vector<std::uint32_t>& triangles, const std::vector<std::uint32_t>& points, bool turned = false);

}  // namespace fur::geometry
