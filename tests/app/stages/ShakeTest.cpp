// A soaked animal that shakes itself: where its water goes.
#include <gtest/gtest.h>

#include "app/stages/Animal.h"
#include "app/stages/MotionStage.h"
#include "app/stages/WaterStage.h"

namespace fur::app {
namespace {

struct Soaked : test::Zoo {
  GroomStage groom;
  WaterStage water;
  MotionStage motion;

  Soaked() {
    reducedMotion = true;  // only what it is told
    settings.dryRate = 0.002f;
    groom.update({shape, settings});
    water.beginStroke({Command::Soak, 0, 1, 0.05f, Vec3(0, 0, 3)});
    water.strokeAt(shape, {0, Vec3(1, 0, 0), 0});
    water.endStroke();
    updateWater(0);
  }
  void updateWater(float seconds) {
    WaterStage::Inputs in{.shape = shape, .groom = groom, .settings = settings, .coatLength = settings.furLength};
    in.shaking = behaviour.shaking();
    in.bySkin = behaviour.shaking() > 0;
    in.seconds = seconds;
    water.update(in);
  }
  void updateMotion(float seconds) {
    MotionStage::Inputs in{.shape = shape, .groom = groom, .water = water, .settings = settings, .coatLength = settings.furLength};
    in.seconds = seconds;
    in.idleTime = 1000;
    motion.update(in);
  }
  double imbalance() const {
    const wet::Accounts a = water.water().accounts();
    return a.painted + a.rained - (a.held + a.film + a.drops + a.hair + a.dripped + a.evaporated + a.removed);
  }
};

TEST(AnimalsShake, ThrowsWaterOffAndTheAccountsBalance) {
  Soaked zoo;
  for (int i = 0; i < 20; ++i) zoo.step(1 / 60.0f), zoo.updateWater(1 / 60.0f);
  const wet::Accounts before = zoo.water.water().accounts();
  ASSERT_GT(before.held, 1);
  ASSERT_TRUE(zoo.behaviour.act("shake"));
  std::size_t most = 0;
  for (int i = 0; i < 120; ++i) {
    zoo.step(1 / 60.0f);
    zoo.updateWater(1 / 60.0f);
    most = std::max(most, zoo.water.water().drops().size());
    // Sums of some ten thousand floats.
    ASSERT_NEAR(zoo.imbalance(), 0, 1e-3 * before.painted) << i;
  }
  const wet::Accounts after = zoo.water.water().accounts();
  EXPECT_GT(most, 40u);
  EXPECT_LT(after.held, 0.8 * before.held);
  EXPECT_GT(after.dripped + after.drops, before.dripped + before.drops + 0.1);
}

TEST(AnimalsShake, WaterFliesAsTheSkinMovesThatItLeaves) {
  Soaked zoo;
  zoo.behaviour.act("shake");
  int thrown = 0, along = 0;
  for (int i = 0; i < 80; ++i) {
    zoo.step(1 / 60.0f);
    const std::size_t before = zoo.water.water().drops().size();
    zoo.updateWater(1 / 60.0f);
    const ShapeStage::Before then = zoo.shape.before();
    if (zoo.behaviour.shaking() < 0.9f) continue;
    const auto drops = zoo.water.water().drops();
    for (std::size_t d = std::min(before, drops.size()); d < drops.size(); ++d) {
      if (drops[d].hangs() || drops[d].splash > 0) continue;
      // It has flown for one step.
      std::size_t nearest = 0;
      const auto& now = zoo.shape.skin()->positions;
      for (std::size_t v = 1; v < now.size(); ++v)
        if (glm::distance(now[v], drops[d].position) < glm::distance(now[nearest], drops[d].position)) nearest = v;
      const Vec3 moves = (now[nearest] - then.positions[nearest]) / then.seconds;
      ++thrown;
      along += glm::dot(moves, drops[d].velocity) > 0.5f * glm::length(moves) * glm::length(drops[d].velocity);
    }
  }
  EXPECT_GT(thrown, 30);
  // Drops that fall from where they hung come down whatever the skin does.
  EXPECT_GT(along, 0.7 * thrown);
}

TEST(AnimalsShake, WithoutMotionNothingIsThrown) {
  Soaked still;
  for (int i = 0; i < 30; ++i) {
    WaterStage::Inputs in{.shape = still.shape, .groom = still.groom, .settings = still.settings, .coatLength = still.settings.furLength};
    still.step(1 / 60.0f);
    in.shaking = 1;
    in.bySkin = true;
    in.seconds = 1 / 60.0f;
    still.water.update(in);
  }
  Soaked body;  // a model without such an animation throws it off all round
  for (int i = 0; i < 30; ++i) {
    WaterStage::Inputs in{.shape = body.shape, .groom = body.groom, .settings = body.settings, .coatLength = body.settings.furLength};
    body.step(1 / 60.0f);
    in.shaking = 1;
    in.seconds = 1 / 60.0f;
    body.water.update(in);
  }
  EXPECT_LT(still.water.water().accounts().dripped + still.water.water().accounts().drops, 0.5 * (body.water.water().accounts().dripped + body.water.water().accounts().drops));
}

TEST(AnimalsShake, TheFurSwingsWithIt) {
  Soaked zoo;
  zoo.updateMotion(1 / 60.0f);
  const std::vector<Vec4> rest(zoo.motion.bends().begin(), zoo.motion.bends().end());
  zoo.behaviour.act("shake");
  float most = 0;
  for (int i = 0; i < 60; ++i) {
    zoo.step(1 / 60.0f);
    zoo.updateMotion(1 / 60.0f);
    zoo.updateWater(1 / 60.0f);
    for (std::size_t v = 0; v < rest.size(); v += 7) most = std::max(most, glm::length(Vec3(zoo.motion.bends()[v]) - Vec3(rest[v])));
  }
  EXPECT_GT(most, 0.2f);
}

}  // namespace
}  // namespace fur::app
