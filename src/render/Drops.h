// Draws drops of water (Frame::drops): one instance each: what falls as a streak, a hose's as one jet, what has landed as
// rings and spray, what clings as a ball.
// Without any nothing is kept, compiled or drawn.
#pragma once

#include "gl/Objects.h"
#include "render/Frame.h"
#include "render/Programs.h"

namespace fur::render {

class Drops {
 public:
  // With the frame's block bound, over a picture that is whole. Adds the bytes that it uploads.
  Status draw(Programs& programs, std::span<const wet::Drop> drops, std::size_t& uploadedBytes);
  std::size_t bytes() const { return drops_.bytes(); }

 private:
  gl::Buffer drops_;
  gl::VertexArray array_;
};

}  // namespace fur::render
