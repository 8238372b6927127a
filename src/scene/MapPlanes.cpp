#include "scene/MapPlanes.h"

#include "scene/PackBits.h"

namespace fur::scene {

std::vector<std::uint8_t> packMap(std::span<const groom::GroomMap::Texel> texels) {
  std::vector<std::uint8_t> planes;
  planes.reserve(4 * texels.size());
  for (std::size_t k = 0; k < 4; ++k)
    for (const groom::GroomMap::Texel& texel : texels) planes.push_back(texel[k]);
  return packBits(planes);
}

bool unpackMap(std::span<const std::uint8_t> packed, std::span<groom::GroomMap::Texel> texels) {
  std::vector<std::uint8_t> planes(4 * texels.size());
  if (!unpackBits(packed, planes)) return false;
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) texels[i][k] = planes[k * texels.size() + i];
  return true;
}

}  // namespace fur::scene
