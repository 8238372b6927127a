#include "common.glsl"
uniform sampler2D shadowMap;
in vec2 vGround;
out vec4 fragColor;
void main() {
  vec2 shadow = texture(shadowMap, vGround * 0.5 + 0.5).rg;
  float edge = 1.0 - smoothstep(0.75, 1.0, length(vGround));
  float dark = clamp(0.55 * shadow.r + 0.45 * shadow.g * shadow.g, 0.0, 1.0) * groundPlane.z * edge;
  fragColor = vec4(vec3(1.0 - dark), 1.0);
}
