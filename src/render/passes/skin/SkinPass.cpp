#include "render/passes/skin/SkinPass.h"

namespace fur::render {

bool drawSkin(const Drawing& drawing, VariantBits variant) {
  if (!drawing.programs.use(Shader::Skin, variant)) return false;
  gl::apply(stateOf(variant, {.cullBack = !drawing.surface.twoSided()}));
  drawing.surface.draw(1);
  return true;
}

}  // namespace fur::render
