// Guides on a scalp that has none yet, and where guides stand on the skin.
#pragma once

#include "core/Result.h"
#include "geometry/SurfaceQuery.h"
#include "hair/Wisps.h"

namespace fur::hair {

// How the skin lies at each guide's root, on the surface as made: the nearest point of it that faces the way in which the guide
// leaves it, or of all. Tangents turn as little as they can from one place to the next: +x turned as +y turns to the normal,
// which leaves no even field at the surface's underside alone. A root that is no number gets the plain frame.
std::vector<RootFrame> rootFrames(const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Guides& guides);
// The place of the skin nearest to a root from which hair goes that way; the root itself where there is none.
Vec3 skinAt(const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& root, const Vec3& way);
// That tangent.
Vec3 evenTangent(const Vec3& normal);

// How many guides at this spacing (model units) cover the scalp.
int guidesAtSpacing(const ScalpSurface& scalp, float spacing);

// `count` guides spread over the scalp as darts are, values.guideLength long, values.nodes nodes, along the normal. `comb`: bends
// (groom/Groom.h), one a vertex of the surface as groom::restBends() gives them; empty: upright. Errors: too-large for a count
// that is not 1..kMostGuides, bad-file for a scalp that covers nothing.
Result<Guides> plantGuides(const ScalpSurface& scalp, const HairValues& values, int count, std::span<const Vec3> comb = {});

}  // namespace fur::hair
