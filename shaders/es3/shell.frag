// Marches the coat along the view ray, front to back from where the ray enters it, and shades once what it met:
// strands, and the skin between them. Rays that leave a round body's coat again stay transparent.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
#ifdef VIEW_STEPS
#include "common_heat.glsl"
#endif

uniform sampler2DArray coverage;  // r
uniform sampler2DArray strand;    // xy: tangent  z: variance  w: dominance
uniform sampler2D baseColor;
#if defined(TEXTURED) || defined(PAINTED) || defined(VIEW_OFFSET)
uniform sampler2DArray offset;  // 0.5 + the way back to the strand's root, in tiles
#endif
#ifdef GROOMED
#include "common_types.glsl"
#endif
#ifdef SHAPED
#include "common_shape.glsl"
#endif

in vec4 vTile;
in vec4 vTurn;
in vec4 vPath;
in vec4 vLight;
in vec4 vView;
in vec4 vLean;
in vec2 vLightStep;
#ifdef WET
in float vTop;
in vec3 vTileOfFur;
#else
flat in float vTop;
#endif
in vec2 vStrands;
#if defined(WET) || defined(GROOMED)
#define WET_OR_GROOMED  // strands stand elsewhere than in the tile, or not all of them
#endif
#if defined(WET_OR_GROOMED) || defined(PAINTED)
in vec2 vAtlas;
in vec4 vAtlasStep;
#endif
#ifdef GROOMED
in float vLength;
#endif

in vec3 vLightSpace, vLightRay;
out vec4 fragColor;

// Half-covered texels count as they are for this many steps a fur length, less for more. By FLIP against the
// reference: 16 and 32 are as good near, 64 is worse far.
const float kReferenceSteps = 24.0;
// A step in texels of the mip level, times stepLength, and how many there are of a fur length at least, however small the
// picture.
const float kTexelsAStep = 2.0;
const float kFewestSteps = 6.0;
// What a fragment may cost at most, whatever the numbers are: FUR_MOST_STEPS steps, of so many look-ups each: coverage 1;
// GROOMED 1 more; TYPES 2 a type instead of coverage; WET 2 more, beside a chart 3.
// Strands that hide this much hide all. Smaller steps and more strands are further from the reference: what lies deep
// makes fur too dark.
const float kClosed = 0.65;

// `between`: added before rounding down; which arrays do, by themselves, to the nearest.
float storedLayer(float h, float between) { return h * storedLayers + between - 0.5; }
float layerOf(float stored) { return clamp(floor(stored + 0.5), 0.0, storedLayers - 1.0); }

float heightAt(float x) { return vTop + x * (vPath.x + x * vPath.y); }
vec2 tileAt(float x, float h) { return vTile.xy + x * (vTile.zw + x * vTurn.xy) + vTurn.zw * (vTop * vTop - h * h); }

// How far the ray goes, in fur lengths: until it is so far down, or where it only grazes a round body, out again.
float rayTo(float depth, out bool comesThere) {
  float slope = -vPath.x, inside = slope * slope - 4.0 * vPath.y * depth;
  comesThere = slope > 0.0 && inside > 0.0;
  if (slope <= 0.0) return 0.0;
  return min(comesThere ? 2.0 * depth / (slope + sqrt(inside)) : slope / vPath.y, 6.0);
}

// How many steps there are from x to `end`. The march counts them: a step that is tiny beside x would not change it, and a loop
// that waits for x to arrive would never end. Rounded as a number that is none, too, it is `most` at most.
int stepsTo(float end, float x, float stepSize, int most) {
  return end > x ? clamp(int(min(ceil((end - x) / stepSize), float(most))), 0, most) : 0;
}

#ifdef WET
#include "shell_wet.glsl"
#endif
// Drawn together, strands are that much thinner than a pixel. Not all of it: clumps keep their lines.
float gatheredLevel(float lod, float pull) { return lod + step(0.3, pull) + step(0.63, pull); }

