// Long hair as it is seen: a strip's strands from its picture, or a strand as a line of its true width.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_hair.glsl"
#include "common_hair_coverage.glsl"

in vec4 vAlong;
in vec4 vUp;
#ifdef STRIPS
in vec4 vAcross;
#endif
#if defined(PLAIN) && !defined(STRIPS)
uniform mediump sampler2DArray strips;
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
// What is drawn of what it covers; 0: nothing.
float drawnAlpha(HairSeen seen) {
  if (hairBlend == 0.0) return wholeSamples(seen.alpha, hairChance(seen));
  float core = step(0.5, seen.alpha);
  return hairBlend == 1.0 ? core : (1.0 - core) * seen.alpha;
}

void main() {
  HairSeen seen = hairSeen();
  float alpha = drawnAlpha(seen), strand = seen.strand, h = vBand.z;
  if (alpha == 0.0) discard;

  // The strand seen there slopes in its strip: t + slope a, of length sqrt(1 + slope^2), and n - t (t.n) as it is turned.
  vec4 along = vAlong;
  vec3 normal = vUp.xyz;
#ifdef STRIPS
  float slope = 8.0 * (seen.slope - 0.5) * vShape.y;
  along = (along + slope * vAcross) * inversesqrt(1.0 + slope * slope);
  normal = (normal - along.w * along.xyz) * inversesqrt(max(vShape.z - along.w * along.w, 1e-4));
#endif
  vec3 albedo = strandColor(hairRootColor.rgb, hairTipColor.rgb, hairVariance, h, strand, vec3(1.0));
  // What lies behind others of its wisp gets less light; so does what lies deep among all.
  float height = mix(0.55, 1.0, seen.front) * mix(1.0, vStrand.z, hairOcclusion);
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
  fragColor = vec4(encodeSrgb(toneMap(color)) * (hairBlend == 2.0 ? alpha : 1.0), alpha);
}
#endif
