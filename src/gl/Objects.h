// Move-only owners of OpenGL ES 3.0 objects: labelled, empty when default-constructed, rebuildable
// from CPU data. This module is the only caller of gl* functions. It holds no scene and no policy.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"

namespace fur::gl {

// Whether destructors delete GL objects. Call it with false before destroying the objects of a lost context, whose names are
// gone.
void setContextAlive(bool alive);

// Whether the context has KHR_parallel_shader_compile, switched on.
void setLinksTold(bool told);

// The name of a GL object and the function that deletes it.
class Name {
 public:
  using Delete = void (*)(unsigned);
  Name() = default;
  Name(unsigned id, Delete deleter) : id_(id), delete_(deleter) {}
  Name(Name&& other) noexcept : id_(other.id_), delete_(other.delete_) { other.id_ = 0; }
  Name& operator=(Name&& other) noexcept;
  ~Name() { reset(); }
  void reset();
  unsigned id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  unsigned id_ = 0;
  Delete delete_ = nullptr;
};

class Program {
 public:
  Program() = default;
  // Sources without the #version line; `defines` ("#define WET 1\n") come first. An error is webgl-unavailable with the
  // driver's message.
  static Result<Program> link(const char* label, std::string_view vertex, std::string_view fragment,
                              std::string_view defines = "");
  // The same in two parts, so that the driver can compile in between. `label` must outlive the program.
  static Program begin(const char* label, std::string_view vertex, std::string_view fragment, std::string_view defines);
  // Whether finish() need not wait for the driver; true where that cannot be told (setLinksTold()).
  bool linked() const;
  Status finish();
  // Names that the program does not use are ignored, as the compiler may remove them.
  void bindBlock(const char* name, unsigned binding) const;
  void bindSampler(const char* name, int unit) const;
  // The block's size by the driver, bytes; 0 when unused. Tests compare it with sizeof.
  int blockSize(const char* name) const;
  // The member's offset in its block by the driver, bytes; -1 when unused.
  int offsetInBlock(const char* member) const;
  void use() const;

 private:
  const char* label_ = "";
  Name name_, vertex_, fragment_;  // the shaders are deleted by finish()
};

enum class BufferKind { Vertex, Index, Uniform };

class Buffer {
 public:
  Buffer() = default;
  Buffer(BufferKind kind, std::span<const std::byte> bytes, bool changesOften);
  void update(std::span<const std::byte> bytes);  // grows when needed
  void bindAsBlock(unsigned binding) const;
  std::size_t bytes() const { return bytes_; }

 private:
  friend class VertexArray;
  Name name_;
  BufferKind kind_ = BufferKind::Vertex;
  std::size_t bytes_ = 0;
  bool changesOften_ = false;
};

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span<const T>(values));
}
template <class T>
std::span<const std::byte> bytesOf(const T& value) {
  static_assert(!requires { typename T::element_type; }, "of a span std::as_bytes()");
  return std::as_bytes(std::span<const T, 1>(&value, 1));
}

struct Attribute {
  unsigned location;
  int components;
  int offsetBytes;
};

class VertexArray {
 public:
  VertexArray() = default;
  // divisor 1: one value for each instance.
  VertexArray(const Buffer& vertices, int strideBytes, std::span<const Attribute> attributes, unsigned divisor,
              const Buffer* indices);
  // Attributes of another buffer.
  void add(const Buffer& vertices, int strideBytes, std::span<const Attribute> attributes, unsigned divisor);
  void drawIndexed(int indexCount, int instances, int first = 0) const;  // triangles, 32-bit indices
  void drawStrips(int vertexCount, int instances) const;
  void drawPoints(int count) const;

 private:
  Name name_;
};

// Draws `vertexCount` vertices without attributes (gl_VertexID alone).
void drawWithoutVertices(int vertexCount, int first = 0);
// Instances of those: triangles, or one strip each.
enum class Shape { Triangles, Strip };
void drawInstancesWithoutVertices(Shape shape, int vertexCount, int instances);

// RGBA16F supports filtering; its texels are passed as 32-bit floats.
enum class TexelFormat { R8, RG8, RGBA8, RGBA16F, RGBA32F, RGBA16UI, RGBA32UI };
// Mipmapped: bilinear in the level that the shader chooses. Crisp: nearest when magnified, else trilinear.
enum class Filter { Nearest, Linear, Mipmapped, Trilinear, Crisp };

