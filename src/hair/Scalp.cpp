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

void paintDensity(groom::GroomMap& map, const groom::GroomSurface& skin, std::span<const Vec4> balls, float density) {
  constexpr float kRim = 0.12f;  // share of the radius
  const geometry::AtlasTexels& atlas = skin.atlas;
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t)
    atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const Vec3 at = positionAt(skin.surface, geometry::SurfacePoint{t, weights, 0});
      float share = 0;
      for (const Vec4& ball : balls)
        if (ball.w > 0) share = std::max(share, saturate((1 - glm::distance(at, Vec3(ball)) / ball.w) / kRim));
      if (share == 0) return;
      groom::GroomMap::Texel value = map.texels()[texel];
      value[0] = static_cast<std::uint8_t>(glm::mix(static_cast<float>(value[0]), 255 * saturate(density), share) + 0.5f);
      map.set(texel, value);
    });
  map.fillGutter(atlas, {0, 0, map.size(), map.size()});
}

}  // namespace fur::hair
