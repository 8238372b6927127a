// What hair keeps of the light: depth of its first surface in two bytes; opacity for every layer that lies deeper; or its
// shadow on the ground.
#include "common.glsl"
#include "common_furshadow.glsl"
#include "common_hair.glsl"
in vec3 vPicture;
flat in float vKind;
uniform mediump sampler2DArray strips;

float stripCoverage() { return texture(strips, vec3(vPicture.xy / vPicture.z, vKind)).r; }

#if defined(ON_GROUND)
in vec4 vShadow;
out vec4 fragColor;
void main() { fragColor = vShadow * stripCoverage(); }
#elif defined(SHADOW_LAYERS)
#include "common_opacity.glsl"
void main() { addOpacity(hairOpacity * stripCoverage()); }
#else
#include "common_depth.glsl"
out vec4 fragColor;
void main() {
  if (stripCoverage() < 0.5) discard;
  fragColor = packedDepth();
}
#endif
