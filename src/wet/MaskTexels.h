// Texels of the wetness mask as the picture's shaders read them. MaskEncoding.h makes them and says what they hold.
#pragma once

#include <vector>

#include "geometry/AtlasTexels.h"

namespace fur::wet {

struct MaskTexels {
  int size = 0;              // of the whole mask, along a side
  geometry::TexelRect rect;  // the part of it that these are
  std::vector<Vec4> texels;  // row by row
};

}  // namespace fur::wet
