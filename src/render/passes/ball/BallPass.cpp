#include "render/passes/ball/BallPass.h"

namespace fur::render {

void fillBall(const Frame& frame, shared::FrameBlock& block) {
  block.ballCentre = Vec4(Vec3(frame.ball), 1);
  block.ballRadius = frame.ball.w;
}

Status drawBall(const Drawing& drawing) {
  if (drawing.frame.ball.w <= 0) return Done{};
  const auto program = drawing.programs.use(Shader::Ball, kPlain);
  if (!program) return program.error();
  gl::apply({});
  drawBallTriangles();
  return Done{};
}

void drawBallTriangles() { gl::drawWithoutVertices(6 * FUR_BALL_AROUND * FUR_BALL_DOWN); }

}  // namespace fur::render
