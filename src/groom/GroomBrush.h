// One dab of a brush on the surface. Strokes are dabs close to each other.
//
// A brush is a ball: what lies in it and does not face away from its normal is changed, by strength in its middle
// and by less towards its rim: weight w = strength (1 - (d / radius)^2)^2, with d the distance in space. Charts
// and seams do not matter. Nothing happens where there is no surface, or for a brush that is not finite. Each
// function returns whether anything changed.
#pragma once

#include "groom/Groom.h"

namespace fur::groom {

struct Brush {
  Vec3 centre{0}, normal{0, 1, 0};  // model space; the normal is unit
  float radius = 0.1f;              // model units
  float strength = 0.5f;            // 0..1
};

// --- length; lengths stay within 0..1 ---
bool trim(Groom& groom, const Ground& ground, const Brush& brush);  // towards 0 by the share w
bool grow(Groom& groom, const Ground& ground, const Brush& brush);  // towards 1

// --- types; presences stay a partition of 1 ---
// 1..kTypes: the share w of what is there becomes that type. 1 is the eraser of the others.
bool paintType(Groom& groom, const Ground& ground, const Brush& brush, int type);

// --- comb; stays across the normal and within kMaxComb ---
// Towards `direction`, whatever its length; where it points straight into the surface nothing moves.
bool comb(Groom& groom, const Ground& ground, const Brush& brush, const Vec3& direction);
bool raise(Groom& groom, const Ground& ground, const Brush& brush);   // towards upright
bool smooth(Groom& groom, const Ground& ground, const Brush& brush);  // towards the mean of the neighbours

// --- whiskers ---
// Pulls out those whose roots lie in the ball, whatever the strength.
bool pluck(Groom& groom, const Brush& brush);

// What comb() leads to at a point with this normal: kMaxComb along the direction, less where they nearly meet.
Vec3 combedTo(const Vec3& direction, const Vec3& normal);

}  // namespace fur::groom
