#include "dynamics/BendField.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dynamics/FurBall.h"

namespace fur::dynamics {
namespace {

TEST(BendField, StaysAtRestWithoutForces) {
  BendField field = FurBall().field();
  for (int k = 0; k < 100; ++k) field.step(1 / 60.0f, kStill, noForces(), {});
  EXPECT_EQ(largest(field), 0.0f);
  EXPECT_TRUE(field.atRest());
}

TEST(BendField, LiesAcrossTheRestDirection) {
  const FurBall ball;
  BendField field = ball.field();
  field.settle(kStill, windy(), {});
  for (int k = 0; k < 50; ++k) field.step(1 / 60.0f, glm::rotate(kStill, 0.1f * k, Vec3(0, 1, 0)), windy(), {});
  for (std::size_t i = 0; i < ball.directions.size(); ++i)
    EXPECT_NEAR(glm::dot(Vec3(field.bends()[i]), ball.directions[i]), 0.0f, 1e-5f);
}

TEST(BendField, ConvergesUnderSteadyWindToWhatSettleGives) {
  const FurBall ball;
  BendField stepped = ball.field(), settled = ball.field();
  settled.settle(kStill, windy(), {});
  EXPECT_TRUE(settled.atRest());
  for (int k = 0; k < 600 && !(k > 0 && stepped.atRest()); ++k) stepped.step(1 / 60.0f, kStill, windy(), {});
  EXPECT_TRUE(stepped.atRest());
  EXPECT_GT(largest(stepped), 0.1f);
  EXPECT_LT(farthest(stepped, settled), 1e-5f);
}

TEST(BendField, SwingsALittlePastItsBalance) {
  const FurBall ball;
  BendField stepped = ball.field(), settled = ball.field();
  settled.settle(kStill, windy(), {});
  float over = 0;
  for (int k = 0; k < 60; ++k) {
    stepped.step(1 / 60.0f, kStill, windy(), {});
    over = std::max(over, largest(stepped) / largest(settled));
  }
  EXPECT_GT(over, 1.1f);
  EXPECT_LT(over, 1.5f);
}

// A model that is dragged to and fro and turned, watched at a frame rate.
std::vector<BendField> watch(const FurBall& ball, int rate) {
  BendField field = ball.field();
  std::vector<BendField> seen;
  for (int frame = 0; frame <= 2 * rate; ++frame) {
    const float t = static_cast<float>(frame) / static_cast<float>(rate);
    const Mat4 moved = glm::translate(kStill, Vec3(0.3f * std::sin(3 * t), 0.1f * std::cos(2 * t), 0));
    const Mat4 turned = glm::rotate(moved, 0.8f * std::sin(2.5f * t), Vec3(0, 1, 0));
    if (frame == 0)
      field.settle(turned, windy(), {});
    else
      field.step(1.0f / static_cast<float>(rate), turned, windy(), {});
    if (frame % (rate / 6) == 0) seen.push_back(field);
  }
  return seen;
}

TEST(BendField, LooksTheSameAtEveryFrameRateUnderSteadyForces) {
  const FurBall ball;
  std::vector<BendField> fields;
  for (const int rate : {30, 60, 144}) {
    BendField field = ball.field();
    for (int frame = 0; frame < rate / 6; ++frame) field.step(1.0f / static_cast<float>(rate), kStill, windy(), {});
    fields.push_back(field);
  }
  // The swing is integrated exactly: only rounding differs.
  EXPECT_LT(farthest(fields[0], fields[1]), 1e-4f);
  EXPECT_LT(farthest(fields[2], fields[1]), 1e-4f);
}

TEST(BendField, LooksTheSameAtEveryFrameRateWhenDragged) {
  const FurBall ball;
  const auto slow = watch(ball, 30), middle = watch(ball, 60), fast = watch(ball, 144);
  float most = 0, apartSlow = 0, apartFast = 0;
  for (std::size_t k = 1; k < middle.size(); ++k) {
    most = std::max(most, largest(middle[k]));
    apartSlow = std::max(apartSlow, farthest(slow[k], middle[k]));
    apartFast = std::max(apartFast, farthest(fast[k], middle[k]));
  }
  EXPECT_LT(apartFast, 0.02f * most);
  EXPECT_LT(apartSlow, 0.02f * most);
}

TEST(BendField, TrailsBehindAModelThatStartsToMove) {
  BendField field;
  field.reset({Vec3(0, 1, 0)}, {Vec3(0, 1, 0)});
  field.step(1 / 60.0f, kStill, noForces(), {});
  float least = 0;
  for (int k = 1; k < 12; ++k) {
    field.step(1 / 60.0f, glm::translate(kStill, Vec3(0.03f * k, 0, 0)), noForces(), {});
    least = std::min(least, field.bends()[0].x);
  }
  EXPECT_LT(least, -0.05f);
  EXPECT_FALSE(field.atRest());
}

TEST(BendField, FeelsForcesInTheModelsOwnFrame) {
  BendField field;
  field.reset({Vec3(1, 0, 0)}, {Vec3(1, 0, 0)});
  BendForces forces = noForces();
  forces.gravity = Vec3(0, -0.3f, 0);
  // Turned by a quarter about x, the model's +z points down.
  field.settle(glm::rotate(kStill, glm::radians(90.0f), Vec3(1, 0, 0)), forces, {});
  EXPECT_GT(field.bends()[0].z, 0.1f);
  EXPECT_NEAR(field.bends()[0].y, 0.0f, 1e-6f);
}

TEST(BendField, HangsLowerWhenWet) {
  const FurBall ball;
  BendField dry = ball.field(), wet = ball.field();
  BendForces forces = noForces();
  forces.gravity = Vec3(0, -0.25f, 0);
  dry.settle(kStill, forces, {});
  wet.settle(kStill, forces, std::vector<float>(ball.positions.size(), 1.0f));
  EXPECT_GT(largest(wet), 1.5f * largest(dry));
}

TEST(BendField, SwingsLessWhenWet) {
  const FurBall ball;
  const std::vector<float> soaked(ball.positions.size(), 1.0f);
  BendField field = ball.field(), settled = ball.field();
  BendForces forces = noForces();
  forces.wind.force = Vec3(0.3f, 0, 0);
  settled.settle(kStill, forces, soaked);
  for (int k = 0; k < 120; ++k) {
    field.step(1 / 60.0f, kStill, forces, soaked);
    EXPECT_LT(largest(field), 1.02f * largest(settled));
  }
}

TEST(BendField, BendsLessWhenStiff) {
  const FurBall ball;
  BendField soft = ball.field(), stiff = ball.field();
  BendForces forces = windy();
  forces.stiffness = 0;
  soft.settle(kStill, forces, {});
  forces.stiffness = 1;
  stiff.settle(kStill, forces, {});
  EXPECT_LT(largest(stiff), 0.5f * largest(soft));
}

TEST(BendField, TakesATeleportForNoMotion) {
  BendField field = FurBall().field();
  field.settle(kStill, noForces(), {});
  field.step(1 / 60.0f, glm::translate(kStill, Vec3(5, 0, 0)), noForces(), {});
  field.step(1 / 60.0f, glm::translate(kStill, Vec3(5, 0, 0)), noForces(), {});
  EXPECT_EQ(largest(field), 0.0f);
}

TEST(BendField, DoesNothingInNoTime) {
  BendField field = FurBall().field();
  for (const float dt : {0.0f, -1.0f, std::nanf("")}) field.step(dt, kStill, windy(), {});
  EXPECT_EQ(largest(field), 0.0f);
}

TEST(BendField, SettlesAfterALongPause) {
  const FurBall ball;
  BendField slept = ball.field(), settled = ball.field();
  slept.step(1e9f, kStill, windy(), {});
  settled.settle(kStill, windy(), {});
  EXPECT_EQ(farthest(slept, settled), 0.0f);
  EXPECT_TRUE(slept.atRest());
}

TEST(BendField, StaysFiniteAndBoundedWhateverHappens) {
  const FurBall ball;
  BendField field = ball.field();
  Random random(77);
  std::vector<float> wetness(ball.positions.size());
  const float odd[] = {std::nanf(""), std::numeric_limits<float>::infinity(), -3.0f, 1e30f};
  for (int k = 0; k < 1000; ++k) {
    Mat4 m = glm::translate(kStill, Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) *
                                        (k % 7 == 0 ? 100.0f : 0.3f));
    m = glm::rotate(m, random.uniform(-3, 3), Vec3(0.6f, 0.8f, 0));
    if (k % 13 == 0) m[1][2] = odd[k % 4];
    if (k % 29 == 0) m = Mat4(0.0f);
    for (float& w : wetness) w = random.uniform(-0.5f, 1.5f);
    if (k % 17 == 0) wetness[5] = odd[k % 4];
    BendForces forces = windy();
    forces.stiffness = random.uniform(-1, 2);
    forces.inertia = k % 19 == 0 ? odd[k % 4] : random.uniform();
    if (k % 23 == 0) forces.wind.force.x = odd[k % 4];
    field.step(random.uniform(0.0f, k % 5 == 0 ? 10.0f : 0.03f), m, forces, wetness);
    for (const Vec4& bend : field.bends()) {
      ASSERT_TRUE(std::isfinite(glm::dot(bend, bend))) << k;
      ASSERT_LE(glm::length(Vec3(bend)), kMaxBend * 1.0001f) << k;
    }
  }
}

// Combed downwards, more on one side than on the other.
std::vector<Vec3> combed(const FurBall& ball) {
  std::vector<Vec3> rests;
  for (const Vec3& n : ball.directions) rests.push_back((Vec3(0, -1, 0) + n * n.y) * (0.6f + 0.5f * n.x));
  return rests;
}

TEST(BendField, CombedFurRestsCombed) {
  const FurBall ball;
  BendField field = ball.field();
  field.setRest(combed(ball), {});
  field.settle(kStill, noForces(), {});
  for (std::size_t i = 0; i < ball.directions.size(); ++i)
    EXPECT_LT(glm::length(Vec3(field.bends()[i]) - combed(ball)[i]), 1e-5f);
  field.setRest({}, {});
  field.settle(kStill, noForces(), {});
  EXPECT_EQ(largest(field), 0);
}

TEST(BendField, ARestOfNothingIsNoRest) {
  const FurBall ball;
  BendField upright = ball.field(), combed = ball.field();
  combed.setRest(std::vector<Vec3>(ball.positions.size(), Vec3(0)), {});
  for (int k = 0; k < 40; ++k) {
    const Mat4 turned = glm::rotate(kStill, 0.05f * k, Vec3(0, 1, 0));
    upright.step(1 / 60.0f, turned, windy(), {});
    combed.step(1 / 60.0f, turned, windy(), {});
  }
  EXPECT_LT(farthest(upright, combed), 1e-5f);
}

TEST(BendField, SwingsFromTheCombToTheBalanceThatSettleGives) {
  const FurBall ball;
  BendField stepped = ball.field(), settled = ball.field();
  for (BendField* field : {&stepped, &settled}) field->setRest(combed(ball), {});
  settled.settle(kStill, windy(), {});
  for (int k = 0; k < 600; ++k) stepped.step(1 / 60.0f, kStill, windy(), {});
  EXPECT_TRUE(stepped.atRest());
  EXPECT_LT(farthest(stepped, settled), 2e-3f);
  for (std::size_t i = 0; i < ball.directions.size(); ++i) {
    EXPECT_NEAR(glm::dot(Vec3(settled.bends()[i]), ball.directions[i]), 0, 1e-5f);
    EXPECT_LE(glm::length(Vec3(settled.bends()[i])), kMaxBend * 1.0001f);
  }
}

TEST(BendField, AForceAlongTheCombMovesLessThanOneAcrossIt) {
  BendField field;
  field.reset({Vec3(0, 1, 0)}, {Vec3(0, 1, 0)});
  field.setRest({Vec3(1.2f, 0, 0)}, {});
  BendForces forces = noForces();
  const auto moved = [&](const Vec3& pull) {  // gravity, for wind has its lee
    forces.gravity = pull;
    field.settle(kStill, forces, {});
    return glm::length(Vec3(field.bends()[0]) - Vec3(1.2f, 0, 0));
  };
  // The chord of a strand that turns by 1.2 stands at 0.6 rad: as much of the force as its cosine is left.
  const float across = moved(Vec3(0, 0, 0.1f)), against = moved(Vec3(-0.1f, 0, 0));
  EXPECT_GT(across, 0.05f);
  EXPECT_NEAR(against, across * std::cos(0.6f), 1e-4f);
  // What presses down lays it flatter.
  forces.gravity = Vec3(0, -0.02f, 0);
  field.settle(kStill, forces, {});
  EXPECT_GT(field.bends()[0].x, 1.2f);
}

TEST(BendField, CarriesTheLengthsForTheShaders) {
  const FurBall ball;
  BendField field = ball.field();
  EXPECT_EQ(field.bends()[7].w, 1);
  std::vector<float> lengths(ball.positions.size(), 0.25f);
  field.setRest({}, lengths);
  field.step(1 / 60.0f, kStill, windy(), {});
  EXPECT_EQ(field.bends()[7].w, 0.25f);
  field.settle(kStill, windy(), {});
  EXPECT_EQ(field.bends()[7].w, 0.25f);
}

TEST(ArcBend, KeepsTheStrandsLength) {
  for (const float theta : {0.0f, 1e-4f, 0.01f, 0.3f, 1.0f, kMaxBend, kMostPressed}) {
    float length = 0;
    Vec2 last = arcBend(theta, 0);
    for (int i = 1; i <= 100; ++i) {
      const Vec2 at = arcBend(theta, i / 100.0f);
      length += glm::length(at - last);
      last = at;
    }
    EXPECT_NEAR(length, 1.0f, 0.01f) << theta;
  }
}

TEST(ArcBend, IsTheClosedFormOnBothSidesOfItsSeries) {
  for (const double theta : {1e-6, 1e-3, 0.0099, 0.0101, 0.1, 1.0})
    for (const double t : {0.0, 0.3, 1.0}) {
      const Vec2 at = arcBend(static_cast<float>(theta), static_cast<float>(t));
      EXPECT_NEAR(at.x, std::sin(theta * t) / theta, 2e-7);
      // Single precision of 1 - cos over theta just past the series' end.
      EXPECT_NEAR(at.y, (1 - std::cos(theta * t)) / theta, 1e-5);
    }
}

TEST(WindBend, StandsUprightWithoutForce) {
  EXPECT_NEAR(windBend(0, 1).x, 1.0f, 1e-6f);
  EXPECT_EQ(windBend(0, 1).y, 0.0f);
}

TEST(WindBend, EndsAtThePrintedEndPoint) {
  const Vec2 end = windBend(0.5f, 1.0f);
  EXPECT_NEAR(end.y, 0.861986 * 0.5 - 0.176676 * 0.25, 1e-6);
  EXPECT_NEAR(end.x, 1 - 0.04743 * 0.5 - 0.36726 * 0.25, 1e-6);
}

}  // namespace
}  // namespace fur::dynamics
