#include "editor/Editor.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "settings/LightRigs.h"
#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

using settings::Field;
using settings::Settings;

// The names of the fields in which the two differ.
std::set<std::string> differences(const Settings& a, const Settings& b) {
  std::set<std::string> names;
  for (const Field& field : settings::fields())
    if (field.get(a) != field.get(b)) names.insert(field.name);
  return names;
}

TEST(Editor, EveryFieldOfTheTableHasAWidget) {
  PanelDriver person({1280, 6000});
  person.openAllGroups();
  std::set<ImGuiID> hovered;
  for (const auto& [at, id] : person.sweep()) hovered.insert(id);
  for (const Field& field : settings::fields())
    EXPECT_TRUE(hovered.count(person.valueId(field))) << field.name;
  EXPECT_TRUE(person.commands.empty()) << "hovering changes nothing";
}

TEST(Editor, WhatArtistsChangeMostStandsAtTheTop) {
  PanelDriver person;
  const ImGuiID section = person.content()->GetID("frequent");
  std::map<ImGuiID, float> heights;
  for (const auto& [at, id] : person.sweep()) heights.emplace(id, at.y);
  const float model = heights[person.id("Model")];
  ASSERT_GT(model, 0);
  int count = 0;
  for (const Field& field : settings::fields()) {
    if (!field.has(settings::kFrequent)) continue;
    const ImGuiID value = ImHashStr("##value", 0, ImHashStr(field.name, 0, section));
    const auto row = heights.find(field.type == settings::FieldType::Color ? ImHashStr("##Text", 0, value) : value);
    ASSERT_NE(row, heights.end()) << field.name;
    EXPECT_LT(row->second, model) << field.name;
    ++count;
  }
  EXPECT_GE(count, 5);
  EXPECT_LE(count, 10) << "a handful";
}

TEST(Editor, ADoubleOfAFieldIsTheSameField) {
  PanelDriver person;
  const ImGuiID section = person.content()->GetID("frequent");
  const auto at = person.find(ImHashStr("##value", 0, ImHashStr("curl", 0, section)));
  ASSERT_TRUE(at);
  const Settings before = person.model.settings;
  person.click(*at);
  EXPECT_EQ(differences(before, person.model.settings), std::set<std::string>{"curl"});
}

TEST(Editor, GroomComesBeforeWater) {
  PanelDriver person;
  const auto groom = person.find(person.id("Groom")), water = person.find(person.id("Water and touch"));
  ASSERT_TRUE(groom && water);
  EXPECT_LT(groom->y, water->y);
}

// The highest pixel of an item that is found there.
float topOf(PanelDriver& person, Vec2 at) {
  person.moveTo(at);
  const ImGuiID item = ImGui::GetHoveredID();
  while (item && ImGui::GetHoveredID() == item) person.moveTo(at -= Vec2(0, 1));
  return at.y;
}

void expectToStayPut(PanelDriver& person, ImGuiID item) {
  const auto first = person.find(item);
  ASSERT_TRUE(first);
  const ImGuiID last = person.id("Share and statistics");
  std::optional<Vec2> end = person.find(last);
  const float top = topOf(person, *first), endTop = end ? topOf(person, *end) : 0;
  EditorModel& model = person.model;
  model.meanWetness = 0.4f;
  model.water = {5, 2, 1, 0.5, 0.25, 1.25};
  model.messages = {};
  static const std::vector<Message> messages = {{"Something is not as it should be, at some length, so that it takes lines", true}, {"Short", false}};
  model.messages = messages;
  model.canUndo = model.canRedo = true;
  model.strands = model.vertices = 12345;
  model.animations = {"walk"};
  model.groom = {.bald = 0.5f, .length = 0.5f, .types = {0.25f, 0.25f, 0.25f, 0.25f}, .whiskers = 12, .plain = false};
  static const std::vector<float> times(60, 0.016f);
  model.frameSeconds = times;
  model.coat.progress = 0.5f;
  person.frames(90);
  EXPECT_EQ(topOf(person, *first), top);
  if (end) {
    EXPECT_EQ(topOf(person, *end), endTop);
  }
}

