#include "render/passes/Drawing.h"

namespace fur::render {

Vec3 eyeInModel(const Frame& frame) { return Vec3(glm::inverse(frame.worldFromModel) * Vec4(frame.camera.eye, 1)); }

gl::DrawState stateOf(VariantBits variant, const gl::DrawState& usual) {
  if (!(variant & (kViewOverdraw | kViewSteps))) return usual;
  return {.depthWrite = false, .cullBack = usual.cullBack, .blend = gl::Blend::Add, .nearer = true};
}

}  // namespace fur::render
