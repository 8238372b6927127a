#include "hair/StrandShading.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

namespace {
// sin of the angle whose cosine is `c`; rounding may carry |c| of unit vectors past 1.
float sineOf(float c) { return std::sqrt(std::max(1.0f - c * c, 0.0f)); }
}  // namespace

float kajiyaDiffuse(const Vec3& tangent, const Vec3& light) { return sineOf(glm::dot(tangent, light)); }

float kajiyaSpecular(const Vec3& tangent, const Vec3& light, const Vec3& view, float exponent) {
  const float tl = glm::dot(tangent, light), tv = glm::dot(tangent, view);
  const float base = saturate(sineOf(tl) * sineOf(tv) - tl * tv);
  // pow(0, 0) is undefined in GLSL, whose twin this is.
  return base > 0.0f ? std::pow(base, exponent) : 0.0f;
}

float furShadow(float height, float density, float nDotL) {
  const float f = 1.0f - saturate(nDotL);
  // Also where nothing stands to cast one.
  if (f <= 0.0f || density <= 0.0f) return 1.0f;
  return saturate((4.0f * height / density - 3.0f * f) / f);
}

}  // namespace fur::hair
