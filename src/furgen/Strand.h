// The shape of one strand as formulas, for the generator and, as twins, the shaders.
#pragma once

#include <algorithm>

namespace fur::furgen {

inline float mix(float a, float b, float t) { return a + (b - a) * t; }

// Radius at s = h / strandLength, relative to the strand's nominal radius: 0.81 at the skin, 0.29 at
// the tip, 0 past it (Sheppard Eq. 3.6). s is linear in the height: the listing of his figure 4.4
// squares it, which kills strands after two or three layers.
inline float strandThinning(float s) {
  if (!(s <= 1.0f)) return 0.0f;
  return 1.0f - 1.0f / (5.4f - 4.0f * std::max(s, 0.0f));
}

// The same with a taper: 0 keeps the radius up to the tip, 0.5 is the function above, 1 ends in a point. Never rises
// with s.
inline float strandThinning(float s, float taper) {
  if (!(s <= 1.0f)) return 0.0f;
  const float root = strandThinning(0.0f), usual = strandThinning(s);
  if (taper < 0.5f) return root + (usual - root) * (2.0f * taper);
  return usual + (root * (1.0f - std::max(s, 0.0f)) - usual) * (2.0f * taper - 1.0f);
}

// The height up to which a strand of that dominance (0.5..1) exists where its type has that presence (1: only this type, 0: only
// others): Sheppard Eq. 3.5.
inline float standsUpTo(float presence, float dominance) {
  return std::max(2.0f - 2.0f * (1.0f - presence) / dominance, 0.0f);
}
inline bool strandExists(float h, float presence, float dominance) {
  return dominance > 0.0f && h <= standsUpTo(presence, dominance);
}

}  // namespace fur::furgen
