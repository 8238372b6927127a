// Softens the depths of first surfaces, across and then down. It is light that must be averaged, so the mean
// is that of exp(k depth): for a flat receiver below, exp(-k dz) of this mean is the mean of exp(-k dz).
#include "common.glsl"
#include "common_furshadow.glsl"
flat in int vSecond;
out vec4 fragColor;

// At this k, in model units and base 2, penumbras are full; fur with a greater one has tighter ones.
const float kMean = 12.0;
// A Gaussian of 1.7 texels, 0.015 of the model.
const int kReach = 5;

// What lies deeper counts as that much deeper at most, model units: or empty space beside a body would light its
// far side as far as the blur reaches, and no further.
const float kFarther = 0.15;

void main() {
  ivec2 direction = vSecond == 0 ? ivec2(1, 0) : ivec2(0, 1);
  ivec2 at = ivec2(gl_FragCoord.xy);
  float centre = unpack(packedDepths(at).rg), k = kMean * shadowRange, sum = 0.0, total = 0.0;
  for (int i = -kReach; i <= kReach; ++i) {
    float weight = exp2(-0.24 * float(i * i));
    ivec2 near = clamp(at + i * direction, ivec2(0), ivec2(shadowSize() - 1));
    sum += weight * exp2(min(k * (unpack(packedDepths(near).rg) - centre), kMean * kFarther));
    total += weight;
  }
  float steps = clamp(centre + log2(sum / total) / k, 0.0, 1.0) * 255.0;
  fragColor = vec4(floor(steps) / 255.0, fract(steps), 0.0, 1.0);
}
