// Long hair's depth alone, so that only what is seen is shaded afterwards.
#include "common.glsl"
#include "common_hair_coverage.glsl"
out vec4 fragColor;

void main() {
  HairSeen seen = hairSeen();
  float alpha = wholeSamples(seen.alpha, hairChance(seen));
  if (alpha == 0.0) discard;
  fragColor = vec4(0.0, 0.0, 0.0, alpha);
}
