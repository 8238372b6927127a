#include "editor/InputQueue.h"

#include <gtest/gtest.h>

#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

TEST(InputQueue, APressAndReleaseBetweenTwoFramesIsStillAClick) {
  PanelDriver person;
  const auto at = person.find(person.rowId("fins", "##value"));
  ASSERT_TRUE(at);
  person.input.pointer(PointerKind::Mouse, *at, 1);
  person.input.pointer(PointerKind::Mouse, *at, 0);
  person.settle();
  EXPECT_FALSE(person.model.settings.fins);
}

TEST(InputQueue, AFingerThatComesFromNowhereHitsWhatItTouches) {
  PanelDriver person;
  const auto at = person.find(person.rowId("fins", "##value"));
  ASSERT_TRUE(at);
  person.input.pointerGone();
  person.settle();
  person.input.pointer(PointerKind::Touch, *at, 1);
  person.input.pointer(PointerKind::Touch, *at, 0);
  person.input.pointerGone();
  person.settle();
  EXPECT_FALSE(person.model.settings.fins);
  EXPECT_EQ(ImGui::GetHoveredID(), 0u);
}

TEST(InputQueue, ManyMovesBetweenTwoFramesAreOne) {
  PanelDriver person;
  for (int i = 0; i < 100; ++i) person.input.pointer(PointerKind::Mouse, Vec2(i, i), 0);
  person.frames(1);
  EXPECT_TRUE(person.input.empty());
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 99);
}

TEST(InputQueue, AKeyPressedAndReleasedBetweenTwoFramesIsSeen) {
  PanelDriver person;
  const auto box = person.find(person.id("##filter"));
  ASSERT_TRUE(box);
  person.click(*box);
  person.input.text("curlx");
  person.input.key("Backspace", true, {});
  person.input.key("Backspace", false, {});
  person.settle();
  EXPECT_TRUE(person.find(person.rowId("curl", "##value"))) << "the x is gone again";
}

TEST(InputQueue, LosingTheFocusLetsEverythingGo) {
  PanelDriver person;
  const auto at = person.find(person.rowId("curl", "##value"));
  ASSERT_TRUE(at);
  person.moveTo(*at);
  person.moveTo(*at, 1);
  EXPECT_TRUE(person.editor.changing());
  const settings::Settings held = person.model.settings;
  person.input.releaseAll();
  person.settle();
  EXPECT_FALSE(person.editor.changing());
  EXPECT_EQ(person.count<command::EndChange>(), 1);
  EXPECT_EQ(person.model.settings, held) << "the slider did not follow the pointer out of the window";
}

}  // namespace
}  // namespace fur::editor
