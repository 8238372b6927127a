// What a person does to guides: one dab of a tool each; a stroke is a row of dabs.
//
// A brush is a ball in space (groom/GroomBrush.h; its normal is not asked for). What lies in it is changed with the weight w =
// strength * falloff(distance / radius); a guide as a whole has the greatest w of its line. Roots stay where they are. Guides
// that are hidden are left alone. Where a tool is not about length each segment keeps its own. A brush or number that is not
// finite does nothing. Each function returns whether anything changed, but for mirrored().
//
// Knows no skin: what is combed into it the simulation's colliders push out again.
#pragma once

#include <span>

#include "core/Result.h"
#include "groom/GroomBrush.h"
#include "hair/Guides.h"

namespace fur::hair {

inline constexpr float kLeastGuideLength = 0.02f, kMostGuideLength = 4.0f;  // model units

// Takes node 1 or above of a guide to that place, or as near to it as the chain reaches; the part before it bends (Aristidou &
// Lasenby 2011, FABRIK), the rest is drawn along. At any brush's strength; also of hidden guides, as it names one.
bool moveNode(Guides& guides, std::size_t guide, std::size_t node, const Vec3& to);

// Drags what lies in the ball along by w.
bool comb(Guides& guides, const groom::Brush& brush, const Vec3& move);
// Cuts guides off where they enter the ball, at any strength; what is left is kLeastGuideLength long at least.
bool cut(Guides& guides, const groom::Brush& brush);
// Makes guides longer by the factor, or shorter where it is below 1, by w; within kLeastGuideLength..kMostGuideLength.
bool lengthen(Guides& guides, const groom::Brush& brush, float factor);
// Towards the straight line from root to tip by w; segments in the ball alone.
bool straighten(Guides& guides, const groom::Brush& brush);
// Winds segments in the ball about the way in which they go: `turns` from root to tip, by up to `slant` radians aside.
bool curl(Guides& guides, std::span<const RootFrame> roots, const groom::Brush& brush, float turns, float slant = 0.5f);
// Turns guides about the line from root to tip, from nothing at the root to `angle` radians at the tip, by w.
bool twist(Guides& guides, const groom::Brush& brush, float angle);

// Guides in the ball take shape and length of another one by w, as it stands on the skin; `roots`: one a guide.
bool copyShape(Guides& guides, std::span<const RootFrame> roots, const groom::Brush& brush, std::size_t from);

// A plane; the normal is unit.
struct Plane {
  Vec3 point{0}, normal{1, 0, 0};
};
// The guides on the normal's side, and the same on the other side instead of those that were there. Guides whose roots lie within
// `onPlane` of the plane stay as they are. Error: too-large for more than kMostGuides.
Result<Guides> mirrored(const Guides& guides, const Plane& plane, float onPlane = 0.01f);

// Sets or clears a flag of guides in the ball, at any strength; showing reaches hidden ones as well.
bool setFlag(Guides& guides, const groom::Brush& brush, GuideFlag flag, bool on);
// Of all guides.
bool setFlag(Guides& guides, GuideFlag flag, bool on);
// Removes guides in the ball, at any strength.
bool removeGuides(Guides& guides, const groom::Brush& brush);

}  // namespace fur::hair
