// One layer of a coat, or its fin map, as a picture that a person can read.
#pragma once

#include <cstdint>
#include <vector>

#include "furgen/Layers.h"

namespace fur::furgen {

// Coverage and variance are grey, dominance is a colour scale, tangents are their components * 0.5 + 0.5, the offset to the
// root has its direction as hue and its length as brightness, and each strand has a hue of its own.
enum class TileChannel { Coverage, Dominance, Variance, Tangent, Offset, Strand };
inline constexpr int kTileChannels = 6;

struct TilePicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // straight, sRGB, row 0 first
};

// Texels that no strand covers are shown darker in every channel but Coverage.
TilePicture pictureOf(const LayerMaps& layer, int size, TileChannel channel);
// A fin map has no Offset and no Strand; Coverage is shown instead.
TilePicture pictureOf(const FinMaps& fin, int size, TileChannel channel);

}  // namespace fur::furgen
