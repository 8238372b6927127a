#include <gtest/gtest.h>

#include "core/Fnv1a.h"
#include "core/PortableMath.h"
#include "dynamics/FurBall.h"
#include "geometry/Primitives.h"
#include "tests/OnEveryPlatform.h"

namespace fur::dynamics {
namespace {

BendField strandAt(const Vec3& position, const Vec3& direction) {
  BendField field;
  field.reset({position}, {direction});
  return field;
}

TEST(Forces, SteadyWindBendsByItsStrengthTheSideAndTheStiffness) {
  BendForces forces = noForces();
  forces.wind.force = Vec3(0.4f, 0, 0);
  for (const auto& [stiffness, compliance] : {std::pair(0.0f, 2.5f), {0.5f, 1.0f}, {1.0f, 0.4f}}) {
    BendField field = strandAt(Vec3(0, 1, 0), Vec3(0, 1, 0));
    forces.stiffness = stiffness;
    for (int k = 0; k < 600; ++k) field.step(1 / 60.0f, kStill, forces, {});
    // Edge-on to the wind: half way between the windward side's whole and the lee side's 0.4 of it.
    EXPECT_NEAR(field.bends()[0].x, kMaxBend * std::min(1.0f, 0.4f * 0.7f * compliance), 1e-5f);
  }
}

TEST(Forces, GravityBendsByTheWeightOfTheCoat) {
  BendForces forces = noForces();
  forces.gravity = Vec3(0, -0.3f, 0);
  for (const float weight : {0.0f, 0.5f, 1.0f}) {
    BendField field = strandAt(Vec3(1, 0, 0), Vec3(1, 0, 0));
    forces.weight = weight;
    field.settle(kStill, forces, {});
    EXPECT_NEAR(field.bends()[0].y, -kMaxBend * 0.3f * (0.5f + weight), 1e-5f);
  }
}

TEST(Forces, HeavyAndSoakedFurIsSlower) {
  // Steps until it has come half of its way.
  const auto steps = [](float weight, float wetness) {
    BendField field = strandAt(Vec3(0, 1, 0), Vec3(0, 1, 0)), there = field;
    BendForces forces = noForces();
    forces.wind.force = Vec3(0.4f, 0, 0);
    forces.weight = weight;
    there.settle(kStill, forces, {wetness});
    int k = 0;
    for (; k < 1000 && field.bends()[0].x < 0.5f * there.bends()[0].x; ++k) field.step(1e-3f, kStill, forces, {wetness});
    return k;
  };
  EXPECT_GT(steps(1, 0), 1.3 * steps(0, 0));
  EXPECT_GT(steps(0.5f, 1), 1.5 * steps(0.5f, 0));
}

TEST(Forces, TheLeeSideIsCalmer) {
  BendForces forces = noForces();
  forces.wind.force = Vec3(0, 0, 0.4f);
  const float slant = std::sqrt(0.5f);
  BendField front = strandAt(Vec3(0, slant, -slant), Vec3(0, slant, -slant));
  BendField back = strandAt(Vec3(0, slant, slant), Vec3(0, slant, slant));
  for (BendField* field : {&front, &back}) field->settle(kStill, forces, {});
  EXPECT_LT(largest(back), 0.65f * largest(front));
  EXPECT_GT(largest(back), 0.4f * largest(front));
}

// How far the fur at x leans over some seconds, 100 numbers each.
std::vector<float> leansAt(float x, BendForces forces, int seconds) {
  BendField field = strandAt(Vec3(x, 0, 0), Vec3(0, 1, 0));
  std::vector<float> leans;
  for (int k = 0; k < 100 * seconds; ++k) {
    forces.wind.time = 0.01 * k;
    field.step(0.01f, kStill, forces, {});
    leans.push_back(field.bends()[0].x);
  }
  return leans;
}

TEST(Forces, GustsTravelOverTheBodyWithTheWind) {
  BendForces forces = noForces();
  forces.wind.force = Vec3(0.4f, 0, 0);
  forces.wind.gust = 1;
  const auto windward = leansAt(-0.8f, forces, 20), leeward = leansAt(0.8f, forces, 20);
  // Where the two agree best the leeward one comes later.
  int best = 0;
  double least = 1e30;
  for (int lag = -200; lag <= 200; ++lag) {
    double apart = 0;
    for (int k = 400; k < 1600; ++k) {
      const double d = windward[static_cast<std::size_t>(k)] - leeward[static_cast<std::size_t>(k + lag)];
      apart += d * d;
    }
    if (apart < least) least = apart, best = lag;
  }
  EXPECT_GT(best, 50);
  EXPECT_LT(best, 200);
}

TEST(Forces, EddiesNeverRepeatAndDifferFromPlaceToPlace) {
  BendForces forces = noForces();
  forces.wind.force = Vec3(0.4f, 0, 0);
  forces.wind.turbulence = 1;
  const auto here = leansAt(0, forces, 20), near = leansAt(0.02f, forces, 20), there = leansAt(0.7f, forces, 20);
  float fromMean = 0, fromNear = 0, fromThere = 0;
  for (std::size_t k = 100; k < here.size(); ++k) {
    fromMean = std::max(fromMean, std::abs(here[k] - 0.4f * 0.7f * kMaxBend));
    fromNear = std::max(fromNear, std::abs(here[k] - near[k]));
    fromThere = std::max(fromThere, std::abs(here[k] - there[k]));
  }
  EXPECT_GT(fromMean, 0.1f);
  EXPECT_LT(fromNear, 0.2f * fromMean);
  EXPECT_GT(fromThere, 0.5f * fromMean);
  for (std::size_t period = 50; period < 1000; ++period) {
    float apart = 0;
    for (std::size_t k = 100; k < 1000; ++k) apart = std::max(apart, std::abs(here[k] - here[k + period]));
    ASSERT_GT(apart, 0.1f * fromMean) << period;
  }
}

// All forces at once: a model that is dragged and turned, soaked below and combed, in gusts and eddies.
struct Storm {
  const FurBall ball;
  std::vector<float> wetness;
  std::vector<Vec3> rests;
  Storm() {
    for (const Vec3& n : ball.directions) {
      wetness.push_back(n.y < 0 ? 1.0f : 0.0f);
      rests.push_back((Vec3(0, -1, 0) + n * n.y) * 0.5f);
    }
  }
  static Mat4 transformAt(float t) {
    const float angle = 0.8f * portableSin(2.5f * t), c = portableCos(angle), s = portableSin(angle);
    Mat4 m(1.0f);
    m[0] = Vec4(c, 0, -s, 0);
    m[2] = Vec4(s, 0, c, 0);
    m[3] = Vec4(0.3f * portableSin(3 * t), 0.1f * portableCos(2 * t), 0, 1);
    return m;
  }
  static BendForces forcesAt(float t) {
    BendForces forces = windy();
    forces.wind.gust = 0.6f;
    forces.wind.turbulence = 0.5f;
    forces.wind.time = static_cast<double>(t);
    return forces;
  }
  std::vector<BendField> watched(int rate) const {
    BendField field = ball.field();
    field.setRest(rests, {});
    std::vector<BendField> seen;
    for (int frame = 0; frame <= 2 * rate; ++frame) {
      const float t = static_cast<float>(frame) / static_cast<float>(rate);
      if (frame == 0)
        field.settle(transformAt(t), forcesAt(t), wetness);
      else
        field.step(1.0f / static_cast<float>(rate), transformAt(t), forcesAt(t), wetness);
      if (frame % (rate / 6) == 0) seen.push_back(field);
    }
    return seen;
  }
};

TEST(Forces, TakeTheSamePathAtEveryFrameRate) {
  const Storm storm;
  const auto slow = storm.watched(30), middle = storm.watched(60), fast = storm.watched(144);
  // Against how far strands swing about where they rest.
  float most = 0, apartSlow = 0, apartFast = 0;
  for (std::size_t k = 1; k < middle.size(); ++k) {
    most = std::max(most, farthest(middle[k], middle[0]));
    apartSlow = std::max(apartSlow, farthest(slow[k], middle[k]));
    apartFast = std::max(apartFast, farthest(fast[k], middle[k]));
  }
  EXPECT_GT(most, 0.5f);
  EXPECT_LT(apartFast, 0.02f * most);
  EXPECT_LT(apartSlow, 0.02f * most);
}

TEST(Forces, AreTheSameBitsOnEveryPlatform) {
  const Storm storm;
  BendField field = storm.ball.field();
  field.setRest(storm.rests, {});
  for (int frame = 1; frame <= 90; ++frame) {
    const float t = static_cast<float>(frame) / 60.0f;
    const float x = 1.4f - 0.02f * static_cast<float>(frame);
    const Contact ball{Vec3(x + 0.02f, 0, 0), Vec3(x, 0, 0), 0.3f, 0.5f};
    field.step(1 / 60.0f, Storm::transformAt(t), Storm::forcesAt(t), storm.wetness, {&ball, 1});
  }
  Fnv1a hash;
  hash.addAll(field.bends());
  test::printOnEveryPlatform("bends in a storm", hash.value());
}

TEST(Forces, WithoutThemEverySwingIsSmallerThanTheOneBefore) {
  const FurBall ball;
  std::vector<float> wetness;
  for (std::size_t i = 0; i < ball.positions.size(); ++i) wetness.push_back(i % 2 ? 0.0f : 0.01f * static_cast<float>(i % 100));
  for (const float dt : {0.004f, 1 / 60.0f, 0.2f}) {
    BendField field = ball.field();
    BendForces forces = noForces();
    forces.wind.force = Vec3(1, 0.3f, 0);
    field.settle(kStill, forces, wetness);
    // x^2 + (x' / omega)^2 of a damped spring falls; what is seen of it are the tops of x.
    std::vector<float> last(ball.positions.size(), kMaxBend), highest(ball.positions.size(), kMaxBend), before = highest;
    std::vector<Vec3> lean(ball.positions.size());
    for (std::size_t i = 0; i < lean.size(); ++i) {
      lean[i] = field.bends()[i];
      last[i] = highest[i] = before[i] = glm::length(lean[i]);
    }
    for (float t = 0; t < 8; t += dt) {
      field.step(dt, kStill, noForces(), wetness);
      for (std::size_t i = 0; i < lean.size(); ++i) {
        const float now = glm::length(Vec3(field.bends()[i]));
        ASSERT_LE(now, highest[i] * 1.0001f + 1e-6f) << dt << ' ' << t;
        // On the way back from a top: nothing that comes is higher than that.
        if (now < last[i] && last[i] > before[i]) highest[i] = last[i];
        before[i] = last[i];
        last[i] = now;
      }
    }
    EXPECT_TRUE(field.atRest());
    EXPECT_EQ(largest(field), 0);
  }
}

TEST(Forces, ThatAreShownAreThoseThatMoveTheFur) {
  // Thrown: it is faster and faster. Another that stands still is pulled by what is shown of the first.
  BendField thrown = strandAt(Vec3(0, 1, 0), Vec3(0, 1, 0)), pulled = thrown;
  thrown.showForces(true);
  BendForces forces = noForces(), pulling = noForces();
  constexpr float kStep = 1 / 240.0f;
  for (const float wet : {0.0f, 1.0f}) {
    const std::vector<float> wetness{wet};
    for (BendField* field : {&thrown, &pulled}) field->settle(kStill, noForces(), wetness);
    for (int k = 1; k <= 40; ++k) {
      const float t = kStep * static_cast<float>(k);
      thrown.step(kStep, glm::translate(kStill, Vec3(3 * t * t, 0, 0)), forces, wetness);
      // Gravity pulls a coat of this weight by just what it is, and a soaked one more.
      pulling.gravity = Vec3(thrown.forces()[0]) / (1 + 1.5f * wet);
      pulled.step(kStep, kStill, pulling, wetness);
    }
    ASSERT_LT(thrown.bends()[0].x, -0.1f);
    // A push at a step's start is half a step ahead of a pull all through it.
    EXPECT_NEAR(thrown.bends()[0].x, pulled.bends()[0].x, 0.06f * largest(thrown)) << wet;
  }
}

TEST(Forces, NeverBendAStrandIntoTheBody) {
  // A torus is hollow inside: the likeliest place for it.
  const geometry::Mesh torus = geometry::makeTorus();
  BendField field;
  field.reset(torus.positions, torus.normals);
  const float ring = 1 - 0.36f, tube = 0.36f, longest = 0.4f;
  Random random(5);
  for (int k = 0; k < 200; ++k) {
    BendForces forces = windy();
    forces.wind.force = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    forces.stiffness = 0;
    forces.furLength = longest;
    const Vec3 at(random.uniform(-1, 1), random.uniform(-0.5f, 0.5f), random.uniform(-1, 1));
    const Contact ball{at, at, 0.3f, 1};
    field.step(0.1f, glm::translate(kStill, Vec3(random.uniform(-0.5f, 0.5f), 0, 0)), forces, {}, {&ball, 1});
    for (std::size_t i = 0; i < torus.positions.size(); ++i) {
      // As shells draw it: no longer than 0.65 of a hollow's radius.
      const Vec3& at = torus.positions[i];
      const float away = std::sqrt(at.x * at.x + at.z * at.z), inward = (ring - away) / tube;
      const float length = inward > 0 ? std::min(longest, 0.65f * away / inward) : longest;
      for (const float h : {0.1f, 0.5f, 1.0f}) {
        const Vec3 p = strandPoint(torus.positions[i], torus.normals[i], field.bends()[i], length, h);
        const float around = std::sqrt(p.x * p.x + p.z * p.z) - ring;
        // The mesh's own corners lie on the torus to rounding.
        ASSERT_GE(std::sqrt(around * around + p.y * p.y), tube - 1e-5f) << k << ' ' << i;
      }
    }
  }
}

TEST(Forces, SleepingVerticesWakeForWhateverChanges) {
  const FurBall ball;
  BendField field = ball.field();
  const std::vector<float> dry, wet(ball.positions.size(), 1.0f);
  const auto changes = [&](auto change) {
    for (int k = 0; k < 600; ++k) field.step(1 / 60.0f, kStill, windy(), dry);
    EXPECT_TRUE(field.atRest());
    const BendField before = field;
    change();
    return farthest(field, before);
  };
  BendForces other = windy();
  other.stiffness = 0.9f;
  EXPECT_EQ(changes([&] { field.step(1 / 60.0f, kStill, windy(), dry); }), 0);
  EXPECT_GT(changes([&] { field.step(1 / 60.0f, kStill, other, dry); }), 1e-3f);
  EXPECT_GT(changes([&] { field.step(1 / 60.0f, kStill, windy(), wet); }), 1e-3f);
  EXPECT_GT(changes([&] { field.step(1 / 60.0f, glm::translate(kStill, Vec3(0.1f, 0, 0)), windy(), dry); }), 1e-3f);
  EXPECT_GT(changes([&] {
              field.setRest(std::vector<Vec3>(ball.positions.size(), Vec3(0.3f, 0, 0)), {});
              field.step(1 / 60.0f, kStill, windy(), dry);
            }),
            1e-3f);
}

}  // namespace
}  // namespace fur::dynamics
