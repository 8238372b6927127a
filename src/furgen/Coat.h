// The strands of a fur tile before they are cut into layers (Sheppard 2004, 3.3.3 and 4.2.2, and his
// future work, 6.5). Units: texels across, volume heights up; a volume height is kHeightTexels texels.
//
// A strand is a polyline from the skin to its tip and may fold back, as curls do. Position and radius are linear between
// nodes, so that a strand is exact at every height whatever the number of layers. kPlanes - 1 evenly spaced planes divide
// the volume; no segment between two nodes crosses one of them.
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

// Mean nominal radius of a guard hair in texels.
float meanRadius(float thickness);
// How many guard hairs and undercoat strands the grower tries to place (Sheppard Eq. 4.1, scaled with the tile's area).
int wantedStrands(const FurParameters& parameters);
int wantedUndercoat(const FurParameters& parameters);

// The height about which a layer is cut, 1 / layers .. 1. It is shown half a layer lower, from layer / layers on
// (shaders/es3/common_layers.glsl): a ray that comes down into a layer meets what reaches into it from above. By FLIP against the
// reference 16 layers are as good that way as 64, 0.138 on a rabbit; cut where they are shown they come to 0.149.
inline float layerHeight(int layer, int layers) {
  return static_cast<float>(layer + 1) / static_cast<float>(layers);
}

// Grows a coat, a few strands in each step. The same parameters give the same coat on every platform, however the work is
// divided into steps and whatever the number of layers.
//
// Strands never intersect, on the torus and at any height: a candidate that would is drawn again up to 100 times and then
// dropped (Sheppard 4.2.2). Strand i depends on the seed and on the strands before it, so that a denser coat contains the
// strands of a sparser one.
class CoatGrower {
 public:
  explicit CoatGrower(const FurParameters& parameters);
  ~CoatGrower();
  CoatGrower(CoatGrower&&) noexcept;
  CoatGrower& operator=(CoatGrower&&) noexcept;

  // Tries to place the next `strands` strands; true when all have been tried.
  bool step(int strands);
  float progress() const;  // 0..1
  // Moves the coat out; the grower is empty afterwards.
  Coat take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

Coat growCoat(const FurParameters& parameters);

}  // namespace fur::furgen
