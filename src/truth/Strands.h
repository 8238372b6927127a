// The strands of a coat on a model, as tapered tubes.
//
// A strand of the tile stands at each place of a fur chart with its root's tile coordinates, plus whole numbers, if the
// chart's interval there (SurfaceVertex::strands) contains its number. The intervals of overlapping charts are disjoint,
// so each strand is drawn once.
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
  float share = 1;  // of long hair: what other hair leaves of the light from all around
};

// What water makes of a strand.
struct Wetness {
  float held = 0;    // 1 is saturated, what is more lies on it as a film
  float soaked = 0;  // how much of a sheet the coat is there, wet::sheetOf()
  float sheet = 0;   // how far clumps have closed into it, wet::nearSheet()
  float shortness = 0;  // wet::shortnessOf() the coat
  float chance = 0;  // of its clump, wet::chanceOfClump()
  Vec3 outward{0};   // from its clump's centre to its root along the skin, 1 at the rim; model space
};

struct Tube {
  std::uint32_t firstNode, nodeCount;  // two or more, root to tip
  float variance;                      // of its strand
  std::uint32_t scalp = 0;             // of long hair
  Wetness water{};
};

struct Tubes {
  std::vector<Tube> tubes;
  std::vector<TubeNode> nodes;
  void append(const Tubes& others);
};

// A strand's number for SurfaceVertex::strands, evenly distributed in 0..1: its variance, folded.
inline float strandNumber(const furgen::Strand& strand) { return std::abs(2.0f * strand.variance - 1.0f); }

// A strand that stands on a triangle: its index and its root. A root on an edge belongs to one of the two triangles.
struct Root {
  std::uint32_t strand;
  glm::dvec2 tile;
  ChartPoint spot;
  float number = 0;  // strandNumber()
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

class Wetting;
// Nodes within `tolerance` (model units) of a straight tube between their neighbours are left out. `wetting`: none on dry fur.
Tubes placeStrands(const FurMap& map, const furgen::Coat& coat, float tolerance, const Wetting* wetting = nullptr);

}  // namespace fur::truth
