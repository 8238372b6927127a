#include "scene/MapPlanes.h"

#include "scene/PackBits.h"

namespace fur::scene {

namespace {
std::size_t planeSize(std::size_t bytes) { return (bytes + 3) / 4; }
}  // namespace

std::vector<std::uint8_t> packPlanes(std::span<const std::uint8_t> bytes) {
  const std::size_t size = planeSize(bytes.size());
  std::vector<std::uint8_t> planes(4 * size);
  for (std::size_t i = 0; i < bytes.size(); ++i) planes[i % 4 * size + i / 4] = bytes[i];
  return packBits(planes);
}

bool unpackPlanes(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes) {
  const std::size_t size = planeSize(bytes.size());
  std::vector<std::uint8_t> planes(4 * size);
  if (!unpackBits(packed, planes)) return false;
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = planes[i % 4 * size + i / 4];
  return true;
}

std::vector<std::uint8_t> packMap(std::span<const groom::GroomMap::Texel> texels) {
  return packPlanes({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size_bytes()});
}

bool unpackMap(std::span<const std::uint8_t> packed, std::span<groom::GroomMap::Texel> texels) {
  return unpackPlanes(packed, {reinterpret_cast<std::uint8_t*>(texels.data()), texels.size_bytes()});
}

}  // namespace fur::scene
