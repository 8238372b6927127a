#include "common.glsl"
in vec2 vScreen;
out vec4 fragColor;
void main() {
  vec3 color = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, vScreen.y));
  // Half a step of noise: a smooth gradient bands in 8 bits.
  float noise = fract(sin(dot(floor(gl_FragCoord.xy), vec2(12.9898, 78.233))) * 43758.5453);
  fragColor = vec4(color + (noise - 0.5) / 255.0, 1.0);
}
