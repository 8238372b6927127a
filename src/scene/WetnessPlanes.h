// The wetness mask in a scene file: eight planes of bytes, compressed with PackBits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

inline constexpr int kLeastWetness = 16, kMostWetness = 2048;  // texels along the mask

// Texels of wet::WetnessMask: (clump centre u, v, radius, wetness), wetness up to 4. Each number is rounded to 16 bits; reading
// and writing again changes nothing.
std::vector<std::uint8_t> packWetness(std::span<const Vec4> texels);
// False when the bytes have more or less texels. The numbers read are finite.
bool unpackWetness(std::span<const std::uint8_t> packed, std::span<Vec4> texels);

}  // namespace fur::scene
