// Long hair as the renderer takes it: plain values and what is to be drawn of each scalp.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hair/HairValues.h"
#include "hair/MemberStrands.h"
#include "hair/Wisps.h"

namespace fur::render {

// What grows on a scalp; spans are read while it is set.
struct HairGrowth {
  const hair::HairValues& values;
  std::span<const hair::Wisp> wisps;  // in an order by chance: the first are the first to be drawn strand by strand
  std::span<const hair::MemberStrand> members;  // strands of a set, one set after another
  const hair::StripPicture& strips;
  std::span<const std::uint8_t> ambient;  // hair/AmbientOcclusion.h, of each point of each wisp
  std::span<const std::array<std::uint8_t, 4>> baseTangents;  // hair/BaseTangents.h, of each vertex of the surface
  int guides = 0, nodes = 0;  // and nodes of each guide
};

}  // namespace fur::render
