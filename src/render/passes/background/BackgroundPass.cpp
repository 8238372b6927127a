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

Status drawBackground(const Drawing& drawing) {
  const auto program = drawing.programs.use(Shader::Background, kPlain);
  if (!program) return program.error();
  gl::apply({.cullBack = false, .blend = drawing.frame.transparent ? gl::Blend::Erase : gl::Blend::None});
  gl::drawWithoutVertices(6 * FUR_BACKGROUND_STRIPS);
  return Done{};
}

}  // namespace fur::render
