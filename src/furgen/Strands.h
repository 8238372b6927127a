// The strands of a fur tile before they are cut into layers. Units: texels across, volume heights up.
#pragma once

#include <vector>

#include "core/Math.h"
#include "furgen/FurVolume.h"

namespace fur::furgen {

struct Strand {
  Vec2 root{0};          // in [0, size)^2
  float radius = 0;      // nominal; see strandThinning()
  float length = 0;      // volume heights, at least one layer's
  float dominance = 1;   // 0.5..1
  float variance = 0;    // 0..1
  Vec2 magnitude[2]{};   // of the two sine curves of each axis, texels
  Vec2 phase[2]{};       // radians over the volume's height, 0..7
  Vec2 toLock{0};        // from the root to the centre of the strand's lock, already scaled by `clump`
};

// Where the axis stands at height h, seen from its root; (0, 0) at h = 0.
Vec2 strandShift(const Strand& strand, float height);
// The radius in texels at height h; 0 above the tip.
float strandRadius(const Strand& strand, float height);

// Mean nominal radius in texels, the count that is tried for, and the height of a layer.
float meanRadius(float thickness);
int wantedStrands(const FurParameters& parameters);
inline float layerHeight(int layer, int layers) {
  return static_cast<float>(layer + 1) / static_cast<float>(layers);
}

// The shortest way from b to a on the torus.
float torusDelta(float a, float b, float size);

FurParameters clampedParameters(const FurParameters& parameters);

// No two strands come closer on any layer (nor at the skin) than the sum of their radii there. A
// candidate that does is drawn anew up to 100 times, then given up. Strand i depends on the seed and
// on the strands before it, so that a denser coat keeps the strands of a sparser one.
std::vector<Strand> growStrands(const FurParameters& parameters);

}  // namespace fur::furgen
