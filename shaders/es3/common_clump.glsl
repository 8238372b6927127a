// Wet clumps (Silva et al. 2010, Eq. 1 and Algorithm 2), the inverse taken exactly. C++ twin: wet/Clump.h.
#include "shared/Wet.h"

// ln x for x > 0 within 1.2e-5. GPUs may be a thousandth off in log(), and a clump magnifies that tenfold.
float naturalLog(float x) {
  int bits = floatBitsToInt(x);
  float u = 2.0 * intBitsToFloat((bits & 0x7fffff) | 0x3f800000) - 3.0;
  return float((bits >> 23) - 127) * 0.69314718 +
         0.40545697 + u * (0.33333567 + u * (-0.05540979 + u * (0.01230384 + u * (-0.00346471 + u * 0.00093152))));
}

// f(h) = (1 - w) h + w (1 + ln h / ln N), h in [1/N, 1]. `least`: 1 / N; `perLog`: 1 / ln N.
float clumpProfile(float h, float w, float least, float perLog) { return (1.0 - w) * h + w * (1.0 + naturalLog(max(h, least)) * perLog); }
float clumpProfile(float h) { return clumpProfile(h, clumpShape, 1.0 / layers, 1.0 / layersLog); }

// `held`: the water that a texel of the mask holds; 1 is saturated, what is more lies on the strands as a film.
// How short fur of that length (model units) is for water, 0..1: clumps of short fur would be as round as beads.
float shortnessOf(float coat) { return smoothstep(FUR_SHORT_FROM, FUR_SHORT, clumpRadius / max(coat, 1e-5)); }

// How far clumps have closed into a sheet: not at all up to where fur is merely wet; short fur makes one sooner.
float sheetOf(float held, float shortness) {
  vec2 sheets = smoothstep(vec2(FUR_SHEET_FROM, FUR_SHORT_SHEET_FROM), vec2(1.0, FUR_SHORT_SHEET), vec2(held));
  return mix(sheets.x, sheets.y, shortness);
}

// How far clumps have closed that are so much of a sheet: short fur makes none, whatever water it holds.
float clumpsClosed(float held, float sheet, float shortness) { return mix(sheet, 1.0, shortness * smoothstep(0.0, FUR_SHORT_SHEET_FROM, held)); }
// How much of a sheet that is where its strands are seen: those of long fur stay in their clumps.
float nearSheet(float sheet, float shortness) { return sheet * mix(FUR_NEAR_SHEET, 1.0, shortness); }
// How far the strands of a clump lie up or down together, by chance, -0.5..0.5.
float chanceOfClump(vec2 centre) { return fract(dot(centre, vec2(37.3, 91.7))) - 0.5; }
// Of a strand with that number: the slope by which its normal turns. In short fur, which makes no clumps, each has a chance of its own.
float liesBy(float ofClump, float strand, float shortness) {
  return 0.5 * mix(ofClump, fract(37.3 * strand) - 0.5, shortness) + 0.3 * (strand - 0.5);
}

// The share of a strand's height at which it gets its light: the wetter, the lower, as strands that water joins shade each other.
float litLower(float held) { return mix(1.0, FUR_WET_LIT, smoothstep(FUR_WET_LIT_FROM, 1.0, held)); }

// s: the share of the way to the clump's centre that a strand has gone at height h: in little water its tip alone. A sheet opens it again.
// `profile`: clumpProfile(h).
float clumpPull(float profile, float h, float held, float sheet) {
  float deep = smoothstep(FUR_TIPS_DRAWN, FUR_ALL_DRAWN, held);
  return profile * min(held, 1.0) * (1.0 - sheet) * mix(h * h, 1.0, deep);
}
float clumpPull(float h, float held, float sheet) { return clumpPull(clumpProfile(h), h, held, sheet); }

// A clump holds smaller locks, to whose middles strands draw together once more: it splits into them at its tip.
float lockPull(float h, float held, float sheet) { return FUR_LOCK_IN_CLUMP_PULL * min(held, 1.0) * (1.0 - sheet) * h * h; }

