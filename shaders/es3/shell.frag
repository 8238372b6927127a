// Marches the coat along the view ray, front to back from where the ray enters it, and shades once what it met:
// strands, and the skin between them. Rays that leave a round body's coat again stay transparent.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_locks.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"
#include "common_layers.glsl"
#include "shell_ray.glsl"
#include "shell_march.glsl"
#ifdef GROOMED
#include "common_types.glsl"
#endif
#ifdef TYPES
#include "shell_types.glsl"
#else
#include "shell_type.glsl"
#endif
#ifdef WET
#include "shell_wet.glsl"
#else
#include "shell_dry.glsl"
#endif
#include "shell_groom.glsl"
#include "shell_views.glsl"

uniform sampler2D baseColor;

out vec4 fragColor;

#include "shell_root.glsl"
#if defined(TEXTURED) && defined(TYPES)
mat2 uvSteps;  // how the model's uv changes from pixel to pixel, from before any branch
void enterModel() { uvSteps = mat2(dFdx(vLean.zw), dFdy(vLean.zw)); }
// Under strands that have a colour map skin has the model's own picture, or one of its own.
vec3 skinAlbedo(vec3 ofStrands) {
  return skinPictured(skinColor() * strandModelColor(baseColor, -1.0, vLean.zw, uvSteps), vLean.zw, uvSteps);
}
#else
void enterModel() {}
vec3 skinAlbedo(vec3 ofStrands) { return skinColor() * ofStrands; }
#endif
#ifdef PAINTED
vec3 paintStrand(vec3 albedo, Met met, float variance) { return paintedStrand(albedo, rootInAtlas(met.spot), variance, met.h, met.strand.z); }
vec3 paintSkin(vec3 albedo, Met met) { return painted(albedo, rootInAtlas(met.spot), vec3(1.0)); }
#else
vec3 paintStrand(vec3 albedo, Met met, float variance) { return albedo; }
vec3 paintSkin(vec3 albedo, Met met) { return albedo; }
#endif

// Sets up the ray. Returns the length of its first step.
float enterCoat() {
  stored = storedLayers;
  // Fur is read from one mip level, picked by chance between the two that trilinear filtering would
  // blend, and half a level sharper than a pixel's footprint: fur hides the grain, blur would make felt of it.
  lod = floor(max(vLight.w - 0.5 - finer, 0.0) + quadNoise());
  float pixels = exp2(-vLight.w);  // that a texel covers
  // Samples together have soft edges when each has sharp ones.
  sharp = max(pixels * (finer > 0.0 ? 1.5 : 1.0), 1.0);
  end = rayTo(vTop, reachesSkin);
  if (chartShare() <= 0.0) end = 0.0;
  stepSize = stepOver(min(pixels, 1.0)) * (finer > 0.0 ? kSampleStep : 1.0);
  // Where the first step falls, which layer stands for a height between two, which samples are covered: each by
  // chance, so that nothing forms rings.
  noise = otherPixelNoise();
  between = fract(noise * 7.0) - 0.5;
  enterView();
  enterWater();
  // A ray along a level coat is long: no more steps than there may be. Of one that comes past the skin they are counted to where it
  // is deepest: to where it comes out they would be twice as long as those of its neighbours that just reach the skin, a dark ring.
  stepSize = max(stepSize, (reachesSkin ? 1.0 : 0.5) * end / float(FUR_MOST_STEPS));
  float first = kFirstStep * stepSize * (noise - 0.5 * min(finer, 1.0));
  softness = kReferenceSteps * stepSize;
  foot = tileAt(end, 0.0);
  enterChart();
  enterShape();
  enterGroom();
  return first;
}

// After a step that adds so much to what is hidden.
void stepOn(inout March march, Strand here, float add) {
  viewStep(here, add);
  march.xSum += add * march.x;
  march.alpha += add;
  march.x += stepSize;
}

// The step at which the ray meets a strand, as the groom has it.
void stepPast(inout March march, Strand here) {
  shape(here);
  trim(here, march);
  stepOn(march, here, addStrand(here, march));
}

// Steps along the ray until strands hide what is behind them, FUR_MOST_STEPS times at most. Look-ups in a step: 1; GROOMED 1 more;
// TYPES up to 2 for each type that is present instead of the 1, while the map is not even; WET 3 more, 1 in a
// whole sheet. A software rasteriser would go through a step once more with nothing to do if loops asked at their beginning alone.
March marchCoat(float first) {
  March march = marchFrom(first + enters, enters);
  int mostSteps = FUR_MOST_STEPS;
  if (underSheet()) mostSteps = kSheetSteps;
  int steps = stepsTo(end, march.x, stepSize, mostSteps);
  int begun = 0;
#ifdef TYPES
  int plainSteps = stepsTo(plainTo, march.x, stepSize, mostSteps);
  for (int i = 0; i < plainSteps; ++i) {
    Strand here = standingAt(march.x);
    shape(here);
    stepOn(march, here, addPlain(here, march));
    if (march.alpha > closes || i + 1 == plainSteps) break;
  }
  if (plainSteps > 0) leavePlain(march);
  begun = march.alpha > closes ? steps : plainSteps;
#endif
  for (int i = begun; i < steps; ++i) {
    stepPast(march, standingAt(march.x));
    if (march.alpha > closes || i + 1 == steps) break;
  }
  return march;
}

