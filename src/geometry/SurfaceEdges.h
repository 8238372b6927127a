// The edges of a surface, for fins: see SurfaceEdge.
#pragma once

#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// `weld` is over the surface's vertices. Where more than two faces meet they are paired in order,
// and an odd one counts as a boundary.
std::vector<SurfaceEdge> findEdges(const std::vector<SurfaceVertex>& vertices,
                                   const std::vector<std::uint32_t>& indices, const Weld& weld);

}  // namespace fur::geometry
