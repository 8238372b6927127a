// A drop of water outside the fur, for who moves it (Water.h) and who draws it.
#pragma once

#include <cstdint>

#include "core/Math.h"

namespace fur::wet {

// Falls, or hangs from the fur; or is what is left to see of one that has landed. World space.
struct Drop {
  static constexpr std::uint32_t kNoPlace = 0xffffffffu;

  Vec3 position{0};
  float radius = 0.01f;
  Vec3 velocity{0};
  float water = 0;                 // how much of it
  std::uint32_t place = kNoPlace;  // of SurfaceTexels, that it hangs at; none while it falls
  float jet = 0;     // above 0: from a hose; a piece of its jet, which has fallen apart into drops when this has come from Water::kJet to 1
  float splash = 0;  // above 0: it has landed, and spreads until this is 1: as a ring on the ground, as spray where it still flies

  bool hangs() const { return place != kNoPlace; }
};

}  // namespace fur::wet
