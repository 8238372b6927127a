// A picture of fewer pixels that is enlarged to the size of the platform's framebuffer: the way to draw less
// without giving the canvas or the window another size.
#pragma once

#include "gl/Objects.h"
#include "render/Programs.h"

namespace fur::render {

class SmallPicture {
 public:
  // What is drawn now goes into width x height pixels, with depth and the platform's multisampling. Keeps
  // its memory for the next frame of the same size.
  Status begin(int width, int height);
  // Enlarges it, with bilinear filtering, to fullWidth x fullHeight of the platform's framebuffer.
  Status show(Programs& programs, int fullWidth, int fullHeight) const;
  std::size_t bytes() const;

 private:
  int width_ = 0, height_ = 0, samples_ = 0;
  gl::Texture texture_;
  gl::Target drawn_, resolved_;
};

}  // namespace fur::render
