// Selections for brushes. What is selected stays free and the mask protects everything else; each selection replaces the mask.
#pragma once

#include "groom/Groom.h"

namespace fur::groom {

// The part of the surface that is connected with that triangle by shared points.
void selectConnected(Groom& groom, const GroomSurface& skin, std::uint32_t triangle);
void selectType(Groom& groom, const GroomSurface& skin, int type);  // 1..kTypes
void selectLength(Groom& groom, const GroomSurface& skin, float shortest, float longest);  // shares, both included
// Where red, green, blue and opacity of the paint each differ by at most `tolerance` (0..1) from those at the atlas point.
// Places without paint match each other.
void selectPaint(Groom& groom, const GroomSurface& skin, const Vec2& atlas, float tolerance);

// Filters of the mask over a radius (model units; at least two texels): maximum, minimum and mean. Distances are in space, so
// that charts do not matter, and the other side of a thin part is left out.
void growMask(Groom& groom, const GroomSurface& skin, float radius);
void shrinkMask(Groom& groom, const GroomSurface& skin, float radius);
void smoothMask(Groom& groom, const GroomSurface& skin, float radius);

}  // namespace fur::groom
