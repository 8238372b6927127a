#include "render/passes/ball/BallPass.h"

namespace fur::render {

void fillBall(const Frame& frame, shared::FrameBlock& block) {
  block.ballCentre = Vec4(Vec3(frame.ball), 1);
  block.ballRadius = frame.ball.w;
}

bool drawBall(const Drawing& drawing) {
  if (drawing.frame.ball.w <= 0) return true;
  if (!drawing.programs.use(Shader::Ball, kPlain)) return false;
  gl::apply({});
  drawBallTriangles();
  return true;
}

void drawBallTriangles() { gl::drawWithoutVertices(6 * FUR_BALL_AROUND * FUR_BALL_DOWN); }

}  // namespace fur::render