struct TextureShape {
  TexelFormat format = TexelFormat::RGBA8;
  int width = 1, height = 1;
  int layers = 0;  // 0: a plain 2D texture
  Filter filter = Filter::Linear;
  bool repeats = false;
  int levels = 0;  // of mipmaps; 0: all there are
  int wrapU = 0, wrapV = 0;  // GL_MIRRORED_REPEAT and so on; 0: by `repeats`
};

class Texture {
 public:
  Texture() = default;
  // `texels` may be empty (undefined content). Generates the mipmaps of mipmapped, trilinear and crisp textures.
  Texture(const TextureShape& shape, std::span<const std::byte> texels);
  // Replaces [x, x+width) x [y, y+height) by the same rectangle of an image whose rows are `rowTexels` long.
  void update(int x, int y, int width, int height, std::span<const std::byte> image, int rowTexels);
  // Replaces one whole level of one layer (0 of a plain texture).
  void updateLevel(int level, int layer, std::span<const std::byte> texels);
  void bind(int unit) const;
  const TextureShape& shape() const { return shape_; }
  std::size_t bytes() const;
  unsigned id() const { return name_.id(); }

 private:
  Name name_;
  TextureShape shape_;
};

// No texture is bound to the unit: where what was is drawn into.
void unbindTexture(int unit);

// A render target. Empty: the platform's framebuffer.
class Target {
 public:
  Target() = default;
  // Draws into a texture, or into up to four layers of an array at once; with 24 bits of depth if wanted. Formats are 8 bits a
  // channel, or whole numbers, which each context supports, so completeness is not checked: that would wait for all earlier work.
  static Target toTexture(const Texture& texture, bool depth = false);
  // Colour and depth renderbuffers with `samples` samples (0: no multisampling), for pictures without a window.
  static Result<Target> offscreen(int width, int height, int samples);
  void bind() const;
  // Resolves `from` into this one (same size).
  void resolve(const Target& from, int width, int height) const;
  // Resolves rows of the platform's framebuffer into this target, a texture of the same size as `texture`, which it is.
  void takeRows(const Texture& texture, int bottom, int count) const;

 private:
  Name framebuffer_, color_, depth_;
};

// Over: premultiplied alpha. Erase: colour and alpha are multiplied by 1 - alpha of the source.
enum class Blend { None, Add, Over, Erase };

struct DrawState {
  bool depthTest = true, depthWrite = true, cullBack = true, cullFront = false;  // one of the two at most
  Blend blend = Blend::None;
  bool alphaToCoverage = false;
  bool nearer = false;  // a depth bias of about the rounding between two programs that draw the same triangle
  bool red = true, green = true, blue = true, alpha = true;  // channels written
};
void apply(const DrawState& state);

// `bottom`: the framebuffer shows rows of the picture from that one on.
void setViewport(int width, int height, int bottom = 0);
// A scissor: until setViewport() only `count` rows from `bottom` on are drawn into and cleared.
void drawOnlyRows(int bottom, int count, int width);
void flush();   // starts all commands so far
void finish();  // waits until they are done
void clear(const Vec4& color);
void clearDepth();  // only depth
void clearColor();  // only colour, to black
void bindPlatformFramebuffer();
struct PlatformFramebuffer {
  int name = 0, samples = 0;  // 0: no multisampling
};
// The one that is bound now, and which of them is the platform's from now on.
PlatformFramebuffer boundFramebuffer();
void setPlatformFramebuffer(const PlatformFramebuffer& framebuffer);
inline void rememberPlatformFramebuffer() { setPlatformFramebuffer(boundFramebuffer()); }
// During its lifetime the framebuffer that was bound replaces the platform's.
class PlatformStandIn {
 public:
  PlatformStandIn();
  ~PlatformStandIn();
  PlatformStandIn(const PlatformStandIn&) = delete;
  PlatformStandIn& operator=(const PlatformStandIn&) = delete;

 private:
  PlatformFramebuffer before_;
};
int platformSamples();  // of the platform's framebuffer; 0: no multisampling
// RGBA8 rows from the top of the bound framebuffer.
std::vector<std::uint8_t> readPixels(int width, int height);
// The numbers of an RGBA32UI texture that is bound as target, four a texel, rows from below.
std::vector<std::uint32_t> readWholeNumbers(int width, int height);

struct Capabilities {
  std::string renderer;
  int maxTextureSize = 0, maxArrayLayers = 0, maxVertexTextures = 0, maxSamples = 0;
};
// webgl-unavailable when the context is less than OpenGL ES 3.0 or lacks what we need.
Result<Capabilities> queryCapabilities();
// The first pending GL error as text, "" when none.
std::string takeError();

}  // namespace fur::gl
