// Points and whiskers that are chosen and changed one by one, with pointers and keys as they come from a person.
#include "app/editor/EditModes.h"
#include "app/editor/EditorHost.h"

#include <cmath>
#include <vector>

#include "tests/render/Picture.h"

namespace fur::app {
namespace {

constexpr Vec2 kOnSkin{80, 80};

struct ModesRoom : test::Room {
  ModesRoom() : Room(160, {{"layers", "8"}, {"tileSize", "64"}, {"dryRate", "0"}, {"brushRadius", "0.3"}}) {
    (void)app.loadPrimitive("sphere");
    app.settle();
    app.tick(0);
  }
  EditModes modes{app};

  bool send(PointerPhase phase, Vec2 at, int buttons) {
    PointerEvent event{phase};
    event.position = at;
    event.buttons = buttons;
    if (phase == PointerPhase::Down) return modes.press(event, 1);
    if (phase == PointerPhase::Up) return modes.release(), true;
    return modes.drag(event), true;
  }
  bool drag(Vec2 from, Vec2 to, int buttons = 1) {
    const bool taken = send(PointerPhase::Down, from, buttons);
    for (int i = 1; i <= 4 && from != to; ++i) send(PointerPhase::Move, from + (to - from) * (static_cast<float>(i) / 4), buttons);
    send(PointerPhase::Up, to, 0);
    return taken;
  }
  bool press(std::string_view key, bool shift = false) {
    const bool taken = modes.key(key, true, {shift});
    modes.key(key, false, {shift});
    return taken;
  }
  editor::GroomView view() {
    editor::GroomView out;
    modes.describe(out);
    return out;
  }
  const groom::Whisker& whisker(std::size_t i = 0) { return app.groom().whiskers[i]; }
};

struct PointRoom : ModesRoom {
  PointRoom() {
    app.setTool(Tool::Edit);
    drag(kOnSkin, kOnSkin);
  }
};

TEST(EditModes, AClickChoosesAPointAndChangesNothing) {
  PointRoom room;
  ASSERT_TRUE(room.view().point);
  EXPECT_FLOAT_EQ(room.view().point->length, 1);
  EXPECT_FALSE(room.app.canUndo());
  EXPECT_FALSE(room.drag({3, 3}, {3, 3})) << "beside the model the view turns";
  EXPECT_TRUE(room.press("Escape"));
  EXPECT_FALSE(room.view().point);
}

TEST(EditModes, EveryNumberOfAPointIsWhatItWasSetToAndOneStepOfUndo) {
  PointRoom room;
  const std::uint64_t before = room.app.groomHash();
  room.modes.set({FurNumber::Length, 0.25f});
  EXPECT_NEAR(room.view().point->length, 0.25f, 0.01f);
  room.modes.set({FurNumber::Comb, 0, {30, 90}});
  EXPECT_NEAR(room.view().point->comb.lean, 30, 1.5f);
  EXPECT_NEAR(room.view().point->comb.heading, 90, 3);
  room.modes.set({FurNumber::Type, 3});
  EXPECT_GT(room.view().point->types[2], 0.95f);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(room.app.undo());
  EXPECT_EQ(room.app.groomHash(), before);
  for (const float wetness : {0.7f, 0.2f}) {
    room.modes.set({FurNumber::Wetness, wetness});
    EXPECT_NEAR(room.view().point->wetness, wetness, 0.08f);
  }
  EXPECT_TRUE(room.app.undo());
  EXPECT_NEAR(room.view().point->wetness, 0.7f, 0.08f);
}

TEST(EditModes, ASliderDrawnToAndFroLeavesWhatItsLastValueLeaves) {
  PointRoom straight, wandering;
  straight.modes.set({FurNumber::Length, 0.8f});
  wandering.app.beginChange();
  for (const float length : {0.1f, 0.6f, 0.0f, 0.8f}) wandering.modes.set({FurNumber::Length, length});
  wandering.app.endChange();
  EXPECT_EQ(wandering.app.groomHash(), straight.app.groomHash());
  EXPECT_TRUE(wandering.app.undo());
  EXPECT_FALSE(wandering.app.canUndo());
}

TEST(EditModes, ADragCombsToWhereItGoesAndWithTheRightButtonItSetsTheLength) {
  PointRoom room;
  room.drag(kOnSkin, kOnSkin + Vec2(14, 0));
  EXPECT_NEAR(room.view().point->comb.heading, 90, 12) << "to the right";
  EXPECT_GT(room.view().point->comb.lean, 5);
  room.drag(kOnSkin, kOnSkin + Vec2(0, 60), 2);
  EXPECT_NEAR(room.view().point->length, 0.7f, 0.02f) << "downwards is shorter";
  EXPECT_TRUE(room.app.undo() && room.app.undo());
  EXPECT_FALSE(room.app.canUndo());
}

TEST(EditModes, KeysSetTypesAndLengthsOfThePointAndTheBrushsTypeWithoutOne) {
  PointRoom room;
  EXPECT_TRUE(room.press("2"));
  EXPECT_GT(room.view().point->types[1], 0.95f);
  EXPECT_TRUE(room.press("["  , true));
  EXPECT_NEAR(room.view().point->length, 0.95f, 0.01f);
  EXPECT_FALSE(room.press("[")) << "the brush's size";
  room.press("Escape");
  EXPECT_TRUE(room.press("4"));
  EXPECT_EQ(room.app.settings().groomType, 3);
}

TEST(EditModes, EAndWBeginAndLeaveTheModesAndEndWithTheKeyWhereSomethingWasDone) {
  ModesRoom room;
  room.app.setTool(Tool::Droplet);
  EXPECT_TRUE(room.press("e"));
  EXPECT_EQ(room.app.tool(), Tool::Edit);
  EXPECT_TRUE(room.press("W"));
  EXPECT_EQ(room.app.tool(), Tool::Whisker);
  EXPECT_TRUE(room.press("w"));
  EXPECT_EQ(room.app.tool(), Tool::Droplet);
  room.modes.key("e", true, {});
  room.modes.key("e", true, {});  // keyboards repeat
  room.drag(kOnSkin, kOnSkin);
  room.modes.key("e", false, {});
  EXPECT_EQ(room.app.tool(), Tool::Droplet);
  EXPECT_FALSE(room.modes.key("e", true, {false, true})) << "with control it is somebody else's";
}

TEST(EditModes, BSAndFHideWhatIsDrawnAndShowItAgain) {
  ModesRoom room;
  const auto centre = [&] {
    const test::Picture picture = room.settled();
    return std::vector<int>(picture.at(80, 80), picture.at(80, 80) + 3);
  };
  const auto furry = centre();
  EXPECT_TRUE(room.press("s") && room.press("f"));
  const auto bare = centre();
  EXPECT_NE(bare, furry);
  EXPECT_TRUE(room.press("b"));
  EXPECT_NE(centre(), bare) << "the background";
  EXPECT_TRUE(room.press("b") && room.press("s") && room.press("f"));
  EXPECT_EQ(centre(), furry);
  for (const auto& [key, part] : {std::pair("b", &settings::Settings::skin), std::pair("s", &settings::Settings::shells), std::pair("f", &settings::Settings::fins)}) {
    const bool before = room.app.settings().*part;
    EXPECT_TRUE(room.press(key));
    EXPECT_NE(room.app.settings().*part, before);
    EXPECT_TRUE(room.press(key));
    EXPECT_EQ(room.app.settings().*part, before);
  }
}

struct WhiskerRoom : ModesRoom {
  WhiskerRoom() {
    app.setTool(Tool::Whisker);
    drag(kOnSkin, kOnSkin + Vec2(24, -24));
  }
  Vec2 middle() { return app.whiskerLine(0)[3]; }
};

TEST(EditModes, AWhiskerIsPlantedAndAimedInOneStepOfUndo) {
  WhiskerRoom room;
  ASSERT_EQ(room.app.whiskerCount(), 1u);
  ASSERT_TRUE(room.view().whisker);
  EXPECT_GT(room.view().whisker->aim.lean, 10);
  EXPECT_NEAR(room.view().whisker->aim.heading, 45, 20);
  EXPECT_TRUE(room.app.undo());
  EXPECT_EQ(room.app.whiskerCount(), 0u);
  EXPECT_FALSE(room.view().whisker);
  EXPECT_FALSE(room.app.canUndo());
}

TEST(EditModes, AWhiskerThatStandsIsChosenWhereItIsSeenAimedAnewAndMadeLonger) {
  WhiskerRoom room;
  room.press("Escape");
  EXPECT_FALSE(room.view().whisker);
  const Vec3 aim = room.whisker().direction;
  EXPECT_TRUE(room.drag(room.middle(), room.middle()));
  ASSERT_TRUE(room.view().whisker);
  EXPECT_EQ(room.whisker().direction, aim) << "a click changes nothing";
  room.drag(room.middle(), kOnSkin + Vec2(-40, 0));
  EXPECT_NEAR(room.view().whisker->aim.heading, -90, 25);
  EXPECT_EQ(room.app.whiskerCount(), 1u);
  const float length = room.whisker().length;
  room.drag(room.middle(), room.middle() - Vec2(0, 100), 2);
  EXPECT_NEAR(room.whisker().length, length * std::exp(0.5f), 0.01f);
  EXPECT_TRUE(room.app.undo() && room.app.undo());
  EXPECT_EQ(room.whisker().direction, aim);
}

TEST(EditModes, KeysMakeTheChosenWhiskerLongerThickerTurnAndDeleteIt) {
  WhiskerRoom room;
  const groom::Whisker before = room.whisker();
  EXPECT_TRUE(room.press("]") && room.press("}"));
  EXPECT_FLOAT_EQ(room.whisker().length, before.length * 1.1f);
  EXPECT_FLOAT_EQ(room.whisker().width, before.width * 1.1f);
  const float heading = room.view().whisker->aim.heading;
  EXPECT_TRUE(room.press("ArrowRight", true));
  EXPECT_NEAR(room.view().whisker->aim.heading, heading + 5.7f, 0.5f);
  EXPECT_TRUE(room.press("Delete"));
  EXPECT_EQ(room.app.whiskerCount(), 0u);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(room.app.undo());
  EXPECT_EQ(room.whisker(), before);
  EXPECT_TRUE(room.view().whisker) << "undo brings it back as it was chosen";
}

TEST(EditModes, NGoesThroughTheWhiskersAndTheChosenOneSurvivesThatOthersGo) {
  WhiskerRoom room;
  room.drag({60, 100}, {60, 100});
  const Vec3 second = room.whisker(1).root;
  room.modes.removeWhisker();
  EXPECT_TRUE(room.app.undo());
  EXPECT_TRUE(room.press("n"));
  EXPECT_TRUE(room.press("n"));
  room.app.removeWhisker(0);
  ASSERT_EQ(room.app.whiskerCount(), 1u);
  EXPECT_EQ(room.whisker().root, second);
  ASSERT_TRUE(room.view().whisker);
  room.modes.removeWhisker();
  EXPECT_EQ(room.app.whiskerCount(), 0u);
}

TEST(EditModes, TwoFingersMoveTheViewAndLeaveThePoint) {
  ModesRoom room;
  EditorHost host(room.app, editor::FileAccess::Path);
  ASSERT_TRUE(host.attach());
  host.resize(160, 160, 1);
  room.app.setTool(Tool::Edit);
  const float distance = room.app.camera().distance;
  const auto send = [&](PointerPhase phase, int id, Vec2 at) {
    PointerEvent event{phase, PointerKind::Touch, id, at, phase == PointerPhase::Up ? 0 : 1};
    if (!host.pointer(event, 0)) room.app.pointer(event);
  };
  send(PointerPhase::Down, 1, {70, 80});
  send(PointerPhase::Down, 2, {90, 80});
  send(PointerPhase::Move, 1, {40, 80});
  send(PointerPhase::Move, 2, {120, 80});
  EXPECT_LT(room.app.camera().distance, distance);
  send(PointerPhase::Up, 1, {40, 80});
  send(PointerPhase::Up, 2, {120, 80});
  EXPECT_FALSE(room.app.canUndo());
  host.detach();
}

}  // namespace
}  // namespace fur::app
