#include "furgen/LockCentres.h"

#include "core/Math.h"
#include "core/Random.h"

namespace fur::furgen {

std::vector<std::array<std::uint8_t, 2>> lockCentres(int size, int across) {
  Random random(1);
  std::vector<Vec2> jitter;
  for (int i = 0; i < across * across; ++i) {
    const float x = random.uniform(), y = random.uniform();
    jitter.emplace_back(0.1f + 0.8f * Vec2(x, y));
  }
  const auto wrapped = [across](int i) { return (i + across) % across; };
  std::vector<std::array<std::uint8_t, 2>> texels;
  for (int i = 0; i < size * size; ++i) {
    const Vec2 at = (Vec2(i % size, i / size) + 0.5f) * (static_cast<float>(across) / static_cast<float>(size));
    const int x0 = static_cast<int>(at.x), y0 = static_cast<int>(at.y);
    Vec2 nearest(9);
    for (int y = y0 - 2; y <= y0 + 2; ++y)
      for (int x = x0 - 2; x <= x0 + 2; ++x) {
        const Vec2 way = Vec2(x, y) + jitter[static_cast<std::size_t>(wrapped(y) * across + wrapped(x))] - at;
        if (glm::dot(way, way) < glm::dot(nearest, nearest)) nearest = way;
      }
    const auto byte = [](float part) { return static_cast<std::uint8_t>(saturate(0.5f + part / 4) * 255 + 0.5f); };
    texels.push_back({byte(nearest.x), byte(nearest.y)});
  }
  return texels;
}

}  // namespace fur::furgen
