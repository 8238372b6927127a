// The view ray in the coat's own space, tile coordinates and height: two parabolas from shell.vert. x is its length in fur lengths.
in vec4 vTile;       // xy: tile where the ray enters  zw: its way over the tile
in vec4 vTurn;       // xy: how that way turns  zw: how far strands lean
in vec4 vPath;       // xy: slope and curvature of its height  zw: how the skin's normal turns along it
in vec4 vLight;      // xyz: light in the surface's frame  w: mip level
in vec4 vView;       // xyz: eye in the surface's frame  w: N.up
in vec4 vLean;       // xy: sideways part of the tip's tangent  zw: model uv
in vec2 vLightStep;  // tile step towards the light for one fur length of height
in vec2 vStrands;    // the strands that this chart shows: from, to
in vec3 vLightSpace, vLightRay;  // in the fur's own shadow map: where the ray enters, and a fur length of it
#ifdef WET
in float vTop;
#else
flat in float vTop;  // height where the ray enters
#endif
#include "common_length.glsl"
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
in vec2 vAtlas;
in vec4 vAtlasStep;

mat2 atlasFromTile() { return mat2(vAtlasStep.xy, vAtlasStep.zw); }
vec2 atlasAt(vec2 tile) { return vAtlas + atlasFromTile() * (tile - vTile.xy); }
#endif

// Half-covered texels count as they are for this many steps a fur length, less for more. By FLIP against the
// reference: 16 and 32 are as good near, 64 is worse far. Fewer lose the tips of needles at the middle: 0.146 with 24, 0.136 with 33.
const float kReferenceSteps = 28.0;
const float kSampleStep = 0.25;  // of samples after the first: how long their steps are beside its
// A step in texels of the mip level, times stepLength, and how many there are of a fur length at least, however small the
// picture and long the steps: of three, where one looks along the strands, rays missed all of them, in a pattern of dark dots.
const float kTexelsAStep = 2.0;
const float kFewestSteps = 6.0;
// Strands that hide this much hide all. Smaller steps and more strands are further from the reference: what lies deep
// makes fur too dark.
const float kClosed = 0.65;

// Of the whole ray: set by enterCoat().
bool reachesSkin;  // or it comes out of the coat again
float end;         // where it does
vec2 foot;         // the tile there
float grown;       // how much of a coat there is there
float stepSize;
float longer;      // than is good for the picture, where the machine has too little time: at most stepLength, a factor
float lod;         // mip level
float sharp;       // pixels that a texel covers, 1 at least
float softness;    // a step's share of a reference step
float noise, between;  // chance: of the pixel; added to heights before they are rounded to a layer
float stored;      // storedLayers: a software rasteriser takes as long for a member of a block as for a dozen products

float heightAt(float x) { return vTop + x * (vPath.x + x * vPath.y); }
vec2 tileAt(float x, float h) { return vTile.xy + x * (vTile.zw + x * vTurn.xy) + vTurn.zw * (vTop * vTop - h * h); }

// How far the ray goes until it is so far down, or where it only grazes a round body, out again.
float rayTo(float depth, out bool comesThere) {
  float slope = -vPath.x, inside = slope * slope - 4.0 * vPath.y * depth;
  comesThere = slope > 0.0 && inside > 0.0;
  if (slope <= 0.0) return 0.0;
  return min(comesThere ? 2.0 * depth / (slope + sqrt(inside)) : slope / vPath.y, 6.0);
}

// Two texels of the mip level over the skin; or past strands that lie rather than stand, whichever is shorter: from above the
// ray comes past many of them. `share`: of a texel of the finest level that a texel of that level is.
float stepOver(float share) {
  float lying = clamp(3.0 * length(vLean.xy) - 2.4, 0.0, 1.0);  // none below a turn of 0.85, all from 1.3 on
  vec2 past = vTile.zw - 2.0 * lying * vTop * vPath.x * vTurn.zw;
  float texels = sqrt(max(dot(vTile.zw, vTile.zw), dot(past, past))) * tileTexels * share;
  float longest = 1.0 / (kFewestSteps * max(-vPath.x, 1.0 / kFewestSteps)), good = min(kTexelsAStep / max(texels, 1e-3), longest);
  longer = min(stepLength, longest / good);
  return good * longer;
}

// How many steps there are from x to `end`. The march counts them: a step that is tiny beside x would not change it, and a loop
// that waits for x to arrive would never end. Rounded as a number that is none, too, it is `most` at most.
int stepsTo(float end, float x, float stepSize, int most) {
  return end > x ? clamp(int(min(ceil((end - x) / stepSize), float(most))), 0, most) : 0;
}

// The chart's share where charts overlap, see geometry/FurClusters.h: blended in order.
float chartShare() {
  vec2 strands = clamp(vStrands, 0.0, 1.0);
  return (strands.y - strands.x) / max(1.0 - strands.x, 1e-3);
}

// A direction in the surface's frame where the ray is, whose normal has turned on the way.
vec3 inTurnedFrame(vec3 v, vec2 turned) {
  v += vec3(-turned * v.z, dot(turned, v.xy));
  return v * (1.5 - 0.5 * dot(v, v));  // nearly a unit: one step of Newton's makes it one
}
