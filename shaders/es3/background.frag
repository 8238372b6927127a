// A gradient, and on it the shadow that the model casts on the ground.
#include "common.glsl"
#include "common_noise.glsl"
uniform sampler2D shadowMap;
in vec3 vColor;
in vec3 vRay;
flat in vec4 vGround;
out vec4 fragColor;
void main() {
  vec3 color = vColor;
  if (vRay.y < 0.0 && vGround.w > 0.0) {
    vec2 spot = vGround.xy + vRay.xz * (vGround.z / vRay.y);
    // Nothing where the map ends.
    color -= color * (vGround.w * textureLod(shadowMap, spot, 0.0).r);
  }
  // Half a step of noise: a smooth gradient bands in 8 bits.
  fragColor = vec4(color + (quickNoise() - 0.5) / 255.0, 1.0);
}
