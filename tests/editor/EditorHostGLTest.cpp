// The panel over the running program, in a context without a window.
#include "app/editor/EditorHost.h"

#include "settings/Presets.h"

#include "tests/render/Picture.h"

namespace fur::app {
namespace {

constexpr int kWidth = 800, kHeight = 500;
constexpr int kPanelLeft = kWidth - 12 - 336;  // its margin and width
constexpr Vec2 kOnModel{200, 250}, kOnPanel{600, 34};

struct HostDesk {
  int height;
  test::Stage stage{kWidth, height};
  App app;
  EditorHost host{app, editor::FileAccess::Path};
  bool attached = false;
  double seconds = 0;  // on the person's clock

  explicit HostDesk(int pixels = kHeight) : height(pixels) {
    stage.attach(app);
    app.setField("layers", "4");
    attached = static_cast<bool>(host.attach());
    host.resize(kWidth, height, 1);
    settle();
  }
  ~HostDesk() {
    host.detach();
    app.detach(false);
  }

  // Frames until neither wants any; returns how many of the panel's looked different.
  int settle() {
    int changed = 0;
    for (int i = 0; i < 600 && (i == 0 || app.active() || host.active()); ++i) {
      app.tick(1 / 60.0f);
      changed += host.update(1 / 60.0f);
    }
    return changed;
  }
  test::Picture picture() {
    stage.draw(app);
    host.draw();
    return stage.read();
  }
  bool send(PointerPhase phase, Vec2 at, int buttons, int id = 0) {
    PointerEvent event{phase};
    event.position = at;
    event.buttons = buttons;
    event.id = id;
    return host.pointer(event, seconds);
  }
  bool click(Vec2 at) {
    seconds += 10;
    const bool captured = send(PointerPhase::Down, at, 1);
    send(PointerPhase::Up, at, 0);
    settle();
    return captured;
  }
};

TEST(EditorHost, SleepsWhenNothingHappens) {
  HostDesk desk;
  ASSERT_TRUE(desk.attached);
  EXPECT_FALSE(desk.host.active());
  desk.picture();
  EXPECT_FALSE(desk.host.update(1 / 60.0f)) << "the panel looks as it was drawn";
  desk.send(PointerPhase::Move, kOnPanel, 0);
  EXPECT_TRUE(desk.host.active());
  desk.settle();
  EXPECT_FALSE(desk.host.active());
}

TEST(EditorHost, DrawsThePanelAndNothingElse) {
  HostDesk desk;
  const test::Picture without = desk.stage.draw(desk.app);
  const test::Picture with = desk.picture();
  int inside = 0, outside = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool differs = !std::equal(without.at(x, y), without.at(x, y) + 3, with.at(x, y));
      (x < kPanelLeft ? outside : inside) += differs;
    }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(inside, 336 * 400);
}

TEST(EditorHost, LeavesTheRendererItsState) {
  HostDesk desk;
  const test::Picture before = desk.stage.draw(desk.app);
  desk.picture();
  EXPECT_EQ(desk.stage.draw(desk.app).differingShare(before, 0), 0);
  EXPECT_EQ(gl::takeError(), "");
}

constexpr Vec2 kPictureSection{600, 92}, kSavePicture{600, 208}, kTurnOnce{520, 295}, kSaveFrames{700, 295};

TEST(EditorHost, WhileAPictureIsDrawnTheSceneStandsStillAndTakesNoInput) {
  HostDesk desk;
  desk.click(kPictureSection);
  desk.send(PointerPhase::Down, kSavePicture, 1);
  desk.send(PointerPhase::Up, kSavePicture, 0);
  for (int i = 0; i < 20 && !desk.host.studio().busy(); ++i) desk.host.update(1 / 60.0f);
  ASSERT_TRUE(desk.host.studio().busy());
  const auto command = desk.host.takeCommand();
  ASSERT_TRUE(command);
  EXPECT_EQ(command->kind, PlatformCommand::Kind::SavePicture);
  EXPECT_EQ(command->text, "sphere.png");
  EXPECT_TRUE(desk.host.active());
  EXPECT_TRUE(desk.send(PointerPhase::Down, kOnModel, 1)) << "it is not for the model";
  desk.send(PointerPhase::Up, kOnModel, 0);
  EXPECT_TRUE(desk.host.key("z", true, {false, true, false}));
  std::vector<std::uint8_t> rgba;
  while (auto band = desk.host.nextBand()) rgba.insert(rgba.end(), band->rgba.begin(), band->rgba.end());
  EXPECT_EQ(rgba.size(), std::size_t(4) * kWidth * kHeight);
  EXPECT_FALSE(desk.host.studio().busy());
}

TEST(EditorHost, EscapeGivesUpAFilmAndTheViewIsAsItWas) {
  HostDesk desk;
  desk.click(kPictureSection);
  const CameraOrbit before = desk.app.camera();
  desk.send(PointerPhase::Down, kSaveFrames, 1);
  desk.send(PointerPhase::Up, kSaveFrames, 0);
  for (int i = 0; i < 20 && !desk.host.studio().busy(); ++i) desk.host.update(1 / 60.0f);
  ASSERT_TRUE(desk.host.studio().busy());
  EXPECT_EQ(desk.host.takeCommand()->kind, PlatformCommand::Kind::SaveTurntable);
  ASSERT_TRUE(desk.host.nextBand());
  ASSERT_TRUE(desk.host.nextBand());
  EXPECT_NE(desk.app.camera().yaw, before.yaw);
  EXPECT_TRUE(desk.host.key("Escape", true, {}));
  EXPECT_FALSE(desk.host.nextBand());
  EXPECT_EQ(desk.app.camera().yaw, before.yaw);
}

TEST(EditorHost, TurnsOnceLiveAndStopsWhenThePictureIsTouched) {
  HostDesk desk;
  desk.click(kPictureSection);
  const float before = desk.app.camera().yaw;
  desk.send(PointerPhase::Down, kTurnOnce, 1);
  desk.send(PointerPhase::Up, kTurnOnce, 0);
  const auto pass = [&](int frames) {
    for (int i = 0; i < frames; ++i) desk.app.tick(1 / 60.0f), desk.host.update(1 / 60.0f);
  };
  pass(3 * 60 + 10);
  EXPECT_NEAR(desk.app.camera().yaw - before, -kPi / 2, 0.1f) << "a quarter of the twelve seconds";
  pass(10 * 60);
  EXPECT_EQ(desk.app.camera().yaw, before);
  desk.settle();
  EXPECT_FALSE(desk.host.active());

  desk.send(PointerPhase::Down, kTurnOnce, 1);
  desk.send(PointerPhase::Up, kTurnOnce, 0);
  pass(60);
  desk.send(PointerPhase::Down, kOnModel, 1);
  desk.send(PointerPhase::Up, kOnModel, 0);
  const float stopped = desk.app.camera().yaw;
  EXPECT_NE(stopped, before);
  pass(60);
  EXPECT_EQ(desk.app.camera().yaw, stopped);
}

TEST(EditorHost, TakesThePointerOverThePanelOnly) {
  HostDesk desk;
  EXPECT_FALSE(desk.click(kOnModel));
  EXPECT_TRUE(desk.click(kOnPanel));
  EXPECT_FALSE(desk.host.wheel(1, kOnModel));
  EXPECT_TRUE(desk.host.wheel(1, kOnPanel));
}

TEST(EditorHost, APressKeepsItsOwnerUntilItIsLetGo) {
  HostDesk desk;
  desk.send(PointerPhase::Down, kOnPanel, 1);
  EXPECT_TRUE(desk.send(PointerPhase::Move, kOnModel, 1));
  EXPECT_TRUE(desk.send(PointerPhase::Up, kOnModel, 0));
  desk.send(PointerPhase::Down, kOnModel, 1);
  EXPECT_FALSE(desk.send(PointerPhase::Move, kOnPanel, 1)) << "a stroke that runs below the panel goes on";
  EXPECT_FALSE(desk.send(PointerPhase::Up, kOnPanel, 0));
}

TEST(EditorHost, ASecondFingerIsNotThePanels) {
  HostDesk desk;
  desk.send(PointerPhase::Down, kOnModel, 1, 1);
  EXPECT_TRUE(desk.send(PointerPhase::Down, kOnPanel, 1, 2));
  EXPECT_FALSE(desk.send(PointerPhase::Move, kOnModel, 1, 1));
  EXPECT_FALSE(desk.send(PointerPhase::Up, kOnModel, 0, 1));
}

TEST(EditorHost, TheModelStandsInTheMiddleOfWhatThePanelLeaves) {
  HostDesk desk;
  desk.app.setField("density", "0");  // tips of strands are where chance has them
  desk.settle();
  // The sphere's silhouette on the middle row: as far from the left edge as from the panel.
  const auto hits = [&](int x) { return desk.app.pick({x, kHeight / 2}).has_value(); };
  int left = 0, right = kPanelLeft;
  while (left < kPanelLeft && !hits(left)) ++left;
  while (right > 0 && !hits(right)) --right;
  EXPECT_LT(left, right);
  // Perspective moves the outline of a sphere off the axis outwards by 1/(d^2 - 1) of its offset: d is
  // 4.4 and the offset 174 pixels, so 9 pixels, twice that between the two gaps, and one for the raster.
  EXPECT_NEAR(left, kPanelLeft - right, 19);
  desk.host.detach();
  desk.settle();
  EXPECT_TRUE(hits(kWidth / 2));
  EXPECT_FALSE(hits(left)) << "back in the middle of all";
}

TEST(EditorHost, UndoAndRedoReachTheApp) {
  HostDesk desk;
  desk.app.setField("curl", "0.9");
  EXPECT_TRUE(desk.host.key("z", true, {false, true, false}));
  EXPECT_FLOAT_EQ(desk.app.settings().curl, settings::Settings{}.curl);
  EXPECT_TRUE(desk.host.key("Z", true, {true, true, false}));
  EXPECT_FLOAT_EQ(desk.app.settings().curl, 0.9f);
}

TEST(EditorHost, BracketsSizeTheBrushAndWithShiftItsStrength) {
  HostDesk desk;
  desk.app.setTool(Tool::Trim);
  const settings::Settings before = desk.app.settings();
  EXPECT_TRUE(desk.host.key("]", true, {}));
  EXPECT_GT(desk.app.settings().brushRadius, before.brushRadius);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(desk.host.key("[", true, {}));
  EXPECT_LT(desk.app.settings().brushRadius, before.brushRadius);
  EXPECT_TRUE(desk.host.key("}", true, {true, false, false}));
  EXPECT_GT(desk.app.settings().groomStrength, before.groomStrength);
  EXPECT_EQ(desk.app.settings().brushFlow, before.brushFlow);
  desk.app.setTool(Tool::Droplet);
  EXPECT_TRUE(desk.host.key("{", true, {true, false, false}));
  EXPECT_LT(desk.app.settings().brushFlow, before.brushFlow) << "of water";
  for (int i = 0; i < 60; ++i) desk.host.key("]", true, {});
  EXPECT_FLOAT_EQ(desk.app.settings().brushRadius, 0.5f) << "up to its end";
  EXPECT_TRUE(desk.app.takeWarnings().empty());
}

TEST(EditorHost, AltTakesTheColourFromTheModelInsteadOfPainting) {
  HostDesk desk;
  desk.app.setTool(Tool::Paint);
  desk.app.setField("rootColor", "#205080");
  desk.app.setField("tipColor", "#205080");
  PointerEvent press{PointerPhase::Down};
  press.position = kOnModel;
  press.buttons = 1;
  press.alt = true;
  EXPECT_TRUE(desk.host.pointer(press, 0));
  EXPECT_EQ(desk.app.settings().paintColor, 0x205080u);
  press.position = {5, 5};
  desk.send(PointerPhase::Up, kOnModel, 0);
  EXPECT_FALSE(desk.host.pointer(press, 1)) << "beside the model the view turns";
}

TEST(EditorHost, LeavesKeysToTheAppUntilThePanelHasTheFocus) {
  HostDesk desk;
  EXPECT_FALSE(desk.host.key("ArrowLeft", true, {}));
  EXPECT_FALSE(desk.host.wantsText());
  desk.click({600, 220});  // somewhere among the rows
  EXPECT_TRUE(desk.host.key("ArrowLeft", true, {}));
  desk.host.key("ArrowLeft", false, {});
  desk.settle();
  EXPECT_FALSE(desk.click(kOnModel));
  EXPECT_FALSE(desk.host.key("ArrowLeft", true, {})) << "given back by a click on the model";
}

TEST(EditorHost, PastedTextThatIsNoStateIsAnErrorOnThePanel) {
  HostDesk desk;
  desk.picture();
  const settings::Settings before = desk.app.settings();
  desk.host.paste("no state at all");
  EXPECT_GT(desk.settle(), 0) << "the message shows";
  EXPECT_EQ(desk.app.settings(), before);
}

TEST(EditorHost, PastedStateIsTakenOver) {
  HostDesk desk;
  const std::string before = desk.app.state();
  desk.app.setField("curl", "0.9");
  desk.host.paste(before);
  EXPECT_FLOAT_EQ(desk.app.settings().curl, settings::Settings{}.curl);
}

void expectBackAfterALostContext(HostDesk& desk) {
  const test::Picture before = desk.picture();
  desk.host.detach();
  desk.app.detach(true);
  ASSERT_TRUE(desk.app.attach());
  ASSERT_TRUE(desk.host.attach());
  desk.settle();
  // The fur is grown again from the same seed, and the panel drawn from the same font: nothing may differ.
  EXPECT_EQ(desk.picture().differingShare(before, 0), 0);
}

TEST(EditorHost, ComesBackAsItWasAfterALostContext) {
  HostDesk desk;
  expectBackAfterALostContext(desk);
}

// Tall enough that the pictures of the tile are open.
constexpr int kTall = 1300;

// White pixels of the panel: strands in the picture of coverage. Its text is not quite white.
int whiteOnPanel(const test::Picture& picture) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = kPanelLeft; x < kWidth; ++x) {
      const std::uint8_t* pixel = picture.at(x, y);
      count += pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
    }
  return count;
}

