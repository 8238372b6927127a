#include "editor/CoatPanel.h"

#include <gtest/gtest.h>

#include <set>

#include "settings/FurTypes.h"
#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

using settings::Settings;

constexpr Vec2 kTall{1280, 3000};
constexpr const char* kPictures = "Tile, layer by layer";

const std::vector<float>& shares(int layers) {
  static std::vector<float> list;
  list.assign(static_cast<std::size_t>(layers), 0.25f);
  return list;
}

// A person who looks at a coat of 32 layers.
struct CoatPerson : PanelDriver {
  explicit CoatPerson(Vec2 screen = kTall, ThemeScale scale = {}) : PanelDriver(screen, scale) {
    editor.setCollapsed(false);
    model.coat.coverage = shares(32);
    model.coat.tileSize = 256;
    frames(3);
  }
  void setOpen(const char* group, bool open) {
    content()->StateStorage.SetInt(content()->GetID(group), open ? 1 : 0);
    frames(3);
  }
  // Opens the combo and chooses the item with that text.
  void choose(const char* combo, const char* item) {
    const auto at = find(id(combo));
    ASSERT_TRUE(at) << combo;
    click(*at);
    ImGuiContext& context = *ImGui::GetCurrentContext();
    ASSERT_EQ(context.OpenPopupStack.Size, 1);
    ImGuiWindow* list = context.OpenPopupStack[0].Window;
    for (float y = list->Rect().Min.y; y < list->Rect().Max.y; y += 4) {
      moveTo({list->Rect().GetCenter().x, y});
      if (ImGui::GetHoveredID() == list->GetID(item)) return click({list->Rect().GetCenter().x, y});
    }
    FAIL() << item << " is not in the list";
  }
  // An item on the same line as another.
  std::optional<Vec2> findBeside(const char* other, const char* item) {
    const auto line = find(id(other));
    for (float x = panel()->Rect().Min.x; line && x < panel()->Rect().Max.x; x += 5) {
      moveTo({x, line->y});
      if (ImGui::GetHoveredID() == id(item)) return Vec2(x, line->y);
    }
    return {};
  }
  TileView shown() const { return editor.shownTile().value_or(TileView{-1, TileChannel::Coverage}); }
  std::size_t pictureHash() {
    std::string all;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
      const auto& vertices = data.CmdLists[i]->VtxBuffer;
      all.append(reinterpret_cast<const char*>(vertices.Data), static_cast<std::size_t>(vertices.size_in_bytes()));
    }
    return std::hash<std::string>()(all);
  }
};

TEST(CoatPanel, AChosenPresetIsOneCommand) {
  CoatPerson person;
  person.choose("##preset", "Wool");
  ASSERT_EQ(person.commands.size(), 1u);
  EXPECT_EQ(std::get<command::ApplyPreset>(person.commands[0]).name, "wool");
  EXPECT_EQ(settings::presetOf(person.model.settings), settings::findPreset("wool"));
}

TEST(CoatPanel, EveryPresetCanBeChosen) {
  CoatPerson person({800, 700});
  for (const settings::Preset& preset : settings::presets()) {
    person.choose("##preset", preset.label);
    EXPECT_EQ(settings::presetOf(person.model.settings), &preset) << preset.name;
  }
}

// A person with two coats of their own.
struct CoatOwner : CoatPerson {
  std::vector<OwnCoatView> own{{"fox.coat", "Winter fox"}, {"cloud.coat", "Cloud"}};
  CoatOwner() {
    model.ownCoats = own;
    setOpen("Own coats", true);
  }
};

TEST(CoatPanel, CoatsOfOnesOwnAreInTheListOfPresetsAndInOneOfTheirOwn) {
  CoatOwner person;
  const auto combo = person.find(person.id("##preset"));
  ASSERT_TRUE(combo);
  person.click(*combo);
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ASSERT_EQ(context.OpenPopupStack.Size, 1);
  ImGuiWindow* list = context.OpenPopupStack[0].Window;
  const ImGuiID fox = ImHashStr("Winter fox", 0, list->GetID("fox.coat"));
  bool found = false;
  for (float y = list->Rect().Min.y; y < list->Rect().Max.y && !found; y += 4) {
    person.moveTo({list->Rect().GetCenter().x, y});
    if ((found = ImGui::GetHoveredID() == fox)) person.click({list->Rect().GetCenter().x, y});
  }
  ASSERT_TRUE(found);
  ASSERT_TRUE(person.last<command::WearCoat>());
  EXPECT_EQ(person.last<command::WearCoat>()->id, "fox.coat");
  person.pressSegmentOf("cloud.coat", "buttons", 0, "Wear");
  EXPECT_EQ(person.last<command::WearCoat>()->id, "cloud.coat");
  person.pressSegmentOf("cloud.coat", "buttons", 1, "File");
  EXPECT_EQ(person.last<command::SaveOwnCoat>()->id, "cloud.coat");
}

