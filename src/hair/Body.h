// Collision shapes: what hair does not enter.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/Math.h"

namespace fur::hair {

inline constexpr std::size_t kMostBodies = 64;
inline constexpr float kLeastBody = 0.01f, kLargestBody = 10;  // radius, model units

// A sphere (a == b) or capsule. Model space, on the model as it was made; goes with the model, and with a bone of its rig.
struct Body {
  Vec3 a{0}, b{0};
  float radius = 0.1f;
  std::int32_t bone = -1;  // a node (scene/Rig.h); -1: none
  bool operator==(const Body&) const = default;
};

}  // namespace fur::hair
