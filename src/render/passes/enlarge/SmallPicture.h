// A picture beside the platform's framebuffer, to which it is enlarged: the way to draw less without giving the canvas or
// the window another size, and to draw a large one bit by bit.
#pragma once

#include "gl/Objects.h"
#include "render/Programs.h"

namespace fur::render {

class SmallPicture {
 public:
  // What is drawn now goes into width x height pixels, with depth and the platform's multisampling. Keeps
  // its memory for the next frame of the same size.
  Status begin(int width, int height);
  // Enlarges it, with bilinear filtering, to the viewport of the platform's framebuffer.
  bool show(Programs& programs) const;
  std::size_t bytes() const;

 private:
  int width_ = 0, height_ = 0, samples_ = 0;
  gl::Texture texture_;
  gl::Target drawn_, resolved_;
};

}  // namespace fur::render