TEST(CoatPanel, ACoatIsKeptUnderTheNameOfItsTypeOrTheNextNumber) {
  CoatOwner person;
  person.press("Keep##coat");
  ASSERT_TRUE(person.last<command::KeepCoat>());
  EXPECT_EQ(person.last<command::KeepCoat>()->name, "Coat 3");
  settings::setTypeName(person.model.settings, 0, "Snow");
  person.press("Keep##coat");
  EXPECT_EQ(person.last<command::KeepCoat>()->name, "Snow");
}

TEST(CoatPanel, ACoatIsDeletedOnlyAfterItHasAskedAndRenamedByTyping) {
  CoatOwner person;
  person.pressSegmentOf("fox.coat", "buttons", 3, "Delete");
  EXPECT_EQ(person.count<command::DeleteCoat>(), 0);
  person.pressSegmentOf("fox.coat", "answers", 0, "Delete");
  ASSERT_EQ(person.count<command::DeleteCoat>(), 1);
  person.pressSegmentOf("cloud.coat", "buttons", 2, "Rename");
  person.frames(3);
  person.type("Storm");
  person.pressKey("Enter");
  ASSERT_TRUE(person.last<command::RenameCoat>());
  EXPECT_EQ(person.last<command::RenameCoat>()->id, "cloud.coat");
  EXPECT_EQ(person.last<command::RenameCoat>()->name, "Storm");
}

TEST(CoatPanel, TheSeedIsSteppedAndKeptInItsRange) {
  CoatPerson person;
  const auto lower = person.findBeside("##seed", "##lower"), higher = person.findBeside("##seed", "##higher");
  ASSERT_TRUE(lower && higher);
  person.click(*higher);
  EXPECT_EQ(person.model.settings.seed, Settings{}.seed + 1);
  EXPECT_EQ(person.count<command::BeginChange>(), 1);
  EXPECT_EQ(person.count<command::EndChange>(), 1);
  for (int i = 0; i < 4; ++i) person.click(*lower);
  EXPECT_EQ(person.model.settings.seed, 0);
  person.model.settings.seed = 65535;
  person.click(*higher);
  EXPECT_EQ(person.model.settings.seed, 65535);
}

TEST(CoatPanel, TheDiceGiveASeedThatHasNotBeenThere) {
  CoatPerson person;
  const auto dice = person.find(person.id("##dice"));
  ASSERT_TRUE(dice);
  std::set<int> seeds{person.model.settings.seed};
  for (int i = 0; i < 40; ++i) {
    person.click(*dice);
    EXPECT_TRUE(seeds.insert(person.model.settings.seed).second) << person.model.settings.seed;
    EXPECT_GE(person.model.settings.seed, 0);
    EXPECT_LE(person.model.settings.seed, 65535);
  }
  EXPECT_EQ(person.count<command::EndChange>(), 40) << "each throw is an undo step";
}

TEST(CoatPanel, TheUprightSliderLeadsFromSkinToTip) {
  CoatPerson person;
  const auto at = person.find(person.id("##layer"));
  ASSERT_TRUE(at);
  EXPECT_EQ(person.shown().layer, 16) << "half way up at first";
  person.moveTo(*at, 1);
  person.moveTo({at->x, 0}, 1);
  EXPECT_EQ(person.shown().layer, 31);
  person.moveTo({at->x, 2900}, 1);
  EXPECT_EQ(person.shown().layer, 0);
  EXPECT_TRUE(person.commands.empty()) << "looking changes nothing";
}

TEST(CoatPanel, APressOnTheCoverageShowsThatLayer) {
  CoatPerson person;
  const auto at = person.find(person.id("##coverage"));
  ASSERT_TRUE(at);
  person.moveTo(*at, 1);
  const int top = person.shown().layer;
  EXPECT_GE(top, 29) << "the first spot from above";
  person.moveTo({at->x, 2900}, 1);
  EXPECT_EQ(person.shown().layer, 0);
}

TEST(CoatPanel, TheShownHeightStaysWhenTheNumberOfLayersChanges) {
  CoatPerson person;
  const auto at = person.find(person.id("##layer"));
  ASSERT_TRUE(at);
  person.moveTo(*at, 1);
  person.moveTo({at->x, 0}, 1);
  person.moveTo({at->x, 0}, 0);
  person.model.coat.coverage = shares(8);
  person.frames(2);
  EXPECT_EQ(person.shown().layer, 7);
  person.model.coat.coverage = shares(128);
  person.frames(2);
  EXPECT_EQ(person.shown().layer, 127);
  person.model.coat.coverage = {};
  person.frames(2);
  EXPECT_EQ(person.shown().layer, 0);
}

