#include "app/stages/Gaze.h"

#include <gtest/gtest.h>

#include "core/Random.h"

namespace fur::app {
namespace {

constexpr float kStep = 1 / 60.0f;

// A head on a neck that only the gaze turns.
struct Neck {
  Gaze gaze;
  Vec2 head{0}, eyes{0};
  float headSpeed = 0, eyeSpeed = 0;

  void look(const std::optional<Vec3>& at, float share = 1, float dt = kStep) {
    Gaze::Frame frame;
    frame.neck = glm::mat3_cast(gaze.neckTurn());
    frame.head = frame.neck * glm::mat3_cast(gaze.headTurn());
    gaze.update(dt, at, share, frame);
    headSpeed = glm::length(gaze.headAngles() - head) / dt;
    eyeSpeed = glm::length(gaze.eyeAngles() - eyes) / dt;
    head = gaze.headAngles();
    eyes = gaze.eyeAngles();
  }
  Vec3 line() const { return glm::mat3_cast(gaze.neckTurn() * gaze.headTurn() * gaze.eyeTurn()) * Vec3(0, 0, 1); }
};

TEST(Gaze, ComesToWhatItLooksAt) {
  for (const Vec3& at : {Vec3(1, 0.3f, 2), Vec3(-1.5f, 0.5f, 1.2f), Vec3(0.1f, -0.6f, 2), Vec3(0, 0, 5), Vec3(2, 0.2f, 0.9f)}) {
    Neck neck;
    for (int i = 0; i < 240; ++i) neck.look(at);
    EXPECT_GT(glm::dot(neck.line(), glm::normalize(at)), 0.9995f) << at.x << ' ' << at.y;
    EXPECT_FALSE(neck.gaze.moving());
  }
}

TEST(Gaze, StaysInItsLimitsAndSpeedsWhateverIsShownToIt) {
  Neck neck;
  Random random(3);
  std::optional<Vec3> at;
  for (int i = 0; i < 6000; ++i) {
    if (random.uniform() < 0.05f) at = Vec3(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
    if (random.uniform() < 0.01f) at = Vec3(0, random.uniform() < 0.5f ? 1e-30f : 1e30f, 0);
    if (random.uniform() < 0.01f) at.reset();
    neck.look(at, random.uniform() < 0.02f ? 0.3f : 1, random.uniform(0.002f, 0.1f));
    for (int c = 0; c < 2; ++c) {
      ASSERT_LE(std::abs(neck.head[c]), Gaze::kHeadLimit[c]);
      ASSERT_LE(std::abs(neck.eyes[c]), Gaze::kEyeLimit[c] + 1e-6f);
    }
    ASSERT_LE(neck.headSpeed, 1.001f * Gaze::kHeadSpeed + 1e-3f);
    ASSERT_LE(neck.eyeSpeed, 1.001f * Gaze::kEyeSpeed + 1e-3f);
  }
}

TEST(Gaze, DoesNotTryToSeeWhatIsRightBehindIt) {
  Neck neck;
  for (int i = 0; i < 120; ++i) neck.look(Vec3(i % 2 ? 0.1f : -0.1f, 0, -2));
  EXPECT_LT(glm::length(neck.head), 0.01f);
}

TEST(Gaze, LooksAheadWhereThereIsNothing) {
  Neck neck;
  for (int i = 0; i < 120; ++i) neck.look(Vec3(2, 0, 2));
  EXPECT_GT(neck.head.x, 0.4f);
  for (int i = 0; i < 240; ++i) neck.look(std::nullopt);
  EXPECT_EQ(neck.head, Vec2(0));
  EXPECT_EQ(neck.eyes, Vec2(0));
}

// A spring in steps of 1/120 s against one in steps of a twentieth of that.
TEST(Gaze, HardlyMindsTheFrameRate) {
  Neck slow, quick;
  const Vec3 at(1.2f, 0.3f, 2);
  for (int i = 0; i < 30; ++i) slow.look(at, 1, 1 / 30.0f);
  for (int i = 0; i < 200; ++i) quick.look(at, 1, 1 / 200.0f);
  EXPECT_LT(glm::distance(slow.head, quick.head), 0.02f);
}

}  // namespace
}  // namespace fur::app
