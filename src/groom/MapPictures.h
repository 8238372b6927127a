// The maps of a groom as pictures for other programs, and back. A picture has the texels of the map, which lies over the atlas
// (geometry/Surface.h); its first row is at v = 0. If the model's texture coordinates can be an atlas, the maps use them;
// otherwise the layout picture shows the packed atlas.
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

// length  grey; 255 is the longest
// types   red, green and blue: the presence of the types 2 to 4
// paint   sRGB; alpha: its opacity
// mask    grey; 255 is protected
// shape   red: curl, green: frizz, blue: locks
// comb    red and green: 0.5 + 0.5 of the lean's direction along u (right) and v (down); blue: its size as a share of
//         kMaxComb; upright is (128, 128, 0)
std::vector<MapPicture> mapPictures(const Groom& groom, const GroomSurface& skin);
// The outlines of the charts on a transparent background, in one of these sizes.
inline constexpr int kLayoutSize = 1024, kLargeLayoutSize = 2048;
MapPicture layoutPicture(const geometry::Surface& surface, int size);

// "bunny-map-length.png", and the map that a file of such a name has, also when a browser has numbered it ("bunny-map-length
// (1).png"); none for other names and for maps that are not read back.
std::string mapFileName(std::string_view model, const char* picture);
std::optional<ImageOf> mapOfFile(std::string_view fileName);
// Reads a picture of any size into its map, by nearest texels. `rgba` has 4 * width * height bytes.
void readMapPicture(ImageOf what, Groom& groom, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace fur::groom
