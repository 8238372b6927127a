// A shell of its own: the strand that stands there, if one does, lit as those that the march meets. Blended over what lies below.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_locks.glsl"
#include "common_layers.glsl"
#include "common_classic.glsl"
#ifdef GROOMED
#include "common_types.glsl"
#endif
#ifdef SHAPED
#include "common_shape.glsl"
#endif

uniform sampler2DArray coverage;  // r
uniform sampler2DArray strand;    // xy: tangent  z: variance  w: dominance
#if defined(TEXTURED) || defined(PAINTED)
uniform sampler2DArray offset;    // 0.5 + the way back to the strand's root, in tiles
#endif
uniform sampler2D baseColor;
#ifdef WET
uniform sampler2D mask;
in vec2 vTip;
in vec3 vTileOfFur;
#endif

in vec4 vTile;
flat in vec2 vShell;
in vec3 vLight;
in vec4 vView;
in vec4 vLean;
in vec4 vAround;
in vec2 vGlint;
in vec3 vUp;
#if defined(WET) || defined(GROOMED) || defined(PAINTED)
in vec2 vAtlas;
in vec4 vAtlasStep;
mat2 atlasFromTile() { return mat2(vAtlasStep.xy, vAtlasStep.zw); }
vec2 atlasAt(vec2 tile) { return vAtlas + atlasFromTile() * (tile - vTile.xy); }
#endif
#include "common_length.glsl"
#include "shell_root.glsl"

out vec4 fragColor;

// What covers less of a pixel is left out.
const float kLeastAlpha = 0.04;

// The strand that stands here, as water, groom and brushes leave it.
struct Strand {
  vec2 root;    // tile
  float along;  // its own length, 0..1; more: past its tip
  float open;   // how many stand there: 0 none, 1 as in the tile, more where many are drawn together
  vec2 tilt;    // by which it leans further than the coat
  int type;
  float held, sheet;  // water; how much of a sheet the coat is
  vec2 outward;       // from the middle of its clump, 1 at the rim
};

#ifdef WET
#include "classic_wet.glsl"
#endif

#ifdef SHAPED
void shape(inout Strand s) {
  vec3 amount = textureLod(shapeMap, vAtlas, 0.0).rgb * (1.0 - 0.8 * min(s.held, 1.0));
  float tiles = max(furLength * tilesPerUnit * vLength, 1e-4), rise = min(0.05, s.along);
  ShapedStrand shaped = shapedStrandAt(s.root, s.along, amount, tiles), lower = shapedStrandAt(s.root, s.along - rise, amount, tiles);
  s.tilt += (lower.root - shaped.root) / max(rise * tiles, 1e-4);
  s.root = shaped.root;
  s.open *= shaped.open;
}
#endif

// Where it is in the textures: tile, layer, mip level.
vec4 spotOf(Strand s, float level) {
#if defined(WET) || defined(GROOMED)
  return vec4(s.root, nearestLayer(storedLayer(s.along)) + float(s.type) * storedLayers, level);
#else
  return vec4(s.root, vShell.y, level);
#endif
}

// Magnified strands get edges one pixel wide.
float coverAt(Strand s, vec4 spot) {
  return clamp((textureLod(coverage, spot.xyz, spot.w).r - 0.5) * vTile.w + 0.5, 0.0, 1.0) * s.open * float(s.along <= 1.0);
}

#ifdef GROOMED
// Its length and type by the groom's map. Of several types that stand here the one that covers most is shown.
float groomed(inout Strand s, float level, out vec4 spot) {
  vec4 texel = textureLod(groom, atlasAt(s.root), 0.0);
  s.along *= vLength / max(texel.r, 1e-3);
  s.open *= step(kBald, texel.r);
#ifdef TYPES
  vec4 grows = presences(texel.gba) * typeGrows;
  Strand any = s;
  float most = 0.0;
  spot = vec4(s.root, 0.0, level);
  for (int type = 0; type < FUR_TYPES; ++type) {
    any.type = type;
    any.along = s.along * typeRise[type];
    vec4 there = spotOf(any, level);
    float cover = coverAt(any, there) * float(grows[type] > 0.0 && any.along <= standsUpTo(grows[type], textureLod(strand, strandSpot(there), there.w).w));
    if (cover > most) most = cover, spot = there, s.type = type;
  }
  s.along *= typeRise[s.type];
  showShares(only(s.type));
  return most;
#else
  spot = spotOf(s, level);
  return coverAt(s, spot);
#endif
}
#endif

vec3 shade(Strand s, vec4 spot, vec3 model) {
  vec4 texel = textureLod(strand, strandSpot(spot), spot.w);
  vec2 tilt = texel.xy * 2.0 - 1.0;
  float own = min(s.along, 1.0), h = own;
#if defined(WET) && !defined(PRINTED_LIGHT)
  h *= litLower(s.held);
#endif
  vec3 T = normalize(vec3(tilt + vLean.xy + s.tilt, sqrt(max(0.05, 1.0 - dot(tilt, tilt))))), L = vLight, V = vView.xyz;
  vec3 albedo = strandColor(rootColors[s.type].rgb, tipColors[s.type].rgb, typeVariance[s.type], own, texel.z, model);
#ifdef PAINTED
  albedo = paintedStrand(albedo, rootInAtlas(spot), typeVariance[s.type], own, texel.z);
#endif
  return litStrand(LightOfShell(vAround, vGlint), albedo, T, L, V, vUp, h, vView.w, texel.z, s.held, s.sheet, s.outward);
}

void main() {
  Strand s = Strand(vTile.xy, vShell.x, 1.0, vec2(0.0), 0, 0.0, 0.0, vec2(0.0));
  float level = floor(vTile.z);
#ifdef WET
  drawToClump(s);
#endif
#ifdef SHAPED
  shape(s);
#endif
  vec4 spot;
#ifdef GROOMED
  float alpha = groomed(s, level, spot);
#else
  spot = spotOf(s, level);
  float alpha = coverAt(s, spot);
#endif
  alpha = min(alpha, 1.0);
  vec3 model = colorAtRoot(spot);
  if (alpha < kLeastAlpha) discard;
  fragColor = vec4(encodeSrgb(toneMap(shade(s, spot, model))) * alpha, alpha);
}
