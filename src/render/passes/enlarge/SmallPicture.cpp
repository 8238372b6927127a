#include "render/passes/enlarge/SmallPicture.h"

#include <algorithm>
#include <utility>

#include "shared/Blocks.h"

namespace fur::render {

Status SmallPicture::begin(int width, int height) {
  if (width != width_ || height != height_ || samples_ != gl::platformSamples()) {
    samples_ = gl::platformSamples();
    gl::Texture texture({.format = gl::TexelFormat::RGBA8, .width = width, .height = height}, {});
    auto resolved = gl::Target::toTexture(texture);
    auto drawn = gl::Target::offscreen(width, height, samples_);
    if (!drawn) return drawn.error();
    texture_ = std::move(texture);
    resolved_ = std::move(resolved);
    drawn_ = std::move(*drawn);
    width_ = width;
    height_ = height;
  }
  drawn_.bind();
  return Done{};
}

bool SmallPicture::show(Programs& programs) const {
  resolved_.resolve(drawn_, width_, height_);
  gl::bindPlatformFramebuffer();
  if (!programs.use(Shader::Enlarge, kPlain)) return false;
  // The depth that lies there is of no use to anyone, nor the colour.
  gl::clear(Vec4(0, 0, 0, 1));
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  texture_.bind(FUR_UNIT_GROUND);
  gl::drawWithoutVertices(3);
  return true;
}

std::size_t SmallPicture::bytes() const {
  // Colour and depth of each sample, four bytes each.
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  return texture_.bytes() + pixels * 8 * static_cast<std::size_t>(std::max(samples_, 1));
}

}  // namespace fur::render
