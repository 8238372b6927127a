// The shape of wet clumps, as plain numbers: the C++ twins of what the shaders do (Silva et al. 2010, Eq. 1).
//
// h: height, 0 skin .. 1 tip   w: shape, 0 = straight leaning strands, 1 = bent in from the root
// rho: wetness 0..1            N = layers
#pragma once

#include <algorithm>
#include <cmath>

#include "core/Math.h"
#include "shared/Wet.h"

namespace fur::wet {

// Soaked clumps close into a sheet from this wetness on: in a whole one nothing draws strands together. Sheets and saturated
// clumps stand by so much lower.
inline constexpr float kSheetFrom = FUR_SHEET_FROM, kSheetSinks = FUR_SHEET_SINKS, kClumpsSink = FUR_CLUMPS_SINK;

// f(h) = (1 - w) h + w (1 + ln h / ln N), h clamped to [1/N, 1]. f(1/N) = (1 - w)/N, f(1) = 1,
// monotone. One layer is the tip alone: 1.
inline float clumpProfile(float h, float w, float layers) {
  if (!(layers > 1.0f)) return 1.0f;
  const float height = glm::clamp(h, 1.0f / layers, 1.0f);
  return (1.0f - w) * height + w * std::max(1.0f + std::log(height) / std::log(layers), 0.0f);
}

// How short fur of that length is where clumps have that radius, 0..1. A clump that is as wide as its strands are long is a bead.
inline float shortnessOf(float length, float clumpRadius) {
  return glm::smoothstep(static_cast<float>(FUR_SHORT_FROM), static_cast<float>(FUR_SHORT), clumpRadius / std::max(length, 1e-5f));
}

// How far clumps have closed into a sheet, 0..1: smooth, so that nothing jumps as water comes and goes. Short fur makes a sheet
// with less water.
inline float sheetOf(float rho, float shortness = 0) {
  const float shortSheet = glm::smoothstep(static_cast<float>(FUR_SHORT_SHEET_FROM), static_cast<float>(FUR_SHORT_SHEET), rho);
  return glm::mix(glm::smoothstep(kSheetFrom, 1.0f, rho), shortSheet, shortness);
}

// How far clumps have closed that are so much of a sheet: short fur makes none, whatever water it holds, as each would cover many strands
// that it cannot draw together.
inline float clumpsClosed(float rho, float sheet, float shortness) {
  return glm::mix(sheet, 1.0f, shortness * glm::smoothstep(0.0f, static_cast<float>(FUR_SHORT_SHEET_FROM), rho));
}

// How much of a sheet it is where its strands are seen, near to the eye and in the reference: those of long fur stay in their clumps. Further off a sheet is
// drawn as one (shell_wet.glsl).
inline float nearSheet(float sheet, float shortness) {
  return sheet * glm::mix(static_cast<float>(FUR_NEAR_SHEET), 1.0f, shortness);
}

// By how much the strands of a clump lie further up or down together than others, -0.5..0.5: without it light would run in rings round a
// soaked body. `centre`: of the clump as the mask has it, less its chart. Of a strand with that number: the slope by which its normal turns.
// In short fur, which makes no clumps, each has a chance of its own.
inline float chanceOfClump(const Vec2& centre) { return glm::fract(glm::dot(centre, Vec2(37.3f, 91.7f))) - 0.5f; }
inline float liesBy(float ofClump, float strand, float shortness) {
  return 0.5f * glm::mix(ofClump, glm::fract(37.3f * strand) - 0.5f, shortness) + 0.3f * (strand - 0.5f);
}

// The share of a strand's height at which it gets its light: the wetter, the lower, as strands that water joins shade each other.
inline float litLower(float rho) { return glm::mix(1.0f, float{FUR_WET_LIT}, glm::smoothstep(float{FUR_WET_LIT_FROM}, 1.0f, rho)); }

// s: the share of the way to the clump's centre that a strand has gone at height h. From FUR_ALL_DRAWN to kSheetFrom it is f(h) rho, as
// printed; where clumps close into a sheet it falls to 0, so that it never exceeds 0.824: s / (1 - s) stays finite. Less than FUR_ALL_DRAWN draws
// at tips more than below, as a few drops do: f(h) alone opens cracks down to the skin.
inline float clumpPull(float h, float w, float layers, float rho, float sheet) {
  const float height = std::min(h, 1.0f), deep = glm::smoothstep(float{FUR_TIPS_DRAWN}, float{FUR_ALL_DRAWN}, rho);
  return clumpProfile(h, w, layers) * glm::clamp(rho, 0.0f, 1.0f) * (1.0f - sheet) * glm::mix(height * height, 1.0f, deep);
}
inline float clumpPull(float h, float w, float layers, float rho) { return clumpPull(h, w, layers, rho, sheetOf(rho)); }

// The wetness that counts for the pull of a clump of that radius (fur lengths), at most 1. Silva Eq. 1 takes rho itself, which draws half-wet
// locks half of the way together: blunt ones, like scales. Hair comes to a point as soon as it is wet, so less than FUR_SHEET_FROM counts for
// more than it is. Not all form at once: `chance`, of chanceOfClump(), says when. Limited so that no strand is
// displaced by more than kMaxDisplacement of its length.
inline constexpr float kMaxDisplacement = FUR_MAX_DISPLACEMENT;
inline float clumpingWetness(float rho, float radius, float chance) {
  const float begins = float{FUR_CLUMPS_BEGIN} + float{FUR_CLUMPS_APART} * chance;
  const float full = std::min(rho, 1.0f) * glm::smoothstep(0.0f, float{FUR_CLUMP_FORMS}, rho - begins);
  return std::min(full * (1 + float{FUR_EARLY_CLUMPS} * std::max(float{FUR_SHEET_FROM} - full, 0.0f)), kMaxDisplacement / std::max(radius, 1e-6f));
}

// The share of the way to the middle of a smaller lock that a strand of a clump has gone at height h: a clump holds several, and
// splits into them at its tip.
inline float lockPull(float h, float rho, float sheet) {
  return FUR_LOCK_IN_CLUMP_PULL * std::min(rho, 1.0f) * (1.0f - sheet) * h * h;
}

// How far fur of that length, where clumps have that radius, stands in tufts, 0..1: short fur that is half wet; and the share of the way to the
// middle of its tuft that a strand has gone at height h, which is by chance: `middle`, in cells of the grid. Fur as short as
// FUR_TUFTS_SHORT has no tufts yet and no locks in its clumps any more (lockSheet(), for lockPull()), so that one grid of cells stands for both:
// so many along a clump's radius (locksInClump()).
inline float tuftsOf(float rho, float length, float clumpRadius) {
  const float some = glm::smoothstep(float{FUR_TUFTS_FROM}, float{FUR_TUFTS}, rho) * (1 - glm::smoothstep(float{FUR_TUFTS_LIE}, float{FUR_NO_TUFTS}, rho));
  const float wide = float{FUR_TUFT_RADIUS} * clumpRadius / std::max(length, 1e-5f);
  return some * glm::smoothstep(float{FUR_TUFTS_SHORT}, 0.75f, shortnessOf(length, clumpRadius)) *
         (1 - glm::smoothstep(float{FUR_WIDE_TUFT}, float{FUR_WIDEST_TUFT}, wide));
}
inline float tuftPull(float h, float tufts, const Vec2& middle) {
  const float chance = glm::fract(glm::dot(glm::floor(middle), Vec2(0.7548777f, 0.5698403f)));
  return float{FUR_TUFT_PULL} * (1 - float{FUR_TUFTS_DIFFER} * chance) * tufts * h * h;
}
inline float lockSheet(float sheet, float shortness) { return std::max(sheet, std::min(shortness / float{FUR_TUFTS_SHORT}, 1.0f)); }
inline float locksInClump(float shortness) { return shortness > float{FUR_TUFTS_SHORT} ? 1.0f : float{FUR_LOCKS_IN_CLUMP}; }

// The position along a strand of constant length of a point at height h that is displaced by `aside`, all in fur lengths. So
// the outer strands of a clump end lower, which makes the clump pointed.
inline float alongStrand(float h, float aside) { return std::sqrt(h * h + aside * aside); }

// A factor for the position along a strand of a clump that is so much `soaked` (sheetOf()): above 1 the strand looks shorter. `outward`: the
// squared distance of its root from the clump's centre, 1 at the rim. Water holds the tips of outer strands further down, which makes the clump pointed, too.
inline constexpr float kRimTaper = FUR_RIM_TAPER;
inline float rimTaper(float soaked, float sheet, float outward) {
  return 1.0f + kRimTaper * soaked * (1.0f - sheet) * std::min(outward, 1.0f);
}

// The displacement of a wet strand's tip (fur lengths), in the direction in which the dry coat leans by `lean`: wet strands
// lie down the way they lean.
inline float wetLean(float lean, float rho, float sheet) { return (0.75f * rho + 0.1f * sheet) * glm::smoothstep(0.0f, 0.12f, lean); }
inline float wetLean(float lean, float rho) { return wetLean(lean, rho, sheetOf(rho)); }

// How high wet fur stands, as a share of dry fur's height.
inline float upright(float rho, float sheet) { return 1.0f - glm::mix(kClumpsSink * std::min(rho, 1.0f), kSheetSinks, sheet); }
inline float upright(float rho) { return upright(rho, sheetOf(rho)); }
// The same where strands are `aside` (fur lengths at the tip) when dry and `lean` more when wet: in clumps they keep their length, so that those
// that stand upright do not sink at all. `top`: upright() of their water.
inline float wetTop(float top, float aside, float lean, float sheet) {
  const float length = glm::length(Vec2(aside, 1)) / glm::length(Vec2(lean + aside * top * top, top));
  return glm::mix(std::min(top * length, 1.0f), top, sheet);
}
// Of fur that is that wet and so far aside.
inline float standsTo(float rho, float aside) {
  const float sheet = sheetOf(rho);
  return wetTop(upright(rho, sheet), aside, wetLean(aside, std::min(rho, 1.0f), sheet), sheet);
}

// How large a bead of water a strand holds near its tip, as a share of the largest that stands alone: lightly wet fur has more and larger ones with
// more water. Then some run down their strands, those that are left grow by what these held, up to four beads in one, and run down as the
// last. `chance`: the strand's own number, 0..1; none has a bead without water.
inline float beadsLeft(float rho) { return 1 - glm::smoothstep(static_cast<float>(FUR_BEADS_RUN), static_cast<float>(FUR_NO_BEADS), rho); }
inline float beadSize(float rho, float chance) {
  const float come = glm::smoothstep(static_cast<float>(FUR_BEADS_FROM), static_cast<float>(FUR_BEADS), rho), left = beadsLeft(rho);
  return glm::clamp(3 * (come * left - chance), 0.0f, 1.0f) * std::cbrt(1 / std::max(left, 0.25f));
}
// How far the strand's bead has run down to its root, 0..1.
inline float beadRun(float rho, float chance) {
  const float left = beadsLeft(rho);
  return glm::clamp(1 - 3 * (left - chance), 0.0f, 1.0f) * glm::clamp(4 * (1 - left), 0.0f, 1.0f);
}

// Where a point lies on a pointed lock that lies along the skin from its root to its tip, `way`; `from`: the point from the root. x: along
// the lock, 0 root .. 1 tip; y: across it, -1 .. 1 from rim to rim. `halfWidth`: of the lock at its root.
inline Vec2 onLock(const Vec2& from, const Vec2& way, float halfWidth) {
  const float squared = std::max(glm::dot(way, way), 1e-8f), along = glm::dot(from, way) / squared;
  const float half = halfWidth * std::max((1 - along) * (1 + 0.8f * along), 1e-3f);
  return {along, (way.x * from.y - way.y * from.x) / (std::sqrt(squared) * half)};
}

// f(h) rho: the look-up's displacement as printed, d = f rho (p - c), with p - c in radii of the clump. It stands in for the exact
// inverse below.
inline float clumpDisplacement(float h, float w, float layers, float rho) { return clumpProfile(h, w, layers) * rho; }

// s / (1 - s): the root of the strand seen at texel p is p + (p - c) times this. The paper prints
// d = f rho r (p - c) with (p - c) in radii of the clump; in texture units that is about 1e-3, which is not visible.
inline float clumpShift(float h, float w, float layers, float rho) {
  const float s = clumpPull(h, w, layers, rho);
  return s / (1.0f - s);
}

// The position of the strand rooted at q where it is pulled by s, and the exact inverse.
inline Vec2 clumpForward(const Vec2& q, const Vec2& centre, float s) { return q - s * (q - centre); }
inline Vec2 clumpInverse(const Vec2& p, const Vec2& centre, float s) { return p + (p - centre) * (s / (1.0f - s)); }

}  // namespace fur::wet
