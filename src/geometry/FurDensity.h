// How evenly the fur tile lies on a surface.
#pragma once

#include "geometry/Surface.h"

namespace fur::geometry {

// The local scale is the square root of tiles (at repeat 1) per area of a triangle: at 1 a tile is one model unit long, at 2
// the same skin has four times the strands.
struct FurDensity {
  float low = 0, median = 0, high = 0;  // the 5th, 50th and 95th percentile of the local scale, over the area
  // The 5th and 95th percentile of the factor by which lengths change, over both principal directions of each triangle.
  float lowLength = 0, highLength = 0;
  // The greatest ratio of the two principal directions on one triangle; infinite where one has no area.
  float worstStretch = 1;
};

// Over the true triangles; copies in the zones between charts are left out.
FurDensity measureFurDensity(const Surface& surface);

}  // namespace fur::geometry
