// The fur tile: a toroidal block of strands, cut into layers (Sheppard 2004, 3.3.3 and chapter 4).
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"

namespace fur::furgen {

// All floats may have any value in [0, 1]; only density 0 gives no strands.
struct FurParameters {
  int size = 256;    // texels along one side, a power of two, 64..1024
  int layers = 16;   // 4..128
  float density = 0.85f;
  float thickness = 0.35f;
  float taper = 0.5f;            // 0 blunt, 0.5 Sheppard's thinning, 1 a needle
  float lengthVariation = 0.35f;
  float length = 1.0f;           // of the longest strand, in volume heights
  float curl = 0.25f;            // Sheppard's sine curves, at 1 with a magnitude of up to 4 radii
  float wave = 0.0f;             // long waves that neighbours share
  float coil = 0.0f;             // loops in three dimensions; they fold back from about 0.3 up
  float frizz = 0.0f;            // fine kinks of single strands
  float clump = 0.0f;            // binds strands into locks
  float lockSize = 0.3f;         // strands in a lock, 6 to 60
  float roll = 0.0f;             // winding of a lock's strands round each other, at 1 two turns
  float stray = 0.1f;            // share of strands that no lock holds
  float tipBreak = 0.0f;         // how far locks open again at their tips
  float undercoat = 0.0f;        // fine short strands beside the guard hairs, at 1 three to two
  float undercoatLength = 0.45f; // of the longest of them, as a share of `length`
  std::uint32_t seed = 1;
  bool operator==(const FurParameters&) const = default;
};

// Layer-major, then rows: texel (x, y) of layer l is at (l * size + y) * size + x. Layer 0 is the
// skin end, its height is 1 / layers; the last layer's is 1. Empty texels carry variance, dominance,
// tangent, offset and strandId of the nearest strand of that layer (exact, toroidal).
struct FurVolume {
  int size = 0;
  int layers = 0;
  int strandCount = 0;
  float density = 0;  // share of layer-0 texels that a strand covers, for the strand shadow
  float weight = 0;   // mean strand volume, relative to the densest straight coat, for dynamics

  std::vector<std::uint8_t> coverage;   // 0..255, anti-aliased
  std::vector<std::uint8_t> dominance;  // 0.5..1 as 128..255
  std::vector<std::uint8_t> variance;   // 0..255, one value a strand
  std::vector<std::int8_t> tangent;     // 3 a texel, unit tangent * 127: x, y in texture axes, z up. Where a
                                        // curl runs downwards it is the tangent towards the root: z >= 1
  std::vector<std::int16_t> offset;     // 2 a texel, texels * 64 from the texel back to its strand's root
  std::vector<std::uint16_t> strandId;  // 1-based; 0 where the layer has no strand at all

  // The fin map: the strands rooted in the central 6 % of the tile, seen from the side.
  // finRows rows (row 0 = root), `size` columns.
  int finRows = 0;
  std::vector<std::uint8_t> finCoverage;
  std::vector<std::uint8_t> finDominance;
  std::vector<std::uint8_t> finVariance;
  std::vector<std::int8_t> finTangent;  // 3 a texel, as above; x runs along the edge
};

// The height of the volume in texels, whatever the size of its tile: a larger tile has more of the same fur.
inline constexpr float kHeightTexels = 256.0f / 3.0f;

// Values out of range are clamped. The same bytes on every platform.
FurVolume generateFur(const FurParameters& parameters);

}  // namespace fur::furgen
