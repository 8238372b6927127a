#include "render/passes/background/BackgroundPass.h"

namespace fur::render {

namespace {

Vec4 shownColor(std::uint32_t rgb) {
  return Vec4((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u, 255.0f) / 255.0f;
}

}  // namespace

void fillBackground(const Frame& frame, shared::FrameBlock& block) {
  block.backgroundTop = shownColor(frame.settings.backgroundTop);
  block.backgroundBottom = shownColor(frame.settings.backgroundBottom);
}

bool drawBackground(const Drawing& drawing) {
  if (!drawing.programs.use(Shader::Background, kPlain)) return false;
  gl::apply({.cullBack = false, .blend = drawing.frame.transparent ? gl::Blend::Erase : gl::Blend::None});
  gl::drawWithoutVertices(3);
  return true;
}

}  // namespace fur::render
