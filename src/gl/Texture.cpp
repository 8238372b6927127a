#include <algorithm>

#include "gl/Api.h"
#include "gl/Objects.h"

namespace fur::gl {

namespace {

struct Layout {
  GLenum internal, external, type;
  int bytes;
};

Layout layoutOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::R8: return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1};
    case TexelFormat::RG8: return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2};
    case TexelFormat::RGBA8: break;
    case TexelFormat::RGBA16F: return {GL_RGBA16F, GL_RGBA, GL_FLOAT, 16};
    case TexelFormat::RGBA32F: return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
    case TexelFormat::RGBA16UI: return {GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, 8};
    case TexelFormat::RGBA32UI: return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16};
  }
  return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
}

GLenum targetOf(const TextureShape& shape) { return shape.layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D; }

// Uploads and new textures use the last unit that every context has, which no shader does, so that bindings made for a draw stay.
constexpr int kWorkUnit = 31;

bool hasLevels(const TextureShape& shape) {
  return shape.filter == Filter::Trilinear || shape.filter == Filter::Mipmapped || shape.filter == Filter::Crisp;
}

int levelCount(const TextureShape& shape) {
  if (!hasLevels(shape)) return 1;
  if (shape.levels > 0) return shape.levels;
  int levels = 1;
  for (int side = std::max(shape.width, shape.height); side > 1; side /= 2) ++levels;
  return levels;
}

}  // namespace

Texture::Texture(const TextureShape& shape, std::span<const std::byte> texels) : shape_(shape) {
  GLuint id = 0;
  glGenTextures(1, &id);
  name_ = Name(id, [](unsigned old) { glDeleteTextures(1, &old); });
  const GLenum target = targetOf(shape);
  const Layout layout = layoutOf(shape.format);
  bind(kWorkUnit);
  const auto expected = static_cast<std::size_t>(shape.width) * shape.height * std::max(shape.layers, 1) * layout.bytes;
  FUR_ASSERT(texels.empty() || texels.size() == expected, "Texture::Texture()", "as many bytes as the shape holds",
             texels.size());
  const void* data = texels.empty() ? nullptr : texels.data();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (shape.layers > 0) {
    glTexStorage3D(target, levelCount(shape), layout.internal, shape.width, shape.height, shape.layers);
    if (data)
      glTexSubImage3D(target, 0, 0, 0, 0, shape.width, shape.height, shape.layers, layout.external, layout.type, data);
  } else {
    glTexStorage2D(target, levelCount(shape), layout.internal, shape.width, shape.height);
    if (data) glTexSubImage2D(target, 0, 0, 0, shape.width, shape.height, layout.external, layout.type, data);
  }
  const bool squares = shape.filter == Filter::Nearest || shape.filter == Filter::Crisp;
  const GLint magnify = squares ? GL_NEAREST : GL_LINEAR;
  const GLint minify = shape.filter == Filter::Mipmapped ? GL_LINEAR_MIPMAP_NEAREST
                       : hasLevels(shape)                ? GL_LINEAR_MIPMAP_LINEAR
                                                         : magnify;
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
  const GLint wrap = shape.repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glTexParameteri(target, GL_TEXTURE_WRAP_S, shape.wrapU ? shape.wrapU : wrap);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, shape.wrapV ? shape.wrapV : wrap);
  if (hasLevels(shape) && data) glGenerateMipmap(target);
}

void Texture::update(int x, int y, int width, int height, std::span<const std::byte> image, int rowTexels) {
  const Layout layout = layoutOf(shape_.format);
  bind(kWorkUnit);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, rowTexels);
  const auto first = rowTexels ? (static_cast<std::size_t>(y) * rowTexels + x) * layout.bytes : 0;
  glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, layout.external, layout.type, image.data() + first);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void Texture::updateLevel(int level, int layer, std::span<const std::byte> texels) {
  const Layout layout = layoutOf(shape_.format);
  const int width = std::max(shape_.width >> level, 1), height = std::max(shape_.height >> level, 1);
  FUR_ASSERT(texels.size() == static_cast<std::size_t>(width) * height * layout.bytes, "Texture::updateLevel()",
             "as many bytes as the level holds", texels.size());
  bind(kWorkUnit);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (shape_.layers > 0)
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, level, 0, 0, layer, width, height, 1, layout.external, layout.type, texels.data());
  else
    glTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width, height, layout.external, layout.type, texels.data());
}

void Texture::bind(int unit) const {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(targetOf(shape_), name_.id());
}

void unbindTexture(int unit) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, 0);
}

std::size_t Texture::bytes() const {
  if (!name_) return 0;
  const auto base = static_cast<std::size_t>(shape_.width) * shape_.height * std::max(shape_.layers, 1) *
                    (shape_.format == TexelFormat::RGBA16F ? 8 : layoutOf(shape_.format).bytes);
  return hasLevels(shape_) ? base * 4 / 3 : base;
}

// --- targets -----------------------------------------------------------------------------------

namespace {

Name makeFramebuffer() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  return Name(id, [](unsigned old) { glDeleteFramebuffers(1, &old); });
}

Name makeRenderbuffer(GLenum format, int width, int height, int samples) {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  glBindRenderbuffer(GL_RENDERBUFFER, id);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return Name(id, [](unsigned old) { glDeleteRenderbuffers(1, &old); });
}

}  // namespace

Target Target::toTexture(const Texture& texture, bool depth) {
  Target target;
  target.framebuffer_ = makeFramebuffer();
  if (depth) target.depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, texture.shape().width, texture.shape().height, 0);
  target.bind();
  const int layers = texture.shape().layers;
  const GLenum colors[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3};
  FUR_ASSERT(layers <= 4, "Target::toTexture()", "at most four layers", layers);
  for (int i = 0; i < layers; ++i) glFramebufferTextureLayer(GL_FRAMEBUFFER, colors[i], texture.id(), 0, i);
  if (layers)
    glDrawBuffers(layers, colors);
  else
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  if (depth) glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth_.id());
  bindPlatformFramebuffer();
  return target;
}

Result<Target> Target::offscreen(int width, int height, int samples) {
  Target target;
  target.framebuffer_ = makeFramebuffer();
  target.color_ = makeRenderbuffer(GL_RGBA8, width, height, samples);
  target.depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, width, height, samples);
  target.bind();
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.color_.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth_.id());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return Error{ErrorId::WebglUnavailable, "Target::offscreen(): the driver refuses this framebuffer"};
  return target;
}

void Target::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id()); }

void Target::resolve(const Target& from, int width, int height) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  bind();
}

}  // namespace fur::gl
