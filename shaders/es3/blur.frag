// One direction of a Gaussian (sigma 2 texels), across and then down; g, what is above, 1.8 times as wide, a, what stands there, half
// as wide. In the end r is how dark the ground is, and g where it mirrors the model; both end in a circle.
precision highp float;
uniform highp sampler2D source;
in vec2 vScreen;
flat in int vSecond;
out vec4 fragColor;
void main() {
  vec2 stepUv = (vSecond == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) / vec2(textureSize(source, 0));
  vec4 sum = vec4(0.0);
  vec2 total = vec2(0.0);
  for (int k = -5; k <= 5; ++k) {
    float i = float(k), weight = exp2(-0.18 * i * i), near = exp2(-0.72 * i * i);
    vec4 here = texture(source, vScreen + i * stepUv);
    sum += vec4(weight * here.r, weight * texture(source, vScreen + 1.8 * i * stepUv).g, weight * here.b, near * here.a);
    total += vec2(weight, near);
  }
  vec4 shadow = sum / total.xxxy;
  if (vSecond != 0) {
    float edge = 1.0 - smoothstep(0.75, 0.98, length(2.0 * vScreen - 1.0));
    shadow = edge * vec4(min(0.55 * shadow.r + 0.45 * shadow.g * shadow.g + 0.8 * shadow.a, 1.0), shadow.b, 0.0, 0.0);
  }
  fragColor = shadow;
}
