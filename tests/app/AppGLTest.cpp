// What a person does, without a page: paint, drag, undo, wait.
#include "app/view/QualityGovernor.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct Desk {
  test::Stage stage{200, 200};
  App app;
  Desk() {
    stage.attach(app);
    app.setField("dryRate", "0");
    settle();
  }
  ~Desk() { app.detach(false); }

  void settle() {
    for (int i = 0; i < 3000 && (i == 0 || app.active()); ++i) app.tick(1 / 60.0f);
  }
  void drag(Vec2 from, Vec2 to, PointerEvent event = {}) {
    event.phase = PointerPhase::Down;
    event.position = from;
    if (!event.buttons) event.buttons = 1;
    app.pointer(event);
    event.phase = PointerPhase::Move;
    for (int i = 1; i <= 8; ++i) {
      event.position = glm::mix(from, to, static_cast<float>(i) / 8);
      app.pointer(event);
      app.tick(1 / 60.0f);
    }
    event.phase = PointerPhase::Up;
    event.buttons = 0;
    app.pointer(event);
  }
};

TEST(App, AStrokeWetsAndUndoDriesAndRedoWetsAgain) {
  Desk desk;
  const auto dry = desk.app.wetnessHash();
  desk.drag({90, 100}, {120, 110});
  const auto wet = desk.app.wetnessHash();
  EXPECT_NE(wet, dry);
  EXPECT_TRUE(desk.app.undo());
  EXPECT_EQ(desk.app.wetnessHash(), dry);
  EXPECT_TRUE(desk.app.redo());
  EXPECT_EQ(desk.app.wetnessHash(), wet);
  EXPECT_FALSE(desk.app.redo());
}

TEST(App, AStrokeBesideTheModelTurnsTheCamera) {
  Desk desk;
  const auto dry = desk.app.wetnessHash();
  const float yaw = desk.app.camera().yaw;
  desk.drag({5, 5}, {60, 5});
  EXPECT_EQ(desk.app.wetnessHash(), dry);
  EXPECT_NE(desk.app.camera().yaw, yaw);
}

TEST(App, TheDryBrushTakesWaterAway) {
  Desk desk;
  desk.app.setWetness(0.8f);
  const float wet = desk.app.meanWetness();
  desk.app.setTool(Tool::Dry);
  desk.drag({90, 100}, {110, 100});
  EXPECT_LT(desk.app.meanWetness(), wet);
}

TEST(App, DryingEndsAndThenNothingIsActive) {
  Desk desk;
  desk.app.setField("dryRate", "1");
  desk.app.splashPixel({100, 100}, 0.1f, 0.5f);
  EXPECT_TRUE(desk.app.active());
  desk.settle();
  EXPECT_EQ(desk.app.meanWetness(), 0);
  EXPECT_FALSE(desk.app.active());
}

TEST(App, AStillSceneNeedsNoFrames) {
  Desk desk;
  desk.app.draw().value();
  EXPECT_FALSE(desk.app.active());
  EXPECT_FALSE(desk.app.tick(1 / 60.0f));
}