TEST(CoatPanel, AChannelIsChosenByItsName) {
  CoatPerson person;
  EXPECT_EQ(person.shown().channel, TileChannel::Coverage);
  person.choose("##channel", "Tangent");
  EXPECT_EQ(person.shown().channel, TileChannel::Tangent);
}

TEST(CoatPanel, AsksForNoPictureWhileTheyAreClosed) {
  CoatPerson person;
  EXPECT_TRUE(person.editor.shownTile());
  person.setOpen(kPictures, false);
  EXPECT_FALSE(person.editor.shownTile());
  person.setOpen(kPictures, true);
  EXPECT_TRUE(person.editor.shownTile());
  person.setOpen("Coat", false);
  EXPECT_FALSE(person.editor.shownTile());
  person.setOpen("Coat", true);
  person.editor.setCollapsed(true);
  person.frames(2);
  EXPECT_FALSE(person.editor.shownTile());
}

TEST(CoatPanel, LeavesThePicturesClosedWhereRoomIsShort) {
  EXPECT_TRUE(CoatPerson({1280, 1300}).editor.shownTile());
  EXPECT_FALSE(CoatPerson({1280, 800}).editor.shownTile());
  EXPECT_FALSE(CoatPerson({390, 844}, {1, true}).editor.shownTile());
  EXPECT_FALSE(CoatPerson({1280, 1300}, {2, false}).editor.shownTile()) << "650 CSS pixels high";
}

TEST(CoatPanel, ShowsProgressOnlyWhenGrowingTakesItsTime) {
  CoatPerson person;
  const auto still = person.pictureHash();
  person.model.coat.progress = 0.4f;
  person.frames(25);  // at 1/60 s
  EXPECT_EQ(person.pictureHash(), still) << "not within half a second";
  person.frames(10);
  EXPECT_NE(person.pictureHash(), still);
  person.model.coat.progress = 1;
  person.frames(1);
  EXPECT_EQ(person.pictureHash(), still);
  person.model.coat.progress = 0.9f;
  person.frames(10);
  EXPECT_EQ(person.pictureHash(), still) << "the next one counts anew";
  for (int i = 0; i < 10; ++i) {
    ++person.model.coat.revision;
    person.frames(10);
  }
  EXPECT_EQ(person.pictureHash(), still) << "coat after coat, as a slider is dragged: none of them is slow";
}

TEST(CoatPanel, SavingIsLeftToTheProgram) {
  CoatPerson person;
  const auto typeSet = person.find(person.id("Save coat (.fts)")), fo = person.find(person.id("Save model (.fo)"));
  ASSERT_TRUE(typeSet && fo);
  person.click(*typeSet);
  person.click(*fo);
  EXPECT_EQ(person.count<command::SaveTypeSet>(), 1);
  EXPECT_EQ(person.count<command::SaveFo>(), 1);
}

TEST(CoatPanel, AFingerOnThePicturesScrolls) {
  CoatPerson person({390, 844}, {1, true});
  person.setOpen(kPictures, true);
  const ImRect rect = person.panel()->Rect();
  const Vec2 at(rect.Min.x + 100, rect.GetCenter().y);
  // The tile comes to the middle of the sheet.
  person.moveTo(at);
  for (int i = 0; i < 13; ++i) person.input.wheel(-1);
  person.settle();
  person.input.pointerGone();
  person.settle();
  const float before = person.content()->Scroll.y;
  const TileView view = person.shown();
  person.input.pointer(PointerKind::Touch, at, 1);
  person.settle();
  EXPECT_EQ(ImGui::GetActiveID(), person.content()->MoveId);
  person.input.pointer(PointerKind::Touch, at - Vec2(0, 40), 1);
  person.settle();
  EXPECT_NEAR(person.content()->Scroll.y, before + 40, 1);
  EXPECT_EQ(person.shown(), view);
}

TEST(CoatPanel, LiesStillAndInsideThePanelOnScreensOfAnyHeight) {
  // A scrollbar that narrows what makes it necessary would come and go for ever.
  for (const float ratio : {1.0f, 2.0f})
    for (float height = 300; height < 1500; height += 37) {
      CoatPerson person(Vec2(1280, height) * ratio, {ratio, false});
      person.setOpen(kPictures, true);
      const auto first = person.pictureHash();
      person.frames(1);
      ASSERT_EQ(person.pictureHash(), first) << height;
      ASSERT_EQ(person.content()->ScrollMax.x, 0) << height;
      ASSERT_LE(person.content()->ContentSize.x, person.content()->Size.x) << height;
    }
}

}  // namespace
}  // namespace fur::editor
