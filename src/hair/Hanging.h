// Lays planted guides on the model, so that hair has a shape before anybody combs it. Hidden guides stay. Each function returns
// whether anything changed; nodes stay outside of the skin by about `clearance`, model units.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "hair/Guides.h"

namespace fur::hair {

// Turns each guide towards `down` (any length), the more the nearer its tip: 0 leaves it, 1 lets it hang from its first segment on.
// Where the skin is in its way it goes along the skin, and where that is level away from the middle of the scalp. Segments keep
// their lengths.
bool hang(Guides& guides, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& down, float share, float clearance);

// Leans guides to both sides of the plane across x through `line`, by up to `share` of a right angle where the plane meets the skin
// squarely. Shapes stay.
bool part(Guides& guides, std::span<const RootFrame> roots, const Vec3& line, float share);

// Guides go along the skin to `place`, the shortest way, and end at that share of it; their nodes are evenly spaced.
bool gather(Guides& guides, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& place, float share, float clearance);

// Guides run side by side as one round bundle along the mean of them, as far from each other as their roots are; `share` of the way
// there.
bool bundle(Guides& guides, float share);

}  // namespace fur::hair
