#include "render/passes/whisker/WhiskerPass.h"

#include "shared/Blocks.h"

namespace fur::render {

namespace {

using groom::WhiskerHair;

constexpr gl::Attribute kHairAttributes[] = {
    {FUR_WHISKER_ROOT, 4, offsetof(WhiskerHair, root)},         {FUR_WHISKER_DIRECTION, 4, offsetof(WhiskerHair, direction)},
    {FUR_WHISKER_CURVE, 4, offsetof(WhiskerHair, curve)},       {FUR_WHISKER_NORMAL, 4, offsetof(WhiskerHair, normal)},
    {FUR_WHISKER_COLOR, 4, offsetof(WhiskerHair, color)},       {FUR_WHISKER_VERTICES, 4, offsetof(WhiskerHair, vertices)},
    {FUR_WHISKER_WEIGHTS, 3, offsetof(WhiskerHair, weights)},
};
static_assert(sizeof(WhiskerHair) == 27 * sizeof(float) && FUR_WHISKER_POINTS == groom::kHairPoints);

}  // namespace

gl::VertexArray hairArray(const gl::Buffer& hairs, unsigned divisor) {
  return gl::VertexArray(hairs, sizeof(WhiskerHair), kHairAttributes, divisor, nullptr);
}

std::size_t WhiskerPass::set(std::span<const WhiskerHair> hairs) {
  count_ = static_cast<int>(hairs.size());
  array_ = {};
  beads_ = {};
  hairs_ = {};
  if (hairs.empty()) return 0;
  hairs_ = gl::Buffer(gl::BufferKind::Vertex, std::as_bytes(hairs), false);
  array_ = hairArray(hairs_, 1);
  beads_ = hairArray(hairs_, 0);
  return hairs_.bytes();
}

bool WhiskerPass::draw(const Drawing& drawing) const {
  if (count_ == 0) return true;
  if (!drawing.programs.use(Shader::Whisker, drawing.look.whiskers())) return false;
  gl::apply({.cullBack = false, .alphaToCoverage = true, .alpha = false});
  array_.drawStrips(2 * FUR_WHISKER_POINTS, count_);
  return true;
}

}  // namespace fur::render
