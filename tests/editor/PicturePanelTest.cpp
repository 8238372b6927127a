#include "editor/PicturePanel.h"

#include "tests/editor/PanelDriver.h"

namespace fur::editor {
namespace {

struct PicturePerson : PanelDriver {
  PicturePerson() {
    model.picture.shownWidth = 1280;
    model.picture.shownHeight = 800;
    openGroup("Picture");
  }
  void choose(const char* row, int segment, const char* one) { pressSegment(id(row), segment, one); }
  void write(const char* field, const char* text) {
    const auto at = find(id(field));
    ASSERT_TRUE(at) << field;
    doubleClick(*at);
    pressKey("Backspace");
    type(text);
    pressKey("Enter");
  }
};

TEST(PicturePanel, APictureIsAsLargeAsWhatIsSeenUntilAnotherSizeIsChosen) {
  PicturePerson person;
  person.press("Save picture (.png)");
  const auto* seen = person.last<command::SavePicture>();
  ASSERT_TRUE(seen);
  EXPECT_EQ(std::pair(seen->width, seen->height), std::pair(1280, 800));
  EXPECT_FALSE(seen->transparent);
  person.choose("pictureSizes", 2, "4K");
  person.press("Transparent background");
  person.press("Save picture (.png)");
  const auto* large = person.last<command::SavePicture>();
  EXPECT_EQ(std::pair(large->width, large->height), std::pair(3840, 2160));
  EXPECT_TRUE(large->transparent);
}

TEST(PicturePanel, NumbersOfOnesOwnAreTakenUpToWhatTheMachineDraws) {
  PicturePerson person;
  person.model.picture.mostSide = 4096;
  person.write("##pictureWidth", "4096");
  person.press("Save picture (.png)");
  ASSERT_TRUE(person.last<command::SavePicture>());
  EXPECT_EQ(person.last<command::SavePicture>()->width, 4096);
  EXPECT_EQ(person.last<command::SavePicture>()->height, 800);
  person.commands.clear();
  person.write("##pictureWidth", "4097");
  person.press("Save picture (.png)");
  EXPECT_EQ(person.last<command::SavePicture>(), nullptr);
}

TEST(PicturePanel, ATurnGoesTheWayAndTakesTheTimeThatWasChosen) {
  PicturePerson person;
  person.model.fileAccess = FileAccess::Path;
  person.press("###turn");
  ASSERT_TRUE(person.last<command::TurnOnce>());
  EXPECT_EQ(person.last<command::TurnOnce>()->secondsPerTurn, 12);
  person.choose("turnWays", 1, "Left");
  person.press("Save frames (.png)");
  ASSERT_TRUE(person.last<command::SaveTurntable>());
  EXPECT_EQ(person.last<command::SaveTurntable>()->secondsPerTurn, -12);
}

TEST(PicturePanel, WhileOneIsDrawnOnlyToStopItIsOffered) {
  PicturePerson person;
  person.model.picture.busy = true;
  person.frames(2);
  EXPECT_FALSE(person.find(person.id("Save picture (.png)")));
  person.press("Save scene (.glb)");
  EXPECT_EQ(person.count<command::SaveScene>(), 0) << "the scene stands still";
  person.press("Cancel");
  EXPECT_EQ(person.count<command::StopPicture>(), 1);
}

}  // namespace
}  // namespace fur::editor
