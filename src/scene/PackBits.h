// PackBits (Apple 1990; TIFF 6.0, section 9): runs of equal bytes in two. A header byte n below 128 is followed by
// n + 1 bytes as they are, one above 128 by a byte that stands 257 - n times; 128 means nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fur::scene {

std::vector<std::uint8_t> packBits(std::span<const std::uint8_t> bytes);
// Whether `packed` is all of `bytes` and nothing over; `bytes` has the size that is expected.
bool unpackBits(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes);

}  // namespace fur::scene
