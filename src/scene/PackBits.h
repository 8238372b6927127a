// PackBits (Apple 1990; TIFF 6.0, section 9), a run-length encoding. A header byte n below 128 is followed by n + 1 literal
// bytes, one above 128 by a byte that is repeated 257 - n times; 128 is skipped.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fur::scene {

std::vector<std::uint8_t> packBits(std::span<const std::uint8_t> bytes);
// Unpacks into `bytes`, which has the expected size; false when `packed` has more or less than that.
bool unpackBits(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes);

}  // namespace fur::scene
