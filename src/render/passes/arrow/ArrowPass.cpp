#include "render/passes/arrow/ArrowPass.h"

#include "shared/Blocks.h"

namespace fur::render {

bool ArrowPass::draw(const Drawing& drawing, VariantBits view) const {
  if (!drawing.programs.use(Shader::Arrow, drawing.look.arrows(view))) return false;
  gl::apply({.cullBack = false});
  array_.drawStrips(2 * FUR_ARROW_POINTS, drawing.surface.vertexCount());
  return true;
}

}  // namespace fur::render
