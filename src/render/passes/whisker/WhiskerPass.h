// Draws whiskers and tufts (groom/Whiskers.h): one instance a hair, a ribbon of eight points that faces the eye.
// Without any nothing is kept, compiled or drawn.
#pragma once

#include <span>

#include "groom/Whiskers.h"
#include "render/passes/Drawing.h"

namespace fur::render {

// `divisor`: 1, an instance a hair; 0, a vertex a hair.
gl::VertexArray hairArray(const gl::Buffer& hairs, unsigned divisor);

class WhiskerPass {
 public:
  // Those that stand on the surface, until the next call. Returns the bytes that were uploaded.
  std::size_t set(std::span<const groom::WhiskerHair> hairs);
  bool draw(const Drawing& drawing) const;
  // By the program of BeadPass, which is in use: one on each.
  void drawBeads() const { if (count_ > 0) beads_.drawPoints(count_); }
  std::size_t bytes() const { return hairs_.bytes(); }

 private:
  gl::Buffer hairs_;
  gl::VertexArray array_, beads_;
  int count_ = 0;
};

}  // namespace fur::render
