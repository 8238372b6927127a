#include "render/passes/arrow/ArrowPass.h"

#include "shared/Blocks.h"

namespace fur::render {

Status ArrowPass::draw(const Drawing& drawing, unsigned view) const {
  const auto program = drawing.programs.use(Shader::Arrow, drawing.look.arrows(view));
  if (!program) return program.error();
  gl::apply({.cullBack = false});
  array_.drawStrips(2 * FUR_ARROW_POINTS, drawing.surface.vertexCount());
  return Done{};
}

}  // namespace fur::render