// Of the cell of the grid that has its middle there: its fraction is chance.
float cellNumber(vec2 middle) { return dot(floor(middle), vec2(0.7548777, 0.5698403)); }
// How far fur of that length (model units) stands in tufts, 0..1; and how far those have drawn a strand to their middle at height h, which is
// by chance: `middle`, in cells. Fur as short as FUR_TUFTS_SHORT has no tufts yet and no locks in its clumps any more (lockSheet()), so that one
// grid of cells stands for both: so many along a clump's radius (locksInClump()).
float tuftsOf(float held, float coat) {
  float some = smoothstep(FUR_TUFTS_FROM, FUR_TUFTS, held) * (1.0 - smoothstep(FUR_TUFTS_LIE, FUR_NO_TUFTS, held));
  float wide = FUR_TUFT_RADIUS * clumpRadius / max(coat, 1e-5);
  return some * smoothstep(FUR_TUFTS_SHORT, 0.75, shortnessOf(coat)) * (1.0 - smoothstep(FUR_WIDE_TUFT, FUR_WIDEST_TUFT, wide));
}
float tuftPull(float h, float tufts, vec2 middle) {
  return FUR_TUFT_PULL * (1.0 - FUR_TUFTS_DIFFER * fract(cellNumber(middle))) * tufts * h * h;
}
float lockSheet(float sheet, float shortness) { return max(sheet, min(shortness / FUR_TUFTS_SHORT, 1.0)); }
float locksInClump(float shortness) { return shortness > FUR_TUFTS_SHORT ? 1.0 : FUR_LOCKS_IN_CLUMP; }

// The water by which a clump of that radius (fur lengths) draws its strands together, at most 1. In little water some clumps have formed
// (`chance`: chanceOfClump()); those are drawn together by more than there is, as half-wet hair comes to a point, not to half of one. None is
// drawn further aside than FUR_MAX_DISPLACEMENT of its length, so a large drop draws short fur together by less.
float clumpingWetness(float held, float radius, float chance) {
  float full = min(held, 1.0) * smoothstep(0.0, FUR_CLUMP_FORMS, held - FUR_CLUMPS_BEGIN - FUR_CLUMPS_APART * chance);
  return min(full * (1.0 + FUR_EARLY_CLUMPS * max(FUR_SHEET_FROM - full, 0.0)), FUR_MAX_DISPLACEMENT / max(radius, 1e-6));
}

// How far along the strand of constant length a point at height h lies that has been drawn `aside` (fur lengths): the
// outer strands of a clump end lower, which is what points it.
float alongStrand(float h, vec2 aside) { return length(vec3(aside, h)); }

// How much shorter a strand of a clump looks that is so much `soaked` (sheetOf()); `outward`: squared, 1 at the rim. Water holds the outer ones
// to the middle by their sides, their tips further down: that, too, points it.
float rimTaper(float soaked, float sheet, float outward) { return 1.0 + FUR_RIM_TAPER * soaked * (1.0 - sheet) * min(outward, 1.0); }

// Wet strands lie down the way they lean: so far aside at their tips, and no higher than upright().
vec2 wetLean(vec2 lean, float held, float sheet) {
  float much = length(lean);
  return lean * ((0.75 * min(held, 1.0) + 0.1 * sheet) * smoothstep(0.0, 0.12, much) / max(much, 1e-6));
}
float upright(float held, float sheet) {
  return 1.0 - mix(FUR_CLUMPS_SINK * min(held, 1.0), FUR_SHEET_SINKS, sheet);
}
// C++ twin in wet/Clump.h, which says more.
float wetTop(float top, float aside, float lean, float sheet) {
  return mix(min(top * length(vec2(aside, 1.0)) / length(vec2(lean + aside * top * top, top)), 1.0), top, sheet);
}

// How large a bead a strand holds at its tip, as a share of the largest alone: more and larger ones with more water; then some run down, and those left
// grow by what they held. `chance`: the strand's own.
float beadsLeft(float held) { return 1.0 - smoothstep(FUR_BEADS_RUN, FUR_NO_BEADS, held); }
float beadSize(float held, float chance) {
  float left = beadsLeft(held);
  return clamp(3.0 * (smoothstep(FUR_BEADS_FROM, FUR_BEADS, held) * left - chance), 0.0, 1.0) * pow(max(left, 0.25), -1.0 / 3.0);
}
// How far it has run down to the strand's root.
float beadRun(float held, float chance) {
  float left = beadsLeft(held);
  return clamp(1.0 - 3.0 * (left - chance), 0.0, 1.0) * clamp(4.0 - 4.0 * left, 0.0, 1.0);
}

// Where a point lies on a lock that lies from its root along `way`; `from`: the point from its root. x: along it, 0 root .. 1 tip
// y: across it, -1 .. 1 from rim to rim. `halfWidth`: at the root; it comes to a point.
vec2 onLock(vec2 from, vec2 way, float halfWidth) {
  float squared = max(dot(way, way), 1e-8), along = dot(from, way) / squared;
  return vec2(along, (way.x * from.y - way.y * from.x) * inversesqrt(squared) / (halfWidth * max((1.0 - along) * (1.0 + 0.8 * along), 1e-3)));
}

