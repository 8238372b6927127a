// Texels of the wetness mask as the picture's shaders read them. MaskEncoding.h makes them and says what they hold.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/AtlasTexels.h"
#include "shared/Wet.h"

namespace fur::wet {

struct MaskTexels {
  int size = 0;              // of the whole mask, along a side
  geometry::TexelRect rect;  // the part of it that these are
  std::vector<Vec4> texels;  // row by row
};

// The water by which fur lies down, 0..1, and the clump's radius, both in a texel's z.
inline float lyingOf(const Vec4& texel) { return std::floor(texel.z / static_cast<float>(FUR_LYING_STEP)) / static_cast<float>(FUR_LYING_STEPS); }
inline float radiusOf(const Vec4& texel) { return texel.z - static_cast<float>(FUR_LYING_STEP) * std::floor(texel.z / static_cast<float>(FUR_LYING_STEP)); }

}  // namespace fur::wet
