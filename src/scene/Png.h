// PNG files (ISO 15948).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fur::scene {

// Straight 8 bits a channel, row by row from the top: width * height * channels bytes; 1 is grey, 3 RGB, 4 RGBA.
std::vector<std::uint8_t> writePng(int width, int height, int channels, std::span<const std::uint8_t> pixels);

// From premultiplied to straight alpha.
void makeStraight(std::span<std::uint8_t> rgba);

}  // namespace fur::scene
