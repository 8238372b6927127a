// The locks into which brushes gather strands: cells of a jittered grid that repeats.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fur::furgen {

// size x size texels over `across` x `across` locks: 0.5 + a quarter of the vector from the texel to the centre of the nearest
// lock, in widths of a lock. The cells are Worley's (1996, A Cellular Texture Basis Function).
std::vector<std::array<std::uint8_t, 2>> lockCentres(int size, int across);

}  // namespace fur::furgen
