// Lets planted guides hang on the model, so that hair has a shape before anybody combs it.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "hair/Guides.h"

namespace fur::hair {

// Turns each guide towards `down` (any length), the more the nearer its tip: 0 leaves it, 1 lets it hang from its first segment on.
// Segments keep their lengths, nodes stay outside of the skin by about `clearance`, model units. Hidden guides stay. Whether anything changed.
bool hang(Guides& guides, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& down, float share, float clearance);

}  // namespace fur::hair
