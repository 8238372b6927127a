// Water that moves, and the tools for it.
#include <algorithm>

#include "app/commands/History.h"
#include "core/Random.h"
#include "render/Frame.h"
#include "tests/OnEveryPlatform.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct Basin {
  test::Stage stage{200, 200};
  App app;
  Basin() {
    stage.attach(app);
    app.loadPrimitive("sphere").value();
    app.setField("dryRate", "0");
    run(60);
  }
  ~Basin() { app.detach(false); }

  void run(int frames) {
    for (int i = 0; i < frames; ++i) app.tick(1 / 60.0f);
  }
  void settle() {
    for (int i = 0; i < 4000 && (i == 0 || app.active()); ++i) app.tick(1 / 60.0f);
  }
  void pointer(PointerPhase phase, Vec2 at, float pressure = 1) {
    app.pointer({.phase = phase, .kind = PointerKind::Pen, .position = at, .buttons = 1, .pressure = pressure});
  }
  void stroke(Vec2 from, Vec2 to, int steps = 8, float pressure = 1) {
    pointer(PointerPhase::Down, from, pressure);
    for (int i = 1; i <= steps; ++i) {
      pointer(PointerPhase::Move, glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps)), pressure);
      run(1);
    }
    pointer(PointerPhase::Up, to, pressure);
  }
};

TEST(AppWater, RunsWithTheClockAndComesToRest) {
  Basin basin;
  for (int i = 0; i < 6; ++i) basin.stroke({80, 80}, {120, 80});
  const auto wet = basin.app.wetnessHash();
  EXPECT_TRUE(basin.app.active());
  basin.run(30);
  EXPECT_NE(basin.app.wetnessHash(), wet);
  basin.settle();
  EXPECT_FALSE(basin.app.active());
  EXPECT_FALSE(basin.app.tick(1 / 60.0f));
}

// A look-up beside a border found dry fur where no droplet had met the gutter.
TEST(AppWater, SoaksTheGuttersOfTheChartsAsWell) {
  Basin basin;
  basin.app.setWetness(0.75f);
  int dry = 0, wet = 0;
  for (const Vec4& texel : basin.app.shownMask().texels) ++(texel.w == 0 ? dry : wet);
  EXPECT_EQ(dry, 0);
  EXPECT_GT(wet, 0);
}

TEST(AppWater, EveryStrokeOfEveryToolIsOneStepBack) {
  Basin basin;
  basin.app.setWetness(0.6f);
  for (const Tool tool : {Tool::Droplet, Tool::Dry, Tool::Rain, Tool::Hose, Tool::Towel, Tool::Dryer}) {
    basin.settle();
    const auto before = basin.app.wetnessHash();
    basin.app.setTool(tool);
    basin.stroke({90, 100}, {120, 110}, 60);
    const auto after = basin.app.wetnessHash();
    EXPECT_NE(after, before) << static_cast<int>(tool);
    EXPECT_TRUE(basin.app.undo());
    EXPECT_EQ(basin.app.wetnessHash(), before) << static_cast<int>(tool);
    EXPECT_TRUE(basin.app.redo());
    EXPECT_EQ(basin.app.wetnessHash(), after) << static_cast<int>(tool);
  }
}

TEST(AppWater, WhatHasRunOnIsTakenBackToo) {
  Basin basin;
  for (int i = 0; i < 3; ++i) basin.stroke({80, 80}, {120, 80});
  basin.run(240);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(basin.app.undo());
  EXPECT_EQ(basin.app.meanWetness(), 0);
  EXPECT_TRUE(basin.app.drops().empty());
  basin.run(60);
  EXPECT_EQ(basin.app.meanWetness(), 0);
}

TEST(AppWater, AHoseWetsDryFur) {
  Basin basin;
  basin.app.setTool(Tool::Hose);
  basin.stroke({95, 100}, {105, 100}, 60);
  basin.run(30);
  EXPECT_GT(basin.app.meanWetness(), 0.001f);
  EXPECT_GT(basin.app.water().accounts().film, 0);
}

TEST(AppWater, RainWetsWhatLiesUp) {
  Basin basin;
  basin.app.setField("rain", "1");
  basin.run(180);
  EXPECT_GT(basin.app.drops().size(), 20u);
  EXPECT_GT(basin.app.meanWetness(), 0.02f);
  basin.app.setField("rain", "0");
  basin.run(300);
  EXPECT_GT(basin.app.water().accounts().dripped, 0.05);  // past the model
}

