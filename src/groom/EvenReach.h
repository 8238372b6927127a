// How far round each texel of a groom's map fur is of one type and of one length: so far a ray through the coat need not ask the map.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "groom/Groom.h"

namespace fur::groom {

// Four bytes a texel, row-major. The first: the type, 0 to 3, and four times the number of texels, kMostReach at most, along x and y, up to
// which all are equal to it that paths over its chart lead to; 0 where several types share the texel. What lies on other charts does not
// count: a ray that comes there is over other skin than they have. The second: its length. The third tells
// charts apart, also in their gutters: of a chart one and the same number, 0 on none. The fourth is 0.
using EvenTexel = std::array<std::uint8_t, 4>;
inline constexpr std::uint8_t kMostReach = 63;
std::vector<EvenTexel> evenReach(const GroomMap& map, const geometry::Surface& surface, const geometry::AtlasTexels& atlas);

// A map of lengths alone with the numbers of charts in its fourth channel, which is a type's otherwise: from 1 on, in their gutters as
// well, 0 on none; of more than 255 charts some have the same. By them shaders tell a ray that leaves its chart.
GroomMap withCharts(GroomMap map, const geometry::Surface& surface, const geometry::AtlasTexels& atlas);

}  // namespace fur::groom