TEST(EditorHost, ShowsTheTileOfTheCoat) {
  HostDesk desk(kTall);
  // The layer half way up, in the tile and from the side: of 256 x 256 texels some hundreds are strands.
  const int strands = whiteOnPanel(desk.picture());
  EXPECT_GT(strands, 1000);
  desk.app.setField("density", "0.05");
  desk.settle();
  EXPECT_LT(whiteOnPanel(desk.picture()), strands / 3) << "a sparser coat is shown as soon as it is drawn";
  EXPECT_EQ(gl::takeError(), "");
}

TEST(EditorHost, SleepsWithTheTileOpen) {
  HostDesk desk(kTall);
  desk.picture();
  EXPECT_FALSE(desk.host.active());
  EXPECT_FALSE(desk.host.update(1 / 60.0f)) << "the panel looks as it was drawn";
}

TEST(EditorHost, ANewCoatMakesThePanelLookDifferent) {
  HostDesk desk(kTall);
  desk.picture();
  desk.app.setField("seed", "77");
  EXPECT_GT(desk.settle(), 0);
}

TEST(EditorHost, ShowsTheTileAgainAfterALostContext) {
  HostDesk desk(kTall);
  expectBackAfterALostContext(desk);
}

TEST(EditorHost, APresetIsOneStepBack) {
  HostDesk desk;
  const settings::Settings before = desk.app.settings();
  ASSERT_TRUE(desk.app.applyPreset("wool"));
  EXPECT_EQ(settings::presetOf(desk.app.settings()), settings::findPreset("wool"));
  EXPECT_TRUE(desk.app.undo());
  EXPECT_EQ(desk.app.settings(), before);
  EXPECT_FALSE(desk.app.applyPreset("fox"));
  EXPECT_EQ(desk.app.settings(), before);
}

TEST(EditorHost, TwoOnOneProgramDoNotMixUp) {
  HostDesk desk;
  App other;
  ASSERT_TRUE(other.attach());
  {
    EditorHost second(other, editor::FileAccess::Dialog);
    ASSERT_TRUE(second.attach());
    second.resize(400, 300, 2);
    second.update(1 / 60.0f);
    desk.host.update(1 / 60.0f);
    second.message("only here", true);
    EXPECT_TRUE(second.active());
    EXPECT_FALSE(desk.host.active());
  }
  other.detach(false);
  desk.picture();
  EXPECT_EQ(gl::takeError(), "");
}

}  // namespace
}  // namespace fur::app
