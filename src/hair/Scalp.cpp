#include "hair/Scalp.h"

#include <algorithm>

namespace fur::hair {

std::string soundName(std::string_view name) {
  constexpr std::size_t kMost = 64;
  std::size_t size = std::min(name.size(), kMost);
  // A byte 10xxxxxx goes on with the character before it.
  while (size < name.size() && size > 0 && (static_cast<unsigned char>(name[size]) & 0xc0u) == 0x80u) --size;
  return std::string(name.substr(0, size));
}

void paintDensity(groom::GroomMap& map, const groom::GroomSurface& skin, const Vec3& centre, float radius, float density) {
  if (!(radius > 0)) return;
  constexpr float kRim = 0.12f;  // share of the radius
  const geometry::AtlasTexels& atlas = skin.atlas;
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t)
    atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const float far = glm::distance(positionAt(skin.surface, geometry::SurfacePoint{t, weights, 0}), centre) / radius;
      groom::GroomMap::Texel value = map.texels()[texel];
      const float now = glm::mix(static_cast<float>(value[0]), 255 * saturate(density), saturate((1 - far) / kRim));
      value[0] = static_cast<std::uint8_t>(now + 0.5f);
      map.set(texel, value);
    });
  map.fillGutter(atlas, {0, 0, map.size(), map.size()});
}

}  // namespace fur::hair
