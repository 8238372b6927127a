// Reconstructs strands from the layers of a type set file, which have, for each texel, its coverage and two values of the
// strand that covers it.
//
// Connected texels of a layer with the same two values are one cross section of a strand. Cross sections of neighbouring
// layers with the same values and near each other belong to one strand. Two strands with the same values closer than `reach`
// are taken for one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

struct MapStack {
  int width = 0, height = 0, layers = 0;  // the plane wraps round; both sides are powers of two
  float reach = 0;                        // the most texels that a strand moves from one layer to the next
  float lowest = 1;                       // height of the first layer above the roots; the others are at 2, 3, ...
  // Layer-major, row-major, one byte a texel.
  std::span<const std::uint8_t> coverage, variance, dominance;
};

// One strand's cross section in one layer. Texels; positions do not wrap along a strand.
struct StrandCut {
  Vec2 axis{0.0f};   // the centre of its texels, weighted by coverage
  Vec2 shift{0.0f};  // from the strand's root to the axis
  Vec2 slope{0.0f};  // movement for a height of 1, by the cross sections before and after
  std::uint32_t strand = 0;  // from 1
};

struct StrandTrace {
  std::vector<std::uint32_t> cutOf;  // one a texel: 1 + index of its cut; 0 where nothing is covered
  std::vector<StrandCut> cuts;       // in order of layers
  int strandCount = 0;
  std::size_t tipsWeighed = 0;  // comparisons of cross sections, for tests of the running time
};

// The root is extrapolated to height 0 by the parabola through the first three cross sections; a strand that begins above the
// first layer is rooted straight below its beginning. O(n log n) in the number of texels for any input.
StrandTrace traceStrands(const MapStack& maps);

}  // namespace fur::scene
