// One direction of a Gaussian (sigma 4 taps of `stepUv`); r the cast shadow, g the contact shadow, which is wider.
precision highp float;
uniform highp sampler2D source;
in vec2 vScreen;
out vec4 fragColor;
void main() {
#ifdef VERTICAL
  const vec2 direction = vec2(0.0, 1.0);
#else
  const vec2 direction = vec2(1.0, 0.0);
#endif
  vec2 stepUv = direction / vec2(textureSize(source, 0));
  vec2 sum = vec2(0.0);
  float total = 0.0;
  for (float i = -9.0; i <= 9.0; i += 1.0) {
    float weight = exp(-i * i / 32.0);
    sum += weight * vec2(texture(source, vScreen + i * stepUv).r, texture(source, vScreen + 1.8 * i * stepUv).g);
    total += weight;
  }
  fragColor = vec4(sum / total, 0.0, 1.0);
}
