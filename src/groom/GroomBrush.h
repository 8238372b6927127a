// One dab of a brush on the surface. Strokes are dabs close to each other.
//
// A brush is a ball: what lies in it and does not face away from its normal is changed, by strength in its middle
// and by less towards its rim: weight w = strength * falloff(d / radius), with d the distance in space; by less where the
// groom's mask protects it. Charts and seams do not matter. Nothing happens where there is no surface, or for a brush that
// is not finite. Each function returns whether anything changed.
#pragma once

#include "groom/Groom.h"

namespace fur::groom {

// How a brush fades from its middle to its rim, in the order of the settings' "brushFalloff": (1 - x^2)^2, 1 - x, (1 - x)^2
// and 1.
enum class Falloff { Smooth, Linear, Sharp, Flat };
float falloffAt(Falloff falloff, float squared);  // squared: x^2, within 0..1

struct Brush {
  Vec3 centre{0}, normal{0, 1, 0};  // model space; the normal is unit
  float radius = 0.1f;              // model units
  float strength = 0.5f;            // 0..1
  Falloff falloff = Falloff::Smooth;
};

// --- length; lengths stay within 0..1 ---
bool trim(Groom& groom, const GroomSurface& skin, const Brush& brush);  // towards 0 by the share w
bool grow(Groom& groom, const GroomSurface& skin, const Brush& brush);  // towards 1
// What is longer than `share` comes towards it.
bool cutTo(Groom& groom, const GroomSurface& skin, const Brush& brush, float share);

// --- types; presences stay a partition of 1 ---
// 1..kTypes: the share w of what is there becomes that type. 1 is the eraser of the others.
bool paintType(Groom& groom, const GroomSurface& skin, const Brush& brush, int type);
// 2..kTypes: the share w of that type becomes type 1.
bool takeType(Groom& groom, const GroomSurface& skin, const Brush& brush, int type);

// --- shape ---
enum class ShapeChannel { Curl, Frizz, Locks };  // of Groom::shape
// Towards all of it by the share w, or towards none.
bool addShape(Groom& groom, const GroomSurface& skin, const Brush& brush, ShapeChannel channel);
bool takeShape(Groom& groom, const GroomSurface& skin, const Brush& brush, ShapeChannel channel);

// --- comb; stays across the normal and within kMaxComb ---
// Towards `direction`, whatever its length; where it points straight into the surface nothing moves.
bool comb(Groom& groom, const GroomSurface& skin, const Brush& brush, const Vec3& direction);
bool raise(Groom& groom, const GroomSurface& skin, const Brush& brush);   // towards upright
bool smooth(Groom& groom, const GroomSurface& skin, const Brush& brush);  // towards the mean of the neighbours

// --- whiskers ---
// Pulls out those whose roots lie in the ball, whatever the strength, unless the mask protects them.
bool pluck(Groom& groom, const GroomSurface& skin, const Brush& brush);

// --- paint and mask ---
// The share w of `color` (0xRRGGBB, sRGB) over what is painted; or takes the share w of the paint off.
bool paint(Groom& groom, const GroomSurface& skin, const Brush& brush, std::uint32_t color);
bool unpaint(Groom& groom, const GroomSurface& skin, const Brush& brush);
// Protects by the share w, or gives free; no mask stands in its way.
bool protect(Groom& groom, const GroomSurface& skin, const Brush& brush);
bool unprotect(Groom& groom, const GroomSurface& skin, const Brush& brush);

// What comb() leads to at a point with this normal: kMaxComb along the direction, less where they nearly meet.
Vec3 combedTo(const Vec3& direction, const Vec3& normal);

}  // namespace fur::groom
