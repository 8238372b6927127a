// Depth of the first surface in two bytes; or opacity, added to every layer that lies deeper.
#include "common.glsl"
#ifdef SHADOW_LAYERS
#include "common_furshadow.glsl"
#include "common_layers.glsl"
uniform sampler2DArray coverage;
in vec2 vTile;
flat in float vHeight;
layout(location = 0) out vec4 layers0;
layout(location = 1) out vec4 layers1;
layout(location = 2) out vec4 layers2;
layout(location = 3) out vec4 layers3;

// A full shell takes this much, so that all of them take 0.72 of what is dark.
const float kShell = 0.09;

void main() {
  float z = gl_FragCoord.z * shadowRange - unpack(packedDepths(ivec2(gl_FragCoord.xy)).rg) * shadowRange;
  float lod = log2(shadowRange * tilesPerUnit * tileTexels / float(kShadowSize));
  float opacity = kShell * textureLod(coverage, vec3(vTile, nearestLayer(storedLayer(vHeight, 0.0))), lod).r;
  // Half a layer on, or rounding would count the first surface as lying before itself.
  float deep = z / shadowLayerDepth + 0.5;
  const vec4 four = vec4(0.0, 1.0, 2.0, 3.0);
  layers0 = opacity * step(deep, four);
  layers1 = opacity * step(deep - 4.0, four);
  layers2 = opacity * step(deep - 8.0, four);
  layers3 = opacity * step(deep - 12.0, four);
}
#else
out vec4 fragColor;
void main() {
  float steps = clamp(gl_FragCoord.z, 0.0, 1.0) * 255.0;
  vec2 depth = vec2(floor(steps) / 255.0, fract(steps));
  fragColor = vec4(depth, depth);  // the colour mask tells which it is
}
#endif
