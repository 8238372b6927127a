// Depth of the first surface in two bytes; or opacity, added to every layer that lies deeper.
#include "common.glsl"
#ifdef SHADOW_LAYERS
#include "common_furshadow.glsl"
#include "common_layers.glsl"
#include "common_opacity.glsl"
uniform sampler2DArray coverage;
in vec2 vTile;
flat in float vHeight;

#ifdef TYPES
in vec4 vAlong, vGrows;

// The share of a type's strands that stand at that height (common_types.glsl), as dominances are spread evenly over 0.5..1.
float standing(float presence, float h) { return clamp(2.0 - 4.0 * (1.0 - presence) / max(2.0 - h, 1e-3), 0.0, 1.0); }

float coverOf(float lod) {
  float sum = 0.0;
  for (int type = 0; type < FUR_TYPES; ++type) {
    float h = vAlong[type], share = float(h <= 1.0) * standing(vGrows[type], h) * step(1e-3, vGrows[type]);
    sum += share * textureLod(coverage, vec3(vTile, nearestLayer(storedLayer(min(h, 1.0))) + float(type) * storedLayers), lod).r;
  }
  return min(sum, 1.0);
}
#else
float coverOf(float lod) { return textureLod(coverage, vec3(vTile, nearestLayer(storedLayer(vHeight))), lod).r; }
#endif

// A full shell takes this much, so that all of them take 0.72 of what is dark.
const float kShell = 0.09;

void main() {
  float lod = log2(shadowRange * tilesPerUnit * tileTexels / float(shadowSize()));
  addOpacity(kShell * coverOf(lod));
}
#else
#include "common_depth.glsl"
out vec4 fragColor;
void main() { fragColor = packedDepth(); }
#endif
