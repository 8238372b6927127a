// How far round each texel of a groom's map fur is of one type and of one length: so far a ray through the coat need not ask the map.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "groom/Groom.h"

namespace fur::groom {

// Two bytes a texel, row-major. The first: the type, 0 to 3, and four times the number of texels, kMostReach at most, along x and y, up to
// which all that lie on charts are equal to it; 0 where several types share the texel. The second: its length. Between charts they say
// nothing.
using EvenTexel = std::array<std::uint8_t, 2>;
inline constexpr std::uint8_t kMostReach = 63;
std::vector<EvenTexel> evenReach(const GroomMap& map, const geometry::AtlasTexels& atlas);

}  // namespace fur::groom