// The chart's share where charts overlap, see geometry/FurClusters.h: blended in order.
float chartShare() {
  vec2 strands = clamp(vStrands, 0.0, 1.0);
  return (strands.y - strands.x) / max(1.0 - strands.x, 1e-3);
}

// A direction in the surface's frame where the ray is, whose normal has turned on the way.
vec3 inTurnedFrame(vec3 v, vec2 turned) {
  v += vec3(-turned * v.z, dot(turned, v.xy));
  return v * (1.5 - 0.5 * dot(v, v));  // nearly a unit: one step of Newton's makes it one
}

// Magnified strands get edges one pixel wide; minified ones keep their fractional coverage.
float edged(float cover, float sharp) { return clamp((cover - 0.5) * sharp + 0.5, 0.0, 1.0); }
// Stands in for 1 - (1 - c)^softness.
float stepCover(float cover, float softness) { return min(cover * mix(softness, 1.0, cover), 1.0); }

#if defined(TEXTURED) || defined(PAINTED)
// How far from where the ray enters the strand that was met has its root, so that a curl has one colour up to its tip.
vec2 toRoot(vec4 spot) { return spot.xy + textureLod(offset, spot.xyz, spot.w).xy - 0.5 - vTile.xy; }
#endif
#ifdef TEXTURED
// The model's own colour there: the model's uv a tile on is solved out of what both do from pixel to pixel.
vec3 colorAtRoot(vec4 spot) {
  vec2 root = toRoot(spot);
  mat2 tiles = mat2(dFdx(vTile.xy), dFdy(vTile.xy)), uvs = mat2(dFdx(vLean.zw), dFdy(vLean.zw));
  float area = determinant(tiles);
  // A surface seen edge-on tells nothing: there the root is not far.
  vec2 moved = abs(area) > 1e-9 ? uvs * (inverse(tiles) * root) : vec2(0.0);
  // By the entry's mip level: from strand to strand roots jump.
  return mix(vec3(1.0), textureGrad(baseColor, vLean.zw + moved, uvs[0], uvs[1]).rgb, textureAmount);
}
#else
vec3 colorAtRoot(vec4 spot) { return vec3(1.0); }
#endif

