// Long hair as it is seen: a strip's strands from its picture, or a strand as a line of its true width.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_hair.glsl"
#include "common_hair_coverage.glsl"

in vec4 vAlong;
in vec4 vTurned;
in vec4 vLight;
#if defined(PLAIN) && !defined(STRIPS)
uniform mediump sampler2DArray strips;
#endif
out vec4 fragColor;

#ifdef PLAIN
// For benches alone (tests/bench/hair.js): the least that the same geometry takes.
void main() {
#ifdef STRIPS
  vec4 seen = texture(strips, vec3(vBand.xy / vStrand.y, vKind));
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
#ifdef BLENDED
  float core = step(0.5, seen.alpha);
  return hairBlend == 1.0 ? core : (1.0 - core) * seen.alpha;
#else
  return wholeSamples(seen.alpha, hairChance(seen));
#endif
}

#ifdef WET
// What water mirrors on a strand, as shares: x of the light, y of the sky. A strand is round and no surface: it mirrors light where it
// lies across the way between light and eye, by chance far from where its neighbours do. So a bend of all of them, as above their
// roots, shows thin streaks and no spot. Roots lie below others. `along`: T.L, T.V; `facing`: the normal and L.
vec2 strandGloss(vec2 along, float facing, float lightDotView, float held, float h, float strand) {
  float own = fract(13.0 * strand), slope = (along.x + along.y) * inversesqrt(max(2.0 + 2.0 * lightDotView, 1e-4)) + 1.1 * (strand - 0.5);
  float glint = kajiyaLobe(sqrt(max(1.0 - slope * slope, 0.0)), 4.0 * typeShininess.x) * (0.1 + 1.2 * own * own * own);
  return held * wetGloss * smoothstep(0.05, 0.3, h) * vec2(glossShare(facing) * glint, 0.03 * (1.0 - along.y * along.y));
}
#endif

void main() {
  HairSeen seen = hairSeen();
  float alpha = drawnAlpha(seen), strand = seen.strand, h = vBand.z;
  if (alpha == 0.0) discard;

  // The strand seen there: the tangent T, or in a strip T + slope A where A lies across it; and it is not as even as its wisp, so that
  // it shines here and there.
  float tilt = strandTilt(strand, h), slope = 0.0;
  vec2 along = vAlong.xy + tilt * vTurned.xy;
#ifdef STRIPS
  slope = 8.0 * (seen.slope - 0.5) * vStrand.w;
  along += slope * vAlong.zw;
#endif
  along *= inversesqrt(1.0 + slope * slope + tilt * tilt);
  vec3 albedo = strandColor(hairRootColor.rgb, hairTipColor.rgb, hairVariance, h, strand, vec3(1.0));
  // What lies behind others of its wisp gets less light; so does what lies deep among all.
  float open = mix(0.55, 1.0, seen.front) * mix(1.0, vStrand.z, hairOcclusion), edge = vLight.w * open;
  StrandLight lights = StrandLight(keyLight.rgb * vLight.x, keyLight.rgb * (vLight.z * open), backLight.rgb * (edge * edge), skyLight(vTurned.z));
#ifdef WET
  // Water narrows the highlight (Silva et al. 2010, Eq. 3), but where all strands bend above their roots: there it would be a spot.
  float held = vBand.w, narrows = mix(0.35, 2.0, smoothstep(0.2, 0.6, h));
  // Wet strands cling together and mirror as one: what each by itself shines along a bend goes with the first water.
  float shine = vLight.y * (1.0 - 0.6 * min(2.0 * held, 1.0));
  vec3 color = shadeStrand(lights, wetCoatAlbedo(albedo, held), along, vTurned.xy, vTurned.w, open, held, strand, hairShininess * mix(1.0, narrows, min(1.5 * held, 1.0)), shine);
  vec2 mirrored = strandGloss(along, vTurned.x, vTurned.w, held, h, strand);
  color += mirrored.x * vLight.x * keyLight.rgb + mirrored.y * skyLight(vTurned.z);
#else
  vec3 color = shadeStrand(lights, albedo, along, vTurned.xy, vTurned.w, open, 0.0, strand, hairShininess, vLight.y);
#endif
  color = encodeSrgb(toneMap(color));
#ifdef BLENDED
  if (hairBlend == 2.0) color *= alpha;
#endif
  fragColor = vec4(color, alpha);
}
#endif
