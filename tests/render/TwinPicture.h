// What twins.frag writes, as numbers.
#pragma once

#include "gl/Objects.h"
#include "shared/Blocks.h"
#include "tests/render/Picture.h"

namespace fur::test {

// Draws a program made of screen.vert and twins.frag over the stage.
inline Picture drawTwin(Stage& stage, const gl::Program& program) {
  program.bindBlock("FrameBlock", FUR_FRAME_BINDING);
  program.bindBlock("FurBlock", FUR_COAT_BINDING);
  program.use();
  gl::setViewport(FUR_TWIN_SIZE, FUR_TWIN_SIZE);
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  gl::drawWithoutVertices(3);
  return stage.read();
}

// The value at column x and row y from below: 24-bit fixed point over [-2, 2).
inline float twinValue(const Picture& picture, int x, int y) {
  const std::uint8_t* p = picture.at(x, FUR_TWIN_SIZE - 1 - y);  // rows come from the top
  return static_cast<float>((p[0] << 16) | (p[1] << 8) | p[2]) / 16777216.0f * 4 - 2;
}

}  // namespace fur::test
