// Marches the coat along the view ray, front to back from where the ray enters it, and shades once what it met:
// strands, and the skin between them. Rays that leave a round body's coat again stay transparent.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"
#include "common_noise.glsl"
#include "common_furshadow.glsl"

uniform sampler2DArray tile;  // r: coverage  g, b: strand tangent x, y  a: variance
uniform sampler2D baseColor;
#ifdef WET
uniform sampler2D mask;
#endif
#ifdef GROOMED
uniform sampler2D groom;  // r: length of the fur, a share
#endif

in vec4 vTile;
in vec4 vTurn;
in vec4 vPath;
in vec4 vLight;
in vec4 vView;
in vec4 vLean;
in vec2 vLightStep;
flat in float vTop;
in vec2 vStrands;
#if defined(WET) || defined(GROOMED)
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
// A step in texels of the mip level, and how much longer each is than the one before: the first strands are seen
// clearly, only rays along the outline come further.
const float kTexelsAStep = 1.25;  // times volume.w
const float kGrowth = 1.03;
const int kMostSteps = 64;
// Steps a fur length at least, however small the picture.
const float kFewestSteps = 12.0;
// Strands that hide this much hide all.
const float kClosed = 0.96;

// `between`: added before rounding down.
float storedLayer(float h, float between) { return clamp(floor(h * volume.y + between), 0.0, volume.y - 1.0); }

// How far the ray goes, in fur lengths: to the skin, or where it only grazes a round body, out again.
float rayEnd(out bool reachesSkin) {
  float slope = -vPath.x, inside = slope * slope - 4.0 * vPath.y * vTop;
  reachesSkin = slope > 0.0 && inside > 0.0;
  if (slope <= 0.0) return 0.0;
  return min(reachesSkin ? 2.0 * vTop / (slope + sqrt(inside)) : slope / vPath.y, 6.0);
}

// The chart's share where charts overlap, see geometry/FurClusters.h: blended in order.
float chartShare() {
  vec2 strands = clamp(vStrands, 0.0, 1.0);
  return (strands.y - strands.x) / max(1.0 - strands.x, 1e-3);
}

// A direction in the surface's frame where the ray is, whose normal has turned on the way.
vec3 inTurnedFrame(vec3 v, vec2 turned) { return normalize(v + vec3(-turned * v.z, dot(turned, v.xy))); }

