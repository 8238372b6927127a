// One direction of a Gaussian (sigma 2 texels), across and then down; g, the contact shadow, 1.8 times as wide. In the end
// r is how dark the ground is, and g where it mirrors the model; both end in a circle.
precision highp float;
uniform highp sampler2D source;
in vec2 vScreen;
flat in int vSecond;
out vec4 fragColor;
void main() {
  vec2 stepUv = (vSecond == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) / vec2(textureSize(source, 0));
  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int k = -5; k <= 5; ++k) {
    float i = float(k), weight = exp2(-0.18 * i * i);
    sum += weight * vec3(texture(source, vScreen + i * stepUv).rb, texture(source, vScreen + 1.8 * i * stepUv).g).xzy;
    total += weight;
  }
  vec3 shadow = sum / total;
  if (vSecond != 0) {
    float edge = 1.0 - smoothstep(0.75, 0.98, length(2.0 * vScreen - 1.0));
    shadow = edge * vec3(min(0.55 * shadow.r + 0.45 * shadow.g * shadow.g, 1.0), shadow.b, 0.0);
  }
  fragColor = vec4(shadow, 1.0);
}