// Beside it they would leave dark spots on the ground, round an animal that nobody has wetted.
TEST(AppWater, SprinkledDropsFallOnTheModelAndNotBesideIt) {
  Basin basin;
  basin.app.loadPrimitive("torus").value();  // with a hole in its middle, seen from above
  basin.app.sprinkle(60);
  basin.run(90);
  EXPECT_TRUE(basin.app.drops().empty()) << "all have come down";
  EXPECT_GT(basin.app.water().accounts().held, 0);
  EXPECT_EQ(basin.app.water().accounts().dripped, 0);
}

// An animal covers little of what holds all that it may do.
TEST(AppWater, SprinkledDropsFindASlenderModel) {
  const std::string blade = "v -1 0 -0.1\nv 1 0 -0.1\nv -1 0 0.1\nv 1 0 0.1\nf 1 3 4\nf 1 4 2\n";
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(blade.data());
  Basin basin;
  ASSERT_TRUE(basin.app.loadModel({bytes, bytes + blade.size()}, "blade.obj"));
  basin.app.sprinkle(60);
  basin.run(90);
  EXPECT_GT(basin.app.water().accounts().held, 0);
  EXPECT_EQ(basin.app.water().accounts().dripped, 0);
}

TEST(AppWater, ATowelTakesAndShakingThrowsOff) {
  Basin basin;
  basin.app.setWetness(0.9f);
  basin.run(2);
  const double soaked = basin.app.water().accounts().held;
  basin.app.setTool(Tool::Towel);
  basin.stroke({80, 100}, {120, 100});
  EXPECT_GT(basin.app.water().accounts().removed, 0.01);
  basin.app.shake();
  EXPECT_TRUE(basin.app.active());
  basin.run(120);
  EXPECT_LT(basin.app.water().accounts().held, 0.9 * soaked);
  EXPECT_GT(basin.app.water().accounts().dripped, 0.05);
}

// Between two frames of a slow machine most of it would be over, with the water still in the fur.
TEST(AppWater, AShakeThrowsOffAsMuchInLongFramesAsInShortOnes) {
  const auto heldAfter = [](int frames, float seconds) {
    Basin basin;
    basin.app.setWetness(0.9f);
    basin.run(2);
    basin.app.shake();
    for (int i = 0; i < frames; ++i) advanceFrame(basin.app, seconds, 1e9f);
    return basin.app.water().accounts().held;
  };
  EXPECT_DOUBLE_EQ(heldAfter(4, 0.5f), heldAfter(20, 0.1f));
}

TEST(AppWater, APenBringsWaterByItsPressure) {
  double brought[2];
  for (int k = 0; k < 2; ++k) {
    Basin basin;
    basin.stroke({90, 100}, {120, 110}, 8, k ? 1.0f : 0.3f);
    basin.run(2);
    brought[k] = basin.app.water().accounts().painted;
  }
  EXPECT_NEAR(brought[0] / brought[1], 0.3, 0.05);
}

