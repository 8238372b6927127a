// How much of the light from all around comes to hair: the static part of its shadow (Halen & Wester 2007, 3.3.1).
//
// H adds up the solid angles of the hair about each vertex, pair by pair, O(n^2). Here hair is spread over a coarse grid as
// opacity, light is swept through it along 14 directions, and each point takes what arrives there: O(n), and hair that lies behind
// hair counts once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hair/Wisps.h"

namespace fur::hair {

// For each point of each wisp, kStripSegments + 1 from root to tip, of their rest shape: 255 is as much light as bare skin gets that
// nothing covers. The skin hides what is behind it. `nodes`: of all guides at rest, guide after guide.
std::vector<std::uint8_t> ambientVisibility(const geometry::Surface& surface, std::span<const Wisp> wisps, std::span<const GuideNode> nodes,
                                            int nodesEach, const HairValues& values);

}  // namespace fur::hair