TEST(Editor, WhatTheProgramTellsMovesNoRow) {
  PanelDriver tall({1280, 4200});
  tall.openGroup("Groom");
  expectToStayPut(tall, tall.rowId("density", "##value"));
  PanelDriver low({1280, 1260});
  expectToStayPut(low, low.rowId("density", "##value"));
  PanelDriver phone({390, 2060}, {1, true});
  phone.editor.setLayout("width 336 sheet 0.6");
  phone.editor.setCollapsed(false);
  phone.frames(3);
  expectToStayPut(phone, phone.id("Groom"));
}

TEST(Editor, AnIdlePanelAsksForNothing) {
  PanelDriver person;
  person.frames(30);
  EXPECT_TRUE(person.commands.empty());
}

TEST(Editor, ADraggedSliderChangesOnlyItsFieldInOneStep) {
  PanelDriver person;
  const auto at = person.find(person.rowId("curl", "##value"));
  ASSERT_TRUE(at);
  const Settings before = person.model.settings;
  person.moveTo(*at);
  person.moveTo(*at, 1);
  for (int i = 1; i <= 5; ++i) person.moveTo(*at + Vec2(8 * i, 0), 1);
  EXPECT_TRUE(person.editor.changing());
  EXPECT_EQ(person.count<command::EndChange>(), 0);
  person.moveTo(*at + Vec2(40, 0), 0);

  EXPECT_EQ(differences(before, person.model.settings), std::set<std::string>{"curl"});
  EXPECT_GE(person.count<command::SetSettings>(), 5);
  EXPECT_EQ(person.count<command::BeginChange>(), 1);
  EXPECT_EQ(person.count<command::EndChange>(), 1);
  EXPECT_TRUE(std::holds_alternative<command::BeginChange>(person.commands.front()));
  EXPECT_TRUE(std::holds_alternative<command::EndChange>(person.commands.back()));
}

TEST(Editor, ASliderFollowsThePointerToBothEnds) {
  PanelDriver person;
  const auto at = person.find(person.rowId("curl", "##value"));
  ASSERT_TRUE(at);
  person.moveTo(*at);
  person.moveTo(*at, 1);
  person.moveTo(*at + Vec2(1000, 0), 1);
  EXPECT_EQ(person.model.settings.curl, 1.0f);
  person.moveTo(*at - Vec2(1000, 0), 1);
  EXPECT_EQ(person.model.settings.curl, 0.0f);
}

// A person whose curl is 0.25, before its slider.
struct AtCurl : PanelDriver {
  explicit AtCurl(ThemeScale scale = {}) : PanelDriver({1280, 3000}, scale) {
    if (const auto found = find(rowId("curl", "##value"))) at = *found;
    EXPECT_NE(at, Vec2(0));
  }
  Vec2 at{0};
  Settings before = model.settings;
};

TEST(Editor, ADoubleClickOnASliderAsksForANumber) {
  AtCurl person;
  person.doubleClick(person.at);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(person.model.settings, person.before) << "the first click moved it";
  person.type("0.7");
  person.pressKey("Enter");
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(person.model.settings.curl, 0.7f);
  EXPECT_EQ(differences(person.before, person.model.settings), std::set<std::string>{"curl"});
  EXPECT_EQ(person.count<command::Undo>(), 1) << "one step from before to what was typed";
  EXPECT_EQ(person.count<command::BeginChange>(), 2);
  EXPECT_EQ(person.count<command::EndChange>(), 2);
}

TEST(Editor, EscapeLeavesWhatWasThereBeforeTyping) {
  AtCurl person;
  person.doubleClick(person.at);
  person.type("0.7");
  person.pressKey("Escape");
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(person.model.settings, person.before);
}

TEST(Editor, TypedNumbersEndAtTheRange) {
  AtCurl person;
  const std::pair<const char*, float> typed[] = {{"7", 1}, {"-3", 0}, {"1e99", 1}, {"0,3", 0.3f}, {"no number", 0.3f}, {"", 0.3f}};
  for (const auto& [text, expected] : typed) {
    person.doubleClick(person.at);
    if (*text) person.type(text);
    else person.pressKey("Delete");
    person.pressKey("Enter");
    EXPECT_EQ(person.model.settings.curl, expected) << text;
  }
  const auto layers = person.find(person.rowId("layers", "##value"));
  ASSERT_TRUE(layers);
  person.doubleClick(*layers);
  person.type("2");
  person.pressKey("Enter");
  EXPECT_EQ(person.model.settings.layers, 4);
}

