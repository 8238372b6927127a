// Finds the strands in a stack of maps that say of every texel only how much of it is covered, and two
// values of the strand that covers it: what a type set file holds.
//
// Texels of a layer that lie together and have the same two values are one cut through a strand; cuts of
// neighbouring layers with the same values and near each other belong to the same strand. Two strands with
// the same values that come within `reach` are taken for one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

struct MapStack {
  int width = 0, height = 0, layers = 0;  // the plane wraps round; both sides are powers of two
  float reach = 0;                        // texels that a strand moves from one layer to the next at most
  float lowest = 1;                       // height of the first layer over the roots; the others stand at 2, 3, ...
  // Layer-major, row-major, one byte a texel.
  std::span<const std::uint8_t> coverage, variance, dominance;
};

// One strand where it crosses one layer. Texels; the plane's wrapping is undone along a strand.
struct StrandCut {
  Vec2 axis{0.0f};   // the middle of its texels, weighted by coverage; in the plane
  Vec2 shift{0.0f};  // from the strand's root to the axis
  Vec2 slope{0.0f};  // how far it moves in a height of 1, by the cuts before and after it
  std::uint32_t strand = 0;  // from 1
};

struct StrandTrace {
  std::vector<std::uint32_t> cutOf;  // one a texel: 1 + index of its cut; 0 where nothing is covered
  std::vector<StrandCut> cuts;       // in order of layers
  int strandCount = 0;
  std::size_t tipsWeighed = 0;  // how often one was looked at as what a cut goes on from
};

// The root lies at height 0 on the parabola through the first three cuts; a strand that shows
// only above the first layer is rooted straight below where it does.
// In O(n log n) of the texels whatever they hold.
StrandTrace traceStrands(const MapStack& maps);

}  // namespace fur::scene
