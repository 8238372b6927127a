// Strands seen from the side along the silhouette: shaded as the shells are, so that both meet without a seam.
// CLASSIC: beside shells of their own, from the skin to the tips, blended.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_locks.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
#ifdef CLASSIC
#include "common_classic.glsl"
in vec4 vAround;
in vec2 vGlint;
in float vLit;
#endif
#ifdef GROOMED
#include "common_types.glsl"
#endif
#ifdef SHAPED
#include "common_shape.glsl"
#endif

uniform sampler2DArray finCoverage, finStrand;  // one layer a fur type, as the shells' are
uniform sampler2D baseColor;
#ifdef WET
uniform sampler2D mask;
#endif

in vec4 vFin;
in vec3 vLight;
in vec3 vUp;
in vec3 vView;
in vec2 vUv;
in vec2 vLean;
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
in vec2 vAtlas;
#endif
#include "common_length.glsl"
#ifdef WET
flat in vec2 vAtlasAlong;
#endif

in vec3 vLightSpace;
out vec4 fragColor;

// The strand that the fragment shows, as water, groom and brushes leave it.
struct Strand {
  float u, h;    // along the fin map; height along the strand, 0..1, more: past its tip
  vec2 lean;     // by which it leans further than the coat: along the edge and across it
  float open;    // how many stand there, as shell_march.glsl has it
  int type;
#ifdef WET
  float held, sheet;  // water; how much of a sheet the coat is
  vec2 outward;  // from the middle of its clump, 1 at the rim
#endif
};

#ifdef WET
void drawToClump(inout Strand s) {
  vec4 clump = maskAt(mask, vAtlas);
  float chart = chartOf(clump), furLengths = 1.0 / max(furLength * tilesPerUnit, 1e-6);
  clump.x -= chart;
  s.held = max(clump.a, 0.0);
  s.sheet = sheetOf(s.held, shortnessOf(coatHere()));
  s.outward = vec2(0.0);
#ifdef PRINTED_CLUMPS
  s.held = min(s.held, 1.0);
  s.sheet = 0.0;
  float pull = clumpDisplacement(s.h, s.held), below = clumpDisplacement(s.h - 1.0 / layers, s.held);
  vec2 fromCentre = vAtlas - clump.xy, across = vec2(-vAtlasAlong.y, vAtlasAlong.x);
  if (s.held <= 0.0) return;
  s.open = float(dot(fromCentre, fromCentre) * (1.0 + pull) * (1.0 + pull) <= clump.z * clump.z);
#else
  s.h /= upright(s.held, s.sheet);
  s.sheet = clumpsClosed(s.held, s.sheet, shortnessOf(coatHere()));
  if (s.held <= 0.0) return;
  float drawn = clumpingWetness(s.held, clump.z * furLengths / max(length(vAtlasAlong), 1e-6), chanceOfClump(clump.xy));
  float pull = clumpPull(s.h, drawn, s.sheet), below = clumpPull(s.h - 1.0 / layers, drawn, s.sheet);
  vec2 fromCentre = (vAtlas - clump.xy) / (1.0 - pull), across = vec2(-vAtlasAlong.y, vAtlasAlong.x);
  s.open = mix(ownStrand(mask, clump, chart, fromCentre), 1.0, 0.7 * s.sheet);
#endif
  // From the clump's centre, in widths of the fin map: along the edge, which moves the look-up, and across it; both tilt the strand.
  vec2 apart = vec2(dot(fromCentre, vAtlasAlong), dot(fromCentre, across)) / max(dot(vAtlasAlong, vAtlasAlong), 1e-12);
  s.u += apart.x * pull;
#ifndef PRINTED_CLUMPS
  s.h = alongStrand(s.h, apart * (pull * furLengths)) * rimTaper(s.sheet, s.sheet, dot(fromCentre, fromCentre) / (clump.z * clump.z + 1e-12));
#endif
  s.lean = apart * ((below - pull) * layers * furLengths);
  s.outward = apart * length(vAtlasAlong) / max(clump.z, 1e-6);
}
#endif

#ifdef GROOMED
// A fin of the march shows one type a pixel, by chance. Whether any fur stands there.
bool trim(inout Strand s) {
  vec4 texel = textureLod(groom, vAtlas, 0.0);
#ifdef TYPES
  vec4 grows = presences(texel.gba);
#ifdef CLASSIC
  // Blended, chance would show as dots: the type that most grows there, each strand as high as its dominance lets it (shell_types.glsl).
  grows *= typeGrows;
  for (int i = 1; i < FUR_TYPES; ++i) s.type = grows[i] > grows[s.type] ? i : s.type;
#else
  float chance = otherPixelNoise();
  for (int i = 0; i < FUR_TYPES - 1 && chance >= grows[i]; ++i) chance -= grows[i], s.type = i + 1;
#endif
  s.h *= typeRise[s.type];
  showShares(only(s.type));
#endif
  s.h *= vLength / max(texel.r, 1e-3);
#if defined(TYPES) && defined(CLASSIC)
  if (s.h > standsUpTo(grows[s.type], textureLod(finStrand, vec3(s.u, min(s.h, 0.985), float(s.type)), 0.0).w)) return false;
#endif
  return s.h <= 1.0 && texel.r >= kBald && typeGrows[s.type] > 0.0;
}
#endif