TEST(Editor, TwoClicksWithAPauseAreNoDoubleClick) {
  AtCurl person;
  person.click(person.at);
  const Settings clicked = person.model.settings;
  person.click(person.at);
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(person.model.settings, clicked);
}

TEST(Editor, ADoubleClickIsOneHoweverSlowTheFramesAre) {
  AtCurl person;
  ImGui::GetIO().DeltaTime = 3;
  person.doubleClick(person.at);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
}

TEST(Editor, ADoubleTapOnASliderAsksForANumber) {
  AtCurl person({1, true});
  person.tap(person.at);
  person.seconds += 0.2;
  person.tap(person.at + Vec2(9, 3));
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(person.model.settings, person.before);
  person.type("0.5");
  person.pressKey("Enter");
  EXPECT_EQ(person.model.settings.curl, 0.5f);
}

TEST(Editor, ASecondTapOnAnotherSliderIsNotForIt) {
  AtCurl person({1, true});
  const auto taper = person.find(person.rowId("taper", "##value"));
  ASSERT_TRUE(taper);
  person.click(*taper);
  const float border = topOf(person, *taper);
  person.seconds += 10;
  person.tap({taper->x, border - 10});
  EXPECT_NE(person.model.settings.curl, person.before.curl);
  person.seconds += 0.2;
  person.tap({taper->x, border + 4});
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(person.count<command::Undo>(), 0);
}

TEST(Editor, ACheckboxIsOneStep) {
  PanelDriver person;
  const auto at = person.find(person.rowId("fins", "##value"));
  ASSERT_TRUE(at);
  person.click(*at);
  EXPECT_FALSE(person.model.settings.fins);
  ASSERT_EQ(person.commands.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<command::BeginChange>(person.commands[0]));
  EXPECT_TRUE(std::holds_alternative<command::EndChange>(person.commands[2]));
}

TEST(Editor, AnAnimationIsChosenByItsNameAndHeld) {
  PanelDriver person({1280, 6000});
  person.model.animations = {"wave", ""};
  person.openAllGroups();
  const auto at = person.find(person.rowId("animation", "##value"));
  ASSERT_TRUE(at);
  person.click(*at);
  ASSERT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1);
  const ImRect names = ImGui::GetCurrentContext()->OpenPopupStack[0].Window->Rect();
  person.click({names.GetCenter().x, names.Min.y + names.GetHeight() * 5 / 6});
  EXPECT_EQ(person.model.settings.animation, 2);
  // Its neighbour on the right.
  std::optional<Vec2> button;
  for (float x = at->x; x < at->x + 200 && !button; x += 6) {
    person.moveTo({x, at->y});
    if (ImGui::GetHoveredID() == person.rowId("animation", "###hold")) button = Vec2(x, at->y);
  }
  ASSERT_TRUE(button);
  person.click(*button);
  EXPECT_EQ(person.model.settings.animationSpeed, 0.0f);
  person.click(*button);
  EXPECT_EQ(person.model.settings.animationSpeed, 1.0f);
}

TEST(Editor, TheResetOfARowRestoresItsDefaultAlone) {
  PanelDriver person;
  EXPECT_FALSE(person.find(person.rowId("curl", "##reset"))) << "nothing to reset yet";
  person.model.settings.curl = 0.9f;
  person.model.settings.density = 0.1f;
  person.frames(2);
  const auto at = person.find(person.rowId("curl", "##reset"));
  ASSERT_TRUE(at);
  person.click(*at);
  EXPECT_EQ(differences(Settings{}, person.model.settings), std::set<std::string>{"density"});
  EXPECT_EQ(person.count<command::BeginChange>(), 1);
  EXPECT_EQ(person.count<command::EndChange>(), 1);
}

TEST(Editor, TheResetOfAGroupRestoresThatGroupAlone) {
  PanelDriver person;
  person.model.settings.curl = 0.9f;
  person.model.settings.density = 0.1f;
  person.model.settings.wind = 1;
  person.frames(2);
  const auto at = person.find(person.id("##resetFur"));
  ASSERT_TRUE(at);
  person.click(*at);
  EXPECT_EQ(differences(Settings{}, person.model.settings), std::set<std::string>{"wind"});
}

