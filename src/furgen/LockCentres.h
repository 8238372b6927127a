// Where the locks are that brushes gather strands into: cells of a jittered grid, repeating.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fur::furgen {

// size x size texels over `across` x `across` locks: 0.5 + the way from the texel to the middle of the nearest lock / 4, in
// locks. Borders of locks are those of Worley's cells (1996, A Cellular Texture Basis Function).
std::vector<std::array<std::uint8_t, 2>> lockCentres(int size, int across);

}  // namespace fur::furgen
