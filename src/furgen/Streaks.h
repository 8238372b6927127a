// Streaks of a wet sheet of fur: strands averaged along the direction in which they lie.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fur::furgen {

// Texels of a streak, at every level of mipmaps.
inline constexpr int kStreakTexels = 13;

// Blurs a repeating map of size x size RGBA8 texels along one direction: `turn` from 0 to 1 is a half turn from +x towards +y.
std::vector<std::uint8_t> streaks(std::span<const std::uint8_t> level, int size, float turn);

}  // namespace fur::furgen
