#include "core/Srgb.h"

namespace fur {

Vec3 encodeSrgb(const Vec3& linear) {
  Vec3 out;
  for (int k = 0; k < 3; ++k) {
    const float x = saturate(linear[k]);
    out[k] = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
  }
  return out;
}

Vec3 decodeSrgb(const Vec3& srgb) {
  Vec3 out;
  for (int k = 0; k < 3; ++k) {
    const float x = saturate(srgb[k]);
    out[k] = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  }
  return out;
}

Vec3 linearColor(std::uint32_t srgb) { return decodeSrgb(Vec3(srgb >> 16 & 255u, srgb >> 8 & 255u, srgb & 255u) / 255.0f); }

}  // namespace fur