// A clump's own colour; grey where it is dry. Views only.
vec3 clumpColor(vec4 clump) {
  vec2 chance = fract(clump.xy * vec2(37.3, 91.7) + clump.yx * vec2(61.1, 23.9));
  vec3 hue = clamp(abs(fract(chance.x + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  return clump.a > 0.0 ? mix(hue, vec3(0.95), 0.6 * chance.y) : vec3(0.45);
}

const float kLastTexel = 0.99999;  // lies in the last one
// The mask's texel under the atlas point `a` as it is stored; with -1 of water beside the map.
vec4 storedAt(sampler2D mask, vec2 a) {
  vec2 inside = clamp(a, 0.0, 1.0);
  vec4 texel = texelFetch(mask, ivec2(min(inside, kLastTexel) * maskTexels), 0);
  if (a != inside) texel.a = -1.0;
  return texel;
}
// The number of the border beyond a gutter's texel; 0: none.
float borderOf(vec4 stored) { return floor(stored.y / FUR_BORDER_STEP + 0.25); }
// A clump's centre u (with the chart, chartOf()), v, radius, water held; that is below 0 beside the charts, as it is beside the map. Unfiltered:
// centres do not mix.
vec4 maskAt(sampler2D mask, vec2 a) {
  vec4 texel = storedAt(mask, a);
  texel.y -= FUR_BORDER_STEP * borderOf(texel);
  texel.z -= FUR_LYING_STEP * floor(texel.z / FUR_LYING_STEP);
  return texel;
}
// What a texel's u is stored with: of each chart another, in multiples of FUR_CHART_STEP.
float chartOf(vec4 texel) { return FUR_CHART_STEP * floor(texel.x / FUR_CHART_STEP) + 0.5 * FUR_CHART_STEP; }
// Whether a texel less a chart's number is beside that chart: another's, or none's.
bool isBeside(vec4 texel) { return texel.a < 0.0 || abs(texel.x) > 0.5 * FUR_CHART_STEP; }
// The clump that the atlas point `a` lies in: centre u, v, radius, water held.
vec4 clumpAt(sampler2D mask, vec2 a) {
  vec4 texel = maskAt(mask, a);
  texel.x -= chartOf(texel);
  return texel;
}

// Between four texels, x: the water held there; y: that by which fur lies down. Beside the charts they have -1 less than the water next to them.
vec2 filteredWater(sampler2D mask, vec2 a) {
  vec2 texel = a * maskTexels - 0.5, corner = floor(texel), part = texel - corner;
  float last = maskTexels - 1.0;
  ivec2 low = ivec2(clamp(corner, 0.0, last)), high = ivec2(clamp(corner + 1.0, 0.0, last));
  vec4 water = vec4(texelFetch(mask, low, 0).zw, texelFetch(mask, ivec2(high.x, low.y), 0).zw);
  vec4 above = vec4(texelFetch(mask, ivec2(low.x, high.y), 0).zw, texelFetch(mask, high, 0).zw);
  vec4 lying = floor(vec4(water.xz, above.xz) / FUR_LYING_STEP) / FUR_LYING_STEPS, held = vec4(water.yw, above.yw);
  held = mix(held, -1.0 - held, step(held, vec4(-1.0)));
  vec4 across = mix(vec4(held.xz, lying.xz), vec4(held.yw, lying.yw), part.x);
  return mix(across.xz, across.yw, part.y);
}

// Whether the strand that roots in the texel `home` is of the clump, 0 or 1; both less the number of its chart. Algorithm 2: a root outside the
// clump, in a dry texel or in another clump is no strand here. A root beyond the chart's border stands on the next chart, which draws the
// other half of the clump: it is one of its own.
float rootsInClump(vec4 home, vec4 clump, bool beyond) {
  vec2 apart = home.xy - clump.xy;
  return float(beyond || (home.a > 0.0 && dot(apart, apart) <= 0.25 * clump.z * clump.z));
}
// Of the strand rooted `from` the centre of the clump.
float ownClump(sampler2D mask, vec4 clump, float chart, vec2 from) {
  vec4 home = maskAt(mask, clump.xy + from);
  home.x -= chart;
  return rootsInClump(home, clump, isBeside(home));
}
// And how many of its strands are left there: cells are no circles, so beyond the radius they get fewer, and end at 1.35 times it. `outward`: squared, 1 at the rim.
float insideRim(float outward) { return clamp(2.2 - 1.2 * outward, 0.0, 1.0); }
float ownStrand(sampler2D mask, vec4 clump, float chart, vec2 from) {
  return insideRim(dot(from, from) / max(clump.z * clump.z, 1e-12)) * ownClump(mask, clump, chart, from);
}