TEST(Editor, TheRightButtonOnARowOffersItsReset) {
  PanelDriver person;
  person.model.settings.curl = 0.9f;
  const auto at = person.find(person.rowId("curl", "##value"));
  ASSERT_TRUE(at);
  person.moveTo(*at, 2);
  person.moveTo(*at, 0);
  ASSERT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1);
  const ImRect menu = ImGui::GetCurrentContext()->OpenPopupStack[0].Window->Rect();
  person.click({menu.GetCenter().x, menu.Min.y + menu.GetHeight() * 0.25f});
  EXPECT_EQ(person.model.settings, Settings{});
}

TEST(Editor, TheSearchBoxNarrowsThePanelToMatchingFields) {
  PanelDriver person;
  const auto box = person.find(person.id("##filter"));
  ASSERT_TRUE(box);
  person.click(*box);
  EXPECT_TRUE(ImGui::GetIO().WantTextInput);
  person.input.text("GuST");
  person.settle();
  std::set<ImGuiID> hovered;
  for (const auto& [at, id] : person.sweep()) hovered.insert(id);
  for (const Field& field : settings::fields())
    EXPECT_EQ(hovered.count(person.valueId(field)), matchesFilter(field, "gust") ? 1u : 0u) << field.name;
}

TEST(Editor, AFilterLooksAtLabelNameAndGroup) {
  const Field& gust = *settings::findField("gust");
  EXPECT_TRUE(matchesFilter(gust, ""));
  EXPECT_TRUE(matchesFilter(gust, "gusts"));   // label
  EXPECT_TRUE(matchesFilter(gust, "MOTION"));  // group
  EXPECT_FALSE(matchesFilter(gust, "curl"));
}

TEST(Editor, TheLightIsDraggedToWhereThePointerIs) {
  PanelDriver person;
  person.openAllGroups();
  const auto pad = person.find(person.id("##lightPad"));
  ASSERT_TRUE(pad);
  const Settings before = person.model.settings;
  person.moveTo(*pad);
  person.moveTo(*pad, 1);
  person.moveTo(*pad + Vec2(500, 0), 1);
  person.moveTo(*pad + Vec2(500, 0), 0);
  // Far to the right of wherever the pad is: from +x, at the horizon. Half a pad off at 500 pixels is
  // less than 0.1 rad.
  EXPECT_NEAR(person.model.settings.lightYaw, kPi / 2, 0.1);
  EXPECT_NEAR(person.model.settings.lightPitch, settings::findField("lightPitch")->low, 1e-3);
  EXPECT_EQ(differences(before, person.model.settings), (std::set<std::string>{"lightPitch", "lightYaw"}));
  EXPECT_EQ(person.count<command::BeginChange>(), 1);
}

TEST(Editor, ALightRigIsChosenInOneStepAndLeavesTheCoatAlone) {
  PanelDriver person;
  person.openAllGroups();
  const auto combo = person.find(person.id("##lightRigs"));
  ASSERT_TRUE(combo);
  const Settings before = person.model.settings;
  person.click(*combo);
  person.settle();
  // The rows of the list, of which one more is below the other.
  const auto row = [&](int index) { return *combo + Vec2(0, (1.5f + static_cast<float>(index)) * ImGui::GetTextLineHeightWithSpacing()); };
  person.click(row(2));
  person.settle();
  EXPECT_NE(person.model.settings, before);
  const settings::LightRig* chosen = settings::lightRigOf(person.model.settings);
  ASSERT_TRUE(chosen) << "all of a rig at once";
  EXPECT_EQ(person.count<command::BeginChange>(), 1);
  for (const std::string& name : differences(before, person.model.settings)) EXPECT_TRUE(settings::belongsToLight(*settings::findField(name))) << name;
}

TEST(Editor, AnAnimalActsAtAClickAndOtherModelsHaveNoRowForIt) {
  PanelDriver person;
  const int second = 1;
  const ImGuiID sit = ImHashStr("sit", 0, ImHashData(&second, sizeof second, person.id("actions")));
  EXPECT_FALSE(person.find(sit));
  person.model.actions = {"stand", "sit", "groom"};
  person.model.action = "stand";
  person.settle();
  const auto at = person.find(sit);
  ASSERT_TRUE(at);
  person.click(*at);
  ASSERT_EQ(person.count<command::Act>(), 1);
  for (const Command& command : person.commands)
    if (const auto* act = std::get_if<command::Act>(&command)) EXPECT_EQ(act->action, "sit");
}