void main() {
  // Fur is read from one mip level, picked by chance between the two that trilinear filtering would
  // blend, and half a level sharper than a pixel's footprint: fur hides the grain, blur would make felt of it.
  float lod = floor(max(vLight.w - 0.5, 0.0) + quadNoise());
  float share = chartShare();
  bool reachesSkin;
  float end = rayTo(vTop, reachesSkin);
  if (share <= 0.0) end = 0.0;
  float pixels = exp2(-vLight.w), sharp = max(pixels, 1.0);  // a texel covers
  // Of the ray's way over the skin; or past strands that lie rather than stand, whichever is more: from above it comes past
  // many of them.
  float lying = clamp(3.0 * length(vLean.xy) - 2.4, 0.0, 1.0);  // none below a turn of 0.85, all from 1.3 on
  vec2 past = vTile.zw - 2.0 * lying * vTop * vPath.x * vTurn.zw;
  float texels = sqrt(max(dot(vTile.zw, vTile.zw), dot(past, past))) * tileTexels * min(pixels, 1.0);
  float stepSize = stepLength * min(kTexelsAStep / max(texels, 1e-3), 1.0 / (kFewestSteps * max(-vPath.x, 1.0 / kFewestSteps)));
  // Where the first step falls, which layer stands for a height between two, which samples are covered: each by
  // chance, so that nothing forms rings.
  float noise = otherPixelNoise();
  float between = fract(noise * 7.0) - 0.5;
  float x = stepSize * noise, alpha = 0.0, xSum = 0.0;
  float metX = 0.0;  // where the strand was met that is shown: the last one that hid more than all before it
#ifdef WET_OR_GROOMED
  float hSum = 0.0;  // height along the strands, weighted as x is
#endif
  vec4 spot = vec4(vTile.xy, 0.0, lod);       // its tile, layer, mip level
#ifdef TYPES
  vec4 types = vec4(0.0);  // what each adds
  vec4 present = typeGrows;
#endif
#ifdef VIEW_LAYER
  // A shell alone: one look-up where the ray meets it, which counts as it is. Only samples go by chance.
  reachesSkin = false;
  lod = floor(max(vLight.w, 0.0) + 0.5);
  noise = pixelNoise() / 13.0;
  x = between = 0.0;
  stepSize = 1.0 / kReferenceSteps;
  end = 0.5 * stepSize;
#endif
#ifdef VIEW_STEPS
  float taken = 0.0;
#endif
#ifdef VIEW_CLUMPS
  vec3 clumpSum = vec3(0.0);
#endif
#ifdef WET_OR_GROOMED
  mat2 atlasFromTile = mat2(vAtlasStep.xy, vAtlasStep.zw);
#endif
#ifdef WET
  tileFromAtlas = inverse(atlasFromTile);
  atlasLength = sqrt(abs(determinant(tileFromAtlas)));
  // Charts are stretched, each in its own way: what is drawn aside is drawn aside on the skin.
  mat2 tileFromFur = mat2(vTileOfFur.xy, 0.0, vTileOfFur.z);
  furFromTile = inverse(tileFromFur);
  furLengths = sqrt(abs(determinant(furFromTile)));
  entryHeld = filteredWetness(mask, vAtlas);
  entryChart = chartOf(maskAt(mask, vAtlas));
  sheet = sheetOf(entryHeld);
  float joined = sheet * (2.0 - sheet);
  coatTop = upright(entryHeld, sheet);
  vec2 laid = wetLean(0.5 * vLean.xy, entryHeld, sheet);
  lie = tileFromFur * laid;
  // Clumps are denser than dry fur: they close sooner, and longer steps find them.
  stepSize *= 1.0 + 0.7 * min(entryHeld, 1.0);
  float enters = 0.0, closes = kClosed * (1.0 - 0.6 * sheet);
  if (vTop > coatTop) {
    bool comesDown;
    enters = rayTo(vTop - coatTop, comesDown);
    x += enters, metX = enters;
    if (!comesDown) end = 0.0;
  }
  vec2 inside = vAtlas;
#else
  const float closes = kClosed;
#endif
  float softness = kReferenceSteps * stepSize;
  vec2 foot = tileAt(end, 0.0);  // where the ray meets the skin
  float grown = 1.0;  // how much of a coat there is there
#ifdef SHAPED
  vec3 shapeAmount = textureLod(shapeMap, vAtlas + 0.5 * atlasFromTile * (foot - vTile.xy), 0.0).rgb;
  float shapeLength = max(furLength * tilesPerUnit * vLength, 1e-4);
#ifdef WET
  shapeAmount *= 1.0 - 0.8 * min(entryHeld, 1.0);  // water draws curls out
#endif
#endif
#ifdef GROOMED
  vec4 below = textureLod(groom, vAtlas + atlasFromTile * (foot - vTile.xy), 0.0);
  grown = min(below.r / 0.15, 1.0);
#ifdef TYPES
  grown *= min(2.0 * dot(presences(below.gba), present), 1.0);
#endif
#endif
  float furry = grown;  // and where the ray is
  // Few variables and one way out: on a software rasteriser the loop itself costs as much as its look-ups.
  int mostSteps = FUR_MOST_STEPS;
#ifdef WET
  if (reachesSkin && joined > kWholeSheet) mostSteps = kSheetSteps;
#endif
  int steps = stepsTo(end, x, stepSize, mostSteps);
  for (int i = 0; i < steps && alpha <= closes; ++i) {
    float h = heightAt(x);
    vec2 at = tileAt(x, h);
#ifdef WET
    at -= lie * (h / coatTop);
#endif
    vec2 root = at;
    float open = 1.0, level = lod, along = h;
#ifdef WET_OR_GROOMED
    vec2 a = vAtlas + atlasFromTile * (at - vTile.xy);
#endif
#ifdef WET
    WetStrand wet = wetStrandAt(at, a, h, inside);
    root = wet.root;
    along = wet.along;
    open = wet.open;
    level = gatheredLevel(lod, wet.pull);
#endif
#ifdef SHAPED
    ShapedStrand shaped = shapedStrandAt(root, along, shapeAmount, shapeLength);
    root = shaped.root;
    open *= shaped.open;
    level = max(level, gatheredLevel(lod, shaped.pull));
#endif
#ifdef GROOMED
    // Vertices know the mean length; the map knows it of every strand.
    vec4 dressed = textureLod(groom, vAtlas + atlasFromTile * (root - vTile.xy), 0.0);
    along *= vLength / max(dressed.r, 1e-3);
    open *= step(kBald, dressed.r);
    furry = min(dressed.r / 0.15, 1.0);
#endif
#ifdef TYPES
    vec4 grows = presences(dressed.gba) * present;
    furry *= min(2.0 * dot(grows, vec4(1.0)), 1.0);
    float closedHere = 0.0;
    for (int type = 0; type < FUR_TYPES; ++type) {
      if (grows[type] <= 0.0) continue;
      float up = along * typeRise[type];
      if (up > 1.0) continue;
      vec4 there = vec4(root, layerOf(storedLayer(up, between)) + float(type) * storedLayers, level);
      float stands = standsUpTo(grows[type], textureLod(strand, there.xyz, level).w);
      float cover = min(edged(textureLod(coverage, there.xyz, level).r, sharp) * open, 1.0) * float(up <= stands);
      float add = stepCover(cover, softness) * (1.0 - alpha - closedHere);
      closedHere += add;
      hSum += add * up;
      types[type] += add + 1e-3 * grows[type];
      if (add > alpha) metX = x, spot = there;
    }
    float add = closedHere;
#else
#ifdef GROOMED
    open *= float(along <= 1.0);
#endif
    vec4 there = vec4(root, storedLayer(along, between), level);
    float add = stepCover(min(edged(textureLod(coverage, there.xyz, level).r, sharp) * open, 1.0), softness) * (1.0 - alpha);
#ifdef WET_OR_GROOMED
    hSum += add * along;
#endif
#ifdef GROOMED
    if (add > alpha) spot = there;
#endif
    if (add > alpha) metX = x;
#endif
    xSum += add * x;
#ifdef VIEW_CLUMPS
#ifdef WET
    vec4 clump = wet.clump;
#else
    const vec4 clump = vec4(0.0);
#endif
    clumpSum += add * clumpColor(clump);
#endif
#ifdef VIEW_STEPS
    taken += 1.0;
#endif
    alpha += add;
    x += stepSize;
  }
#ifdef VIEW_STEPS
  fragColor = heat(0.2 * taken);
  return;
#endif
#ifdef VIEW_CLUMPS
  reachesSkin = false;  // its own pass has the colours
#endif
#ifdef WET
  // A ray that goes on so far may come to an edge first, behind which there is no such skin.
  if (end > kFarOn && leavesChart(vAtlas + atlasFromTile * (foot - vTile.xy))) reachesSkin = false;
#endif
  float closed = min(alpha / closes, 1.0), levels = samples;
  float shown = (reachesSkin ? 1.0 : closed) * share + (fract(noise * 13.0) - 0.5) / levels;
#ifdef VIEW_EXPLODED
  // A line along the shell's end and its outline. So far out a hollow is turned inside out: it is left out.
  bool line = vStrands.y < 1.5 || vView.z < min(2.0 * fwidth(vView.z), 0.15);
  if (line) shown = 1.0;
  if (vStrands.y <= 0.0 || vView.z < 0.0) discard;
#endif
  if (shown < 0.5 / levels) discard;

  float perStrand = 1.0 / max(alpha, 1e-3), toStrand = alpha > 0.0 ? xSum * perStrand : end;
#ifdef WET
  toStrand = mix(toStrand, enters, joined);
  float metHeight = heightAt(metX);
  vec2 metTile = tileAt(metX, metHeight) - lie * (metHeight / coatTop);
  WetStrand metStrand = wetStrandAt(metTile, vAtlas + atlasFromTile * (metTile - vTile.xy), metHeight, inside);
#ifndef GROOMED
  spot = vec4(metStrand.root, storedLayer(metStrand.along, between), gatheredLevel(lod, metStrand.pull));
#endif
#elif !defined(GROOMED)
  spot.xyz = vec3(tileAt(metX, heightAt(metX)), storedLayer(heightAt(metX), between));
#endif
  if (alpha <= 0.0) spot.xyz = vec3(foot, 0.0);
#ifdef WET_OR_GROOMED
  float h = hSum * perStrand;
#else
  float h = heightAt(toStrand);
#endif
#ifdef WET
  // Strands that water joins are one as far as light is concerned: as many as a pixel has, and in a sheet those that lie in
  // line where the ray comes to it. Chance of the march would be grain there.
  vec4 met = textureLod(strand, spot.xyz, spot.w + 1.5 * min(metStrand.clump.a, 1.0));
  float strandNumber = met.z;
  if (sheet > 0.0) {
    vec4 inLine = strandsInLine(enters, spot.z);
    met = mix(met, inLine, joined);
    strandNumber = mix(strandNumber, clamp(0.5 + 3.0 * (inLine.z - 0.5), 0.0, 1.0), joined);
    h = mix(mix(h, 0.7, joined * (1.0 - closed)), 0.3 + 0.4 * strandNumber, joined);
    // Through a sparse coat skin shows all the same.
    if (reachesSkin) closed = mix(closed, 1.0, joined * furry * min(3.0 * density, 1.0));
  }
#else
  vec4 met = textureLod(strand, spot.xyz, spot.w);
#endif
  vec2 turned = vPath.zw * toStrand;
  vec3 light3 = inTurnedFrame(vLight.xyz, turned), view3 = inTurnedFrame(vView.xyz, turned);
  vec2 tilt = met.xy * 2.0 - 1.0;
#ifdef WET
  tilt = furFromTile * tilt / furLengths;
  tilt /= max(length(tilt), 1.0);
#endif
  vec3 tangent = vec3(tilt + vLean.xy * h, sqrt(max(0.05, 1.0 - dot(tilt, tilt))));
#ifdef WET
  // Eq. 4: the strand moves by -d, in fur lengths.
  float metAlong = metHeight / coatTop, drawn = clumpingWetness(metStrand.clump.a, metStrand.clump.z * atlasLength * furLengths);
  float rises = clumpPull(metAlong - 1.0 / layers, drawn, sheet) - clumpPull(metAlong, drawn, sheet);
  tangent.xy += furFromTile * metStrand.from * (rises * layers * (1.0 - joined)) + laid / coatTop;
  vec2 outward = metStrand.from / max(metStrand.clump.z * atlasLength, 1e-6);
  outward *= (1.0 - joined) / max(length(outward), 1.0);
  float held = mix(metStrand.clump.a, entryHeld, joined), rho = min(held, 1.0), skinWetness = rho;
  float strandShade = 0.65 * (1.0 - joined);
#else
  const float rho = 0.0, skinWetness = 0.0, strandShade = 0.65;
#endif
#ifdef SHAPED
  float rise = min(0.05, h);
  ShapedStrand above = shapedStrandAt(spot.xy, h, shapeAmount, shapeLength), lower = shapedStrandAt(spot.xy, h - rise, shapeAmount, shapeLength);
  tangent.xy += (lower.root - above.root) / max(rise * shapeLength, 1e-4);
#endif
  tangent = normalize(tangent);

  float firstLayer = 0.0;  // of the type that was met
#ifdef TYPES
  firstLayer = floor(spot.z / storedLayers) * storedLayers;
#endif
  // A look towards the light through the fur above: real strands cast real shadows.
  const float kRise = 0.1;
  float lit = 1.0;
  if (h + kRise < 1.0)
    lit -= strandShade * strandShadow * furry * textureLod(coverage, vec3(spot.xy + vLightStep * kRise, layerOf(storedLayer(h + kRise, 0.0)) + firstLayer), lod + 1.0).r;

  // How far the ray went, to the strands or to the skin.
  lit *= furShadowAt(vLightSpace + vLightRay * toStrand);
  vec3 model = colorAtRoot(spot);
  float exposed = h;
#ifdef VIEW_LAYER
  exposed = lit = 1.0;  // nothing stands above it
#endif
  vec3 tip = tipColors[0].rgb, rootTint = rootColors[0].rgb;
  float variance = typeVariance.x;
#ifdef TYPES
  types /= max(dot(types, vec4(1.0)), 1e-6);
  tip *= types.x, rootTint *= types.x;
  for (int type = 1; type < FUR_TYPES; ++type) {
    tip += types[type] * tipColors[type].rgb;
    rootTint += types[type] * rootColors[type].rgb;
  }
  variance = dot(types, typeVariance);
#endif
  vec3 albedo = strandColor(rootTint, tip, variance, h, met.z, model);
#ifdef PAINTED
  vec2 rooted = vAtlas + mat2(vAtlasStep.xy, vAtlasStep.zw) * toRoot(spot);
  albedo = paintedStrand(albedo, rooted, variance, h, met.z);
#endif
#ifdef WET
  albedo = wetAlbedo(albedo, rho);
#endif
  vec3 color = shadeStrand(albedo, tangent, light3, view3, exposed, rho, lit, vView.w, met.z);
#ifdef WET
  vec3 n = normalize(clumpNormal(outward, sheet) + vec3(0.8 * joined * tilt, 0.0));
  color = clumpLight(color, tangent, n, light3, view3, h, held, sheet, lit, vView.w, strandNumber);
#endif
  for (int i = 0, once = int(reachesSkin && closed < 1.0); i < once; ++i) {
    vec3 bare = skinColor.rgb * model;
#ifdef PAINTED
    bare = painted(bare, rooted, vec3(1.0));
#endif
    vec3 skin = shadeSkin(bare * 0.5, vLight.z, vView.w, 0.0, skinWetness, lit);
    // Pores: the lowest layer says where strands root (Sheppard 5.2).
    skin *= 1.0 - 0.4 * grown * textureLod(coverage, vec3(foot, firstLayer), lod).r;
#ifdef GROOMED
    skin = mix(bareSkin(bare, vLight.z, vView.w, skinWetness, lit), skin, grown);
#endif
    color = closed > 0.0 ? mix(skin, color, closed) : skin;
  }
#if defined(VIEW_EXPLODED)
  // From blue at the skin to yellow at the tips.
  vec3 tint = mix(vec3(0.25, 0.55, 1.0), vec3(1.0, 0.8, 0.1), vTop) - vec3(1.8, 0.0, 0.4) * vTop * (1.0 - vTop);
  fragColor = vec4(mix(encodeSrgb(toneMap(color)), tint, line ? 1.0 : 0.5), shown);
#elif defined(VIEW_TANGENTS)
  fragColor = vec4(tangent * 0.5 + 0.5, shown);
#elif defined(VIEW_COVERAGE)
  fragColor = vec4(vec3(h), shown);
#elif defined(VIEW_DOMINANCE)
  fragColor = vec4(vec3(met.w * 2.0 - 1.0), shown);
#elif defined(VIEW_OFFSET)
  fragColor = vec4(clamp(0.5 + 12.0 * (textureLod(offset, spot.xyz, spot.w).xy - 0.5), 0.0, 1.0), 0.5, shown);
#elif defined(VIEW_TYPES)
  // As the picture of the groom: type 1 white, the others red, green and blue.
#ifdef TYPES
  vec3 tint = types.x + types.yzw + 0.25 * (1.0 - types.x);
#else
  const vec3 tint = vec3(1.0);
#endif
  fragColor = vec4(tint * mix(0.3, 0.9, h), shown);
#elif defined(VIEW_CLUMPS)
  fragColor = vec4(clumpSum * perStrand * (0.5 + 0.5 * h), shown);
#elif defined(VIEW_SHADOW)
  fragColor = vec4(vec3(mix(lightShare(lit, 0.0, light3.z), lightShare(lit, h, light3.z), closed)), shown);
#else
  fragColor = vec4(encodeSrgb(toneMap(color)), shown);
#endif
}
