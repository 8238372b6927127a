// A map of the groom or of a scalp in a file: four planes of bytes, one a channel, compressed with PackBits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "groom/Groom.h"

namespace fur::scene {

std::vector<std::uint8_t> packMap(std::span<const groom::GroomMap::Texel> texels);
// False when the bytes have more or less texels.
bool unpackMap(std::span<const std::uint8_t> packed, std::span<groom::GroomMap::Texel> texels);

}  // namespace fur::scene
