#include "editor/PanelLayout.h"

#include <gtest/gtest.h>

#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

struct LayoutPerson : PanelDriver {
  explicit LayoutPerson(Vec2 screen = {1280, 800}, ThemeScale scale = {}) : PanelDriver(screen, scale) {}
  ImRect rect() const { return panel()->Rect(); }
  void drag(Vec2 from, Vec2 by) {
    seconds += 10;
    moveTo(from);
    moveTo(from, 1);
    moveTo(from + by * 0.5f, 1);
    moveTo(from + by, 1);
    moveTo(from + by, 0);
  }
  Vec2 edge() const { return {rect().Min.x + 5, rect().GetCenter().y}; }
  Vec2 title() const { return {rect().Min.x + 60, rect().Min.y + 20}; }
};

TEST(PanelLayout, TheColumnIsDraggedWiderByItsEdge) {
  for (const float ratio : {1.0f, 2.0f}) {
    LayoutPerson person(Vec2(1280, 800) * ratio, {ratio, false});
    const ImRect before = person.rect();
    person.drag(person.edge(), Vec2(-100, 0) * ratio);
    EXPECT_EQ(person.rect().Min.x, before.Min.x - 100 * ratio);
    EXPECT_EQ(person.rect().Max.x, before.Max.x);
    EXPECT_FLOAT_EQ(person.editor.covered().x, (1280 * ratio - person.rect().Min.x) / (1280 * ratio));
    EXPECT_EQ(person.editor.layout(), "width 436 sheet 0.450");
    EXPECT_TRUE(person.commands.empty());
  }
}

TEST(PanelLayout, ThePictureAndTheRowsKeepTheirRoom) {
  LayoutPerson person;
  person.drag(person.edge(), {-2000, 0});
  EXPECT_LE(person.editor.covered().x, 0.6f);
  EXPECT_GE(person.editor.covered().x, 0.5f);
  person.drag(person.edge(), {2000, 0});
  EXPECT_EQ(person.rect().GetWidth(), 280);
}

TEST(PanelLayout, ADoubleClickOnTheEdgeGivesTheFirstWidthBack) {
  LayoutPerson person;
  person.drag(person.edge(), {-100, 0});
  person.doubleClick(person.edge());
  EXPECT_EQ(person.rect().GetWidth(), 336);
}

TEST(PanelLayout, TheEdgeFollowsTheArrowKeysWhileItHasTheFocus) {
  LayoutPerson person;
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  ImGuiContext& context = *ImGui::GetCurrentContext();
  ImGui::FocusWindow(person.panel());
  ImGui::SetNavID(person.panel()->GetID("##edge"), ImGuiNavLayer_Main, 0, ImRect(0, 0, 12, 700));
  context.NavDisableHighlight = false;
  person.pressKey("ArrowLeft");
  EXPECT_EQ(person.rect().GetWidth(), 352);
  person.pressKey("ArrowRight");
  person.pressKey("ArrowRight");
  EXPECT_EQ(person.rect().GetWidth(), 320);
  EXPECT_EQ(context.NavId, person.panel()->GetID("##edge"));
}

struct PhonePerson : LayoutPerson {
  explicit PhonePerson() : LayoutPerson({390, 844}, {1, true}) {}
};

TEST(PanelLayout, TheSheetIsDraggedHigherByItsTitle) {
  PhonePerson person;
  person.editor.setCollapsed(false);
  person.frames(3);
  const float before = person.rect().GetHeight();
  person.drag(person.title(), {0, -80});
  EXPECT_NEAR(person.rect().GetHeight(), before + 80, 1);
  EXPECT_EQ(person.rect().Max.y, 844);
  EXPECT_NEAR(person.editor.covered().y, person.rect().GetHeight() / 844, 1e-3f);
  person.drag(person.title(), {0, -800});
  EXPECT_NEAR(person.rect().GetHeight(), 0.6f * 844, 1) << "the model stays in sight";
}

TEST(PanelLayout, TheSheetClosesWhenItIsDraggedDownAndOpensWhenItIsDraggedUp) {
  PhonePerson person;
  const float open = person.rect().GetHeight();
  person.drag(person.title(), {0, 700});
  const float closed = person.rect().GetHeight();
  EXPECT_LT(closed, open - 200);
  EXPECT_EQ(person.editor.covered(), Vec2(0));
  person.drag(person.title(), {0, -300});
  EXPECT_GT(person.rect().GetHeight(), closed + 200);
}

TEST(PanelLayout, ATapOnTheSheetsTitleClosesAndOpensIt) {
  PhonePerson person;
  const float open = person.rect().GetHeight();
  person.tap(person.title());
  EXPECT_LT(2 * person.rect().GetHeight(), open);
  person.seconds += 10;
  person.tap(person.title());
  EXPECT_EQ(person.rect().GetHeight(), open);
}

TEST(PanelLayout, ItsSizesAreKeptAsAText) {
  LayoutPerson person;
  person.drag(person.edge(), {-64, 0});
  LayoutPerson another;
  another.editor.setLayout(person.editor.layout());
  another.frames(3);
  EXPECT_EQ(another.rect().GetWidth(), 400);
}

TEST(PanelLayout, TextsThatAreNoneOfItsOwnChangeNothingOrAreClamped) {
  PanelLayout layout;
  const std::string first = layout.text();
  for (const char* text : {"", "nonsense", "width", "width 0 sheet 0", "width nan sheet nan", "width -5 sheet 0.3"}) {
    layout.read(text);
    EXPECT_EQ(layout.text(), first) << text;
  }
  layout.read("width 99999 sheet 7");
  EXPECT_EQ(layout.text(), "width 720 sheet 0.600");
}

TEST(PanelLayout, ANarrowerScreenKeepsItsShareOfAWidePanel) {
  LayoutPerson person({700, 800});
  person.editor.setLayout("width 720 sheet 0.4");
  person.frames(3);
  EXPECT_LE(person.editor.covered().x, 0.6f);
  EXPECT_EQ(person.editor.layout(), "width 720 sheet 0.400") << "it is wide again on a wide one";
}

}  // namespace
}  // namespace fur::editor
