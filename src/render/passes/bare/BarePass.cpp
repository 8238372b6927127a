#include "render/passes/bare/BarePass.h"

#include "render/passes/shadow/FurShadow.h"

namespace fur::render {

namespace {

bool drawParts(const Drawing& drawing, bool blended) {
  const Materials& materials = drawing.materials;
  for (std::size_t i = 0; i < materials.count(); ++i) {
    const scene::Material& material = materials.at(i);
    if (!materials.isBare(i) || (material.alpha == scene::AlphaMode::Blend) != blended) continue;
    if (!drawing.programs.use(Shader::Bare, shadowVariant(drawing.frame.settings))) return false;
    materials.bindBare(i);
    const bool masked = material.alpha == scene::AlphaMode::Mask;
    gl::DrawState state{.depthWrite = !blended, .cullBack = true, .blend = blended ? gl::Blend::Over : gl::Blend::None, .alphaToCoverage = masked, .alpha = !masked};
    // Of what one sees through first what is inside.
    if (blended && material.doubleSided) {
      state.cullFront = true, state.cullBack = false;
      gl::apply(state);
      drawing.surface.drawMaterial(i);
      state.cullFront = false, state.cullBack = true;
    } else if (material.doubleSided) {
      state.cullBack = false;
    }
    gl::apply(state);
    drawing.surface.drawMaterial(i);
  }
  materials.bind(materials.main());
  return true;
}

}  // namespace

bool drawBare(const Drawing& drawing) { return !drawing.materials.anyBare() || drawParts(drawing, false); }
bool drawBlended(const Drawing& drawing) { return !drawing.materials.anyBare() || drawParts(drawing, true); }

}  // namespace fur::render
