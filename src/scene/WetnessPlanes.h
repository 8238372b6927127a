// The wetness mask as a scene file has it: eight planes of bytes, packed by PackBits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

inline constexpr int kLeastWetness = 16, kMostWetness = 2048;  // texels along the mask

// Texels as wet::WetnessMask has them: (clump centre u, v, radius, wetness) in units of the atlas, wetness up to 4. They are
// rounded to 16 bits each, once: what was read comes out again as it went in.
std::vector<std::uint8_t> packWetness(std::span<const Vec4> texels);
// False when the bytes do not hold that many. All numbers are finite.
bool unpackWetness(std::span<const std::uint8_t> packed, std::span<Vec4> texels);

}  // namespace fur::scene
