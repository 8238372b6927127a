// Strands seen from the side along the silhouette: shaded as the shells are, so that both meet without a seam.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
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
in vec4 vLight;
in vec3 vView;
in vec2 vUv;
in vec2 vLean;
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
in vec2 vAtlas;
#endif
#ifdef GROOMED
in float vLength;
#endif
#ifdef WET
flat in vec2 vAtlasAlong;
#endif

in vec3 vLightSpace;
out vec4 fragColor;

void main() {
  float u = vFin.x, h = vFin.y, rho = 0.0, open = 1.0;
  vec2 clumpLean = vec2(0.0);
#ifdef WET
  vec4 clump = maskAt(mask, vAtlas);
  float chart = chartOf(clump);
  clump.x -= chart;
  float held = max(clump.a, 0.0), sheet = sheetOf(held), furLengths = 1.0 / max(furLength * tilesPerUnit, 1e-6);
  vec2 outward = vec2(0.0);
  rho = min(held, 1.0);
  h /= upright(held, sheet);
  if (held > 0.0) {
    float drawn = clumpingWetness(held, clump.z * furLengths / max(length(vAtlasAlong), 1e-6));
    float s = clumpPull(h, drawn, sheet), below = clumpPull(h - 1.0 / layers, drawn, sheet);
    vec2 fromCentre = (vAtlas - clump.xy) / (1.0 - s), across = vec2(-vAtlasAlong.y, vAtlasAlong.x);
    open = mix(ownStrand(mask, clump, chart, fromCentre), 1.0, 0.7 * sheet);
    // In turns of the fin map along the edge and across it; only the first moves the look-up, both tilt the strand.
    vec2 turns = vec2(dot(fromCentre, vAtlasAlong), dot(fromCentre, across)) / max(dot(vAtlasAlong, vAtlasAlong), 1e-12);
    u += turns.x * s;
    h = alongStrand(h, turns * (s * furLengths)) * rimTaper(held, sheet, dot(fromCentre, fromCentre) / (clump.z * clump.z + 1e-12));
    clumpLean = turns * ((below - s) * layers * furLengths);
    outward = turns * length(vAtlasAlong) / max(clump.z, 1e-6);
  }
  if (h > 1.0) discard;
#endif
  int type = 0;
#ifdef GROOMED
  vec4 dressed = textureLod(groom, vAtlas, 0.0);
#ifdef TYPES
  // A fin shows one type a pixel, by chance.
  vec4 grows = presences(dressed.gba);
  float chance = otherPixelNoise();
  for (int i = 0; i < FUR_TYPES - 1 && chance >= grows[i]; ++i) chance -= grows[i], type = i + 1;
  h *= typeRise[type];
#endif
  h *= vLength / max(dressed.r, 1e-3);
  if (h > 1.0 || dressed.r < kBald || typeGrows[type] <= 0.0) discard;
#endif
#ifdef SHAPED
  vec3 amount = textureLod(shapeMap, vAtlas, 0.0).rgb * (1.0 - 0.8 * rho);
  float tiles = max(furLength * tilesPerUnit * vLength, 1e-4), rise = min(0.05, h);
  ShapedStrand shaped = shapedStrandAt(vec2(u, 0.0), h, amount, tiles), lower = shapedStrandAt(vec2(u, 0.0), h - rise, amount, tiles);
  clumpLean += (lower.root - shaped.root) / max(rise * tiles, 1e-4);
  u = shaped.root.x;
  open *= shaped.open;
#endif
  vec3 spot = vec3(u, min(h, 0.985), float(type));
  float level = floor(max(vFin.w, 0.0) + 0.5);
  float sharp = exp2(max(-vFin.w, 0.0));
  float alpha = clamp((textureLod(finCoverage, spot, level).r - 0.5) * sharp + 0.5, 0.0, 1.0) * vFin.z * open;
  // Shells show the coat up to its outline; only the tips beyond it are missing.
  alpha *= smoothstep(FUR_FIN_FOOT, 0.9, h) * (1.0 - smoothstep(0.94, 1.0, h));
#ifdef WET
  alpha *= 1.0 - sheet;
#endif
  // Samples by chance, as in shell.frag.
  alpha += (pixelNoise() - 0.5) / samples;
  vec3 model = modelColor(baseColor, vUv), color = vec3(0.0);
  // Once or not at all: most of a fin is gaps, and a software rasteriser jumps over loops but not over an if.
  for (int i = 0, once = int(alpha >= 0.5 / samples); i < once; ++i) {
    vec4 strand = textureLod(finStrand, spot, level);
    vec2 tilt = strand.xy * 2.0 - 1.0;
    vec3 tangent = normalize(vec3(tilt + vLean + clumpLean, sqrt(max(0.05, 1.0 - dot(tilt, tilt)))));
    vec3 albedo = strandColor(rootColors[type].rgb, tipColors[type].rgb, typeVariance[type], h, strand.z, model);
#ifdef PAINTED
    albedo = paintedStrand(albedo, vAtlas, typeVariance[type], h, strand.z);
#endif
    // Nothing stands before an outline: light reaches it from the side, further down than inside the coat.
    float exposed = mix(h, 1.0, 0.4);
    vec3 L = normalize(vLight.xyz), V = normalize(vView);
    float lit = 0.75 * furShadowAt(vLightSpace);
#ifdef WET
    albedo = wetAlbedo(albedo, rho);
#endif
    color = shadeStrand(albedo, tangent, L, V, exposed, rho, lit, vLight.w, strand.z);
#ifdef WET
    color = clumpLight(color, tangent, clumpNormal(outward, sheet), L, V, h, held, sheet, lit, vLight.w, strand.z);
#endif
#ifdef VIEW_SHADOW
    color = vec3(lightShare(lit, exposed, L.z));
#else
    color = encodeSrgb(toneMap(color));
#endif
  }
  if (alpha < 0.5 / samples) discard;
  fragColor = vec4(color, alpha);
}
