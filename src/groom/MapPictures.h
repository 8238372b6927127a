// The maps of a groom as pictures for other programs, and back. A picture lies over the atlas (geometry/Surface.h) as the
// map does, texel by texel; its first row is at v = 0.
//
// A model whose own texture coordinates make an atlas has its maps in those; of others the atlas is packed anew, as the
// picture of the layout shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "groom/Groom.h"

namespace fur::groom {

struct MapPicture {
  const char* name;
  int size, channels;                // texels along it; 1 grey, 3 RGB, 4 straight RGBA
  std::vector<std::uint8_t> pixels;  // size * size * channels
};

// length: grey, 255 is the longest. types: red, green and blue are the presence of the types 2 to 4. paint: sRGB, alpha: how
// much of it there is. mask: grey, 255 is protected. shape: red is
// what brushes add in curl, green in frizz, blue in locks. comb: red and green are the direction in which the fur leans, 0.5 + 0.5
// of its part along u (to the right in the picture) and along v (downwards), blue how far, as a share of kMaxComb; upright
// is (128, 128, 0).
std::vector<MapPicture> mapPictures(const Groom& groom, const GroomSurface& skin);
// The outlines of the charts, on transparent; one of these sizes.
inline constexpr int kLayoutSize = 1024, kLargeLayoutSize = 2048;
MapPicture layoutPicture(const geometry::Surface& surface, int size);

// "bunny-map-length.png", and which map a file of such a name has, as browsers number it, too ("bunny-map-length (1).png");
// none: of another name, or one that is not read back.
std::string mapFileName(std::string_view model, const char* picture);
std::optional<ImageOf> mapOfFile(std::string_view fileName);
// The way back of those of ImageOf, whatever the picture's size: nearest texels. `rgba` has 4 * width * height bytes.
void readMapPicture(ImageOf what, Groom& groom, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace fur::groom