void main() {
  // Fur is read from one mip level, picked by chance between the two that trilinear filtering would
  // blend, and half a level sharper than a pixel's footprint: fur hides the grain, blur would make felt of it.
  float lod = floor(max(vLight.w - 0.5, 0.0) + quadNoise());
  // Magnified strands get edges one pixel wide; minified ones keep their fractional coverage.
  float sharp = exp2(max(-vLight.w, 0.0));
  float share = chartShare();
  bool reachesSkin;
  float end = rayEnd(reachesSkin);
  if (share <= 0.0) end = 0.0;
  float texels = length(vTile.zw) * volume.x * exp2(-max(vLight.w, 0.0));
  float stepSize = volume.w * min(kTexelsAStep / max(texels, 1e-3), 1.0 / (kFewestSteps * max(-vPath.x, 1.0 / kFewestSteps)));
  // Where the first step falls, which layer stands for a height between two, which samples are covered: each by
  // chance, so that nothing forms rings.
  float noise = otherPixelNoise();
  float between = fract(noise * 7.0) - 0.5;
  float x = stepSize * noise, alpha = 0.0, xSum = 0.0;
  vec4 sum = vec4(0.0);  // tangent x, y, variance, height; weighted by what each step adds
  vec2 at = vTile.xy;
#if defined(WET) || defined(GROOMED)
  mat2 atlasFromTile = mat2(vAtlasStep.xy, vAtlasStep.zw);
#endif
#ifdef WET
  mat2 tileFromAtlas = inverse(atlasFromTile);
  vec3 wetSum = vec3(0.0);  // clump lean in tile units a fur length, wetness
  float rho = 0.0;
#endif
  for (int k = 0; k < kMostSteps; ++k) {
    if (x >= end) break;
    float h = vTop + x * (vPath.x + x * vPath.y);
    at = vTile.xy + x * (vTile.zw + x * vTurn.xy) + vTurn.zw * (vTop * vTop - h * h);
    vec2 root = at;
    float open = 1.0, level = lod, along = h;
#if defined(WET) || defined(GROOMED)
    vec2 a = vAtlas + atlasFromTile * (at - vTile.xy);
#endif
#ifdef WET
    vec4 clump = clumpAt(mask, a);
    rho = clump.a;
    vec3 lean = vec3(0.0, 0.0, rho);
    if (rho > 0.0) {
      float s = clumpPull(h, rho);
      vec2 fromCentre = (a - clump.xy) / (1.0 - s);
      // Drawn together, strands are that much thinner than a pixel. Not all of it: locks keep their lines.
      level = floor(lod - 0.7 * log2(1.0 - s));
      vec4 home = clumpAt(mask, clump.xy + fromCentre);
      // Algorithm 2: a root outside the clump, in a dry texel or in another clump is no strand here.
      vec2 apart = home.xy - clump.xy;
      // The rim fades over a twelfth of the radius, so that locks have soft edges.
      open = clamp(12.0 * (1.0 - length(fromCentre) / max(clump.z, 1e-6)), 0.0, 1.0) *
             float(home.a > 0.0 && dot(apart, apart) <= 0.25 * clump.z * clump.z);
      root += tileFromAtlas * (clump.xy + fromCentre - a);
      float below = clumpPull(h - 1.0 / shape.z, rho);
      lean.xy = tileFromAtlas * (fromCentre * (below - s)) * shape.z;
    }
#endif
#ifdef GROOMED
    // Vertices know the mean length; the map knows it of every strand.
    along = h * vLength / max(textureLod(groom, vAtlas + atlasFromTile * (root - vTile.xy), 0.0).r, 1e-3);
    open *= float(along <= 1.0);
#endif
    vec4 t = textureLod(tile, vec3(root, storedLayer(along, between)), level);
    float cover = clamp((t.r - 0.5) * sharp + 0.5, 0.0, 1.0) * open;
    // Stands in for 1 - (1 - c)^softness.
    float softness = kReferenceSteps * stepSize;
    float add = cover * softness / (1.0 - cover * (1.0 - softness)) * (1.0 - alpha);
    sum += add * vec4(t.gba, h);
    xSum += add * x;
#ifdef WET
    wetSum += add * lean;
#endif
    alpha += add;
    if (alpha > kClosed) break;
    x += stepSize;
    stepSize *= kGrowth;
  }
  float closed = min(alpha / kClosed, 1.0), levels = sky.w;
  float shown = (reachesSkin ? 1.0 : closed) * share + (fract(noise * 13.0) - 0.5) / levels;
  if (shown < 0.5 / levels) discard;

  float perStrand = 1.0 / max(alpha, 1e-3);
  sum *= perStrand;
  float h = sum.w;
  vec2 turned = vPath.zw * (xSum * perStrand);
  vec3 light3 = inTurnedFrame(vLight.xyz, turned), view3 = inTurnedFrame(vView.xyz, turned);
  vec2 tilt = sum.xy * 2.0 - 1.0;
  vec3 tangent = vec3(tilt + vLean.xy * h, sqrt(max(0.05, 1.0 - dot(tilt, tilt))));
#ifdef WET
  wetSum *= perStrand;
  // Eq. 4: the strand moves by -d, in model units.
  tangent.xy += wetSum.xy / max(shape.x * shape.y, 1e-6);
  float skinWetness = rho;
  rho = wetSum.z;
#else
  const float rho = 0.0, skinWetness = 0.0;
#endif
  tangent = normalize(tangent);

  // A look towards the light through the fur above: real strands cast real shadows.
  const float kRise = 0.1;
  float lit = 1.0;
  if (h + kRise < 1.0)
    lit -= 0.65 * shading.w * textureLod(tile, vec3(at + vLightStep * kRise, storedLayer(h + kRise, 0.0)), lod + 1.0).r;

  // How far the ray went, to the strands or to the skin.
  lit *= furShadowAt(vLightSpace + vLightRay * (alpha > 0.0 ? xSum * perStrand : end));
  vec3 model = modelColor(baseColor, vLean.zw);
  vec3 color = shadeStrand(strandColor(h, sum.z, model), tangent, light3, view3, h, rho, lit, vView.w, sum.z);
  if (reachesSkin && closed < 1.0) {
    vec3 skin = shadeSkin(skinColor.rgb * model * 0.5, vLight.z, vView.w, 0.0, skinWetness, lit);
    color = alpha > 0.0 ? mix(skin, color, closed) : skin;
  }
#if defined(VIEW_TANGENTS)
  fragColor = vec4(tangent * 0.5 + 0.5, shown);
#elif defined(VIEW_COVERAGE)
  fragColor = vec4(vec3(h), shown);
#else
  fragColor = vec4(encodeSrgb(toneMap(color)), shown);
#endif
}
