// Sheppard's type set file .fts (2004, 4.2.1): one kind of fur as maps, binary and without a header,
//
//   16 layers, innermost first, each 256 rows of 256 texels of 3 bytes: variance, dominance, alpha
//   the fin map, 64 rows of 256 such texels; row 0 is at the roots
//   density of the fur, for the shadow between strands; its weight, for dynamics: float32, little-endian
//
// and nothing else. Alpha is FurVolume's coverage. Dominance bytes are kept; ours are 128..255, Sheppard's 51..255 (from 0.2
// up).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/Result.h"
#include "furgen/FurVolume.h"

namespace fur::scene {

inline constexpr int kTypeSetSize = 256;
inline constexpr int kTypeSetLayers = 16;
inline constexpr int kTypeSetFinRows = 64;
inline constexpr std::size_t kTypeSetBytes =
    3 * kTypeSetSize * (kTypeSetLayers * std::size_t{kTypeSetSize} + kTypeSetFinRows) + 8;

// A complete volume. strandId, tangent and offset are not in the file; they are computed from the strands that can be
// distinguished in it (StrandTracing.h). Coils that turn within a few layers get the direction of their axis. Fin tangents
// have y = 0, as a fin does not show the direction across its edge. If there are more strands than ids, the last id is
// shared. Bad-file: a length other than kTypeSetBytes, density or weight outside 0..1.
Result<furgen::FurVolume> readTypeSet(std::span<const std::uint8_t> bytes, const std::string& name);

// Bad-file unless the volume has the size, layers and fin rows of the format. Reading the result and writing it again gives
// the same bytes.
Result<std::vector<std::uint8_t>> writeTypeSet(const furgen::FurVolume& volume);

}  // namespace fur::scene
