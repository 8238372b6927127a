// Light on one strand, as plain numbers: the C++ twins of what the shaders do (common_shading.glsl).
// T is the unit tangent root to tip; L and V point away from the strand, towards light and eye.
#pragma once

#include "core/Math.h"

namespace fur::hair {

// sin(T, L), Kajiya & Kay 1989.
float kajiyaDiffuse(const Vec3& tangent, const Vec3& light);
// max(0, sin(T,L) sin(T,V) - (T.L)(T.V))^p. The printed forms (Halen 3.2.1, Silva Eq. 3) have L the
// way the light travels; this peaks on the cone T.V = -T.L (Sheppard Eq. 2.4).
float kajiyaSpecular(const Vec3& tangent, const Vec3& light, const Vec3& view, float exponent);
// The same of that cosine.
float kajiyaPower(float cosine, float exponent);
// What the march draws of it, without powers, in two lobes (Marschner et al. 2003 saw them; Scheuermann 2004 gave
// them to Kajiya and Kay's model): `cosine` is cos(x - shift) where x = theta_L + theta_V is 0 on that cone.
// A shift moves the highlight along the strand, positive towards the tip.
float shiftedCosine(const Vec3& tangent, const Vec3& light, const Vec3& view, float shift);
// max(0, 1 - p (1 - cosine) / 8)^8, within 0.05 of cosine^p for p >= 8; 1 at cosine 1.
float kajiyaLobe(float cosine, float exponent);
// The two shifts of a strand whose random number is 0..1: strands of one lock shine at different heights.
Vec2 lobeShifts(float strand);
// Light from behind that shines through the thin edge of the coat, relative to the light: max(0, -L.V)^4, as
// fur scatters forwards, by (1 - |N.V|)^2 h, as only the edge is thin.
float rimLight(float lightDotView, float normalDotView, float height);
// The same of a light that is always behind, narrower: of the tips along the outline alone.
float fringe(float normalDotView, float height);
// Sheppard Eq. 3.3-3.4: F = 1 - N.L, S = clamp((4 h / d - 3 F) / F); F = 0 casts no shadow: 1.
float furShadow(float height, float density, float nDotL);

// Factors of wet fur (Silva et al. 2010), rho: wetness 0..1.
// p (1 + sigma_spec (rho - 1)): dry fur has the blunter highlight (Eq. 3).
inline float wetSpecularExponent(float p, float rho, float sigmaSpec) { return p * (1.0f + sigmaSpec * (rho - 1.0f)); }
// 1 + sigma_occ (h - 1): less light reaches the roots (Eq. 5).
inline float occlusionFactor(float h, float sigmaOcc) { return 1.0f + sigmaOcc * (h - 1.0f); }
// 1 - sigma_wet rho (Eq. 5).
inline float wetDarkening(float rho, float sigmaWet) { return 1.0f - sigmaWet * rho; }
// The same by as much as strands are not white: one factor for all would make white fur grey, and markings alike.
inline Vec3 strandDarkening(const Vec3& albedo, float rho, float sigmaWet) { return 1.0f - sigmaWet * rho * (1.0f - albedo); }

// How a coat reflects light: the settings of these names; and its density.
struct StrandLook {
  float lambert = 0.4f, specular = 0.45f;
  float shininess = 60, dryShininess = 12;  // exponent p when soaked, and when dry (Eq. 3)
  float strandShadow = 0.6f;
  float occlusion = 0.6f, wetDarkening = 0.4f, wetGloss = 0.8f;  // sigma_occ, sigma_wet, sigma_spec
  float density = 0.4f;  // share of the densest layer that strands cover
};

// Eq. 2, 3 and 5 as printed: occ wet (K_color (key max(0, L.n) + around) + key K_s I_s), with n the surface's normal and I_s the power of
// `cosine` = sin(T,L) sin(T,V) - (T.L)(T.V). `key`, `around`: the light that arrives from the lamp, which the paper has alone, and from all
// round. With sigma_wet = 0 wet fur is no darker.
Vec3 printedLight(const StrandLook& look, const Vec3& albedo, const Vec3& key, const Vec3& around, float nDotL, float cosine, float height, float rho);

// The share of the light that a body's curve leaves: it shades its own far side (object over fur).
float bodyShare(float nDotL);
// The share of the key light that comes to height h of the coat on a body whose normal has that cosine to the light;
// `lit` is what the strands next to it leave.
float keyShare(const StrandLook& look, float height, float nDotL, float lit);
// The share of the light that a strand throws back as gloss. Kajiya and Kay's lobes know no surface: past the
// terminator of a coat they would glow where strands of the lit side stand in the light's way.
float glossShare(float nDotL);
// What arrives at a strand, linear.
struct StrandLight {
  Vec3 key{0};      // of the key light
  Vec3 through{0};  // of it, through the coat's edge (rimLight())
  float fill = 0;   // from the eye
  Vec3 rim{0};      // of the light behind what the eye sees (fringe())
  Vec3 sky{0};      // from all round
};
// By how much the tangent of a strand of long hair leans to the way that it is turned, -0.12 to 0.12: it is not as even as its wisp.
float strandTilt(float strand, float height);
// How much a strand mirrors on its scales. Keratin in air mirrors 0.047 of the light that comes straight at it, under water 0.006 (Fresnel's
// formula with indices of 1.55 and 1.33): an eighth, and any water makes a film. What the film itself mirrors is waterGloss().
float whiteLobe(float wetness);
// Light from strand to eye, all vectors in one frame: Kajiya & Kay 1989 with a Lambert term and the factors of Silva et
// al. 2010, Eq. 2-5; two lobes, a white one and a wider one of the strand's colour. `strand`: its random number.
Vec3 shadeStrand(const StrandLook& look, const Vec3& albedo, const Vec3& tangent, const Vec3& light, const Vec3& view,
                 float nDotL, float nDotV, float height, float wetness, const StrandLight& lights, float strand);
// Wet strands. Water lies between them with nearly their own refractive index: light goes further in before it comes
// out again, so that a wet coat is darker and its colour richer (Lekner and Dorf 1988, mirrors left out). The
// first water does most of it.
Vec3 wetAlbedo(const Vec3& albedo, float wetness);
// Of strands among others, in a coat or a mane: light that water lets from one to the next meets more of them before it comes out again. White fur stays light, and from
// black fur little comes back of what has met several strands; all between grows much darker and richer.
Vec3 wetCoatAlbedo(const Vec3& albedo, float wetness);
// The normal of a clump in the surface's frame; `outward`: from its middle, 1 at its rim. `sheet`: wet::sheetOf().
Vec3 clumpNormal(const Vec2& outward, float sheet);
// The share that a strand at `height` of a clump keeps of its light: clumps are round and stand close, so their far sides and feet get
// less, and strands that water joins shade each other the more, the wetter they are, in a sheet somewhat more. `facing`: the cosine between
// the clump's normal and the light, `risen`: by how much larger that between it and the way up is than the surface's. `keyed`: the share of
// the key light that comes there: what comes from all round, most of it from above, knows no other far sides, and comes to clumps, which stand
// apart, from more of it, the more, the wetter they are, most of all in shade, where it is all there is.
float clumpShade(float facing, float risen, float keyed, float height, float wetness, float sheet);
// What a coat sends back of light of which its strands leave each other `share`: what they take they pass on by as much as they are white, so
// that all of it comes back from white fur, and `share` from black.
Vec3 passedOn(float share, const Vec3& albedo);
// How many times as much as lights a strand water mirrors of the sky, where `keyed` is the share of the key light that comes. In water one sees the
// background, of which the setting `ambient` makes a fraction the sky's light: that shows in shade, where nothing else is mirrored.
float mirroredSky(float keyed);
// The share of the key light and the share of the sky that water mirrors to the eye off a strand of the clump with the
// normal `n`: glints that run along strands where the clump is turned to the light, more of both at grazing. Where clumps close into a sheet
// few strands glint, and those more: all of a clump together were white patches.
// `wetGloss`: sigma_spec, `exponent`: of soaked strands, `smoothness`: the share of it that is left where what is too small to be seen is turned
// to all sides: light is spread wider and is as much fainter.
Vec2 waterGloss(const Vec3& tangent, const Vec3& n, const Vec3& light, const Vec3& view, float wetness, float sheet,
                float wetGloss, float exponent, float strand, float smoothness = 1);

// Root to tip, brighter or darker from strand to strand (variance and spread in 0..1).
Vec3 strandColor(const Vec3& root, const Vec3& tip, float height, float variance, float spread);

// Linear light to linear light as a screen shows it: straight up to 0.6, then towards 1.
Vec3 toneMap(const Vec3& linear, float exposure);

}  // namespace fur::hair