// The share of the pixel's samples that is shown, dithered. Bare skin is left to its own pass: what stands on it, as an eye, would be hidden.
float shownShare(March march) {
  if (!kSkinShows || leavesSkin() || grown < kBareBelow) reachesSkin = false;
  float closed = min(march.alpha / closes, 1.0);
  return viewedShare((reachesSkin ? 1.0 : closed) * chartShare() + (fract(noise * 13.0) - 0.5) / samples);
}

Met resolve(March march) {
  Met met;
  met.closed = min(march.alpha / closes, 1.0);
  float perStrand = 1.0 / max(march.alpha, 1e-3);
  met.x = march.alpha > 0.0 ? march.xSum * perStrand : end;
  // Worked out again: to carry it through the march costs more.
  met.here = standingAt(march.metX);
  met.spot = spotOf(met.here, march);
  if (march.alpha <= 0.0) met.spot.xyz = vec3(foot, 0.0);
  met.h = heightMet(march, perStrand, met.x);
  met.strand = strandAt(met.spot, met.here);
  met.number = met.strand.z;
  met.held = 0.0;
  joinStrands(met, march.furry);
  return met;
}

vec3 tangentOf(Met met, March march) {
  vec2 tilt = tiltOf(met);
  // As where they are lit: wet strands that lean by their whole height shine in rings round the body.
  vec3 tangent = vec3(tilt + vLean.xy * litHeight(met), sqrt(max(0.05, 1.0 - dot(tilt, tilt))));
  tangent.xy += clumpTilt(met, march);
  tangent.xy += shapeTilt(met.spot, met.h);
  return normalize(tangent);
}

// Looks towards the light in samples after the first, which count strands; the first of them so many texels away, as the light begins
// within its own strand.
const int kLooks = 8;
const float kOwnTexels = 3.0;

// What covers the way to the light `rise` higher up than the strand, at height h.
float coverAbove(Met met, float h, float rise, float level) {
  float layer = nearestLayer(storedLayer(h)) + firstLayer(met.spot.z);
  return textureLod(coverage, vec3(met.spot.xy + vLightStep * rise, layer), level).r;
}

// The share of the key light that other strands leave: real strands cast real shadows.
float lightOn(Met met, float furry) {
  float lit = 1.0, ofOne = shadeOfOne() * shadowShown() * furry, h = litHeight(met);
  // One look says what is there on average; several find the strands that the light crosses, each of which takes its share.
  bool counts = finer > 0.0 && lod < 0.5;
  float first = min(kOwnTexels / (tileTexels * length(vLightStep) + 1e-6), 0.5 * FUR_SHADE_RISE), stride = (FUR_SHADE_RISE - first) / float(kLooks);
  float rise = counts ? first + stride * pixelNoise() : FUR_SHADE_RISE, before = counts ? 1.0 : 0.0;
  bool looks = ofOne > 0.0 && h + rise < 1.0;
  for (int i = 0; i < kLooks && looks; ++i) {
    float there = coverAbove(met, h + rise, rise, counts ? lod : lod + 1.0);
    there = clamp((there - 0.5) * (counts ? sharp : 1.0) + 0.5, 0.0, 1.0);
    lit *= 1.0 - ofOne * max(there - before, 0.0);
    before = there;
    rise += stride;
    if (!counts || i + 1 == kLooks || h + rise >= 1.0) break;
  }
  // How far the ray went, to the strands or to the skin.
  return underOthers(lit * furShadowAt(vLightSpace + vLightRay * (met.x - enters)));
}

vec3 shadeStrands(Met met, March march, vec3 model, vec3 T, vec3 L, vec3 V, float lit) {
  StrandColors colors = colorsOf();
  vec3 albedo = strandColor(colors.root, colors.tip, colors.variance, met.h, met.strand.z, model);
  float rho = min(met.held, 1.0);
  albedo = soaked(paintStrand(albedo, met, colors.variance), rho);
  vec3 color = shadeStrand(albedo, T, L, V, underOthers(litHeight(met)), rho, lit, vView.w, met.strand.z);
  return waterLight(color, albedo, met, T, L, V, lit);
}

// `color` over the skin that strands leave open.
vec3 overSkin(vec3 color, Met met, vec3 model, float lit) {
  if (reachesSkin && met.closed < 1.0) {
    vec3 bare = paintSkin(skinAlbedo(model), met);
    float rho = min(met.held, 1.0);
    vec3 skin = shadeSkin(bare * 0.5, vLight.z, vView.w, FUR_WET_SKIN_HEIGHT * rho, rho, lit);
    // Pores: the lowest layer says where strands root (Sheppard 5.2).
    skin *= 1.0 - 0.4 * grown * textureLod(coverage, vec3(foot, firstLayer(met.spot.z)), lod).r;
    skin = thinned(skin, bare, rho, lit);
    color = met.closed > 0.0 ? mix(skin, color, met.closed) : skin;
  }
  return color;
}

void main() {
  enterModel();
  March march = marchCoat(enterCoat());
#ifdef VIEW_STEPS
  fragColor = heat(0.2 * taken);
#else
  float shown = shownShare(march);
  if (shown < 0.5 / samples) discard;
  showTypes(march);
  Met met = resolve(march);
  vec2 turned = vPath.zw * met.x;
  vec3 T = tangentOf(met, march), L = inTurnedFrame(vLight.xyz, turned), V = inTurnedFrame(vView.xyz, turned);
  float lit = lightOn(met, march.furry);
  vec3 model = colorAtRoot(met.spot);
  vec3 color = overSkin(shadeStrands(met, march, model, T, L, V, lit), met, model, lit);
  fragColor = vec4(viewed(color, met, march, T, L, lit), shown);
#endif
}
