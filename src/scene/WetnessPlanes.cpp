#include "scene/WetnessPlanes.h"

#include <cmath>

#include "scene/PackBits.h"

namespace fur::scene {

namespace {
// Number times scale plus offset is the whole number in the file. Centres may lie beside the atlas: -1..2.
constexpr Vec4 kScale(21845, 21845, 65535, 16384), kOffset(21845, 21845, 0, 0);
}  // namespace

std::vector<std::uint8_t> packWetness(std::span<const Vec4> texels) {
  std::vector<std::uint8_t> planes(8 * texels.size());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    if (!(texels[i].w > 0)) continue;
    const Vec4 whole = glm::clamp(glm::floor(texels[i] * kScale + kOffset + 0.5f), Vec4(0, 0, 1, 0), Vec4(65535));
    for (int k = 0; k < 4; ++k) {
      const auto bits = static_cast<std::uint32_t>(whole[k]);
      planes[static_cast<std::size_t>(2 * k) * texels.size() + i] = static_cast<std::uint8_t>(bits >> 8);
      planes[static_cast<std::size_t>(2 * k + 1) * texels.size() + i] = static_cast<std::uint8_t>(bits);
    }
  }
  return packBits(planes);
}

bool unpackWetness(std::span<const std::uint8_t> packed, std::span<Vec4> texels) {
  std::vector<std::uint8_t> planes(8 * texels.size());
  if (!unpackBits(packed, planes)) return false;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    Vec4 whole;
    for (int k = 0; k < 4; ++k)
      whole[k] = static_cast<float>(planes[static_cast<std::size_t>(2 * k) * texels.size() + i] * 256 +
                                    planes[static_cast<std::size_t>(2 * k + 1) * texels.size() + i]);
    texels[i] = whole.w > 0 && whole.z > 0 ? (whole - kOffset) / kScale : Vec4(0);
  }
  return true;
}

}  // namespace fur::scene
