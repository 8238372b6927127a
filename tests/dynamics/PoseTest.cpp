#include <gtest/gtest.h>

#include "dynamics/FurBall.h"

namespace fur::dynamics {
namespace {

struct Moved {
  std::vector<Vec3> positions, directions, tangents;
  Moved(const FurBall& ball, const Mat4& by) : positions(ball.positions), directions(ball.directions), tangents(ball.tangents) {
    for (Vec3& p : positions) p = Vec3(by * Vec4(p, 1));
    for (auto* vectors : {&directions, &tangents})
      for (Vec3& v : *vectors) v = Mat3(by) * v;
  }
  void give(BendField& field) const { field.setPose(positions, directions, tangents); }
};

std::vector<Vec3> combedEvenly(const FurBall& ball) {
  std::vector<Vec3> rests;
  for (const Vec3& n : ball.directions) rests.push_back((Vec3(0, -1, 0) + n * n.y) * 0.6f);
  return rests;
}

TEST(Pose, AShapeThatMovesAsAWholeSwingsLikeAModelThatIsMoved) {
  const FurBall ball;
  BendField shape = ball.field(), model = ball.field();
  for (int k = 0; k < 60; ++k) {
    const Mat4 by = glm::translate(kStill, Vec3(0.3f * std::sin(0.08f * k), 0.1f * std::sin(0.11f * k), 0));
    Moved(ball, by).give(shape);
    shape.step(1 / 60.0f, kStill, windy(), {});
    model.step(1 / 60.0f, by, windy(), {});
  }
  EXPECT_GT(largest(model), 0.5f);
  EXPECT_LT(farthest(shape, model), 1e-3f);
}

TEST(Pose, ACombTurnsWithTheSkin) {
  const FurBall ball;
  const Mat4 turn = glm::rotate(kStill, 1.1f, glm::normalize(Vec3(0.3f, 1, -0.5f)));
  for (const bool combedFirst : {true, false}) {
    BendField field = ball.field();
    if (combedFirst) field.setRest(combedEvenly(ball), {});
    Moved(ball, turn).give(field);
    // A comb is told as it is on the shape of reset().
    if (!combedFirst) field.setRest(combedEvenly(ball), {});
    field.settle(kStill, noForces(), {});
    for (std::size_t i = 0; i < ball.positions.size(); ++i)
      ASSERT_LT(glm::length(Vec3(field.bends()[i]) - Mat3(turn) * combedEvenly(ball)[i]), 1e-5f) << i;
  }
}

TEST(Pose, WhatLeansTurnsWithTheSkin) {
  const FurBall ball;
  BendField field = ball.field();
  field.settle(kStill, windy(), {});
  const auto before = field.bends();
  const Mat4 turn = glm::rotate(kStill, 0.7f, Vec3(0, 1, 0));
  Moved(ball, turn).give(field);
  field.step(1e-6f, kStill, windy(), {});  // in no time
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_LT(glm::length(Vec3(field.bends()[i]) - Mat3(turn) * Vec3(before[i])), 1e-3f) << i;
}

TEST(Pose, FurTrailsBehindASkinThatStartsToMoveAndRestsWhenItStops) {
  const FurBall ball;
  BendField field = ball.field();
  Moved(ball, kStill).give(field);
  field.step(1 / 60.0f, kStill, noForces(), {});
  for (int k = 1; k <= 10; ++k) {
    Moved(ball, glm::translate(kStill, Vec3(0.02f * k, 0, 0))).give(field);
    field.step(1 / 60.0f, kStill, noForces(), {});
    EXPECT_FALSE(field.atRest());
  }
  float lean = 0;
  for (const Vec4& bend : field.bends()) lean = std::min(lean, bend.x);
  EXPECT_LT(lean, -0.05f);
  for (int k = 0; k < 600 && !field.atRest(); ++k) field.step(1 / 60.0f, kStill, noForces(), {});
  EXPECT_TRUE(field.atRest());
  EXPECT_EQ(largest(field), 0);
}

TEST(Pose, StaysFiniteAndBoundedWhateverTheShapeDoes) {
  const FurBall ball;
  BendField field = ball.field();
  field.setRest(combedEvenly(ball), {});
  Random random(8);
  for (int k = 0; k < 500; ++k) {
    Mat4 by = glm::rotate(kStill, random.uniform(-3, 3), glm::normalize(Vec3(random.uniform(-1, 1), 1, random.uniform(-1, 1))));
    if (k % 11 == 0) by[3] = Vec4(random.uniform(-1e6f, 1e6f), 0, 0, 1);
    Moved(ball, by).give(field);
    field.step(k % 5 == 0 ? random.uniform(0, 10) : random.uniform(0, 0.03f), kStill, windy(), {});
    for (const Vec4& bend : field.bends()) {
      ASSERT_TRUE(std::isfinite(glm::dot(bend, bend))) << k;
      ASSERT_LE(glm::length(Vec3(bend)), kMaxBend * 1.0001f) << k;
    }
  }
}

}  // namespace
}  // namespace fur::dynamics
