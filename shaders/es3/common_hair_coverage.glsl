// What a strip or a strand covers of a pixel: fragments of hair.vert.
#include "common_noise.glsl"
#include "common_hair_samples.glsl"

in vec4 vBand;
in vec4 vStrand;
#ifdef STRIPS
flat in float vKind;
uniform mediump sampler2DArray strips;  // hair/MemberStrands.h: coverage, slope, random number, nearness
#endif

struct HairSeen {
  float alpha;   // share of the pixel
  float slope;   // of a strip's strand, 0.5: along the strip
  float strand;  // its random number
  float front;   // how near to the front of its wisp it lies, 0..1
};

HairSeen hairSeen() {
#ifdef STRIPS
  vec4 seen = texture(strips, vec3(vBand.xy / vStrand.y, vKind));
  return HairSeen(seen.r, seen.g, fract(seen.b + vStrand.x), seen.a);
#else
  // Where strands are thinner than a pixel there are fewer, a pixel wide: each ends where it is thinner than its own chance has it.
  return HairSeen(step(fract(61.0 * vStrand.x), vBand.y), 0.5, vStrand.x, vStrand.y);
#endif
}

float hairChance(HairSeen seen) { return fract(pixelNoise() + 7.0 * seen.strand); }