TEST(Editor, ColoursSurviveBeingShown) {
  PanelDriver person;
  person.model.settings.tipColor = 0x010280;
  person.openAllGroups();
  person.sweep();
  EXPECT_EQ(person.model.settings.tipColor, 0x010280u);
}

TEST(Editor, UndoAndRedoHaveTheirKeys) {
  const Modifiers control{false, true, false}, both{true, true, false};
  EXPECT_TRUE(std::holds_alternative<command::Undo>(*Editor::shortcut("z", control)));
  EXPECT_TRUE(std::holds_alternative<command::Redo>(*Editor::shortcut("Z", both)));
  EXPECT_TRUE(std::holds_alternative<command::Redo>(*Editor::shortcut("y", control)));
  EXPECT_FALSE(Editor::shortcut("z", {}));
  EXPECT_FALSE(Editor::shortcut("a", control));
}

TEST(Editor, OnANarrowScreenItLeavesTheModelInSight) {
  for (const float ratio : {1.0f, 2.0f, 3.0f}) {
    const Vec2 screen = Vec2(390, 844) * ratio;
    PanelDriver person(screen, {ratio, true});
    EXPECT_GE(person.panel()->Size.y, 0.3f * screen.y);
    EXPECT_LE(person.panel()->Size.y, 0.45f * screen.y);
    EXPECT_EQ(person.panel()->Rect().Max.y, screen.y);
    EXPECT_EQ(person.panel()->Size.x, screen.x);
  }
}

TEST(Editor, SavesAtOnceWhatIsSavedWhole) {
  PanelDriver person;
  person.press("Save scene (.glb)");
  EXPECT_EQ(person.count<command::SaveScene>(), 1);
  person.editor.setCollapsed(true);
  person.editor.save();  // the key
  person.frames(2);
  EXPECT_EQ(person.count<command::SaveScene>(), 2);
}

TEST(Editor, AsksWhenAKeySavesWithoutSomething) {
  PanelDriver person({1280, 600});
  person.model.lostBySaving = {"1 skin"};
  person.editor.setCollapsed(true);
  person.editor.save();
  person.frames(3);
  EXPECT_EQ(person.count<command::SaveScene>(), 0);
  person.press("Save anyway");
  EXPECT_EQ(person.count<command::SaveScene>(), 1);
}

TEST(Editor, AsksBeforeItSavesWithoutSomething) {
  PanelDriver person;
  person.model.lostBySaving = {"1 skin", "the animation \"walk 100 %s\""};
  person.press("Save scene (.glb)");
  EXPECT_EQ(person.count<command::SaveScene>(), 0);
  EXPECT_FALSE(person.find(person.id("Save scene (.glb)"))) << "it asks";
  person.press("Cancel");
  EXPECT_EQ(person.count<command::SaveScene>(), 0);
  person.press("Save scene (.glb)");
  person.press("Save anyway");
  EXPECT_EQ(person.count<command::SaveScene>(), 1);
  person.press("Save scene (.glb)");
  EXPECT_EQ(person.count<command::SaveScene>(), 1) << "it asks each time";
  person.model.lostBySaving.clear();  // another model
  person.frames(2);
  person.press("Save scene (.glb)");
  EXPECT_EQ(person.count<command::SaveScene>(), 2);
}

TEST(Editor, CollapsedItIsATitleOnly) {
  PanelDriver person({1280, 800});
  const float open = person.panel()->Size.y;
  person.editor.setCollapsed(true);
  person.frames(2);
  EXPECT_LT(person.panel()->Size.y, 0.1f * open);
}

TEST(Editor, AFingerGetsLargerTargets) {
  PanelDriver mouse({1280, 800}, {1, false});
  const float small = ImGui::GetFrameHeight();
  PanelDriver finger({1280, 800}, {1, true});
  EXPECT_GE(ImGui::GetFrameHeight(), 1.3f * small);
}

TEST(Theme, TheFontIsBuiltAgainOnlyForANewPixelRatio) {
  PanelDriver person;
  EXPECT_FALSE(applyTheme({1, false}));
  EXPECT_FALSE(applyTheme({1, true}));
  EXPECT_TRUE(applyTheme({2, true}));
  EXPECT_FALSE(applyTheme({2, true}));
}

}  // namespace
}  // namespace fur::editor
