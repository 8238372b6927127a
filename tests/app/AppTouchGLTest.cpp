// What a person does with a hand and a ball, without a page.
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct Paddock : test::Room {
  Paddock() : Room(160, {{"layers", "8"}, {"tileSize", "64"}, {"breath", "0"}}) {}

  void pointer(PointerPhase phase, Vec2 at) {
    app.pointer({.phase = phase, .position = at, .buttons = phase == PointerPhase::Up ? 0 : 1});
  }
  void drag(Vec2 from, Vec2 to) {
    pointer(PointerPhase::Down, from);
    for (int i = 1; i <= 20; ++i) {
      pointer(PointerPhase::Move, glm::mix(from, to, static_cast<float>(i) / 20));
      app.tick(1 / 60.0f);
    }
  }
  int settle() {
    int ticks = 0;
    while (ticks < 3000 && app.active()) app.tick(1 / 60.0f), ++ticks;
    return ticks;
  }
  float apartFrom(const std::vector<Vec4>& bends) const {
    float most = 0;
    for (std::size_t i = 0; i < bends.size(); ++i) most = std::max(most, glm::length(app.bends()[i] - bends[i]));
    return most;
  }
  std::vector<Vec4> bends() const { return {app.bends().begin(), app.bends().end()}; }
};

TEST(AppTouch, AHandLaysTheFurOverAndItComesBackWithoutAnUndoStep) {
  Paddock paddock;
  const auto before = paddock.bends();
  const bool undoable = paddock.app.canUndo();
  const auto combed = paddock.app.groomHash();
  paddock.app.setTool(Tool::Pet);
  paddock.drag({60, 80}, {100, 80});
  EXPECT_GT(paddock.apartFrom(before), 1);
  paddock.pointer(PointerPhase::Up, {100, 80});
  EXPECT_TRUE(paddock.app.active());
  paddock.settle();
  EXPECT_FALSE(paddock.app.active());
  EXPECT_EQ(paddock.apartFrom(before), 0);
  EXPECT_EQ(paddock.app.canUndo(), undoable);
  EXPECT_EQ(paddock.app.groomHash(), combed);
}

TEST(AppTouch, AModelThatIsThrownOrSpunLeavesItsFurBehind) {
  Paddock paddock;
  paddock.settle();
  const auto before = paddock.bends();
  paddock.app.setTool(Tool::Grab);
  paddock.drag({80, 80}, {120, 80});
  EXPECT_GT(paddock.apartFrom(before), 0.2f);
  paddock.pointer(PointerPhase::Up, {120, 80});
  // Swings on when it is let go, and comes to rest.
  EXPECT_TRUE(paddock.app.active());
  paddock.settle();
  EXPECT_EQ(paddock.apartFrom(before), 0);
  paddock.app.pointer({.phase = PointerPhase::Down, .position = {80, 80}, .buttons = 1, .shift = true});
  for (int i = 1; i <= 20; ++i) {
    paddock.app.pointer({.phase = PointerPhase::Move, .position = {80 + 3.0f * static_cast<float>(i), 80}, .buttons = 1, .shift = true});
    paddock.app.tick(1 / 60.0f);
  }
  EXPECT_GT(paddock.apartFrom(before), 0.2f);
}

TEST(AppTouch, TheBendOfThePolynomialIsAnotherPictureOfTheSameFur) {
  Paddock paddock;
  paddock.app.setField("wind", "1");
  paddock.app.setField("gust", "0");
  paddock.app.setField("turbulence", "0");
  paddock.app.settle();
  const auto bends = paddock.bends();
  const auto arc = paddock.stage.draw(paddock.app);
  paddock.app.setField("bendCurve", "polynomial");
  paddock.app.settle();
  EXPECT_EQ(paddock.apartFrom(bends), 0);
  EXPECT_GT(paddock.stage.draw(paddock.app).differingShare(arc, 16), 0.01f);
}

TEST(AppTouch, SoakedFurStaysCombedForLonger) {
  Paddock dry, soaked;
  soaked.app.setField("dryRate", "0");
  soaked.app.setWetness(1);
  for (Paddock* paddock : {&dry, &soaked}) {
    paddock->settle();
    paddock->app.setTool(Tool::Pet);
    paddock->drag({60, 80}, {100, 80});
    paddock->pointer(PointerPhase::Up, {100, 80});
  }
  EXPECT_GT(soaked.settle(), 4 * dry.settle());
}

