#include "common.glsl"
#include "common_noise.glsl"
in vec2 vScreen;
out vec4 fragColor;
void main() {
  vec3 color = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, vScreen.y));
  // Half a step of noise: a smooth gradient bands in 8 bits.
  fragColor = vec4(color + (pixelNoise() - 0.5) / 255.0, 1.0);
}
