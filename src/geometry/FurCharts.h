// The charts of the fur domain: flat coordinates for the fur tile, one unit a model unit.
#pragma once

#include <optional>
#include <vector>

#include "geometry/Charts.h"
#include "geometry/Mesh.h"
#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// `mesh` has unit normals and only triangles with an area. If it has furUv for all vertices, finite and with an area, their
// connected components are the charts, all scaled by one factor that makes the median density one tile a model unit.
// Otherwise `mapping` decides; nothing where they are to be cut (Charts.h).
std::optional<Charts> givenFurCharts(const Mesh& mesh, const Weld& weld, FurMapping mapping);

}  // namespace fur::geometry
