// What models that are shipped wear: hair, paint and whiskers, by the tools that programs have.
#pragma once

#include <string>
#include <vector>

#include "core/Result.h"
#include "geometry/Surface.h"
#include "scene/FurData.h"

// Each step is one of
//   plant,120  hang,0.8,0,-1,-0.3     an edit of long hair, as --hair and the element's hair() have them
//   guideLength=0.5                   a value of the selected scalp, as --hair-value
//   dab #RRGGBB STRENGTH RADIUS X Y Z paint in a ball, on skin that faces the way it lies
//   shade #RRGGBB STRENGTH            paint where the selected scalp is
//   soften DISTANCE                   wisps of the selected scalp get sparse, thin and short up to so far from its border
//   whisker #RRGGBB LENGTH WIDTH X Y Z DX DY DZ
fur::Status dress(const fur::geometry::Mesh& mesh, const fur::geometry::Surface& surface, const std::vector<std::string>& steps, fur::scene::FurData& out);
