#include "editor/GroomPanel.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

struct Person : PanelDriver {
  Person() : PanelDriver({1280, 3600}) {
    editor.setCollapsed(false);
    model.groom.plain = false;
    frames(3);
    open(true);
  }
  void open(bool is) {
    content()->StateStorage.SetInt(content()->GetID("Groom"), is ? 1 : 0);
    frames(3);
  }
  // Presses the segment of that row.
  void press(const char* row, int segment, const char* label) {
    const ImGuiID rowId = content()->GetID(row);
    const ImGuiID item = ImHashStr(label, 0, ImHashData(&segment, sizeof segment, rowId));
    if (places.empty()) look();
    const auto place = places.find(item);
    ASSERT_NE(place, places.end()) << row << ' ' << label;
    click(place->second);
  }
  // As sweep(), on more lines: segments are narrow.
  void look() {
    const ImRect rect = panel()->Rect();
    for (float y = rect.Min.y + 3; y < rect.Max.y; y += 12)
      for (float share = 0.05f; share < 1; share += 0.08f) {
        const Vec2 at(rect.Min.x + rect.GetWidth() * share, y);
        input.pointer(PointerKind::Mouse, at, 0);
        frames(2);
        if (const ImGuiID hovered = ImGui::GetHoveredID()) places.emplace(hovered, at);
      }
  }
  std::map<ImGuiID, Vec2> places;  // nothing here moves
  command::GroomAll only() {
    const auto last = commands;
    commands.clear();
    EXPECT_EQ(last.size(), 1u);
    const auto* edit = last.empty() ? nullptr : std::get_if<command::GroomAll>(&last[0]);
    EXPECT_TRUE(edit);
    return edit ? *edit : command::GroomAll{};
  }
};

TEST(GroomPanel, ItsBrushesAreTools) {
  Person person;
  const std::pair<const char*, int> buttons[] = {{"Comb", 0}, {"Smooth", 1}, {"Raise", 2}, {"Trim", 0}, {"Grow", 1}, {"Type", 2}, {"Whisker", 0}, {"Pluck", 1}};
  int next = static_cast<int>(Tool::Comb);
  for (const auto& [label, segment] : buttons) {
    const bool combs = next < static_cast<int>(Tool::Trim), hairs = next >= static_cast<int>(Tool::Whisker);
    person.press(combs ? "combs" : hairs ? "hairs" : "cuts", segment, label);
    ASSERT_EQ(person.commands.size(), 1u);
    EXPECT_EQ(static_cast<int>(std::get<command::SetTool>(person.commands[0]).tool), next++);
    person.commands.clear();
  }
}

TEST(GroomPanel, WhatItDoesAllOverIsOneCommandEach) {
  Person person;
  person.press("lengths", 2, "1/2");
  command::GroomAll edit = person.only();
  EXPECT_EQ(edit.edit, GroomEdit::Length);
  EXPECT_FLOAT_EQ(edit.value, 0.5f);
  person.press("lengths", 4, "Bald");
  EXPECT_EQ(person.only().value, 0);
  person.press("changes", 0, "Invert");
  EXPECT_EQ(person.only().edit, GroomEdit::Invert);
  person.press("changes", 1, "Vary");
  EXPECT_EQ(person.only().edit, GroomEdit::Vary);
  person.press("ways", 0, "Down");
  edit = person.only();
  EXPECT_EQ(edit.edit, GroomEdit::Comb);
  EXPECT_EQ(edit.direction, Vec3(0, -1, 0));
  person.press("ways", 3, "Upright");
  EXPECT_EQ(person.only().edit, GroomEdit::Raise);
  person.press("sizes", 1, "512");
  edit = person.only();
  EXPECT_EQ(edit.edit, GroomEdit::Size);
  EXPECT_EQ(edit.value, 512);
}

TEST(GroomPanel, ThereIsNothingToClearInAPlainGroom) {
  Person person;
  const auto clear = person.find(person.id("Clear"));
  ASSERT_TRUE(clear);
  person.click(*clear);
  EXPECT_EQ(person.only().edit, GroomEdit::Clear);
  person.model.groom.plain = true;
  person.frames(2);
  person.click(*clear);
  EXPECT_TRUE(person.commands.empty());
}

TEST(GroomPanel, BrushSettingsAreUndoSteps) {
  Person person;
  person.press("types", 2, "3");
  EXPECT_EQ(person.model.settings.groomType, 2);
  EXPECT_EQ(person.count<command::BeginChange>(), 1);
  EXPECT_EQ(person.count<command::EndChange>(), 1);
  const auto strength = person.find(person.id("##groomStrength"));
  ASSERT_TRUE(strength);
  person.moveTo(*strength, 1);
  person.moveTo(*strength + Vec2(1000, 0), 1);
  person.moveTo(*strength + Vec2(1000, 0), 0);
  EXPECT_EQ(person.model.settings.groomStrength, 1);
}

TEST(GroomPanel, AsksForThePictureOfTheMapOnlyWhileItShows) {
  Person person;
  EXPECT_TRUE(person.editor.showsGroom());
  person.open(false);
  EXPECT_FALSE(person.editor.showsGroom());
  person.open(true);
  person.editor.setCollapsed(true);
  person.frames(2);
  EXPECT_FALSE(person.editor.showsGroom());
}

}  // namespace
}  // namespace fur::editor