#ifdef SHAPED
void shape(inout Strand s, float rho) {
  vec3 amount = textureLod(shapeMap, vAtlas, 0.0).rgb * (1.0 - 0.8 * rho);
  float tiles = max(furLength * tilesPerUnit * vLength, 1e-4), rise = min(0.05, s.h);
  ShapedStrand shaped = shapedStrandAt(vec2(s.u, 0.0), s.h, amount, tiles), lower = shapedStrandAt(vec2(s.u, 0.0), s.h - rise, amount, tiles);
  s.lean += (lower.root - shaped.root) / max(rise * tiles, 1e-4);
  s.u = shaped.root.x;
  s.open *= shaped.open;
}
#endif

vec3 shade(Strand s, vec4 strand, float rho, vec3 model) {
#if defined(WET) && !defined(PRINTED_LIGHT)
  float h = s.h * litLower(s.held);
#else
  float h = s.h;
#endif
  vec2 tilt = strand.xy * 2.0 - 1.0;
  vec3 tangent = normalize(vec3(tilt + vLean + s.lean, sqrt(max(0.05, 1.0 - dot(tilt, tilt)))));
  vec3 albedo = strandColor(rootColors[s.type].rgb, tipColors[s.type].rgb, typeVariance[s.type], s.h, strand.z, model);
#ifdef PAINTED
  albedo = paintedStrand(albedo, vAtlas, typeVariance[s.type], s.h, strand.z);
#endif
#ifdef CLASSIC
  float held = 0.0, sheet = 0.0;
  vec2 outward = vec2(0.0);
#ifdef WET
  held = s.held, sheet = s.sheet, outward = s.outward;
#endif
  return encodeSrgb(toneMap(litStrand(LightOfShell(vAround, vGlint), albedo, tangent, vLight, vView, vUp, h, vLit, strand.z,
                                      held, sheet, outward)));
#else
  // Nothing stands before an outline: light reaches it from the side, further down than inside the coat.
  float exposed = mix(h, 1.0, 0.4);
  vec3 L = normalize(vLight), V = normalize(vView);
  float lit = 0.75 * furShadowAt(vLightSpace);
#ifdef WET
  albedo = wetCoatAlbedo(albedo, rho);
#endif
  vec3 color = shadeStrand(albedo, tangent, L, V, exposed, rho, lit, vUp.z, strand.z);
#ifdef WET
  color = clumpLight(color, albedo, tangent, clumpNormal(s.outward, s.sheet), L, V, h, s.held, s.sheet, lit, vUp, strand.z, 1.0);
#endif
#ifdef VIEW_SHADOW
  return vec3(lightShare(lit, exposed, L.z));
#else
  return encodeSrgb(toneMap(color));
#endif
#endif
}

void main() {
#if defined(TEXTURED) && defined(TYPES)
  mat2 uvs = mat2(dFdx(vUv), dFdy(vUv));  // before fragments are discarded
#endif
  Strand s;
  s.u = vFin.x;
  s.h = vFin.y;
  s.lean = vec2(0.0);
  s.open = 1.0;
  s.type = 0;
  float rho = 0.0;
#ifdef WET
  drawToClump(s);
  rho = min(s.held, 1.0);
  if (s.h > 1.0) discard;
#endif
#ifdef GROOMED
  if (!trim(s)) discard;
#endif
#ifdef SHAPED
  shape(s, rho);
#endif
  vec3 spot = vec3(s.u, min(s.h, 0.985), float(s.type));
  float level = floor(max(vFin.w, 0.0) + 0.5);
  float sharp = exp2(max(-vFin.w, 0.0));
  float alpha = clamp((textureLod(finCoverage, spot, level).r - 0.5) * sharp + 0.5, 0.0, 1.0) * vFin.z * s.open;
#ifndef CLASSIC
  // Shells show the coat up to its outline; only the tips beyond it are missing.
  alpha *= smoothstep(FUR_FIN_FOOT, 0.9, s.h) * (1.0 - smoothstep(0.94, 1.0, s.h));
#endif
#ifdef WET
  alpha *= 1.0 - s.sheet;
#endif
#ifdef CLASSIC
  const float least = 0.02;
#else
  // Samples by chance, as in shell.frag.
  alpha += (pixelNoise() - 0.5) / samples;
  float least = 0.5 / samples;
#endif
#if !defined(TEXTURED) || !defined(TYPES)
  vec3 model = modelColor(baseColor, vUv);
#endif
  vec3 color = vec3(0.0);
  if (alpha >= least) {
#if defined(TEXTURED) && defined(TYPES)
    vec3 model = strandModelColor(baseColor, typePicture[s.type], vUv, uvs);
#endif
    color = shade(s, textureLod(finStrand, spot, level), rho, model);
  }
  if (alpha < least) discard;
#ifdef CLASSIC
  color *= alpha;
#endif
  fragColor = vec4(color, alpha);
}
