#include "render/Samples.h"

namespace fur::render {

namespace {

// The digits of `number` in that base, mirrored at the point.
float mirrored(int number, int base) {
  float sum = 0, digit = 1;
  for (; number > 0; number /= base) sum += (digit /= static_cast<float>(base)) * static_cast<float>(number % base);
  return sum;
}

}  // namespace

Vec2 sampleOffset(int sample) { return glm::fract(Vec2(mirrored(sample, 2), mirrored(sample, 3)) + 0.5f) - 0.5f; }

Vec4 sampleChance(int sample) {
  const float two = mirrored(sample, 5), four = mirrored(sample, 7);
  return {four, two, four, two};
}

}  // namespace fur::render