TEST(AppTouch, TheBallComesWithItsToolIsPressedInAndLeavesNothingBehind) {
  Paddock paddock;
  const auto before = paddock.bends();
  EXPECT_FALSE(paddock.app.ball());
  paddock.app.setTool(Tool::Ball);
  ASSERT_TRUE(paddock.app.ball());
  // Where it waits it touches nothing.
  paddock.settle();
  EXPECT_EQ(paddock.apartFrom(before), 0);
  paddock.drag({60, 80}, {90, 80});
  paddock.pointer(PointerPhase::Up, {90, 80});
  paddock.settle();
  const Ball ball = paddock.app.ball().value();
  EXPECT_NEAR(glm::length(ball.centre), 1 + ball.radius + 0.25f * paddock.app.settings().furLength, 0.02f);
  EXPECT_GT(paddock.apartFrom(before), 0.8f);
  EXPECT_FALSE(paddock.app.active());
  // Beside the model it is dragged on.
  paddock.drag({90, 80}, {150, 10});
  paddock.settle();
  EXPECT_GT(glm::length(paddock.app.ball()->centre), 1 + ball.radius + paddock.app.settings().furLength);
  EXPECT_EQ(paddock.apartFrom(before), 0);
  paddock.app.setTool(Tool::None);
  EXPECT_FALSE(paddock.app.ball());
}

TEST(AppTouch, TheBallIsInThePicture) {
  Paddock paddock;
  paddock.app.setTool(Tool::Ball);
  paddock.drag({80, 80}, {80, 80});
  paddock.settle();
  const auto with = paddock.stage.draw(paddock.app);
  paddock.app.setTool(Tool::None);
  const auto without = paddock.stage.draw(paddock.app);
  const auto redder = [&](int x, int y) {
    return (with.at(x, y)[0] - with.at(x, y)[1]) - (without.at(x, y)[0] - without.at(x, y)[1]);
  };
  EXPECT_GT(redder(80, 80), 40);
}

TEST(AppTouch, TheBallCastsAShadowOnTheFur) {
  Paddock paddock;
  for (const char* shadows : {"depth", "layers"}) {
    paddock.app.setField("shadows", shadows);
    paddock.app.setTool(Tool::Ball);
    paddock.drag({80, 80}, {80, 80});
    paddock.settle();
    const Ball ball = paddock.app.ball().value();
    const auto with = paddock.stage.draw(paddock.app);
    paddock.app.setTool(Tool::None);
    paddock.settle();
    const auto without = paddock.stage.draw(paddock.app);
    // Beside the ball, away from the light, which comes from above on the left.
    int darker = 0, brighter = 0;
    for (int y = 80; y < 120; ++y)
      for (int x = 80; x < 120; ++x) {
        const int change = with.at(x, y)[2] - without.at(x, y)[2];
        darker += change < -25;
        brighter += change > 25;
      }
    EXPECT_GT(darker, 3 * brighter + 100) << shadows << ' ' << ball.radius;
  }
}

TEST(AppTouch, IdleFurBreathesForAWhileAndNotForThoseWhoAskedForLessMotion) {
  Paddock paddock;
  const auto before = paddock.bends();
  paddock.app.setField("breath", "1");
  EXPECT_TRUE(paddock.app.active());
  float most = 0;
  for (int i = 0; i < 120; ++i) {
    paddock.app.tick(1 / 60.0f);
    most = std::max(most, paddock.apartFrom(before));
  }
  EXPECT_GT(most, 0.02f);
  EXPECT_LT(most, 0.3f);
  EXPECT_LT(paddock.settle(), 900);
  EXPECT_FALSE(paddock.app.active());
  EXPECT_EQ(paddock.apartFrom(before), 0);
  paddock.pointer(PointerPhase::Down, {1, 1});
  paddock.pointer(PointerPhase::Up, {1, 1});
  EXPECT_TRUE(paddock.app.active());
  paddock.app.setReducedMotion(true);
  paddock.settle();
  EXPECT_EQ(paddock.apartFrom(before), 0);
  EXPECT_FALSE(paddock.app.active());
}

}  // namespace
}  // namespace fur::app
