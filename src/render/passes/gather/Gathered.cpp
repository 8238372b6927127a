#include "render/passes/gather/Gathered.h"

#include "shared/Blocks.h"

namespace fur::render {

void Gathered::fit(int width, int height) {
  const auto make = [&](gl::TexelFormat format, gl::Texture& texture, gl::Target& target) {
    if (texture.bytes() && texture.shape().width == width && texture.shape().height == height) return;
    texture = gl::Texture({.format = format, .width = width, .height = height, .filter = gl::Filter::Nearest}, {});
    target = gl::Target::toTexture(texture);
  };
  make(gl::TexelFormat::RGBA8, taken_, takes_);
  for (int i = 0; i < 2; ++i) make(gl::TexelFormat::RGBA16UI, means_[i], targets_[i]);
}

bool Gathered::add(Programs& programs, int width, int height, int bottom, int count) {
  fit(width, height);
  takes_.takeRows(taken_, bottom, count);
  const int older = newest_, newer = 1 - older;
  targets_[newer].bind();
  if (!programs.use(Shader::Mean, kPlain)) return false;
  gl::setViewport(width, height);
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  gl::drawOnlyRows(bottom, count, width);
  taken_.bind(FUR_UNIT_GROUND);
  means_[older].bind(FUR_UNIT_MEAN);
  gl::drawWithoutVertices(3);
  gl::setViewport(width, height);
  gl::bindPlatformFramebuffer();
  if (bottom + count == height) newest_ = newer;
  return true;
}

void Gathered::rest() {
  takes_ = {};
  taken_ = {};
  targets_[1 - newest_] = {};
  means_[1 - newest_] = {};
}

bool Gathered::show(Programs& programs, bool keepsDepth) const {
  gl::bindPlatformFramebuffer();
  if (!programs.use(Shader::ShowMean, kPlain)) return false;
  gl::setViewport(means_[newest_].shape().width, means_[newest_].shape().height);
  // The colour that lies there is of no use to anyone, nor mostly the depth.
  if (!keepsDepth) gl::clear(Vec4(0, 0, 0, 1));
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  means_[newest_].bind(FUR_UNIT_MEAN);
  gl::drawWithoutVertices(3);
  return true;
}

}  // namespace fur::render
