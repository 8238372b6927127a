// What views of hair show, and tools that work on it: plain values for the renderer. ViewLines.h makes them.
#pragma once

#include <cstdint>
#include <vector>

#include "groom/Groom.h"

namespace fur::hair {

// A line with round ends, a dot where both are the same. Model space.
struct ViewLine {
  Vec3 a{0};
  float width = 1;  // pixels
  Vec3 b{0};
  float lift = 0;   // what is nearer to the eye by less than this does not hide it; model units
  Vec4 color{1};    // sRGB, alpha
};

using ViewColor = groom::GroomMap::Texel;  // sRGB, alpha

struct HairView {
  // Other numbers whenever lines have changed, or colours.
  std::uint64_t lineRevision = 0, colorRevision = 0;
  bool instead = false;        // of the picture: over the bare skin, and hair without colours is left out
  std::vector<ViewLine> lines;
  // A scalp: of each wisp at its root and at its tip; empty: hair has its own.
  std::vector<std::vector<ViewColor>> wispColors;
  // Over the atlas, square; alpha 0: as it is. Empty: all as it is.
  std::vector<ViewColor> mapColors;
};

}  // namespace fur::hair
