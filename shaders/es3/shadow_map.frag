// Depth of the first surface in two bytes; or opacity, added to every layer that lies deeper.
#include "common.glsl"
#ifdef SHADOW_LAYERS
#include "common_furshadow.glsl"
#include "common_layers.glsl"
#include "common_opacity.glsl"
uniform sampler2DArray coverage;
in vec2 vTile;
flat in float vHeight;

// A full shell takes this much, so that all of them take 0.72 of what is dark.
const float kShell = 0.09;

void main() {
  float lod = log2(shadowRange * tilesPerUnit * tileTexels / float(shadowSize()));
  addOpacity(kShell * textureLod(coverage, vec3(vTile, nearestLayer(storedLayer(vHeight, 0.0))), lod).r);
}
#else
#include "common_depth.glsl"
out vec4 fragColor;
void main() { fragColor = packedDepth(); }
#endif
