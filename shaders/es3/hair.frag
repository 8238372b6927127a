// Long hair as it is seen: a strip's strands from its picture, or a strand as a line of its true width.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_noise.glsl"
#include "common_hair.glsl"

in vec4 vBand;
in vec4 vAlong;
in vec4 vUp;
in vec4 vStrand;
#ifdef STRIPS
in vec4 vAcross;
in vec4 vShape;
flat in float vKind;
#endif
#if defined(STRIPS) || defined(PLAIN)
uniform mediump sampler2DArray strips;  // hair/MemberStrands.h: coverage, slope, random number, nearness
#endif
out vec4 fragColor;

#ifdef PLAIN
// For benches alone (tests/bench/hair.js): the least that the same geometry takes.
void main() {
#ifdef STRIPS
  vec4 seen = texture(strips, vec3(vBand.xy / vShape.x, vKind));
  float alpha = seen.r;
#else
  vec4 seen = texture(strips, vec3(0.5, vBand.z, 0.0));
  float alpha = min(vBand.y, 1.0);
#endif
  if (alpha < 0.05) discard;
  fragColor = vec4(seen.rgb, alpha);
}
#else
void main() {
  float h = vBand.z;
#ifdef STRIPS
  vec4 seen = texture(strips, vec3(vBand.xy / vShape.x, vKind));
  float alpha = seen.r, strand = fract(seen.b + vStrand.x), front = seen.a;
#else
  float strand = vStrand.x, front = vStrand.y;
  // Where strands are thinner than a pixel there are fewer, a pixel wide: each ends where it is thinner than its own chance has it.
  float alpha = step(fract(61.0 * strand), vBand.y);
#endif
  float chance = fract(pixelNoise() + 7.0 * strand);
  // A whole number of samples, by chance: drivers differ in what they make of the shares between.
  alpha = floor(alpha * samples + chance) / samples;
  if (alpha == 0.0) discard;

  // The strand seen there slopes in its strip: t + slope a, of length sqrt(1 + slope^2), and n - t (t.n) as it is turned.
  vec4 along = vAlong;
  vec3 normal = vUp.xyz;
#ifdef STRIPS
  float slope = 8.0 * (seen.g - 0.5) * vShape.y;
  along = (along + slope * vAcross) * inversesqrt(1.0 + slope * slope);
  normal = (normal - along.w * along.xyz) * inversesqrt(max(vShape.z - along.w * along.w, 1e-4));
#endif
  vec3 albedo = strandColor(hairRootColor.rgb, hairTipColor.rgb, hairVariance, h, strand, vec3(1.0));
  // What lies behind others of its wisp gets less light; so does what lies deep among all.
  float height = mix(0.55, 1.0, front) * mix(1.0, vStrand.z, hairOcclusion);
  float lit = vStrand.w;
#ifdef WET
  albedo = wetAlbedo(albedo, vBand.w);
#endif
  // A strand is not as even as its wisp: it shines here and there.
  float tilt = 0.12 * sin(6.2831853 * (strand + 3.0 * h));
  vec2 tilted = (along.xy + tilt * normal.xy) * inversesqrt(1.0 + tilt * tilt);
  vec3 color = shadeStrand(albedo, tilted, normal.xy, vUp.w, height, vBand.w, lit, normal.z, strand, mix(hairShininess, 2.0 * hairShininess, vBand.w), hairGloss);
#ifdef WET
  vec2 mirrored = waterGloss(tilted, normal.xy, vUp.w, normal.x, vBand.w, 0.0, strand);
  // A strand mirrors on its own: half of what a clump of fur does, whose strands lie in one film.
  color += 0.5 * (mirrored.x * lit * keyLight.rgb + mirrored.y * skyLight(normal.z));
#endif
  fragColor = vec4(encodeSrgb(toneMap(color)), alpha);
}
#endif
