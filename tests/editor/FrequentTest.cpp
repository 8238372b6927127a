#include "editor/Frequent.h"

#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

using settings::findField;

ImGuiID rowIn(const PanelDriver& person, const char* field) {
  return ImHashStr("##value", 0, ImHashStr(field, 0, person.content()->GetID("frequent")));
}

void rightClick(PanelDriver& person, Vec2 at) {
  person.moveTo(at);
  person.moveTo(at, 2);
  person.moveTo(at, 0);
}

// The entry of the row's menu that is open at `at`.
void choose(PanelDriver& person, const char* entry) {
  ImGuiWindow* menu = nullptr;
  for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
    if (window->WasActive && (window->Flags & ImGuiWindowFlags_Popup)) menu = window;
  ASSERT_TRUE(menu) << "no menu is open";
  const ImRect rect = menu->Rect();
  for (float y = rect.Min.y + 3; y < rect.Max.y; y += 4) {
    const Vec2 at(rect.Min.x + 0.3f * rect.GetWidth(), y);
    person.moveTo(at);
    if (ImGui::GetHoveredID() == menu->GetID(entry)) return person.click(at);
  }
  FAIL() << entry;
}

TEST(Frequent, ARowIsAddedAndRemovedByItsMenuAndStaysForTheNextTime) {
  PanelDriver person({1280, 4600});
  person.openAllGroups();
  EXPECT_FALSE(person.find(rowIn(person, "wave")));
  const auto own = person.find(person.rowId("wave", "##value"));
  ASSERT_TRUE(own);
  rightClick(person, *own);
  choose(person, "Add to frequently used");
  EXPECT_TRUE(person.find(rowIn(person, "wave")));
  EXPECT_EQ(person.editor.layout(), "width 336 sheet 0.450 frequent brushRadius,clump,curl,density,furLength,rootColor,thickness,tipColor,wave");

  PanelDriver later({1280, 4600});
  later.editor.setLayout(person.editor.layout());
  later.frames(3);
  const auto there = later.find(rowIn(later, "wave"));
  ASSERT_TRUE(there);
  rightClick(later, *there);
  choose(later, "Remove from frequently used");
  EXPECT_FALSE(later.find(rowIn(later, "wave")));
  EXPECT_EQ(later.editor.layout(), "width 336 sheet 0.450") << "as the table has it";
}

TEST(Frequent, AFingerThatIsHeldOnARowsNameOpensItsMenu) {
  PanelDriver person({1280, 3000});
  const auto row = person.find(rowIn(person, "curl"));
  ASSERT_TRUE(row);
  const Vec2 name(person.panel()->Pos.x + 30, row->y);
  person.input.pointer(PointerKind::Touch, name, 1, 50);
  person.settle();
  person.frames(20);
  EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 0);
  person.frames(15);
  EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1);
  person.input.pointer(PointerKind::Touch, name, 0, 51);
  person.settle();
  EXPECT_EQ(ImGui::GetCurrentContext()->OpenPopupStack.Size, 1) << "it stays when the finger is lifted";
}

TEST(Frequent, TextsThatAreNoneOfOursAreReadAsWellAsCanBe) {
  Frequent frequent;
  frequent.read("width 300 sheet 0.4");
  EXPECT_TRUE(frequent.isStandard());
  frequent.read("frequent curl,,no such,density, curl");
  EXPECT_TRUE(frequent.has(*findField("curl")));
  EXPECT_FALSE(frequent.has(*findField("furLength")));
  frequent.read("width 300 sheet 0.4 frequent ");
  EXPECT_TRUE(frequent.empty());
  Frequent again;
  again.read(frequent.text());
  EXPECT_TRUE(again.empty()) << "none is kept, too";
}

}  // namespace
}  // namespace fur::editor