TEST(AppWater, TheSpeedOfTheHandChangesNoStroke) {
  std::uint64_t hashes[2];
  for (int k = 0; k < 2; ++k) {
    Basin basin;
    basin.pointer(PointerPhase::Down, {80, 100});
    for (int i = 1; i <= (k ? 40 : 4); ++i) basin.pointer(PointerPhase::Move, {80 + i * (k ? 1 : 10), 100});
    basin.pointer(PointerPhase::Up, {120, 100});
    hashes[k] = basin.app.wetnessHash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(AppWater, ABrushThatIsHeldStillGoesOnByTheClock) {
  // Painted in a second and in two, with a hand that keeps still and one that trembles.
  double brought[2][2];
  std::size_t spots[2];
  for (const bool trembles : {false, true}) {
    Basin basin;
    basin.pointer(PointerPhase::Down, {100, 100});
    for (int second = 0; second < 2; ++second) {
      for (int i = 0; i < 60; ++i) {
        if (trembles) basin.pointer(PointerPhase::Move, {100 + i % 2, 100});
        basin.run(1);
      }
      brought[trembles][second] = basin.app.water().accounts().painted;
    }
    EXPECT_TRUE(basin.app.active());
    basin.pointer(PointerPhase::Up, {100, 100});
    const std::string strokes = basin.app.recordedStrokes();
    spots[trembles] = static_cast<std::size_t>(std::count(strokes.begin(), strokes.end(), ','));
  }
  EXPECT_GT(brought[0][0], 0);
  EXPECT_NEAR(brought[0][1] / brought[0][0], 2, 0.3);
  EXPECT_EQ(spots[0], spots[1]);
}

TEST(AppWater, HeldStillTheDryBrushAndTheTowelTakeMore) {
  for (const Tool tool : {Tool::Dry, Tool::Towel}) {
    Basin basin;
    basin.app.setWetness(0.8f);
    basin.settle();
    basin.app.setTool(tool);
    const auto at = basin.app.pick({100, 100}).value();
    const auto there = [&] { return basin.app.wetnessAt(at.x, at.y); };
    basin.pointer(PointerPhase::Down, {100, 100});
    const float once = there();
    basin.run(20);
    EXPECT_LT(there(), once - 0.1f) << static_cast<int>(tool);
    basin.pointer(PointerPhase::Up, {100, 100});
    const auto after = basin.app.wetnessHash();
    basin.settle();
    EXPECT_TRUE(basin.app.undo());
    EXPECT_NE(basin.app.wetnessHash(), after);
  }
}

TEST(AppWater, WhatWasHeldIsReplayedToTheSameWater) {
  Basin first, second;
  first.run(10);
  for (const Tool tool : {Tool::Droplet, Tool::Towel, Tool::Droplet, Tool::Dry}) {
    first.app.setTool(tool);
    first.pointer(PointerPhase::Down, {90, 100});
    first.run(33);
    first.pointer(PointerPhase::Move, {120, 100});
    first.run(21);
    first.pointer(PointerPhase::Up, {120, 100});
    first.run(5);
  }
  EXPECT_TRUE(second.app.replay(first.app.recordedStrokes()));
  EXPECT_EQ(second.app.wetnessHash(), first.app.wetnessHash());
}

TEST(AppWater, AJetOfTheHoseComesDownWhereItPoints) {
  Basin basin;
  basin.app.setTool(Tool::Hose);
  for (const Vec2 pixel : {Vec2(100, 100), Vec2(70, 90), Vec2(120, 130)}) {
    basin.app.setWetness(0);
    basin.pointer(PointerPhase::Down, pixel);
    basin.run(12);
    // The middle of what is wet before it has run far.
    Vec3 sum(0);
    float weight = 0;
    for (const auto& place : basin.app.water().texels()->places()) {
      const float held = basin.app.wetnessMask().texels()[place.texel].w * place.area;
      sum += held * place.position;
      weight += held;
    }
    ASSERT_GT(weight, 0);
    const render::Frame f = basin.app.frame();
    const Vec4 clip = render::clipFromWorld(f) * f.worldFromModel * Vec4(sum / weight, 1);
    const Vec2 at = (Vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * Vec2(200);
    EXPECT_LT(glm::length(at - pixel), 6) << at.x << ", " << at.y;
    basin.pointer(PointerPhase::Up, pixel);
    basin.run(60);
  }
}

TEST(AppWater, TheHoseIsOneJetThatIsSeenFromTheSide) {
  Basin basin;
  basin.app.setTool(Tool::Hose);
  basin.pointer(PointerPhase::Down, {100, 100});
  basin.run(30);
  const Vec3 eye = basin.app.frame().camera.eye;
  const wet::Drop* before = nullptr;
  int pieces = 0;
  for (const wet::Drop& drop : basin.app.drops()) {
    if (drop.jet <= 0 || drop.splash > 0) continue;
    if (before) {
      const Vec3 link = before->position - drop.position;
      EXPECT_NEAR(glm::length(link), glm::length(drop.velocity) * wet::Water::kStep, 0.1f * glm::length(link)) << pieces;
      EXPECT_GT(glm::dot(glm::normalize(link), glm::normalize(drop.velocity)), 0.99f) << pieces;
      EXPECT_LT(std::abs(glm::dot(glm::normalize(link), glm::normalize(eye - drop.position))), 0.93f) << pieces;
    }
    before = &drop;
    ++pieces;
  }
  EXPECT_GT(pieces, 8);
}

TEST(AppWater, FurThatStaysWetDriesOnlyByHand) {
  Basin basin;
  basin.app.setField("dryRate", "1");
  basin.app.setField("stayWet", "true");
  basin.app.setWetness(0.5f);
  basin.settle();
  EXPECT_FALSE(basin.app.active());
  EXPECT_NEAR(basin.app.meanWetness(), 0.5f, 0.01f);
  basin.app.setTool(Tool::Dryer);
  basin.stroke({90, 100}, {110, 100}, 60);
  EXPECT_LT(basin.app.meanWetness(), 0.499f);
  basin.app.setField("stayWet", "false");
  basin.run(120);
  EXPECT_EQ(basin.app.meanWetness(), 0);
}

TEST(AppWater, ByDefaultItIsWetForMinutesAndSeenToDry) {
  Basin basin;
  basin.app.setField("dryRate", "0.002");
  EXPECT_EQ(App().settings().dryRate, 0.002f);
  basin.stroke({80, 80}, {120, 80});
  const float stroke = basin.app.meanWetness();
  basin.run(3600);
  EXPECT_GT(basin.app.meanWetness(), 0.4f * stroke);
  basin.app.setWetness(1);
  basin.run(3600);
  EXPECT_LT(basin.app.meanWetness(), 0.97f);
  EXPECT_GT(basin.app.meanWetness(), 0.5f);
}

TEST(AppWater, LettersAreStampedWhereTheyLie) {
  Basin basin;
  // A bar on the left half of the picture.
  std::vector<std::uint8_t> bar(64 * 32);
  for (int i = 0; i < 64 * 32; ++i) bar[i] = i % 64 < 32 ? 255 : 0;
  basin.app.stamp(bar, 64, 32, {100, 100}, 80);
  const auto wetAt = [&](Vec2 pixel) {
    const auto at = basin.app.pick(pixel).value();
    return basin.app.wetnessAt(at.x, at.y);
  };
  EXPECT_GT(wetAt({75, 100}), 0.3f);
  EXPECT_EQ(wetAt({125, 100}), 0.0f);
  // It has run out a little, no further.
  basin.run(600);
  EXPECT_GT(wetAt({75, 100}), 0.25f);
  EXPECT_LT(wetAt({106, 100}), 0.1f);
  EXPECT_TRUE(basin.app.undo());
  EXPECT_EQ(basin.app.meanWetness(), 0);
}

TEST(AppWater, UndoOfAStrokeTakesItsPuddlesAlongAndLeavesThoseBeforeIt) {
  Basin basin;
  const auto onGround = [&] {
    double sum = 0;
    for (const float amount : basin.app.water().ground()) sum += amount;
    return sum;
  };
  basin.app.setTool(Tool::Droplet);
  basin.stroke({80, 80}, {120, 80});
  basin.app.setTool(Tool::Hose);
  basin.stroke({95, 95}, {105, 105}, 60);
  basin.run(240);
  const double before = onGround();
  EXPECT_GT(before, 0);
  basin.stroke({95, 95}, {105, 105}, 60);
  const double after = onGround();
  EXPECT_GT(after, before);
  basin.run(240);
  EXPECT_GT(onGround(), after);  // as it drips on
  EXPECT_TRUE(basin.app.undo());
  EXPECT_EQ(onGround(), before);
  EXPECT_TRUE(basin.app.restoreHistory(basin.app.saveHistory(false)));
  EXPECT_TRUE(basin.app.redo());
  EXPECT_EQ(onGround(), after);
  EXPECT_TRUE(basin.app.undo());
  EXPECT_TRUE(basin.app.undo());
  EXPECT_EQ(onGround(), 0);
  EXPECT_GT(basin.app.meanWetness(), 0);  // the first stroke
}

TEST(AppWater, RecordedStrokesGiveTheSameWaterAgain) {
  Basin first, second;
  first.stroke({80, 90}, {120, 110});
  first.run(30);
  first.app.setField("brushRadius", "0.1");
  first.stroke({110, 90}, {90, 120});
  first.app.setTool(Tool::Towel);
  first.pointer(PointerPhase::Down, {90, 90});
  first.pointer(PointerPhase::Move, {110, 110});
  first.pointer(PointerPhase::Up, {110, 110});
  const std::string strokes = first.app.recordedStrokes();
  EXPECT_LT(strokes.size(), 4000u);
  EXPECT_TRUE(second.app.replay(strokes));
  EXPECT_EQ(second.app.wetnessHash(), first.app.wetnessHash());
  EXPECT_TRUE(second.app.undo());
  for (const char* text : {"", "{}", "[[0]]", "[[0,0.1,0.1,0.1,0,99999999,0,0,1]]", "[[0,0.1,0.1,0.1,0,1,-0.5,0,1]]"})
    EXPECT_FALSE(second.app.replay(text)) << text;
}

TEST(AppWater, ASessionOfAllToolsIsReplayedToTheSameWater) {
  Basin first, second;
  App& app = first.app;
  app.setField("dryRate", "0.05");
  second.app.setField("dryRate", "0.05");
  std::vector<std::uint8_t> bar(32 * 16, 255);
  app.stamp(bar, 32, 16, {100, 100}, 40);
  for (const Tool tool : {Tool::Hose, Tool::Droplet, Tool::Rain, Tool::Dryer, Tool::Towel}) {
    app.setTool(tool);
    first.stroke({85, 95}, {120, 110}, 20, 0.8f);
    first.run(7);
  }
  app.shake();
  first.run(40);
  EXPECT_TRUE(app.undo());
  app.setTool(Tool::Hose);
  EXPECT_TRUE(app.key({" "}));
  first.run(60);
  app.splashAt(0.4f, 0.3f, 0.05f, 0.9f);
  first.run(5);
  app.setWetness(0.7f);
  app.dry(2);
  const std::string strokes = app.recordedStrokes();
  EXPECT_LT(strokes.size(), 20000u);
  EXPECT_TRUE(second.app.replay(strokes));
  EXPECT_EQ(second.app.wetnessHash(), app.wetnessHash());
  EXPECT_EQ(second.app.water().hash(second.app.wetnessMask()), app.water().hash(app.wetnessMask()));
  EXPECT_EQ(second.app.recordedStrokes(), strokes);
}

// As tests/web/page.test.mjs replays it, which compares what both give.
TEST(AppWater, ARecordedSessionHasTheSameHashOnEveryPlatform) {
  App app;
  app.loadPrimitive("sphere").value();
  app.setField("dryRate", "0.02");
  app.setField("lie", "0");
  EXPECT_TRUE(app.replay(
      "[[0,0.2,0.6,0.05,0,0,3,0,100,0.3,0.3,1],[3,0.2,0.8,0.05,0,1,3,5,300,0.3,0.3,1,40,310,0.3,0.3,1,60,310,0.3,0.3,0],"
      "[2,0.2,0.8,0.05,0,0,3,70,300,0.3,0.3,1,110,300,0.3,0.3,0],[100,0.05,0.8,0.05,0,0,3,120,200,0.3,0.3,1,120,220,0.3,0.3,1],"
      "[4,0.2,0.5,0.05,0,0,3,130,310,0.3,0.3,1],[104,0,0,0.05,0,0,0,135,0,0,0,1],[5,0.2,0.8,0.05,0,0,3,150,300,0.2,0.2,1,170,300,0.2,0.2,0],"
      "[105,0,0,0.05,0,0,0,171,0,0,0,1],[0,0.1,0.6,0.05,0,0,3,200,120,0.3,0.3,1]]"));
  test::printOnEveryPlatform("a recorded session", app.wetnessHash());
  EXPECT_GT(app.meanWetness(), 0.01f);
}

TEST(AppWater, KeysMoveTheCursorOverTheModelAndSpaceWetsThere) {
  Basin basin;
  App& app = basin.app;
  const Vec2 middle = app.cursor();
  const float yaw = app.camera().yaw;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(app.key({"ArrowRight", true}));
  EXPECT_GT(app.cursor().x, middle.x + 10);
  EXPECT_EQ(app.camera().yaw, yaw);
  EXPECT_TRUE(app.key({"ArrowRight"}));  // without shift the view turns
  EXPECT_NE(app.camera().yaw, yaw);
  app.resetCamera();
  basin.run(120);
  EXPECT_TRUE(app.key({" "}));
  const auto wetAt = [&](Vec2 pixel) {
    const auto at = app.pick(pixel).value();
    return app.wetnessAt(at.x, at.y);
  };
  EXPECT_GT(app.meanWetness(), 0);
  EXPECT_EQ(wetAt(middle - Vec2(30, 0)), 0);
  for (int i = 0; i < 60; ++i) app.key({"ArrowRight", true});
  EXPECT_TRUE(app.pick(app.cursor()));  // it stays on the model
  app.setCameraControls(false);
  const Vec2 edge = app.cursor();
  EXPECT_TRUE(app.key({"ArrowLeft"}));  // nobody else wants it
  EXPECT_LT(app.cursor().x, edge.x);
}

TEST(AppWater, SpaceHoldsRainHoseAndDryerForAMoment) {
  Basin basin;
  basin.app.setWetness(0.6f);
  basin.settle();
  for (const Tool tool : {Tool::Rain, Tool::Hose, Tool::Dryer}) {
    const auto before = basin.app.wetnessHash();
    basin.app.setTool(tool);
    EXPECT_TRUE(basin.app.key({" "}));
    EXPECT_TRUE(basin.app.active());
    basin.run(60);
    const auto after = basin.app.wetnessHash();
    EXPECT_NE(after, before) << static_cast<int>(tool);
    basin.run(240);
    basin.settle();
    EXPECT_TRUE(basin.app.undo()) << static_cast<int>(tool);
    basin.settle();
  }
}

TEST(AppWater, TheBrushShowsItsFootprintOnTheSkin) {
  Basin basin;
  App& app = basin.app;
  const Vec2 middle(100, 100);
  const auto sizeOf = [&](Vec2 at) {
    Vec2 low(1e9f), high(-1e9f);
    for (const Vec2& point : app.brushRing(at)) low = glm::min(low, point), high = glm::max(high, point);
    return high - low;
  };
  app.setField("brushRadius", "0.1");
  const Vec2 small = sizeOf(middle);
  app.setField("brushRadius", "0.2");
  const Vec2 large = sizeOf(middle);
  EXPECT_NEAR(large.x / small.x, 2, 0.15);  // of a ball: nearer rims look larger
  EXPECT_NEAR(small.x, small.y, 0.1f * small.x);
  // Seen at a slant it is narrow.
  float rim = 100;
  while (app.pick({rim + 1, 100})) rim += 1;
  EXPECT_LT(sizeOf({rim - 8, 100}).x, 0.8f * sizeOf({rim - 8, 100}).y);
  EXPECT_TRUE(app.brushRing({2, 2}).empty());
  app.setTool(Tool::Grab);
  EXPECT_TRUE(app.brushRing(middle).empty());
}

TEST(AppWater, GoesOnInAnotherProgramAsIfNothingHadHappened) {
  Basin basin, other;
  basin.app.setWetness(1);
  basin.run(300);
  const wet::Accounts before = basin.app.water().accounts();
  ASSERT_FALSE(basin.app.wetnessMask().film().empty());
  ASSERT_GT(basin.app.drops().size(), 0u);
  ASSERT_GT(before.dripped, 0);
  other.app.restoreWater(basin.app.saveWater()).value();
  EXPECT_EQ(other.app.recordedStrokes(), basin.app.recordedStrokes());
  for (Basin* one : {&basin, &other}) one->run(120);
  const auto &mine = basin.app.water(), &theirs = other.app.water();
  EXPECT_EQ(theirs.hash(other.app.wetnessMask()), mine.hash(basin.app.wetnessMask()));
  EXPECT_NEAR(theirs.accounts().painted, before.painted, 1e-9);
  EXPECT_GT(theirs.accounts().dripped, before.dripped);
}

TEST(AppWater, OfBytesThatAreNotItsOwnNothingIsTaken) {
  Basin basin;
  basin.stroke({95, 140}, {105, 140});
  const auto before = basin.app.wetnessHash();
  std::vector<std::uint8_t> bytes = basin.app.saveWater();
  bytes.pop_back();
  EXPECT_FALSE(basin.app.restoreWater(bytes));
  EXPECT_FALSE(basin.app.restoreWater({}));
  EXPECT_EQ(basin.app.wetnessHash(), before);
}

TEST(AppWater, IsTheSameInSmallStepsOfTimeAndLarge) {
  std::uint64_t hashes[2];
  for (const int every : {1, 4}) {
    Basin basin;
    basin.app.setWetness(1);
    for (int i = 0; i < 120; i += every) basin.app.tick(static_cast<float>(every) / 60);
    hashes[every > 1] = basin.app.water().hash(basin.app.wetnessMask());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

// What a frame brings to the GPU beside the water: blocks of numbers, and where every vertex bends.
TEST(AppWater, OnlyWhatHasChangedGoesToTheGpu) {
  Basin basin;
  basin.settle();
  const auto bytes = [&] {
    EXPECT_TRUE(basin.app.draw());
    return static_cast<long>(basin.app.stats().uploadedBytes);
  };
  // Which patches of the coat are wet is brought there as well when that changes.
  basin.app.splashPixel({100, 100}, 0.04f, 0.3f);
  bytes();
  const long still = bytes();
  const long mask = 16l * basin.app.wetnessMask().size() * basin.app.wetnessMask().size();
  basin.app.splashPixel({100, 100}, 0.04f, 0.3f);
  const long splash = bytes() - still;
  EXPECT_GT(splash, 0);
  // Fur lies down as far as water shows in means, 0.3 of the model round it: a twentieth of the skin, in rectangles.
  EXPECT_LT(splash, mask / 10);
  // A ground that is wet but does not change goes there once.
  basin.app.setWetness(1);
  basin.settle();
  EXPECT_GE(bytes() - still, mask + wet::kGroundCells * wet::kGroundCells);
  EXPECT_LE(bytes() - still, static_cast<long>(basin.app.drops().size() * sizeof(wet::Drop)));
  EXPECT_GT(basin.app.water().accounts().dripped, 0);
}

TEST(AppWater, SoakedFurHasNoDrySpotAndLocksOfSeveralSizes) {
  Basin basin;
  basin.app.setWetness(0.8f);
  basin.run(2);
  float least = 1, smallest = 1, largest = 0;
  for (const auto& place : basin.app.water().texels()->places()) {
    const Vec4& texel = basin.app.wetnessMask().texels()[place.texel];
    least = std::min(least, texel.w);
    smallest = std::min(smallest, texel.z);
    largest = std::max(largest, texel.z);
  }
  EXPECT_GT(least, 0.7f);
  EXPECT_GT(largest, 1.4f * smallest);
}

TEST(History, TakesTenThousandStrokesBackAndDoesThemAgain) {
  constexpr int kStrokes = 10000;
  History history;
  wet::WetnessMask mask(32);  // every step is hashed
  Random random(9);
  std::vector<std::uint64_t> hashes{mask.hash()};
  const auto hash = [&mask] {
    std::uint64_t sum = mask.hash();
    for (const float film : mask.film())
      if (film > 0) sum = sum * 31 + static_cast<std::uint64_t>(film * 1e6f);
    return sum;
  };
  hashes[0] = hash();
  for (int i = 0; i < kStrokes; ++i) {
    const MaskImage before{mask.texels(), mask.film()};
    const wet::Droplet at{Vec2(random.uniform(), random.uniform()), random.uniform(0.01f, 0.04f), random.uniform(0.1f, 1.0f)};
    if (i % 3) mask.addDroplet(at);
    else mask.dryAt(at);
    if (auto step = maskStep(before, mask)) {
      history.push(std::move(*step));
      hashes.push_back(hash());
    }
  }
  std::size_t at = hashes.size() - 1;
  while (const Step* step = history.undo()) {
    apply(std::get<MaskStep>(*step), true, mask);
    ASSERT_EQ(hash(), hashes[--at]);
  }
  EXPECT_EQ(at, 0u);
  while (const Step* step = history.redo()) {
    apply(std::get<MaskStep>(*step), false, mask);
    ASSERT_EQ(hash(), hashes[++at]);
  }
  EXPECT_EQ(at, hashes.size() - 1);
}

TEST(History, AStrokeOnADryCoatKeepsNothingOfWhatWasAndTakesBackWaterThatRanOn) {
  wet::WetnessMask mask(32);
  const MaskImage before{mask.texels(), mask.film()};
  const std::uint64_t dry = mask.hash();
  mask.addDroplet({Vec2(0.3f), 0.1f, 0.8f});
  const std::uint64_t wet = mask.hash();
  const auto step = maskStep(before, mask);
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->before.texels.empty());
  EXPECT_FALSE(step->after.texels.empty());
  mask.addDroplet({Vec2(0.8f), 0.1f, 0.5f});  // beside the stroke's rectangle
  apply(*step, true, mask);
  EXPECT_EQ(mask.hash(), dry);
  apply(*step, false, mask);
  EXPECT_EQ(mask.hash(), wet);
}

}  // namespace
}  // namespace fur::app
