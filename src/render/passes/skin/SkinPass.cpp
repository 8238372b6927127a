#include "render/passes/skin/SkinPass.h"

namespace fur::render {

Status drawSkin(const Drawing& drawing, unsigned variant) {
  const auto program = drawing.programs.use(Shader::Skin, variant);
  if (!program) return program.error();
  gl::apply(stateOf(variant, {.cullBack = !drawing.surface.twoSided()}));
  drawing.surface.draw(1);
  return Done{};
}

}  // namespace fur::render
