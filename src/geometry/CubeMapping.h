// Fur coordinates from the faces of a cube round the model (Sheppard 2004, 2.4.1, 3.3.4 and 4.3.2).
//
// S-mapping: the six faces of the cube [least coordinate, greatest coordinate]^3. A vertex goes to the
// face that a ray from it along its normal meets first (Eq. 4.2). A triangle whose corners go to
// different faces, or that turns its back on theirs, goes to the face that its own normal matches best.
// O-mapping along the normal of the intermediate surface (3.3.4): a vertex is put on the face at
// P0 + t V (Eq. 4.3) with V the face's normal. Along the vertex's own normal (the object-normal mapping of
// Fig. 2.12) rays from a bump far below the face fan out, and its fur would be many times denser.
// Eq. 4.4 with sfact = maxDim - minDim: one tile a model unit before the repeat of the settings.
#pragma once

#include <vector>

#include "geometry/Charts.h"
#include "geometry/Mesh.h"

namespace fur::geometry {

// Each connected component on a face is a chart. Corners run counter-clockwise except where the surface folds under its
// face. `mesh` has normals; `across` is from neighboursAcrossSides().
Charts cubeCharts(const Mesh& mesh, const std::vector<std::uint32_t>& across);

}  // namespace fur::geometry
