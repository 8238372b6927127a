// The strands of a fur tile before they are cut into layers (Sheppard 2004, 3.3.3 and 4.2.2, and his
// future work, 6.5). Units: texels across, volume heights up; a volume height is size / kTileAspect
// texels.
//
// A strand is a polyline whose nodes lie on kPlanes + 1 planes of equal spacing, skin and top included.
// From one node to the next it goes to the plane above, to the one below (a curl that folds back), or
// stays on its own (where it turns). Between nodes axis and radius run straight, so that everything
// about a strand is exact at every height, whatever the layers it is cut into.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"
#include "furgen/FurVolume.h"

namespace fur::furgen {

inline constexpr int kPlanes = 32;

struct Node {
  Vec2 shift;    // from the root, texels; not wrapped
  float radius;  // texels
  int plane;     // 0..kPlanes; height = plane / kPlanes
};

struct Strand {
  Vec2 root;             // in [0, size)^2
  float radius;          // nominal, see strandThinning(); texels
  float length;          // volume heights along the strand's own axis
  float dominance;       // 0.5..1
  float variance;        // 0..1
  std::uint32_t firstNode, nodeCount;
};

struct Coat {
  FurParameters parameters;  // clamped
  std::vector<Strand> strands;
  std::vector<Node> nodes;
  float weight = 0;          // as FurVolume's

  std::span<const Node> nodesOf(const Strand& strand) const {
    return {nodes.data() + strand.firstNode, strand.nodeCount};
  }
};

FurParameters clampedParameters(const FurParameters& parameters);

// The shortest way from b to a on the torus.
float torusDelta(float a, float b, float size);

// Mean nominal radius of a guard hair in texels, and how many of them are tried for (Sheppard Eq. 4.1).
float meanRadius(float thickness);
int wantedStrands(const FurParameters& parameters);

}  // namespace fur::furgen
