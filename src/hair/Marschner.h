// Light scattered by one strand: a rough glass cylinder (Marschner et al. 2003; Halen & Wester 2007, 3.2.2).
// Three ways a ray takes: R glances off, TT goes through, TRT goes through and back (p = 0, 1, 2).
//
//   S = sum over p of 1/2 M_p(theta_h) N_p(theta_d, phi_d) / cos^2 theta_d
//
// theta: angles of light and eye from the strand's normal plane, positive towards the tip;
// theta_h = (theta_i + theta_r) / 2, theta_d = (theta_r - theta_i) / 2; phi_d: angle between light and eye
// round the strand, 0: on the same side. M's integral over theta_h is 1; over theta_i, of which theta_h goes
// half, it would be 2: hence the 1/2, with which a strand that absorbs nothing gives back what it gets.
// Radians throughout. Absorption is per strand radius.
#pragma once

#include <vector>

#include "core/Math.h"

namespace fur::hair {

inline constexpr float kStrandEta = 1.55f;  // keratin (Marschner 5.1)
inline constexpr int kStrandTableM = 128;   // texels a side
inline constexpr IVec2 kStrandTableN{128, 32};

// Shifts alpha of R, TT, TRT: scales tilt towards the root (Halen's table has shift and width exchanged).
inline constexpr Vec3 kLobeShift{-0.131f, 0.0655f, 0.1965f};  // -7.5 degrees, and -1/2 and -3/2 of it
inline constexpr Vec3 kLobeWidth{1.0f, 0.5f, 2.0f};           // of beta_R

// The width at which M falls off as the highlight cos^p(2 theta_h) of Kajiya and Kay does near its top,
// within what kStrandTableM resolves.
float lobeWidth(float exponent);

// A normal distribution of theta_h round alpha with the standard deviation beta > 0.
float marschnerM(float thetaH, float alpha, float beta);

// The share of the light that leaves round the strand at phi_d, per radian; sums to at most 1 over the circle
// and p = 0..2 (the rest would be more inner reflections). TT and TRT are averaged over 3 degrees of phi_d:
// that bounds TRT at its caustics, where two of its three roots meet and the formula is infinite, keeps its
// energy, and needs no roots. 0 for any other p.
float marschnerN(int p, float thetaD, float phiD, float eta, float absorption);

// All of it on a strand of the colour `albedo`: pi S cos theta_i, to be multiplied by the light as a white
// diffuse surface would be. Light once through the strand takes the root of the albedo, so that TRT, which
// goes through twice, shows the albedo itself. T, L, V as in StrandShading.h. The shaders' twin, without
// tables. `sharpen` >= 1: wet strands have lobes narrower by its root.
Vec3 marschnerStrand(const Vec3& albedo, const Vec3& tangent, const Vec3& light, const Vec3& view,
                     float width, float sharpen);

// Texel centres of the first and last texel are the ends of each range.
// M over (sin theta_i, sin theta_r), both -1..1: r, g, b: exp(-(theta_h - alpha)^2 / 2 beta^2) of R, TT, TRT,
// of which a power is a narrower lobe; a: cos theta_d.
std::vector<Vec4> strandTableM(float width);
// N over (cos phi_d, -1..1; cos theta_d, 0..1): r, g, b: N / cos^2 theta_d of R, TT, TRT without absorption;
// a: the mean way through the strand in diameters, which colour is taken to the power of. So one table serves
// strands of every colour. cos theta_d is at least kLeastCosine in the quotient.
std::vector<Vec4> strandTableN();
inline constexpr float kLeastCosine = 0.2f;

}  // namespace fur::hair
