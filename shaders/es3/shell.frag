// Marches one slab of fur from its top layer down, front to back, and shades the result once.
// Blended over what lies below: slabs are drawn from the skin outwards.
#include "common.glsl"
#include "common_shading.glsl"
#include "common_clump.glsl"

uniform sampler2DArray tile;  // r: coverage  g, b: strand tangent x, y  a: variance
uniform sampler2D baseColor;
#ifdef WET
uniform sampler2D mask;
#endif

in vec4 vTile;
in vec4 vLight;
in vec4 vView;
in vec4 vLean;
in vec2 vLightStep;
flat in float vTop;
in float vSubSteps;
in vec2 vStrands;
#ifdef WET
in vec2 vAtlas;
in vec4 vAtlasStep;
#endif

out vec4 fragColor;

// The layers that the strand edges and mip levels are tuned for; see `softness`.
const float kReferenceLayers = 16.0;

// The ends of the interval run linearly over the triangle, and a ray that comes in askew meets the strands
// below where they have moved on: asked at the slab's top only, a strand would come and go from slab to slab.
vec2 strandsALayerDown() {
  vec2 tileX = dFdx(vTile.xy), tileY = dFdy(vTile.xy);
  float area = tileX.x * tileY.y - tileX.y * tileY.x;
  if (abs(area) < 1e-14) return vec2(0.0);
  vec2 pixels = vec2(tileY.y * vTile.z - tileY.x * vTile.w, tileX.x * vTile.w - tileX.y * vTile.z) / area;
  return clamp(dFdx(vStrands) * pixels.x + dFdy(vStrands) * pixels.y, -1.0, 1.0);
}

float storedLayer(float drawn) { return floor((drawn + 0.5) * volume.y / shape.z); }

void main() {
  float lod = pickLevel(vLight.w);
  // Where charts overlap (geometry/FurOverlap.h) this one shows the strands whose number lies between the
  // two of `strands`, with ends a tenth wide (1 / perSoft): a texel or two on the way through the zone.
  // Mip levels mix the numbers of neighbours until only the mean share is known: wide ends come to that.
  float perSoft = 10.0 * exp2(-2.0 * lod);
  vec2 strandsStep = strandsALayerDown();
  vec2 strands = vStrands * (perSoft + 1.0);
  vec2 lastStrands = vStrands + strandsStep * shape.w;
  bool some = max(vStrands.y, lastStrands.y) > 0.0 && min(vStrands.x, lastStrands.x) < 1.0 && vStrands.x < vStrands.y;
  // Magnified strands get edges one pixel wide; minified ones keep their fractional coverage.
  float sharp = exp2(max(-vLight.w, 0.0));
  vec2 at = vTile.xy;
  float layer = vTop - 1.0;
  float alpha = 0.0;
  vec4 sum = vec4(0.0);       // tangent x, y, variance, layer; weighted by what each adds
  vec2 hit = at;
#ifdef WET
  mat2 atlasFromTile = mat2(vAtlasStep.xy, vAtlasStep.zw);
  mat2 tileFromAtlas = inverse(atlasFromTile);
  vec3 wetSum = vec3(0.0);    // clump lean in tile units a layer, wetness
  // One clump a slab: the ray hardly leaves its texel on the way, and whose strands stand here is
  // asked of every root below.
  vec4 clump = clumpAt(mask, vAtlas);
#endif
  float subSteps = ceil(vSubSteps - 0.01);
  float stepSize = 1.0 / subSteps;
  strandsStep *= stepSize * (perSoft + 1.0);
  // A discard would not do: rasterisers may go on to march pixels that are discarded.
  float steps = some ? shape.w * subSteps : 0.0;
  // A half-covered texel is half-covered on every layer of the same strand: counted anew each time
  // it would grow opaque with the number of layers. Stands in for 1 - (1 - c)^softness.
  float softness = min(1.0, kReferenceLayers / (shape.z * subSteps));
  for (float k = 0.0; k < steps; k += 1.0) {
    vec2 root = at;
    float open = 1.0, level = lod;
#ifdef WET
    vec2 a = vAtlas + atlasFromTile * (at - vTile.xy);
    vec3 lean = vec3(0.0, 0.0, clump.a);
    if (clump.a > 0.0) {
      float h = (layer + 1.0) / shape.z;
      float s = clumpPull(h, clump.a);
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
      float below = clumpPull(h - 1.0 / shape.z, clump.a);
      lean.xy = tileFromAtlas * (fromCentre * (below - s));
    }
#endif
    vec4 t = textureLod(tile, vec3(root, storedLayer(layer)), level);
    float cover = clamp((t.r - 0.5) * sharp + 0.5, 0.0, 1.0) * open;
    // A strand's number is its variance, folded: any part of 0..1 holds as many bright as dark strands.
    vec2 below = clamp(strands - abs(2.0 * perSoft * t.a - perSoft), 0.0, 1.0);
    cover *= below.y - below.x;
    float add = cover * softness / (1.0 - cover * (1.0 - softness)) * (1.0 - alpha);
    sum += add * vec4(t.gba, layer);
#ifdef WET
    wetSum += add * lean;
#endif
    alpha += add;
    hit = at;
    if (alpha > 0.96) break;
    at += vTile.zw * stepSize;
    strands += strandsStep;
    layer -= stepSize;
  }
  // Along the silhouette a slab is seen edge-on and shows rings; fins take over (Lengyel et al. 2001).
  float shown = alpha * smoothstep(0.0, 0.12, normalize(vView.xyz).z);
  if (shown < 0.04) discard;
  sum /= alpha;
  float h = (sum.w + 1.0) / shape.z;

  vec2 tilt = sum.xy * 2.0 - 1.0;
  float rho = 0.0;
  vec3 tangent = vec3(tilt + vLean.xy, sqrt(max(0.05, 1.0 - dot(tilt, tilt))));
#ifdef WET
  wetSum /= alpha;
  rho = wetSum.z;
  // Eq. 4: the strand moves by -d, in model units; a layer is shape.x / shape.z high.
  tangent.xy += wetSum.xy * (shape.z / max(shape.x * shape.y, 1e-6));
#endif
  tangent = normalize(tangent);

  // A look towards the light through the fur above: real strands cast real shadows.
  const float kRise = 0.1;
  float lit = 1.0;
  if (h + kRise < 1.0)
    lit -= 0.65 * shading.w *
           textureLod(tile, vec3(hit + vLightStep * kRise, storedLayer((h + kRise) * shape.z - 1.0)), lod + 1.0).r;

  vec3 albedo = strandColor(h, sum.z, modelColor(baseColor, vLean.zw));
  vec3 color = shadeStrand(albedo, tangent, normalize(vLight.xyz), normalize(vView.xyz), h, rho, lit, vView.w);
#if defined(VIEW_TANGENTS)
  color = tangent * 0.5 + 0.5;
  fragColor = vec4(color * shown, shown);
#elif defined(VIEW_COVERAGE)
  fragColor = vec4(vec3(h) * shown, shown);
#else
  fragColor = vec4(encodeSrgb(toneMap(color)) * shown, shown);
#endif
}
