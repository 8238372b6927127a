// One direction of a Gaussian (sigma 2 texels), across and then down; g, the contact shadow, 1.8 times as wide.
precision highp float;
uniform highp sampler2D source;
in vec2 vScreen;
flat in int vSecond;
out vec4 fragColor;
void main() {
  vec2 stepUv = (vSecond == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) / vec2(textureSize(source, 0));
  vec2 sum = vec2(0.0);
  float total = 0.0;
  for (float i = -5.0; i <= 5.0; i += 1.0) {
    float weight = exp2(-0.18 * i * i);
    sum += weight * vec2(texture(source, vScreen + i * stepUv).r, texture(source, vScreen + 1.8 * i * stepUv).g);
    total += weight;
  }
  fragColor = vec4(sum / total, 0.0, 1.0);
}
