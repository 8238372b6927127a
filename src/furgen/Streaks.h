// What a wet sheet of fur shows of its strands: those that lie in line, averaged.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fur::furgen {

// Texels of a streak, at every level of mipmaps.
inline constexpr int kStreakTexels = 13;

// Of a level of size x size texels of RGBA8 that repeats, each texel's mean over those in line with it in the direction
// `turn`, which goes from 0 to 1 over a half turn from +x towards +y.
std::vector<std::uint8_t> streaks(std::span<const std::uint8_t> level, int size, float turn);

}  // namespace fur::furgen
