#include "render/passes/ground/GroundShadow.h"

#include "render/Blocks.h"
#include "render/passes/ball/BallPass.h"

namespace fur::render {

namespace {

constexpr int kSize = 128;

}  // namespace

void GroundShadow::create() {
  for (int i = 0; i < 2; ++i) {
    maps_[i] = gl::Texture({gl::TexelFormat::RGBA8, kSize, kSize, 0}, {});
    targets_[i] = gl::Target::toTexture(maps_[i]);
  }
}

void GroundShadow::drawNothing() const {
  targets_[1].bind();
  gl::clear(Vec4(0));
  gl::bindPlatformFramebuffer();
}

bool GroundShadow::drawModel(const Drawing& drawing, const HairPass& hair) {
  if (!drawing.programs.use(Shader::GroundShadow, kPlain)) return false;
  const gl::DrawState added{.depthTest = false, .depthWrite = false, .cullBack = false, .blend = gl::Blend::Add};
  gl::apply(added);
  // Along the light, straight down, and where the eye sees it mirrored.
  const int ways = drawing.frame.puddles.empty() ? 2 : 3;
  drawing.surface.draw(ways);
  if (!hair.drawShadow(drawing.programs, kOnGround, added, ways)) return false;
  if (drawing.frame.ball.w <= 0) return true;
  if (!drawing.programs.use(Shader::GroundShadow, kBall)) return false;
  drawBallTriangles();
  return true;
}

bool GroundShadow::blur(Programs& programs) {
  if (!programs.use(Shader::Blur, kPlain)) return false;
  gl::apply({.depthTest = false, .depthWrite = false, .cullBack = false});
  // Across into [1], down back into [0].
  for (const int from : {0, 1}) {
    targets_[1 - from].bind();
    maps_[from].bind(FUR_UNIT_GROUND);
    gl::drawWithoutVertices(3, 3 * from);
  }
  return true;
}

bool GroundShadow::update(const Drawing& drawing, const HairPass& hair) {
  const Frame& frame = drawing.frame;
  if (!frame.settings.ground) return true;
  const Key key{drawing.surface.revision(), hair.revision(), frame.worldFromModel, lightDirection(frame), frame.coatLength, frame.groundHeight,
                frame.ball, frame.puddles.empty() ? Vec3(0) : frame.camera.eye, frame.castsShadows};
  if (key_ == key) return true;
  gl::setViewport(kSize, kSize);
  targets_[0].bind();
  gl::clear(Vec4(0));
  const bool drawn = !frame.castsShadows || (drawModel(drawing, hair) && blur(drawing.programs));
  gl::bindPlatformFramebuffer();
  if (drawn) key_ = key;
  return drawn;
}

}  // namespace fur::render
