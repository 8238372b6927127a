#include "render/passes/shadow/FurShadow.h"

#include <algorithm>
#include <cmath>

#include "render/passes/ball/BallPass.h"

namespace fur::render {

namespace {

constexpr float kLog2E = 1.442695f;

}  // namespace

float shadowRadius(float furLength, float reach) { return 0.02f + reach + furLength; }

Mat4 lightFromModel(const Vec3& light, float radius) {
  const Vec3 up = std::abs(light.y) < 0.99f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 x = glm::normalize(glm::cross(up, light)), y = glm::cross(light, x);
  const float half = 0.5f / radius;
  Mat4 matrix(glm::transpose(Mat3(half * x, half * y, -light)));
  matrix[3] = Vec4(0.5f, 0.5f, radius, 1);
  return matrix;
}

VolumeShadow volumeShadow(const settings::Settings& s, float density, float reach) {
  const float range = 2 * shadowRadius(s.furLength, reach);
  // Bare skin takes a map as coarse as ours for fur of this length.
  const float length = std::max(s.furLength, 0.06f);
  if (static_cast<Shadows>(s.shadows) == Shadows::Layers) {
    // sigma 1 is dark (Halen 3.3.2). The layers reach three lengths deep; the skin has a depth of its own.
    return {.extinction = 5 * kLog2E, .bias = 0, .layerDepth = 0.2f * length, .surface = 1, .range = range};
  }
  // A dense coat keeps all but a third of the light from its own depth; a body beneath a thin one still does.
  // Above 10 the edges of shadows would be harder than fur is.
  const float k = std::min(std::max(1.1f * saturate(density / 0.35f), 0.6f) / length, 10.0f);
  // Half a length is what strands' own shadow shows, and covers the map's steps: no acne.
  return {.extinction = k * kLog2E, .bias = 0.5f * length, .layerDepth = 0, .surface = 0.6f, .range = range};
}

VariantBits shadowVariant(const settings::Settings& s) {
  switch (static_cast<Shadows>(s.shadows)) {
    case Shadows::None:
      break;
    case Shadows::Depth:
      return kShadowDepth;
    case Shadows::Layers:
      return kShadowLayers;
  }
  return kPlain;
}

void FurShadow::Key::fill(shared::FrameBlock& block) const {
  block.lightFromModel = lightFromModel;
  block.shadowExtinction = volume.extinction;
  block.shadowBias = volume.bias;
  block.shadowLayerDepth = volume.layerDepth;
  block.shadowSurface = volume.surface;
  block.shadowRange = volume.range;
}

void FurShadow::prepare(int size, bool layers) {
  const auto format = layers ? gl::TexelFormat::RGBA8 : gl::TexelFormat::RG8;
  if (first_[0].shape().width != size || first_[0].shape().format != format)
    for (int i = 0; i < 2; ++i) {
      first_[i] = gl::Texture({format, size, size, 0, layers ? gl::Filter::Nearest : gl::Filter::Linear}, {});
      firstTarget_[i] = gl::Target::toTexture(first_[i], i == 0);
    }
  if (layers && (!opacity_.bytes() || opacity_.shape().width != size)) {
    opacity_ = gl::Texture({gl::TexelFormat::RGBA8, size, size, FUR_SHADOW_TARGETS, gl::Filter::Nearest}, {});
    opacityTarget_ = gl::Target::toTexture(opacity_);
  }
}

void FurShadow::clear(bool layers) {
  firstTarget_[0].bind();
  gl::clear(Vec4(1));
  if (!layers) return;
  opacityTarget_.bind();
  gl::clear(Vec4(0));
}

bool FurShadow::drawFirst(Programs& programs, const Key& key, bool layers, const gl::VertexArray& surface, int indexCount, const HairPass& hair) {
  firstTarget_[0].bind();
  for (const bool skin : {false, true}) {
    if (skin && !layers) break;
    if (!programs.use(Shader::ShadowMap, key.curve | (skin ? +kSkinOnly : +kPlain))) return false;
    if (skin) gl::clearDepth();
    gl::apply({.cullBack = false, .red = !skin, .green = !skin, .blue = skin, .alpha = skin});
    surface.drawIndexed(indexCount, 1);
    // Hair is part of the first surface.
    if (!skin && !hair.drawShadow(programs, kPlain, {.cullBack = false, .blue = false, .alpha = false})) return false;
    // As dark as skin: layers count strands from the coat on, whatever is above it.
    if (key.ball.w <= 0 || skin != layers) continue;
    if (!programs.use(Shader::ShadowMap, kBall)) return false;
    drawBallTriangles();
  }
  return true;
}

bool FurShadow::blur(Programs& programs) {
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  // Across into [1], down back into [0].
  if (!programs.use(Shader::ShadowBlur, kShadowDepth)) return false;
  for (const int from : {0, 1}) {
    firstTarget_[1 - from].bind();
    first_[from].bind(FUR_UNIT_SHADOW);
    gl::drawWithoutVertices(3, 3 * from);
  }
  return true;
}

bool FurShadow::drawLayers(Programs& programs, VariantBits curve, const gl::VertexArray& surface, int indexCount, const HairPass& hair) {
  if (!programs.use(Shader::ShadowMap, curve | kShadowLayers)) return false;
  first_[0].bind(FUR_UNIT_SHADOW);
  opacityTarget_.bind();
  const gl::DrawState added{.depthTest = false, .depthWrite = false, .cullBack = false, .blend = gl::Blend::Add};
  gl::apply(added);
  surface.drawIndexed(indexCount, FUR_SHADOW_SHELLS);
  return hair.drawShadow(programs, kShadowLayers, added);
}

bool FurShadow::update(Programs& programs, const Key& key, const gl::VertexArray& surface, int indexCount, const HairPass& hair) {
  if (key.shadows == Shadows::None) return true;
  const bool layers = key.shadows == Shadows::Layers;
  if (key_ != key) {
    prepare(key.size, layers);
    gl::setViewport(key.size, key.size);
    clear(layers);
    const bool drawn = !key.casts || (drawFirst(programs, key, layers, surface, indexCount, hair) &&
                                      (layers ? drawLayers(programs, key.curve, surface, indexCount, hair) : blur(programs)));
    gl::bindPlatformFramebuffer();
    if (!drawn) return false;
    key_ = key;
    ++redraws_;
  }
  first_[0].bind(FUR_UNIT_SHADOW);
  if (layers) opacity_.bind(FUR_UNIT_OPACITY);
  return true;
}

std::size_t FurShadow::bytes() const {
  const auto side = static_cast<std::size_t>(first_[0].bytes() ? first_[0].shape().width : 0);
  return first_[0].bytes() + first_[1].bytes() + opacity_.bytes() + 4 * side * side;  // the last: depth
}

}  // namespace fur::render
