// Skin for tests of what lies round a texel: places on the plane z = 0, or wherever a test moves them, one a texel.
#pragma once

#include <span>
#include <vector>

#include "wet/WaterAround.h"

namespace fur::test {

struct FlatSkin {
  int size;
  std::vector<wet::SurfaceTexels::Place> places;
  std::vector<std::uint32_t> placeOf;

  static constexpr float kWidth = wet::WaterAround::kCell / 4;  // of a texel: a cell is 4 wide
  wet::WaterAround around() const { return {size, places, placeOf, kWidth}; }
};

// Of those texels of a mask under which `skin` says that some lies.
inline FlatSkin flatSkin(int size, std::span<const std::uint8_t> skin) {
  FlatSkin flat{size, {}, std::vector<std::uint32_t>(skin.size(), wet::SurfaceTexels::kNone)};
  for (std::uint32_t i = 0; i < skin.size(); ++i) {
    if (!skin[i]) continue;
    const Vec2 at = Vec2(i % static_cast<std::uint32_t>(size), i / static_cast<std::uint32_t>(size)) - 0.5f * static_cast<float>(size);
    flat.placeOf[i] = static_cast<std::uint32_t>(flat.places.size());
    flat.places.push_back({Vec3(FlatSkin::kWidth * at, 0), Vec3(0, 0, 1), FlatSkin::kWidth * FlatSkin::kWidth, i, 0});
  }
  return flat;
}

}  // namespace fur::test
