#include "render/passes/skin/SkinPass.h"

#include "render/passes/bare/BarePass.h"

namespace fur::render {

bool drawSkin(const Drawing& drawing, VariantBits variant) {
  if (!drawing.programs.use(Shader::Skin, variant)) return false;
  gl::apply(stateOf(variant, {.cullBack = !drawing.surface.twoSided()}));
  if (isView(variant)) {
    drawing.surface.draw(1);
    return true;
  }
  forFurry(drawing.materials, [&](std::size_t material) { drawing.surface.drawMaterial(material); });
  return drawBare(drawing);
}

}  // namespace fur::render
