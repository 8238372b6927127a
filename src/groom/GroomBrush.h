// One dab of a brush on the surface; a stroke is a row of dabs.
//
// A brush is a ball in space. It changes what lies in it and does not face away from its normal, with the weight
// w = strength * falloff(distance / radius), less where the groom's mask protects. Charts and seams do not matter. A brush
// that is not finite or touches no surface does nothing. Each function returns whether anything changed.
#pragma once

#include "groom/Groom.h"

namespace fur::groom {

// In the order of the setting "brushFalloff": (1 - x^2)^2, 1 - x, (1 - x)^2 and 1.
enum class Falloff { Smooth, Linear, Sharp, Flat };
float falloffAt(Falloff falloff, float squared);  // squared: x^2, within 0..1

struct Brush {
  Vec3 centre{0}, normal{0, 1, 0};  // model space; the normal is unit
  float radius = 0.1f;              // model units
  float strength = 0.5f;            // 0..1
  Falloff falloff = Falloff::Smooth;
};

// Its weight w at a place, 0 outside of the ball.
float weightOf(const Brush& brush, const Vec3& at);

// --- length; lengths stay within 0..1 ---
bool trim(Groom& groom, const GroomSurface& skin, const Brush& brush);  // towards 0 by w
bool grow(Groom& groom, const GroomSurface& skin, const Brush& brush);  // towards 1
// Fur longer than `share` gets nearer to it by w.
bool cutTo(Groom& groom, const GroomSurface& skin, const Brush& brush, float share);
bool setLength(Groom& groom, const GroomSurface& skin, const Brush& brush, float share);  // towards `share` by w

// --- types; presences stay a partition of 1 ---
// Turns the share w of all types into `type`, 1..kTypes. 1 erases the others.
bool paintType(Groom& groom, const GroomSurface& skin, const Brush& brush, int type);
// Turns the share w of `type`, 2..kTypes, into type 1.
bool takeType(Groom& groom, const GroomSurface& skin, const Brush& brush, int type);

// --- shape ---
enum class ShapeChannel { Curl, Frizz, Locks };  // of Groom::shape
// Towards 1 by w; or towards 0.
bool addShape(Groom& groom, const GroomSurface& skin, const Brush& brush, ShapeChannel channel);
bool takeShape(Groom& groom, const GroomSurface& skin, const Brush& brush, ShapeChannel channel);

// --- comb; stays perpendicular to the normal and within kMaxComb ---
// Towards `direction`, whose length does not matter; a direction along the normal does nothing.
bool comb(Groom& groom, const GroomSurface& skin, const Brush& brush, const Vec3& direction);
// Towards `bend`, turned across each point's normal; the point of `vertex`, which may lie beside the brush, gets it in full.
bool setComb(Groom& groom, const GroomSurface& skin, const Brush& brush, const Vec3& bend, std::uint32_t vertex);
bool raise(Groom& groom, const GroomSurface& skin, const Brush& brush);   // towards upright
bool smooth(Groom& groom, const GroomSurface& skin, const Brush& brush);  // towards the mean of the neighbours

// --- whiskers ---
// Removes whiskers whose roots lie in the ball, at any strength, unless the mask protects them.
bool pluck(Groom& groom, const GroomSurface& skin, const Brush& brush);

// --- paint and mask ---
// Blends `color` (0xRRGGBB, sRGB) over the paint by w; or removes the share w of the paint.
bool paint(Groom& groom, const GroomSurface& skin, const Brush& brush, std::uint32_t color);
bool unpaint(Groom& groom, const GroomSurface& skin, const Brush& brush);
// Raises the mask towards 1 by w, or lowers it towards 0. The mask does not protect itself.
bool protect(Groom& groom, const GroomSurface& skin, const Brush& brush);
bool unprotect(Groom& groom, const GroomSurface& skin, const Brush& brush);

// --- another map of the groom's size ---
// Moves a channel of it towards `value` by w; `mask`: the groom's.
bool paintChannel(GroomMap& map, const GroomMap& mask, const GroomSurface& skin, const Brush& brush, std::size_t channel, std::uint8_t value);

// The bend towards which comb() works at a point with this normal: kMaxComb in the direction, less where it is nearly parallel
// to the normal.
Vec3 combedTo(const Vec3& direction, const Vec3& normal);

}  // namespace fur::groom
