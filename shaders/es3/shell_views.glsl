// What views show instead of the picture (render/README.md).
#ifdef VIEW_STEPS
#include "common_heat.glsl"
float taken = 0.0;
void viewStep(Strand here, float add) { taken += 1.0; }
#elif defined(VIEW_CLUMPS)
vec3 clumpSum = vec3(0.0);
void viewStep(Strand here, float add) {
#ifdef WET
  clumpSum += add * clumpColor(here.clump);
#else
  clumpSum += add * clumpColor(vec4(0.0));
#endif
}
#else
void viewStep(Strand here, float add) {}
#endif

#ifdef VIEW_CLUMPS
const bool kSkinShows = false;  // its own pass has the colours
#else
const bool kSkinShows = true;
#endif

#ifdef VIEW_DOMINANCE
const float kBareBelow = 0.0;  // of `grown`: shown where no strand is left, too
#else
const float kBareBelow = 0.25;
#endif

#ifdef VIEW_LAYER
// A shell alone: one look-up where the ray meets it, which counts as it is. Only samples go by chance.
const float kFirstStep = 0.0;
void enterView() {
  reachesSkin = false;
  lod = floor(max(vLight.w, 0.0) + 0.5);
  noise = pixelNoise() / 13.0;
  between = 0.0;
  stepSize = 1.0 / kReferenceSteps;
  end = 0.5 * stepSize;
}
// Nothing stands above it.
float underOthers(float share) { return 1.0; }
#else
const float kFirstStep = 1.0;
void enterView() {}
float underOthers(float share) { return share; }
#endif

#ifdef VIEW_EXPLODED
bool line;
// A line along the shell's end and its outline. So far out a hollow is turned inside out: it is left out.
float viewedShare(float shown) {
  line = vStrands.y < 1.5 || vView.z < min(2.0 * fwidth(vView.z), 0.15);
  if (vStrands.y <= 0.0 || vView.z < 0.0) discard;
  return line ? 1.0 : shown;
}
#else
float viewedShare(float shown) { return shown; }
#endif

vec3 viewed(vec3 color, Met met, March march, vec3 T, vec3 L, float lit) {
#if defined(VIEW_EXPLODED)
  // From blue at the skin to yellow at the tips.
  vec3 tint = mix(vec3(0.25, 0.55, 1.0), vec3(1.0, 0.8, 0.1), vTop) - vec3(1.8, 0.0, 0.4) * vTop * (1.0 - vTop);
  return mix(encodeSrgb(toneMap(color)), tint, line ? 1.0 : 0.5);
#elif defined(VIEW_TANGENTS)
  return T * 0.5 + 0.5;
#elif defined(VIEW_COVERAGE)
  return vec3(met.h);
#elif defined(VIEW_DOMINANCE)
  return vec3(met.strand.w * 2.0 - 1.0);
#elif defined(VIEW_OFFSET)
  return vec3(clamp(0.5 + 12.0 * (textureLod(offset, strandSpot(met.spot), met.spot.w).xy - 0.5), 0.0, 1.0), 0.5);
#elif defined(VIEW_TYPES)
  return typeColor() * mix(0.3, 0.9, met.h);
#elif defined(VIEW_CLUMPS)
  return clumpSum / max(march.alpha, 1e-3) * (0.5 + 0.5 * met.h);
#elif defined(VIEW_SHADOW)
  return vec3(mix(lightShare(lit, 0.0, L.z), lightShare(lit, met.h, L.z), met.closed));
#else
  return encodeSrgb(toneMap(color));
#endif
}
