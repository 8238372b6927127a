// Numbers of four bytes in a file: four planes, first the first byte of each, compressed with PackBits, so that what is alike takes
// little room. A map of the groom or of a scalp has one a texel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "groom/Groom.h"

namespace fur::scene {

// Of the last number there may be less than four bytes.
std::vector<std::uint8_t> packPlanes(std::span<const std::uint8_t> bytes);
// False when there are more or less bytes.
bool unpackPlanes(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes);

std::vector<std::uint8_t> packMap(std::span<const groom::GroomMap::Texel> texels);
// False when the bytes have more or less texels.
bool unpackMap(std::span<const std::uint8_t> packed, std::span<groom::GroomMap::Texel> texels);

}  // namespace fur::scene
