// One layer of a coat, or its fin map, as a picture that a person can read.
#pragma once

#include <cstdint>
#include <vector>

#include "furgen/Layers.h"

namespace fur::furgen {

// Coverage and variance in grey; dominance on a scale; tangents as their components * 0.5 + 0.5; root
// offset as hue by direction and brightness by length; strands each in a hue of their own.
enum class TileChannel { Coverage, Dominance, Variance, Tangent, Offset, Strand };
inline constexpr int kTileChannels = 6;

struct TilePicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // straight, sRGB, row 0 first
};

// Texels that no strand covers are shown darker in every channel but Coverage.
TilePicture pictureOf(const LayerMaps& layer, int size, TileChannel channel);
// The map has no Offset and no Strand: these give Coverage.
TilePicture pictureOf(const FinMaps& fin, int size, TileChannel channel);

}  // namespace fur::furgen
