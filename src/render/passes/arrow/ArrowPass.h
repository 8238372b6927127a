// Draws the arrows of the views of bends and forces: one instance a vertex of the surface.
#pragma once

#include "render/passes/Drawing.h"

namespace fur::render {

class ArrowPass {
 public:
  void set(const SurfaceBuffers& surface) { array_ = surface.instanceArray(); }
  bool draw(const Drawing& drawing, VariantBits view) const;

 private:
  gl::VertexArray array_;
};

}  // namespace fur::render
