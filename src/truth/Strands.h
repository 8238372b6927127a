// The strands of a coat on a model, as tapered tubes.
//
// A strand stands wherever its root's place in the tile, or that place a whole number of tiles further, falls into a
// triangle of a fur chart, if the strands that the chart shows there (SurfaceVertex::strands) take in its number.
// Charts that overlap share out the numbers, so every strand of every place is drawn whole and once.
#pragma once

#include <cstdint>
#include <vector>

#include "furgen/Coat.h"
#include "truth/FurMap.h"

namespace fur::truth {

struct TubeNode {
  Vec3 position;  // of the axis, model space
  float radius;   // model units
  Vec3 normal;    // of the surface that it stands over, unit
  float height;   // 0..1
};

struct Tube {
  std::uint32_t firstNode, nodeCount;  // two or more, root to tip
  float variance;                      // of its strand
};

struct Tubes {
  std::vector<Tube> tubes;
  std::vector<TubeNode> nodes;
};

// Which strand it is among all, evenly spread over 0..1: its variance, folded, as in shell.frag.
inline float strandNumber(const furgen::Strand& strand) { return std::abs(2.0f * strand.variance - 1.0f); }

// The strands whose root falls into the triangle and that are shown there: index of the strand, and tile coordinates of
// its root. A root on the edge between two triangles of a chart belongs to one of them.
struct Root {
  std::uint32_t strand;
  glm::dvec2 tile;
  ChartPoint spot;
};

class RootFinder {
 public:
  RootFinder(const FurMap& map, const furgen::Coat& coat);
  void find(std::uint32_t triangle, std::vector<Root>& out) const;

 private:
  const FurMap& map_;
  const furgen::Coat& coat_;
  std::vector<std::uint32_t> byRow_;  // strands in the order of their root's y
};

// Nodes that lie within `tolerance` (model units) of a straight tube between their neighbours are left out.
Tubes placeStrands(const FurMap& map, const furgen::Coat& coat, float tolerance);

}  // namespace fur::truth
