#include "render/passes/ground/GroundPass.h"

#include <utility>

#include "core/Assert.h"

namespace fur::render {

void fillGround(const Frame& frame, shared::FrameBlock& block) {
  block.groundCentre = {frame.worldFromModel[3].x, frame.worldFromModel[3].z};
  block.groundHeight = frame.groundHeight;
  block.groundHalfSide = kGroundHalfSide;
}

void GroundPass::showPuddles(const Drawing& drawing) {
  constexpr int kCells = wet::kGroundCells;
  const wet::Puddles& puddles = drawing.frame.puddles;
  FUR_ASSERT(puddles.cells.size() == kCells * kCells, "Frame::puddles", "a byte for each cell", puddles.cells.size());
  if (puddles_.bytes() == 0) puddles_ = gl::Texture({gl::TexelFormat::R8, kCells, kCells, 0}, {});
  puddles_.bind(FUR_UNIT_PUDDLES);
  if (std::exchange(puddlesRevision_, puddles.revision) == puddles.revision) return;
  puddles_.update(0, 0, kCells, kCells, std::as_bytes(puddles.cells), 0);
  drawing.uploadedBytes += puddles.cells.size();
}

bool GroundPass::draw(const Drawing& drawing, const GroundShadow& shadow) {
  const Frame& frame = drawing.frame;
  if (!frame.settings.ground || frame.transparent) return true;
  const bool wet = !frame.puddles.empty();
  if (wet) showPuddles(drawing);
  shadow.map().bind(FUR_UNIT_GROUND);
  if (!drawing.programs.use(Shader::Ground, wet ? kWet : kPlain)) return false;
  gl::apply({.cullBack = false});
  gl::drawWithoutVertices(6 * FUR_GROUND_CELLS * FUR_GROUND_CELLS);
  return true;
}

}  // namespace fur::render
