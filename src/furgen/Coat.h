// The strands of a fur tile before they are cut into layers (Sheppard 2004, 3.3.3 and 4.2.2, and his
// future work, 6.5). Units: texels across, volume heights up; a volume height is kHeightTexels texels.
//
// A strand is a polyline from the skin to its tip that is free in all three dimensions: a curl may
// fold back. Between nodes axis and radius run straight, so that everything about a strand is exact at
// every height, whatever the layers it is cut into. No piece between two nodes crosses one of the
// kPlanes - 1 planes that part the volume evenly.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/Math.h"
#include "furgen/FurVolume.h"

namespace fur::furgen {

inline constexpr int kPlanes = 32;

struct Node {
  Vec2 shift;    // from the root, texels; not wrapped
  float height;  // 0..1
  float radius;  // texels
};

struct Strand {
  Vec2 root;       // in [0, size)^2
  float length;    // its highest point, volume heights
  float dominance; // 0.5..1
  float variance;  // 0..1
  std::uint32_t firstNode, nodeCount;  // two nodes or more
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
inline float torusDelta(float a, float b, float size) {
  const float d = a - b;
  return d - size * std::floor(d / size + 0.5f);
}

// Mean nominal radius of a guard hair in texels; how many guard hairs and how many undercoat strands
// are tried for (Sheppard Eq. 4.1, scaled with the tile's area).
float meanRadius(float thickness);
int wantedStrands(const FurParameters& parameters);
int wantedUndercoat(const FurParameters& parameters);

// Height of a layer, 1 / layers .. 1.
inline float layerHeight(int layer, int layers) {
  return static_cast<float>(layer + 1) / static_cast<float>(layers);
}

// Grows a coat, a few strands a step. The same parameters give the same coat however often and when
// step() is called, on every platform, and whatever the number of layers.
//
// At no height do two strands come closer than the sum of their radii there, round the torus. A
// candidate that would is drawn anew up to 100 times, then given up (Sheppard 4.2.2). Strand i depends
// on the seed and on the strands before it, so that a denser coat keeps the strands of a sparser one.
class CoatGrower {
 public:
  explicit CoatGrower(const FurParameters& parameters);
  ~CoatGrower();
  CoatGrower(CoatGrower&&) noexcept;
  CoatGrower& operator=(CoatGrower&&) noexcept;

  // Tries for the next `strands` strands; returns whether all have been tried for.
  bool step(int strands);
  float progress() const;  // 0..1
  // The coat so far; the grower is empty afterwards.
  Coat take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

Coat growCoat(const FurParameters& parameters);

}  // namespace fur::furgen
