// The outlines of the atlas's charts, as line segments.
#pragma once

#include <vector>

#include "geometry/Surface.h"

namespace fur::geometry {

// Each edge that belongs to only one triangle in the atlas, as (u, v) of its two ends, in the order of the triangles.
// Edges without length are left out.
std::vector<Vec4> atlasOutlines(const Surface& surface);

}  // namespace fur::geometry
