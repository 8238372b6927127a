#include <gtest/gtest.h>

#include <limits>

#include "dynamics/FurBall.h"

namespace fur::dynamics {
namespace {

// A square of fur that looks up, and its mirror image at every place but the middle line: x = 0 runs through it.
struct Meadow {
  static constexpr int kHalf = 20;
  static constexpr float kCell = 0.05f;
  std::vector<Vec3> positions, directions, tangents;
  Meadow() {
    for (int z = -kHalf; z <= kHalf; ++z)
      for (int x = -kHalf; x <= kHalf; ++x) positions.push_back(Vec3(kCell * x, 0, kCell * z));
    directions.assign(positions.size(), Vec3(0, 1, 0));
    tangents.assign(positions.size(), Vec3(1, 0, 0));
  }
  static std::size_t at(int x, int z) { return static_cast<std::size_t>((z + kHalf) * (2 * kHalf + 1) + x + kHalf); }
  BendField field() const {
    BendField f;
    f.reset(positions, directions, tangents);
    return f;
  }
};

BendForces meadowForces() {
  BendForces forces = noForces();
  forces.furLength = 0.2f;
  return forces;
}

Contact resting(const Vec3& at, float radius = 0.3f) { return {at, at, radius, 0.5f}; }

// A hand that goes along x = `x`, from z = -0.6 to 0.6 within a second.
void stroke(BendField& field, float x, float sideways, int rate, const BendForces& forces, const std::vector<float>& wetness) {
  const auto at = [&](int frame) {
    const float t = static_cast<float>(frame) / static_cast<float>(rate);
    return Vec3(x + sideways * (t - 0.5f), 0.25f, 1.2f * t - 0.6f);
  };
  for (int frame = 1; frame <= rate; ++frame) {
    const Contact hand{at(frame - 1), at(frame), 0.3f, 1.0f};
    field.step(1.0f / static_cast<float>(rate), kStill, forces, wetness, {&hand, 1});
  }
}

TEST(Contact, ABallPressesStrandsBelowItsSurfaceAndAway) {
  const Meadow meadow;
  BendField field = meadow.field();
  const Vec3 centre(0.012f, 0.4f, 0.007f);
  const Contact ball = resting(centre);
  for (int k = 0; k < 30; ++k) field.step(1 / 60.0f, kStill, meadowForces(), {}, {&ball, 1});
  int pressed = 0;
  for (std::size_t i = 0; i < meadow.positions.size(); ++i) {
    const Vec3 bend = field.bends()[i], aside = meadow.positions[i] - Vec3(centre.x, 0, centre.z);
    const float near = glm::length(aside);
    if (near > 0.3f) {
      EXPECT_EQ(glm::length(bend), 0) << i;
      continue;
    }
    // Below the surface where the ball leaves room for it: an arc lies no flatter than 0.41 of its length.
    const float surface = centre.y - std::sqrt(0.09f - near * near);
    const Vec3 tip = strandPoint(meadow.positions[i], Vec3(0, 1, 0), bend, 0.2f, 1);
    if (surface > 0.2f) continue;
    ++pressed;
    EXPECT_LT(tip.y, std::max(surface, 0.0822f) + 1e-3f) << i;
    EXPECT_GE(glm::dot(bend, aside), 0) << i;
  }
  EXPECT_GT(pressed, 50);
}

TEST(Contact, PressedFurRisesWithoutAJump) {
  const Meadow meadow;
  BendField field = meadow.field();
  const Contact ball = resting(Vec3(0.012f, 0.32f, 0.007f));
  for (int k = 0; k < 30; ++k) field.step(1 / 60.0f, kStill, meadowForces(), {}, {&ball, 1});
  EXPECT_GT(largest(field), kMaxBend + 0.5f);
  for (int k = 0; k < 120; ++k) {
    const BendField before = field;
    field.step(1 / 60.0f, kStill, meadowForces(), {});
    // It springs back at 12 rad/s: a tenth of its bend a frame.
    ASSERT_LT(farthest(field, before), 0.15f * kMostPressed) << k;
  }
}

TEST(Contact, FurThatTheBallLeavesComesBack) {
  const Meadow meadow;
  BendField field = meadow.field();
  const Contact ball = resting(Vec3(0, 0.35f, 0));
  field.step(1 / 60.0f, kStill, meadowForces(), {}, {&ball, 1});
  EXPECT_GT(largest(field), 1);
  float last = largest(field);
  for (int k = 0; k < 600 && !field.atRest(); ++k) field.step(1 / 60.0f, kStill, meadowForces(), {});
  EXPECT_TRUE(field.atRest());
  EXPECT_EQ(largest(field), 0) << last;
}

TEST(Contact, ABallThatWasDraggedAndRestsLetsEverythingSleep) {
  const Meadow meadow;
  BendField field = meadow.field();
  stroke(field, 0, 0.3f, 60, meadowForces(), {});
  const Contact ball = resting(Vec3(0.15f, 0.25f, 0.6f));
  for (int k = 0; k < 300; ++k) field.step(1 / 60.0f, kStill, meadowForces(), {}, {&ball, 1});
  EXPECT_TRUE(field.atRest());
  EXPECT_GT(largest(field), 1);
}

TEST(Contact, AHeldBallLetsEverythingSleep) {
  const Meadow meadow;
  BendField field = meadow.field();
  const Contact ball = resting(Vec3(0.01f, 0.35f, 0));
  for (int k = 0; k < 600; ++k) field.step(1 / 60.0f, kStill, windy(), {}, {&ball, 1});
  EXPECT_TRUE(field.atRest());
  const BendField before = field;
  field.step(1 / 60.0f, kStill, windy(), {}, {&ball, 1});
  EXPECT_EQ(farthest(field, before), 0);
  // And wakes those that it lets go.
  for (int k = 0; k < 30; ++k) field.step(1 / 60.0f, kStill, windy(), {});
  EXPECT_GT(farthest(field, before), 0.5f);
}

TEST(Contact, AStrokeLaysTheFurAlongItAndPartsIt) {
  const Meadow meadow;
  BendField field = meadow.field();
  stroke(field, 0, 0, 60, meadowForces(), {});
  const Vec3 middle = field.bends()[Meadow::at(0, 8)];
  EXPECT_GT(middle.z, 0.8f);
  EXPECT_LT(std::abs(middle.x), 0.05f);
  // To its own side on each side.
  EXPECT_GT(field.bends()[Meadow::at(4, 8)].x, 0.05f);
  EXPECT_LT(field.bends()[Meadow::at(-4, 8)].x, -0.05f);
}

TEST(Contact, AStrokeAndItsMirrorImageAreMirrorImages) {
  const Meadow meadow;
  BendField right = meadow.field(), left = meadow.field();
  stroke(right, 0.13f, 0.3f, 60, meadowForces(), {});
  stroke(left, -0.13f, -0.3f, 60, meadowForces(), {});
  ASSERT_GT(largest(right), 1);
  for (int z = -Meadow::kHalf; z <= Meadow::kHalf; ++z)
    for (int x = -Meadow::kHalf; x <= Meadow::kHalf; ++x) {
      const Vec3 a = right.bends()[Meadow::at(x, z)], b = left.bends()[Meadow::at(-x, z)];
      // A change of sign is exact.
      ASSERT_EQ(a, Vec3(-b.x, b.y, b.z)) << x << ' ' << z;
    }
}

TEST(Contact, AStrokeLeavesTheSameAtEveryFrameRate) {
  const Meadow meadow;
  std::vector<BendField> fields;
  for (const int rate : {30, 60, 144}) {
    BendField field = meadow.field();
    stroke(field, 0.03f, 0.2f, rate, meadowForces(), {});
    fields.push_back(std::move(field));
  }
  const auto apart = [&](const BendField& a, const BendField& b) {
    double sum = 0, all = 0;
    for (std::size_t i = 0; i < a.bends().size(); ++i) {
      sum += glm::length(Vec3(a.bends()[i]) - Vec3(b.bends()[i]));
      all += glm::length(Vec3(b.bends()[i]));
    }
    return sum / all;
  };
  EXPECT_LT(apart(fields[2], fields[1]), 0.02);
  EXPECT_LT(apart(fields[0], fields[1]), 0.04);
}

// Seconds until half of what a stroke has done is forgotten.
float halfLife(float stiffness, float wetness) {
  const Meadow meadow;
  BendField field = meadow.field();
  BendForces forces = meadowForces();
  forces.stiffness = stiffness;
  const std::vector<float> wet(meadow.positions.size(), wetness);
  stroke(field, 0, 0, 60, forces, wet);
  const std::size_t strand = Meadow::at(0, 12);
  const float before = glm::length(Vec3(field.bends()[strand]));
  float seconds = 0;
  for (; seconds < 60 && glm::length(Vec3(field.bends()[strand])) > 0.5f * before; seconds += 1 / 60.0f)
    field.step(1 / 60.0f, kStill, forces, wet);
  return seconds;
}

TEST(Contact, SoftAndWetFurStaysCombedForLonger) {
  const float stiff = halfLife(1, 0), middle = halfLife(0.5f, 0), soft = halfLife(0, 0), soaked = halfLife(0.5f, 1);
  EXPECT_LT(stiff, 0.3f);
  EXPECT_GT(middle, 1.3f * stiff);
  EXPECT_GT(soft, 1.3f * middle);
  EXPECT_GT(soaked, 5);
  EXPECT_LT(soaked, 20);
}

TEST(Contact, CombedFurComesBackToItsComb) {
  const Meadow meadow;
  BendField field = meadow.field(), combed = meadow.field();
  const std::vector<Vec3> rests(meadow.positions.size(), Vec3(0.8f, 0, 0));
  field.setRest(rests, {});
  combed.setRest(rests, {});
  stroke(field, 0, 0, 60, meadowForces(), {});
  for (int k = 0; k < 900; ++k) field.step(1 / 60.0f, kStill, meadowForces(), {});
  combed.settle(kStill, meadowForces(), {});
  EXPECT_TRUE(field.atRest());
  EXPECT_LT(farthest(field, combed), 1e-6f);
}

TEST(Contact, StaysFiniteAndBoundedWhateverTouches) {
  const Meadow meadow;
  BendField field = meadow.field();
  Random random(3);
  const float odd[] = {std::nanf(""), std::numeric_limits<float>::infinity(), -3.0f, 1e30f, 0.0f};
  const auto number = [&](int k) { return k % 7 == 0 ? odd[k % 5] : random.uniform(-1, 1); };
  std::vector<float> wetness(meadow.positions.size());
  for (int k = 0; k < 1000; ++k) {
    for (float& w : wetness) w = random.uniform();
    Contact contacts[3];
    for (Contact& one : contacts) {
      one.from = Vec3(number(k), random.uniform(-0.3f, 0.5f), random.uniform(-1, 1));
      one.to = Vec3(random.uniform(-1, 1), number(k + 3), random.uniform(-1, 1));
      one.radius = k % 11 == 0 ? odd[k % 5] : random.uniform(0, 0.5f);
      one.grip = number(k + 5);
      one.presses = random.uniform(0, 4);
    }
    BendForces forces = windy();
    forces.furLength = k % 13 == 0 ? odd[k % 5] : 0.2f;
    const float dt = k % 5 == 0 ? random.uniform(0, 10) : random.uniform(0, 0.03f);
    field.step(dt, glm::translate(kStill, Vec3(number(k + 1), 0, 0)), forces, wetness, contacts);
    for (const Vec4& bend : field.bends()) {
      ASSERT_TRUE(std::isfinite(glm::dot(bend, bend))) << k;
      ASSERT_LE(glm::length(Vec3(bend)), kMostPressed * 1.0001f) << k;
    }
  }
}

}  // namespace
}  // namespace fur::dynamics
