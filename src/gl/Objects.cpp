#include "gl/Objects.h"

#include <algorithm>
#include <utility>

#include "core/NumberText.h"
#include "gl/Api.h"

namespace fur::gl {

namespace {

bool contextAlive = true;

GLenum target(BufferKind kind) {
  switch (kind) {
    case BufferKind::Index: return GL_ELEMENT_ARRAY_BUFFER;
    case BufferKind::Uniform: return GL_UNIFORM_BUFFER;
    case BufferKind::Vertex: break;
  }
  return GL_ARRAY_BUFFER;
}

unsigned make(void (*generate)(GLsizei, GLuint*)) {
  GLuint id = 0;
  generate(1, &id);
  return id;
}

}  // namespace

void setContextAlive(bool alive) { contextAlive = alive; }

Name& Name::operator=(Name&& other) noexcept {
  if (this != &other) {
    reset();
    id_ = std::exchange(other.id_, 0);
    delete_ = other.delete_;
  }
  return *this;
}

void Name::reset() {
  if (id_ && contextAlive) delete_(id_);
  id_ = 0;
}

// --- buffers -----------------------------------------------------------------------------------

Buffer::Buffer(BufferKind kind, std::span<const std::byte> bytes, bool changesOften)
    : name_(make(glGenBuffers), [](unsigned id) { glDeleteBuffers(1, &id); }), kind_(kind), changesOften_(changesOften) {
  update(bytes);
}

void Buffer::update(std::span<const std::byte> bytes) {
  // An index buffer bound while some vertex array is would be recorded in it.
  if (kind_ == BufferKind::Index) glBindVertexArray(0);
  glBindBuffer(target(kind_), name_.id());
  if (bytes.size() > bytes_)
    glBufferData(target(kind_), static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                 changesOften_ ? GL_DYNAMIC_DRAW : GL_STATIC_DRAW);
  else
    glBufferSubData(target(kind_), 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
  bytes_ = std::max(bytes_, bytes.size());
}

void Buffer::bindAsBlock(unsigned binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, name_.id()); }

VertexArray::VertexArray(const Buffer& vertices, int strideBytes, std::span<const Attribute> attributes,
                         unsigned divisor, const Buffer* indices)
    : name_(make(glGenVertexArrays), [](unsigned id) { glDeleteVertexArrays(1, &id); }) {
  glBindVertexArray(name_.id());
  if (indices) glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices->name_.id());
  add(vertices, strideBytes, attributes, divisor);
}

void VertexArray::add(const Buffer& vertices, int strideBytes, std::span<const Attribute> attributes, unsigned divisor) {
  glBindVertexArray(name_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.name_.id());
  for (const Attribute& a : attributes) {
    glEnableVertexAttribArray(a.location);
    glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, strideBytes,
                          reinterpret_cast<const void*>(static_cast<std::uintptr_t>(a.offsetBytes)));
    glVertexAttribDivisor(a.location, divisor);
  }
  glBindVertexArray(0);
}

void VertexArray::drawIndexed(int indexCount, int instances, int first) const {
  glBindVertexArray(name_.id());
  glDrawElementsInstanced(GL_TRIANGLES, indexCount, GL_UNSIGNED_INT, reinterpret_cast<const void*>(sizeof(std::uint32_t) * static_cast<std::size_t>(first)), instances);
  glBindVertexArray(0);
}

void VertexArray::drawPoints(int count) const {
  glBindVertexArray(name_.id());
  glDrawArrays(GL_POINTS, 0, count);
  glBindVertexArray(0);
}

void VertexArray::drawStrips(int vertexCount, int instances) const {
  glBindVertexArray(name_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, vertexCount, instances);
  glBindVertexArray(0);
}

void drawWithoutVertices(int vertexCount, int first) {
  glBindVertexArray(0);
  glDrawArrays(GL_TRIANGLES, first, vertexCount);
}

void drawInstancesWithoutVertices(Shape shape, int vertexCount, int instances) {
  glBindVertexArray(0);
  glDrawArraysInstanced(shape == Shape::Strip ? GL_TRIANGLE_STRIP : GL_TRIANGLES, 0, vertexCount, instances);
}

// --- state -------------------------------------------------------------------------------------

namespace {

void toggle(GLenum what, bool on) { on ? glEnable(what) : glDisable(what); }

PlatformFramebuffer platform;

}  // namespace