TEST(App, TheSameStepsGiveTheSameWater) {
  std::uint64_t hashes[2];
  for (auto& hash : hashes) {
    Desk desk;
    desk.app.setField("dryRate", "0.1");
    desk.drag({80, 90}, {130, 120});
    for (int i = 0; i < 30; ++i) desk.app.tick(1 / 60.0f);
    hash = desk.app.wetnessHash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(App, ADraggedModelSpringsBackToRest) {
  Desk desk;
  desk.drag({100, 100}, {150, 80}, {.phase = PointerPhase::Down, .buttons = 2});
  EXPECT_TRUE(desk.app.active());
  desk.settle();
  EXPECT_FALSE(desk.app.active());
}

TEST(App, TwoFingersZoom) {
  Desk desk;
  const float distance = desk.app.camera().distance;
  const auto touch = [&](PointerPhase phase, int id, Vec2 at) {
    desk.app.pointer({.phase = phase, .kind = PointerKind::Touch, .id = id, .position = at, .buttons = 1});
  };
  touch(PointerPhase::Down, 1, {80, 100});
  touch(PointerPhase::Down, 2, {120, 100});
  touch(PointerPhase::Move, 1, {60, 100});
  touch(PointerPhase::Move, 2, {140, 100});
  touch(PointerPhase::Up, 1, {60, 100});
  touch(PointerPhase::Up, 2, {140, 100});
  EXPECT_NEAR(desk.app.camera().distance, distance / 2, 0.01f);
}

TEST(App, HomeIsTheViewThatTheFileBroughtAndTheUsualOneOfTheNextModel) {
  Desk desk;
  const float usual = desk.app.camera().yaw;
  desk.app.setCamera({1.0f, 0.5f, 4.0f, Vec3(0.1f, 0, 0)});
  ASSERT_TRUE(desk.app.loadModel(desk.app.saveScene(), "scene.glb"));
  desk.app.setCamera({2.0f, 0.1f, 3.0f, Vec3(0)});
  desk.app.resetCamera();
  EXPECT_FLOAT_EQ(desk.app.camera().yaw, 1);
  EXPECT_FLOAT_EQ(desk.app.camera().distance, 4);
  ASSERT_TRUE(desk.app.loadPrimitive("sphere"));
  desk.app.resetCamera();
  EXPECT_FLOAT_EQ(desk.app.camera().yaw, usual);
}

TEST(App, AModelComesInPiecesWhileTheOneBeforeIsShown) {
  Desk desk;
  const std::string before = desk.app.modelName();
  ASSERT_TRUE(desk.app.beginPrimitive("torus"));
  int pieces = 1;
  for (; !desk.app.workOnComing(0); ++pieces) ASSERT_EQ(desk.app.modelName(), before);
  EXPECT_GT(pieces, 20);
  ASSERT_TRUE(desk.app.showComing());
  EXPECT_EQ(desk.app.modelName(), "torus");
  Desk other;
  ASSERT_TRUE(other.app.loadPrimitive("torus"));
  EXPECT_EQ(desk.app.saveSurface(), other.app.saveSurface());
}

TEST(App, WhatAPictureNeedsGrowsInPieces) {
  Desk desk;
  ASSERT_TRUE(desk.app.loadPrimitive("torus"));
  desk.app.setField("furLength", "0.3");  // into the hole of the ring
  desk.app.setField("curl", "0.9");
  int pieces = 1;
  while (desk.app.workOnPicture(0) == Work::GoesOn) ++pieces;
  // Strands, then layers, then where further shells stand.
  EXPECT_GT(pieces, 2 * desk.app.settings().layers);
  EXPECT_EQ(desk.app.coatProgress(), 1);
  EXPECT_EQ(desk.app.workOnPicture(0), Work::Done);
}

TEST(App, AFirstPictureOfFewerLayersBecomesThatOfTheWholeCoat) {
  const auto picture = [](bool coarse) {
    Desk desk;
    EXPECT_TRUE(desk.app.loadPrimitive("torus"));
    desk.app.detach(false);
    desk.stage.attach(desk.app);
    while (desk.app.workOnPicture(0, coarse) == Work::GoesOn) {
    }
    EXPECT_EQ(desk.app.coatProgress() < 1, coarse);
    EXPECT_EQ(desk.app.coatLayers() < desk.app.settings().layers, coarse);
    desk.app.tick(0);
    EXPECT_EQ(desk.app.coatLayers(), desk.app.settings().layers);
    return desk.stage.draw(desk.app).rgba;
  };
  EXPECT_EQ(picture(true), picture(false));
}

TEST(App, NothingCastsAShadowInAFirstPictureAndAllDoesInThoseThatFollow) {
  const auto pictures = [](const char* shadows) {
    Desk desk;
    desk.app.setField("shadows", shadows);
    EXPECT_TRUE(desk.app.loadPrimitive("torus"));
    desk.app.detach(false);
    desk.stage.attach(desk.app);
    while (desk.app.workOnPicture(0, true) != Work::Done) {
    }
    desk.app.tick(0, 0);
    EXPECT_FALSE(desk.app.frame().castsShadows);
    const auto first = desk.stage.draw(desk.app).rgba;
    while (desk.app.coatProgress() < 1) desk.app.tick(0, 1e-6f);
    EXPECT_TRUE(desk.app.frame().castsShadows);
    return std::pair(first, desk.stage.draw(desk.app).rgba);
  };
  const auto with = pictures("depth"), without = pictures("none");
  // By rounding: the map that nothing is in leaves all of the light but for its last bit.
  int most = 0;
  for (std::size_t i = 0; i < with.first.size(); ++i) most = std::max(most, std::abs(with.first[i] - without.first[i]));
  EXPECT_LE(most, 2);
  EXPECT_NE(with.second, without.second);
}

TEST(App, StateGoesRoundTrip) {
  Desk desk;
  desk.app.setField("furLength", "0.2");
  desk.app.setField("tipColor", "#112233");
  desk.app.setField("view", "skin");
  desk.app.setCamera({1.0f, 0.5f, 4.0f, Vec3(0.1f, 0, 0)});
  const std::string state = desk.app.state();
  App other;
  ASSERT_TRUE(other.loadPrimitive("sphere"));
  ASSERT_TRUE(other.setState(state));
  EXPECT_EQ(other.settings(), desk.app.settings());
  EXPECT_EQ(other.state(), state);
  EXPECT_TRUE(other.takeWarnings().empty());
}

TEST(App, BadStatesAreTypedErrorsAndChangeNothing) {
  App app;
  const std::string before = app.state();
  const auto idOf = [&](std::string_view text) {
    const Status status = app.setState(text);
    EXPECT_FALSE(status);
    return status ? ErrorId::Network : status.error().id;
  };
  EXPECT_EQ(idOf("not json"), ErrorId::BadFile);
  EXPECT_EQ(idOf("[1,2]"), ErrorId::BadFile);
  EXPECT_EQ(idOf(R"({"version":99})"), ErrorId::UnsupportedVersion);
  EXPECT_EQ(idOf(std::string(100000, ' ')), ErrorId::TooLarge);
  EXPECT_EQ(app.state(), before);
}

TEST(App, ABadModelLeavesTheOldScene) {
  Desk desk;
  const auto before = desk.stage.draw(desk.app);
  const std::uint8_t junk[] = {'n', 'o', ' ', 'g', 'l', 'b'};
  const Status status = desk.app.loadModel(junk, "junk.glb");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().id, ErrorId::BadFile);
  EXPECT_NE(status.error().message.find("junk.glb"), std::string::npos);
  EXPECT_EQ(desk.app.modelName(), "sphere");
  EXPECT_EQ(before.differingShare(desk.stage.draw(desk.app), 0), 0);
}

TEST(App, OneSliderDragIsOneUndoStep) {
  App app;
  const float start = app.settings().furLength;
  for (const char* value : {"0.15", "0.2", "0.25"}) app.setField("furLength", value);
  EXPECT_TRUE(app.undo());
  EXPECT_EQ(app.settings().furLength, start);
  EXPECT_FALSE(app.undo());
}

TEST(App, AnotherFurMappingLaysTheFurAnewAndKeepsWhatIsWet) {
  Desk desk;
  desk.drag({90, 100}, {120, 110});
  desk.settle();
  const auto wet = desk.app.wetnessHash();
  const test::Picture charts = desk.stage.draw(desk.app);
  EXPECT_TRUE(desk.app.setField("furMapping", "cube"));
  desk.settle();
  EXPECT_EQ(desk.app.wetnessHash(), wet);
  EXPECT_GT(charts.differingShare(desk.stage.draw(desk.app), 16), 0.03f);
  EXPECT_TRUE(desk.app.undo());
  desk.settle();
  EXPECT_EQ(desk.app.wetnessHash(), wet);
  // Not to the bit: the fur has come to rest from another side.
  EXPECT_LT(charts.differingShare(desk.stage.draw(desk.app), 16), 0.01f);
}

TEST(App, OutOfRangeAndUnknownFieldsWarn) {
  App app;
  EXPECT_TRUE(app.setField("furLength", "99"));
  EXPECT_FLOAT_EQ(app.settings().furLength, 0.4f);
  EXPECT_FALSE(app.setField("noSuchField", "1"));
  EXPECT_EQ(app.takeWarnings().size(), 2u);
}

TEST(App, CheaperLevelsDrawFewerPixelsOfTheSameScene) {
  Desk desk;
  const test::Picture best = desk.stage.draw(desk.app);
  long pixels = desk.app.stats().pixels;
  EXPECT_EQ(pixels, 200 * 200);
  for (int level = 1; level < kQualityLevels; ++level) {
    desk.app.setQuality(level, false);
    const test::Picture picture = desk.stage.draw(desk.app);
    EXPECT_EQ(desk.app.stats().level, level);
    EXPECT_LE(desk.app.stats().pixels, pixels);
    pixels = desk.app.stats().pixels;
    // Single strands move; what is model and what is not stays, and how bright it is.
    EXPECT_LT(picture.differingShare(best, 64), 0.08f) << level;
    EXPECT_NEAR(picture.brightness(), best.brightness(), 4) << level;
  }
  EXPECT_LT(pixels, 200 * 200 / 5);
  desk.app.setQuality(0, false);
  EXPECT_EQ(desk.stage.draw(desk.app).differingShare(best, 0), 0);
}

TEST(App, NothingJumpsWhenItIsDrawnBetterAgain) {
  Desk desk;
  // The light, and where locks are: strands get sharper. Half of the blocks are fur; where locks are as wide as a few pixels they differ more.
  for (const auto& [wetness, most, light] : {std::tuple{0.0f, 1.5f, 0.6f}, {0.6f, 3.5f, 1.2f}, {1.0f, 1.5f, 0.6f}}) {
    desk.app.setWetness(wetness);
    desk.app.setQuality(5, false);
    test::Picture before = desk.stage.draw(desk.app);
    for (int level = 4; level >= 0; --level) {
      desk.app.setQuality(level, false);
      const test::Picture now = desk.stage.draw(desk.app);
      EXPECT_LT(test::meanDifference(test::blocksOf(now), test::blocksOf(before)), most) << wetness << ", " << level;
      EXPECT_LT(std::abs(now.brightness() - before.brightness()), light) << wetness << ", " << level;
      before = now;
    }
  }
}

TEST(App, SlowFramesMakeMovingPicturesCheaperAndNoOthers) {
  Desk desk;
  desk.app.setField("refine", "false");
  desk.app.setQuality(0, true);
  for (int i = 0; i < 60; ++i) desk.app.frameShown(40);
  EXPECT_TRUE(desk.app.draw(Picture::Moving));
  EXPECT_GT(desk.app.stats().level, 0);
  EXPECT_LT(desk.app.stats().pixels, 200 * 200);
  EXPECT_TRUE(desk.app.improvable());
  EXPECT_TRUE(desk.app.draw(Picture::Still));
  EXPECT_EQ(desk.app.stats().level, 0);
  EXPECT_FALSE(desk.app.improvable());
  EXPECT_TRUE(desk.app.draw());
  EXPECT_EQ(desk.app.stats().level, 0);
  desk.app.setQuality(0, false);
  for (int i = 0; i < 60; ++i) desk.app.frameShown(40);
  EXPECT_TRUE(desk.app.draw(Picture::Moving));
  EXPECT_EQ(desk.app.stats().level, 0);
}

TEST(App, ShowsTheBestPictureBitByBitWhereItWouldTakeLong) {
  Desk desk;
  desk.app.setField("refine", "false");
  const auto best = desk.stage.draw(desk.app);
  desk.app.setQuality(0, true);
  for (int i = 0; i < 60; ++i) desk.app.frameShown(900);
  EXPECT_TRUE(desk.app.draw(Picture::Moving));
  const int cheapest = desk.app.stats().level;
  ASSERT_GT(cheapest, 0);
  int shown = 0, hidden = 0;
  while (desk.app.improvable() && hidden < 100) {
    const auto step = desk.app.improve();
    ASSERT_TRUE(step);
    ++(step.value() ? shown : hidden);
    // Not from the middle on with another picture.
    if (hidden == 5 && shown == 0) {
      EXPECT_TRUE(desk.app.draw(Picture::Moving));
      hidden = 6;
    }
  }
  EXPECT_GT(hidden, 10);
  EXPECT_GE(shown, 1);
  EXPECT_EQ(desk.app.stats().level, 0);
  EXPECT_EQ(desk.stage.read().differingShare(best, 0), 0);
}

// Long fur fills the hollow of a ring, and rays that come out of its near side are in the coat of the far one at once.
TEST(App, LongFurOnARingHasNoHoles) {
  test::Stage stage(280, 210);
  App app;
  stage.attach(app);
  ASSERT_TRUE(app.loadPrimitive("torus"));
  for (const auto& [field, value] : {std::pair("backgroundTop", "#ff00ff"), std::pair("backgroundBottom", "#ff00ff"), std::pair("ground", "false")})
    ASSERT_TRUE(app.setField(field, value)) << field;
  ASSERT_TRUE(app.applyPreset("shag"));
  app.settle();
  app.tick(0);
  const test::Picture picture = stage.draw(app);
  int inside = 0, holes = 0;
  for (int y = 0; y < 210; ++y) {
    const auto isSky = [&](int x) { const std::uint8_t* rgba = picture.at(x, y); return rgba[0] > 200 && rgba[1] < 60 && rgba[2] > 200; };
    // Its outline is round: between the first and the last of a row there is fur, but for the tips at its sides.
    constexpr int kTips = 6;
    int first = 0, last = 279;
    while (first < 280 && isSky(first)) ++first;
    while (last > first && isSky(last)) --last;
    if (last - first < 100) continue;
    for (int x = first + kTips; x <= last - kTips; ++x, ++inside) holes += isSky(x);
  }
  EXPECT_GT(inside, 10'000);
  EXPECT_LT(holes, 10);
  app.detach(false);
}

TEST(App, AnotherModelSizeOrCoatIsMeasuredAnew) {
  Desk desk;
  desk.app.setQuality(0, true);
  const auto measure = [&] {
    for (int i = 0; i < 60; ++i) desk.app.frameShown(10);
    return desk.app.stats().frameTime;
  };
  EXPECT_EQ(measure(), 10);
  EXPECT_TRUE(desk.app.loadPrimitive("torus"));
  EXPECT_EQ(desk.app.stats().frameTime, 0);
  EXPECT_EQ(measure(), 10);
  desk.app.resize(160, 200, 1);
  EXPECT_EQ(desk.app.stats().frameTime, 0);
  EXPECT_EQ(measure(), 10);
  desk.app.setField("seed", "9");
  desk.app.settle();
  EXPECT_EQ(desk.app.stats().frameTime, 0);
}

}  // namespace
}  // namespace fur::app
