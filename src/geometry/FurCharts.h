// The charts of the fur domain: flat coordinates for the fur tile, one unit a model unit.
#pragma once

#include <vector>

#include "geometry/Charts.h"
#include "geometry/Mesh.h"
#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// `mesh` has unit normals and only triangles with an area. Its own furUv, when there is one for every
// vertex, all are finite and they have an area: pieces that are connected in them are charts, scaled
// together so that the median density over the area is one tile a model unit. Else as `mapping` says.
Charts furCharts(const Mesh& mesh, const Weld& weld, FurMapping mapping);

}  // namespace fur::geometry
