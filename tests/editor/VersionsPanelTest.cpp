#include "editor/VersionsPanel.h"

#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

struct VersionsPerson : PanelDriver {
  std::vector<VersionView> kept{{"b", "Wet", "today"}, {"a", "Dry", "yesterday"}};
  VersionsPerson() {
    model.versions = kept;
    openGroup("Versions");
  }
};

TEST(VersionsPanel, KeepsUnderTheNameThatWasTypedOrTheNextNumber) {
  VersionsPerson person;
  person.press("Keep");
  ASSERT_TRUE(person.last<command::KeepVersion>());
  EXPECT_EQ(person.last<command::KeepVersion>()->name, "Version 3");
  const auto field = person.find(person.id("##versionName"));
  ASSERT_TRUE(field);
  person.click(*field);
  person.type("Ötter: 50 % \"wet\" / 乾");
  person.press("Keep");
  EXPECT_EQ(person.last<command::KeepVersion>()->name, "Ötter: 50 % \"wet\" / 乾");
}

TEST(VersionsPanel, GoesBackToTheOneWhoseButtonWasPressed) {
  VersionsPerson person;
  person.pressSegmentOf("a", "buttons", 0, "Go back");
  ASSERT_TRUE(person.last<command::OpenVersion>());
  EXPECT_EQ(person.last<command::OpenVersion>()->id, "a");
}

TEST(VersionsPanel, DeletesOnlyAfterItHasAsked) {
  VersionsPerson person;
  person.pressSegmentOf("b", "buttons", 2, "Delete");
  EXPECT_EQ(person.count<command::DeleteVersion>(), 0);
  person.pressSegmentOf("b", "answers", 1, "Cancel");
  EXPECT_EQ(person.count<command::DeleteVersion>(), 0);
  person.pressSegmentOf("b", "buttons", 2, "Delete");
  person.pressSegmentOf("b", "answers", 0, "Delete");
  ASSERT_EQ(person.count<command::DeleteVersion>(), 1);
  EXPECT_EQ(person.last<command::DeleteVersion>()->id, "b");
}

TEST(VersionsPanel, RenamesByTypingOverTheOldName) {
  VersionsPerson person;
  person.pressSegmentOf("a", "buttons", 1, "Rename");
  person.frames(3);
  person.type("Fluffy");
  person.pressKey("Enter");
  ASSERT_TRUE(person.last<command::RenameVersion>());
  EXPECT_EQ(person.last<command::RenameVersion>()->id, "a");
  EXPECT_EQ(person.last<command::RenameVersion>()->name, "Fluffy");
}

TEST(VersionsPanel, ANameHasEightyCharactersOfAnyScript) {
  std::string longName;
  for (int i = 0; i < 100; ++i) longName += "乾";
  EXPECT_EQ(nameFrom(longName.c_str()).size(), 3u * 80);
  EXPECT_EQ(nameFrom("  a b  "), "a b");
  EXPECT_EQ(nameFrom("   "), "");
}

}  // namespace
}  // namespace fur::editor
