// What every pass is given of the picture that is being drawn, and what several of them ask.
#pragma once

#include <cstddef>

#include "render/Frame.h"
#include "render/Look.h"
#include "render/Materials.h"
#include "render/Programs.h"
#include "render/SurfaceBuffers.h"
#include "render/WetCells.h"

namespace fur::render {

// What draws returns false where the driver refuses a shader: programs.error().
struct Drawing {
  const Frame& frame;  // its size is that of the picture which is drawn, not of the one to which it is enlarged
  const Look& look;
  const SurfaceBuffers& surface;
  const Materials& materials;
  const WetCells& wetCells;
  Programs& programs;
  std::size_t& uploadedBytes;  // passes add theirs
};

// Draws each furry material that comes, bound: draw(its number). Afterwards the main one is bound.
template <class Draw>
void forFurry(const Materials& materials, const Draw& draw) {
  for (std::size_t i = 0; i < materials.count(); ++i) {
    if (materials.isBare(i)) continue;
    materials.bind(i);
    draw(i);
  }
  materials.bind(materials.main());
}

Vec3 eyeInModel(const Frame& frame);

// How a pass is drawn: as usual, or its fragments counted.
gl::DrawState stateOf(VariantBits variant, const gl::DrawState& usual);

}  // namespace fur::render