void apply(const DrawState& state) {
  toggle(GL_DEPTH_TEST, state.depthTest);
  toggle(GL_CULL_FACE, state.cullBack || state.cullFront);
  glCullFace(state.cullFront ? GL_FRONT : GL_BACK);
  toggle(GL_BLEND, state.blend != Blend::None);
  toggle(GL_SAMPLE_ALPHA_TO_COVERAGE, state.alphaToCoverage);
  glDisable(GL_STENCIL_TEST);
  toggle(GL_POLYGON_OFFSET_FILL, state.nearer);
  glPolygonOffset(-2, -8);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(state.depthWrite);
  glColorMask(state.red, state.green, state.blue, state.alpha);
  glBlendEquation(GL_FUNC_ADD);
  switch (state.blend) {
    case Blend::None: break;
    case Blend::Add: glBlendFunc(GL_ONE, GL_ONE); break;
    case Blend::Over: glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case Blend::Erase: glBlendFunc(GL_ZERO, GL_ONE_MINUS_SRC_ALPHA); break;
  }
}

void setViewport(int width, int height, int bottom) {
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, -bottom, width, height);
}

void drawOnlyRows(int bottom, int count, int width) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, bottom, width, count);
}

void flush() { glFlush(); }
void finish() { glFinish(); }

void clear(const Vec4& color) {
  glColorMask(true, true, true, true);
  glDepthMask(true);
  glClearColor(color.r, color.g, color.b, color.a);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void clearColor() {
  glColorMask(true, true, true, true);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void clearDepth() {
  glDepthMask(true);
  glClear(GL_DEPTH_BUFFER_BIT);
}

PlatformFramebuffer boundFramebuffer() {
  PlatformFramebuffer bound;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound.name);
  glGetIntegerv(GL_SAMPLES, &bound.samples);
  return bound;
}
void setPlatformFramebuffer(const PlatformFramebuffer& framebuffer) { platform = framebuffer; }
PlatformStandIn::PlatformStandIn() : before_(platform) { rememberPlatformFramebuffer(); }
PlatformStandIn::~PlatformStandIn() {
  platform = before_;
  bindPlatformFramebuffer();
}
int platformSamples() { return platform.samples; }
void bindPlatformFramebuffer() { glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(platform.name)); }

// A framebuffer of our own is resolved by a blit, that of a window or a canvas by copying: each refuses the other.
void Target::takeRows(const Texture& texture, int bottom, int count) const {
  glDisable(GL_SCISSOR_TEST);
  const int width = texture.shape().width;
  if (platform.name != 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(platform.name));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
    glBlitFramebuffer(0, bottom, width, bottom + count, 0, bottom, width, bottom + count, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return;
  }
  bindPlatformFramebuffer();
  texture.bind(31);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, bottom, 0, bottom, width, count);
}

std::vector<std::uint8_t> readPixels(int width, int height) {
  const auto row = static_cast<std::size_t>(width) * 4;
  std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(height)), downward(upward.size());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  for (int y = 0; y < height; ++y)
    std::copy_n(upward.begin() + static_cast<std::ptrdiff_t>(row) * y, row,
                downward.begin() + static_cast<std::ptrdiff_t>(row) * (height - 1 - y));
  return downward;
}

std::vector<std::uint32_t> readWholeNumbers(int width, int height) {
  std::vector<std::uint32_t> numbers(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glReadPixels(0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, numbers.data());
  return numbers;
}

Result<Capabilities> queryCapabilities() {
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!version) return Error{ErrorId::WebglUnavailable, "no OpenGL ES 3.0 context is current"};
  Capabilities c;
  c.renderer = renderer ? renderer : "unknown";
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &c.maxTextureSize);
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &c.maxArrayLayers);
  glGetIntegerv(GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS, &c.maxVertexTextures);
  glGetIntegerv(GL_MAX_SAMPLES, &c.maxSamples);
  if (c.maxArrayLayers < 64 || c.maxVertexTextures < 1)
    return Error{ErrorId::WebglUnavailable, c.renderer + ": " + decimal(c.maxArrayLayers) +
                                                " array layers (64 needed), " + decimal(c.maxVertexTextures) +
                                                " vertex textures (1 needed)"};
  return c;
}

std::string takeError() {
  std::string text;
  while (const GLenum error = glGetError()) {
    if (text.empty()) text = "GL error 0x" + hexadecimal(error, 4);
    if (error == 0x0507) break;  // context lost: would be reported for ever
  }
  return text;
}

}  // namespace fur::gl
