// A gradient, and on it the shadow that the model casts on the ground.
#include "common.glsl"
#include "common_noise.glsl"
uniform sampler2D shadowMap;
in vec2 vScreen;
in vec3 vRay;
flat in vec3 vEye;
out vec4 fragColor;
void main() {
  vec3 color = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, vScreen.y));
  float above = vEye.y - groundPlane.x;
  // From below the ground would hide the model.
  if (groundPlane.z > 0.0 && above > 0.0 && vRay.y < 0.0) {
    vec2 spot = (vEye.xz - vRay.xz * (above / vRay.y) - groundCentre.xy) / groundPlane.y;  // -1..1 over the map
    float far = length(spot);
    if (far < 1.0) {
      vec2 shadow = textureLod(shadowMap, spot * 0.5 + 0.5, 0.0).rg;
      float dark = clamp(0.55 * shadow.r + 0.45 * shadow.g * shadow.g, 0.0, 1.0);
      color *= 1.0 - dark * groundPlane.z * (1.0 - smoothstep(0.75, 1.0, far));
    }
  }
  // Half a step of noise: a smooth gradient bands in 8 bits.
  fragColor = vec4(color + (pixelNoise() - 0.5) / 255.0, 1.0);
}
