// The numbers of the fur at one place of the skin, which the editor's Edit mode shows and sets (Sheppard 2004, 5.4.2).
#pragma once

#include <array>

#include "core/Math.h"

namespace fur::app {

struct FurAt {
  Vec3 place{0}, normal{0, 1, 0};          // of the skin, model space
  float length = 1;                        // share of the longest
  std::array<float, 4> types{1, 0, 0, 0};  // shares
  Vec3 comb{0};                            // bend, radians across the normal, as groom::Groom::comb
  float wetness = 0;                       // 0 dry to 1 soaked
};

// One that can be set.
enum class FurNumber { Length, Type, Comb, Wetness };

}  // namespace fur::app
