// The way in which hair leaves the skin: the scalp is shaded as hair that lies so, with the base tangents of the hair on it, so that
// it does not show between wisps (Halen & Wester 2007, 5.8).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "hair/Wisps.h"

namespace fur::hair {

// For each vertex of the surface: the way along the skin, as its parts along evenTangent() and along the normal x that, and how
// much it lies along the skin, 0 where it stands; each from -1..1 as 0..255. Then the density of the scalp, 0..255.
std::vector<std::array<std::uint8_t, 4>> baseTangents(const ScalpSurface& scalp, std::span<const Wisp> wisps, std::span<const GuideNode> nodes,
                                                      int nodesEach, const HairValues& values);

}  // namespace fur::hair
