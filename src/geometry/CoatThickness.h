// How thick a coat of fur stands on a surface, and where the coats of two of its parts meet.
#pragma once

#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"

namespace fur::geometry {

// Of strands of that length; in a crease no more than 0.65 of its radius, before they would cross those of the other side.
float coatThickness(const SurfaceVertex& vertex, float furLength);

// A ray that grazes a round part of the coat comes out of it again, by the shape of the skin there. Where another part is near, as
// across the hollow of a ring, it goes on deep in that one's coat instead, whose outside it never crosses. The share of such
// rays: of some vertices, evenly spread, all ways along the outside.
float grazingShare(const Surface& surface, const SurfaceQuery& query, float furLength);

}  // namespace fur::geometry
