// Draws whiskers and tufts (groom/Whiskers.h): one instance a hair, a ribbon of eight points that faces the eye.
// Without any nothing is kept, compiled or drawn.
#pragma once

#include <span>

#include "gl/Objects.h"
#include "groom/Whiskers.h"
#include "render/Programs.h"

namespace fur::render {

class Whiskers {
 public:
  // Returns the bytes that were uploaded.
  std::size_t set(std::span<const groom::WhiskerHair> hairs);
  // With the textures and blocks of the frame bound. `variant`: kWet, kMarschner and the shadow's.
  Status draw(Programs& programs, unsigned variant) const;
  std::size_t bytes() const { return hairs_.bytes(); }

 private:
  gl::Buffer hairs_;
  gl::VertexArray array_;
  int count_ = 0;
};

}  // namespace fur::render
