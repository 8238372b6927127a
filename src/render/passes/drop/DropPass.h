// Draws drops of water (Frame::drops): one instance each: what falls as a streak, a hose's as one jet, what has landed as
// rings and spray, what clings as a ball.
// Without any nothing is kept, compiled or drawn.
#pragma once

#include "render/passes/Drawing.h"

namespace fur::render {

class DropPass {
 public:
  // Over a picture that is whole.
  bool draw(const Drawing& drawing);
  std::size_t bytes() const { return instances_.bytes(); }

 private:
  gl::Buffer instances_;
  gl::VertexArray array_;
};

}  // namespace fur::render
