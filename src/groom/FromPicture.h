// Grooms made from pictures in the model's texture coordinates, or in the atlas if it has none; coordinates repeat.
#pragma once

#include <span>

#include "groom/Groom.h"

namespace fur::groom {

// Straight RGBA8, first row at v = 0, 4 * width * height bytes; at least one texel.
struct Picture {
  int width, height;
  std::span<const std::uint8_t> rgba;
  const std::uint8_t* at(const Vec2& uv) const;
};

// Its colours over the paint, as far as it is opaque.
void paintColors(Groom& groom, const GroomSurface& skin, const Picture& picture);
bool isOpaque(const Picture& picture);
// Its alpha is the length.
void lengthFromAlpha(Groom& groom, const GroomSurface& skin, const Picture& picture);
// The darker, the more of the fur is `bald`, a type from 2 on: the others have what its brightness leaves them of what they had.
void thinByPicture(Groom& groom, const GroomSurface& skin, const Picture& picture, int bald);
// Red and green: 0.5 + 0.5 of the comb's direction along u and v; blue: its size as a share of kMaxComb, as the map "comb" has it
// (MapPictures.h). Of a picture without blue the length of the direction.
void combFromPicture(Groom& groom, const GroomSurface& skin, const Picture& picture);

}  // namespace fur::groom
