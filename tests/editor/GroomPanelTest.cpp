#include "editor/GroomPanel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "editor/ToolRows.h"
#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

struct GroomPerson : PanelDriver {
  GroomPerson() : PanelDriver({1280, 3600}) {
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
    if (!places.contains(item)) look(item);
    const auto place = places.find(item);
    ASSERT_NE(place, places.end()) << row << ' ' << label;
    click(place->second);
  }
  // As find(), on more lines: segments are narrow.
  void look(ImGuiID item) {
    const ImRect rect = panel()->Rect();
    for (float y = rect.Min.y + 3; y < rect.Max.y; y += 12)
      for (float share = 0.05f; share < 1; share += 0.08f) {
        const Vec2 at(rect.Min.x + rect.GetWidth() * share, y);
        const ImGuiID hovered = hoveredAt(at);
        if (hovered) places.emplace(hovered, at);
        if (hovered == item) return;
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

TEST(GroomPanel, EveryToolThatGroomsHasAButton) {
  GroomPerson person;
  for (std::size_t i = 0; i < app::kToolCount; ++i) {
    const auto tool = static_cast<Tool>(i);
    if (!app::grooms(tool)) continue;
    const app::ToolWords& words = app::wordsOf(tool);
    const std::vector<Tool> row = toolsIn(words.row);
    const bool paired = *words.inverseLabel != '\0';  // it has a row of its own
    const auto place = std::find(row.begin(), row.end(), tool) - row.begin();
    person.press(paired ? words.label : words.row, paired ? 0 : static_cast<int>(place), words.label);
    ASSERT_EQ(person.commands.size(), 1u) << words.label;
    EXPECT_EQ(std::get<command::SetTool>(person.commands[0]).tool, tool);
    person.commands.clear();
  }
}

TEST(GroomPanel, BrushesOfARowStandInTheTablesOrder) {
  EXPECT_EQ(toolsIn("combs"), (std::vector{Tool::Comb, Tool::Smooth, Tool::Raise}));
  EXPECT_EQ(toolsIn("cuts"), (std::vector{Tool::Trim, Tool::Grow, Tool::Cut, Tool::Type}));
  EXPECT_TRUE(toolsIn("hammers").empty());
}

TEST(GroomPanel, WhatBrushesAddComesOffAgainByTheButtonsBesideThem) {
  const struct {
    const char *row, *gives, *takes;
    Tool tool;
  } pairs[] = {{"Thin", "Thin", "Thicken", Tool::Thin}, {"Paint", "Paint", "Erase paint", Tool::Paint}, {"Mask", "Mask", "Unmask", Tool::Mask},
               {"Curl", "Curl", "Uncurl", Tool::Curl}, {"Frizz", "Frizz", "Unfrizz", Tool::Frizz}, {"Gather locks", "Gather locks", "Open locks", Tool::Locks}};
  for (const auto& pair : pairs) {
    GroomPerson person;
    person.press(pair.row, 1, pair.takes);
    EXPECT_TRUE(person.model.settings.brushErases) << pair.takes;
    EXPECT_EQ(person.count<command::SetTool>(), 1);
    person.press(pair.row, 0, pair.gives);
    EXPECT_FALSE(person.model.settings.brushErases) << pair.gives;
  }
}

TEST(GroomPanel, FalloffAndMirrorAreSettings) {
  GroomPerson person;
  person.press("falloffs", 3, "Flat");
  EXPECT_EQ(person.model.settings.brushFalloff, 3);
  person.press("mirrors", 1, "X");
  EXPECT_EQ(person.model.settings.mirror, 1);
  person.press("mirrors", 0, "Off");
  EXPECT_EQ(person.model.settings.mirror, 0);
}

TEST(GroomPanel, SelectingShowsTheMaskToThoseWhoDoNotGroomYet) {
  GroomPerson person;
  person.model.tool = Tool::Droplet;
  person.press("selects", 2, "Type");
  ASSERT_EQ(person.count<command::SetTool>(), 1);
  EXPECT_EQ(std::get<command::SetTool>(person.commands.back()).tool, Tool::Mask);
}

TEST(GroomPanel, SelectionsAreEditsOrWaitForAClick) {
  GroomPerson person;
  person.model.tool = Tool::Comb;
  const std::pair<const char*, GroomEdit> changes[] = {{"Grow", GroomEdit::GrowMask}, {"Shrink", GroomEdit::ShrinkMask}, {"Smooth", GroomEdit::SmoothMask}};
  for (int i = 0; i < 3; ++i) {
    person.press("maskChanges", i, changes[i].first);
    const command::GroomAll edit = person.only();
    EXPECT_EQ(edit.edit, changes[i].second);
    EXPECT_GT(edit.value, 0);
  }
  person.press("selects", 2, "Type");
  const command::GroomAll type = person.only();
  EXPECT_EQ(type.edit, GroomEdit::SelectType);
  EXPECT_EQ(type.value, static_cast<float>(person.model.settings.groomType + 1));
  for (const auto& [segment, label, what] : {std::tuple(0, "Connected", Selects::Connected), std::tuple(1, "Paint", Selects::Paint)}) {
    person.press("selects", segment, label);
    ASSERT_EQ(person.commands.size(), 1u);
    EXPECT_EQ(std::get<command::SelectAt>(person.commands[0]).what, what);
    person.commands.clear();
    // Pressed again it is taken back.
    person.model.groom.selects = what;
    person.press("selects", segment, label);
    EXPECT_EQ(std::get<command::SelectAt>(person.commands[0]).what, Selects::Nothing);
    person.commands.clear();
    person.model.groom.selects = Selects::Nothing;
  }
}

TEST(GroomPanel, WhatItDoesAllOverIsOneCommandEach) {
  GroomPerson person;
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
  person.press("paintAlls", 0, "Fill");
  edit = person.only();
  EXPECT_EQ(edit.edit, GroomEdit::Paint);
  EXPECT_EQ(edit.value, static_cast<float>(person.model.settings.paintColor));
  person.press("paintAlls", 1, "Clear paint");
  EXPECT_EQ(person.only().edit, GroomEdit::ClearPaint);
  person.press("maskAlls", 0, "Invert mask");
  EXPECT_EQ(person.only().edit, GroomEdit::InvertMask);
  person.press("maskAlls", 1, "Clear mask");
  EXPECT_EQ(person.only().edit, GroomEdit::ClearMask);
  person.press("shapeAlls", 0, "Clear curls, frizz and locks");
  EXPECT_EQ(person.only().edit, GroomEdit::ClearShape);
  person.press("sizes", 1, "512");
  edit = person.only();
  EXPECT_EQ(edit.edit, GroomEdit::Size);
  EXPECT_EQ(edit.value, 512);
}

TEST(GroomPanel, ThereIsNothingToClearInAPlainGroom) {
  GroomPerson person;
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
  GroomPerson person;
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
  GroomPerson person;
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
