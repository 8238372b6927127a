// How a coat lies where nobody has combed it: as animals' do, from the front (+z) backwards along the body, down the sides and
// legs, and from the root of whatever else stands out of the body to its tip. A model that is no longer than it is high has no
// back to follow: its coat falls from a crown on its top, as the hair of a head does.
//
// Found on patches of the surface, about a tenth of the model wide, and from there on its points:
// 1. Where normals lack a direction there is an axis: that of a leg, a tail, a barrel. On evenly round parts there is none.
// 2. The way that fur would like to go, backwards, down and outwards along such parts, is taken as far as it runs along the axis
//    and the skin.
// 3. Neighbours are averaged. Where ways meet or part they cancel each other: there fur stands up, in crowns and partings.
//
// Only + - * / and square roots: the same bytes on every platform. Does not know bare parts, lengths or poses.
#pragma once

#include <vector>

#include "groom/Groom.h"

namespace fur::groom {

// One a point, across its normal, at most 1 long: 1 lies, 0 stands.
std::vector<Vec3> naturalLie(const geometry::Surface& surface, const SurfacePoints& points);

}  // namespace fur::groom
