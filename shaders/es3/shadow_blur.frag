// Softens the depths of first surfaces, one direction at a time. It is light that must be averaged, so the mean
// is that of exp(k depth): for a flat receiver below, exp(-k dz) of this mean is the mean of exp(-k dz).
#include "common.glsl"
#include "common_furshadow.glsl"
out vec4 fragColor;

// At this k, in model units and base 2, penumbras are full; fur with a greater one has tighter ones.
const float kMean = 12.0;
// Every second texel up to here: a Gaussian of 3.5 texels, 0.02 of the model.
const int kReach = 10;

// What lies deeper counts as that much deeper at most, model units: or empty space beside a body would light its
// far side as far as the blur reaches, and no further.
const float kFarther = 0.15;

void main() {
#ifdef VERTICAL
  const ivec2 direction = ivec2(0, 1);
#else
  const ivec2 direction = ivec2(1, 0);
#endif
  ivec2 at = ivec2(gl_FragCoord.xy);
  float centre = unpack(packedDepths(at).rg), k = kMean * volumeShadow.w, sum = 0.0, total = 0.0;
  for (int i = -kReach; i <= kReach; i += 2) {
    float weight = exp2(-0.06 * float(i * i));
    ivec2 near = clamp(at + i * direction, ivec2(0), ivec2(kShadowSize - 1));
    sum += weight * exp2(min(k * (unpack(packedDepths(near).rg) - centre), kMean * kFarther));
    total += weight;
  }
  float steps = clamp(centre + log2(sum / total) / k, 0.0, 1.0) * 255.0;
  fragColor = vec4(floor(steps) / 255.0, fract(steps), 0.0, 1.0);
}
