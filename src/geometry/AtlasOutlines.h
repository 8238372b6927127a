// Where the charts of the atlas end, as lines over the square map.
#pragma once

#include <vector>

#include "geometry/Surface.h"

namespace fur::geometry {

// Every edge of the surface that only one triangle has in the atlas, as its two ends: (u, v, u, v). In the order of the
// triangles; none has no length.
std::vector<Vec4> atlasOutlines(const Surface& surface);

}  // namespace fur::geometry
