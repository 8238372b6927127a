// The strands of a wisp, made one by one: where each runs within the wisp's cross-section, and the picture of them that strips
// show. Both show the same strands, so that hair looks the same near and far.
//
// A member strand runs in coordinates of the wisp: x across its width and z through its depth, each -1..1 of half of it, by
// height t, 0 at the root to 1 at the tip. Strays leave that, up to kStripReach.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"
#include "hair/HairValues.h"

namespace fur::hair {

inline constexpr int kWispKinds = 4;  // different sets of member strands; a wisp has one of them by its random number
// The kind of a wisp with this random number: the twin of wispShape() in common_hair_point.glsl.
inline int wispKind(float random) { return glm::clamp(static_cast<int>(random * kWispKinds), 0, kWispKinds - 1); }
// A strip is wider than its wisp by this factor, so that strays and waves are on it.
inline constexpr float kStripReach = 1.25f;

// Floats only, as shaders have it.
struct MemberStrand {
  Vec2 root{0}, tip{0};   // x and z at its root and, but for waves, at its wisp's tip
  float length = 1;       // share of its wisp
  float phase = 0;        // of its waves, turns
  float frizz = 0;        // their amplitude
  float random = 0;       // its own number, 0..1
};

// `count` strands of each kind, kWispKinds * count in all; the same bytes on every platform. Their roots are spread evenly over
// the wisp's cross-section, more of them in its middle; the first few of a kind are spread as well, so that at a distance fewer
// can be drawn. They gather into finer locks towards the tip.
std::vector<MemberStrand> memberStrands(int count, const HairValues& values);
// Where a strand is at height t of its wisp: the twin of memberOffset() in common_hair_member.glsl, as is
// memberWidth(). Never farther out than kStripReach.
Vec2 memberOffset(const MemberStrand& strand, float t);
// Its width there as a share of that at its root: it tapers, the more the nearer its tip, and is 0 beyond.
float memberWidth(const MemberStrand& strand, float t);
// By so much of its width a soaked wisp is thinner at its tip.
inline constexpr float kWetGathers = 0.65f;
// The width of a wisp at height t as a share of that at its root; water (0..1) draws its strands together, the more the nearer
// the tip.
inline float wispWidth(float tipWidth, float t, float wetness = 0) { return glm::mix(1.0f, tipWidth, t) * (1 - kWetGathers * wetness * t * (2 - t)); }

// What a strip shows, an array layer a kind: RGBA8, x across the wisp, -kStripReach..kStripReach, y from root to tip. r: coverage;
// g: slope dx/dt of the strand seen there, 0.5 + slope / 8 clamped; b: its random number; a: how near to the front it lies, z as
// 0.5 + 0.5 z / kStripReach. Where no strand is, g, b and a are those of the next one.
//
// The levels end at 4 x 16 (TEXTURE_MAX_LEVEL): smaller ones cannot hold the coverage. Each keeps that of level 0 as alpha to
// coverage and alpha tests see it: the share of texels of r above a half is that of level 0 within 2 %, and edges are as
// steep (after Castano 2010). g, b and a are means weighted by coverage (H 5.6).
struct StripPicture {
  static constexpr int kWidth = 64, kHeight = 256, kLevels = 5;
  using Texel = std::array<std::uint8_t, 4>;
  using Level = std::vector<Texel>;
  std::array<std::array<Level, kLevels>, kWispKinds> levels;  // [kind][level]
};
// Widths in the same unit: of a strand and of a wisp at their roots; `tipWidth`: the wisp's at its tip as a share.
StripPicture drawStrips(std::span<const MemberStrand> strands, float strandWidth, float widthOfWisp, float tipWidth);

}  // namespace fur::hair
