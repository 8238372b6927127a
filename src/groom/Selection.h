// Selecting by what a groom is, for the brushes: what is selected stays free, the mask protects all else. Each replaces
// the mask, whole texels or, by type, as far as the type is there.
#pragma once

#include "groom/Groom.h"

namespace fur::groom {

// The part of the surface that hangs together with that triangle, by points that its triangles share.
void selectConnected(Groom& groom, const GroomSurface& skin, std::uint32_t triangle);
void selectType(Groom& groom, const GroomSurface& skin, int type);  // 1..kTypes
void selectLength(Groom& groom, const GroomSurface& skin, float shortest, float longest);  // shares, both included
// Where the paint differs from that at the atlas point by `tolerance` (0..1) at most in each of red, green, blue and how much
// of it there is. No paint is like no paint.
void selectPaint(Groom& groom, const GroomSurface& skin, const Vec2& atlas, float tolerance);

// The mask itself: what lies within `radius` (model units) of what is protected is protected, too; the same of what is free;
// and the mean over that radius. In space, so that charts do not show, and not through to the other side of a thin
// part. A radius below two texels counts as two.
void growMask(Groom& groom, const GroomSurface& skin, float radius);
void shrinkMask(Groom& groom, const GroomSurface& skin, float radius);
void smoothMask(Groom& groom, const GroomSurface& skin, float radius);

}  // namespace fur::groom
