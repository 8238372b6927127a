// Draws the ground: the cells on which the model's shadow, or water, shows. Only where nothing else is.
#pragma once

#include "render/passes/Drawing.h"
#include "render/passes/ground/GroundShadow.h"
#include "shared/Blocks.h"

namespace fur::render {

void fillGround(const Frame& frame, shared::FrameBlock& block);

class GroundPass {
 public:
  bool draw(const Drawing& drawing, const GroundShadow& shadow);
  std::size_t bytes() const { return puddles_.bytes(); }

 private:
  void showPuddles(const Drawing& drawing);

  gl::Texture puddles_;
  std::uint32_t puddlesRevision_ = 0;  // of those that the texture has
};

}  // namespace fur::render
