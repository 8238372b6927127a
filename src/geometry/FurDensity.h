// How evenly the fur tile lies on a surface.
#pragma once

#include "geometry/Surface.h"

namespace fur::geometry {

// The local scale is the root of the tiles (at repeat 1) on a triangle over its area: 1 is one tile a model
// unit, 2 packs four times the strands onto the same skin.
struct FurDensity {
  float low = 0, median = 0, high = 0;  // the 5th, 50th and 95th percentile of the local scale, over the area
  // The same for the factor by which lengths change, both principal directions of every triangle counted.
  float lowLength = 0, highLength = 0;
  // The greatest ratio of the two principal directions on one triangle; infinite where one has no area.
  float worstStretch = 1;
};

// Over the true triangles; copies in the zones between charts are left out.
FurDensity measureFurDensity(const Surface& surface);

}  // namespace fur::geometry
