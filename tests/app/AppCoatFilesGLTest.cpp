// Coats of one's own and pictures of skin and types, as a whole program has them.
#include <gtest/gtest.h>

#include "app/App.h"
#include "render/Frame.h"
#include "scene/CoatFile.h"
#include "scene/Png.h"
#include "settings/FurTypes.h"
#include "settings/Presets.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct WearingRoom : test::Room {
  WearingRoom() : Room(48, {{"layers", "8"}, {"tileSize", "64"}, {"breath", "0"}, {"ground", "false"}}) { app.settle(); }
  auto picture() { return settled().rgba; }
};

using test::OneColor, test::meanChannel;

TEST(AppCoats, ASavedCoatBringsAllOfItToAnyTypeInOneStepOfUndo) {
  WearingRoom from;
  from.app.applyPreset("persian");
  from.app.setField("curl", "0.7");
  from.app.setField("type1.name", "Cloud");
  const OneColor red({255, 0, 0, 255});
  ASSERT_TRUE(from.app.setTypePicture(0, red.png, 1, 1, red.rgba));
  const auto file = from.app.saveCoat();
  const settings::Settings coat = from.app.settings();

  for (const int type : {0, 2}) {
    WearingRoom room;
    const std::string before = room.app.state();
    ASSERT_TRUE(room.app.loadTypeSet(file, "cloud.coat", type));
    const settings::Settings worn = settings::typeCoat(room.app.settings(), type);
    for (const settings::Field& field : settings::fields())
      if (field.has(settings::kOfType)) {
        EXPECT_EQ(field.get(worn), field.get(coat)) << field.name;
      }
    EXPECT_EQ(settings::typeName(room.app.settings(), type), "Cloud");
    ASSERT_EQ(room.app.pendingPictures().size(), 1u);
    EXPECT_EQ(room.app.typePicture(room.app.pendingPictures()[0]).bytes, red.png);
    ASSERT_TRUE(room.app.undo());
    EXPECT_EQ(room.app.state(), before);
  }
}

TEST(AppCoats, ASavedCoatHasTheStrandsOfItsFile) {
  WearingRoom room;
  const auto strands = room.app.saveTypeSet();
  ASSERT_TRUE(room.app.loadTypeSet(strands, "coat.fts"));
  const auto drawn = room.picture();
  const auto file = room.app.saveCoat("Traced");
  room.app.applyPreset("wool");
  EXPECT_FALSE(room.app.coatGiven());
  ASSERT_TRUE(room.app.loadTypeSet(file, "traced.coat"));
  EXPECT_TRUE(room.app.coatGiven());
  EXPECT_EQ(room.picture(), drawn);
  EXPECT_EQ(room.app.saveTypeSet(), strands);
}

TEST(AppCoats, ACoatWithoutFilesTakesThoseOfTheCoatBeforeAway) {
  WearingRoom room;
  const auto plain = room.app.saveCoat("Plain");
  const OneColor red({255, 0, 0, 255});
  ASSERT_TRUE(room.app.setTypePicture(1, red.png, 1, 1, red.rgba));
  ASSERT_TRUE(room.app.loadTypeSet(plain, "plain.coat", 1));
  EXPECT_EQ(room.app.settings().typePictures[1], 0u);
  EXPECT_TRUE(settings::isOwn(room.app.settings(), 1));
}

TEST(AppCoats, HostileOnesAreTypedErrorsAndNothingIsLost) {
  WearingRoom room;
  room.app.applyPreset("otter");
  const std::string state = room.app.state();
  const auto picture = room.picture();
  const auto refused = [&](const std::string& text, ErrorId id) {
    for (const int type : {0, 3}) {
      const Status status = room.app.loadTypeSet(std::vector<std::uint8_t>(text.begin(), text.end()), "bad.coat", type);
      ASSERT_FALSE(status) << text.substr(0, 64);
      EXPECT_EQ(status.error().id, id) << status.error().message;
      EXPECT_NE(status.error().message.find("bad.coat"), std::string::npos) << status.error().message;
    }
  };
  refused("{", ErrorId::BadFile);
  refused("{}", ErrorId::BadFile);
  refused(R"({"wetFurCoat":9})", ErrorId::UnsupportedVersion);
  refused(R"({"wetFurCoat":1,"typeSet":"AAAA"})", ErrorId::BadFile);  // no .fts
  refused(R"({"wetFurCoat":1,"picture":"AAAA"})", ErrorId::BadFile);
  refused(R"({"wetFurCoat":1,"name":")" + std::string(1000, 'n') + "\"}", ErrorId::TooLarge);
  EXPECT_EQ(room.app.state(), state);
  EXPECT_EQ(room.picture(), picture);
}

// Skin of a colour that no coat has.
const OneColor kGreen({0, 255, 0, 255});

TEST(AppSkinPicture, ColoursTheSkinWhereItIsSeenAndUndoTakesItAway) {
  for (const char* technique : {"march", "shells"}) {
    WearingRoom room;
    room.app.setField("technique", technique);
    room.app.setField("density", "0.1");
    // Of the same shaders: a picture that is clear.
    ASSERT_TRUE(room.app.usePicture(PictureUse::Skin, "clear.png", 1, 1, OneColor({0, 255, 0, 0}).rgba));
    const auto before = room.picture();
    ASSERT_TRUE(room.app.usePicture(PictureUse::Skin, "skin.png", 1, 1, kGreen.rgba));
    const auto after = room.picture();
    EXPECT_GT(meanChannel(after, 1) - meanChannel(after, 0), meanChannel(before, 1) - meanChannel(before, 0) + 1) << technique;
    ASSERT_TRUE(room.app.undo());
    EXPECT_EQ(room.picture(), before) << technique;
    ASSERT_TRUE(room.app.redo());
    EXPECT_EQ(room.picture(), after) << technique;
  }
}

TEST(AppSkinPicture, IsSeenOnBareSkinAndInBaldPlacesToo) {
  for (const auto& [name, value] : {std::pair("view", "skin"), std::pair("density", "0")}) {
    WearingRoom room;
    room.app.setField(name, value);
    ASSERT_TRUE(room.app.usePicture(PictureUse::Skin, "skin.png", 1, 1, kGreen.rgba));
    const test::Picture picture = room.settled();
    EXPECT_GT(picture.at(24, 24)[1], picture.at(24, 24)[0] + 40) << name;
  }
  WearingRoom room;
  room.app.groomAll(GroomEdit::Length, 0);
  ASSERT_TRUE(room.app.usePicture(PictureUse::Skin, "skin.png", 1, 1, kGreen.rgba));
  const test::Picture bald = room.settled();
  EXPECT_GT(bald.at(24, 24)[1], bald.at(24, 24)[0] + 40);
}

TEST(AppSkinPicture, LeavesTheSkinAsItIsWhereItIsClear) {
  WearingRoom room;
  room.app.setField("view", "skin");
  const test::Picture before = room.settled();
  const OneColor clear({0, 255, 0, 0});
  ASSERT_TRUE(room.app.usePicture(PictureUse::Skin, "skin.png", 1, 1, clear.rgba));
  // Other shader variants round otherwise.
  EXPECT_EQ(room.settled().differingShare(before, 2), 0);
}

TEST(AppSkinPicture, GoesWithTheSceneAndToOtherPrograms) {
  WearingRoom room;
  ASSERT_TRUE(room.app.usePicture(PictureUse::Skin, "skin.png", 1, 1, kGreen.rgba, kGreen.png));
  const settings::Settings settings = room.app.settings();
  App other;
  ASSERT_TRUE(other.loadModel(room.app.saveScene(), "scene.glb"));
  EXPECT_EQ(other.settings(), settings);
  ASSERT_EQ(other.pendingPictures().size(), 1u);
  EXPECT_EQ(other.typePicture(settings.typePictures[settings::kSkin]).bytes, kGreen.png);
  App third;
  ASSERT_TRUE(third.setState(room.app.state()));
  const auto files = room.app.saveTypeFiles();
  ASSERT_TRUE(third.restoreTypeFiles(files));
  EXPECT_EQ(third.typePicture(settings.typePictures[settings::kSkin]).bytes, kGreen.png);
  // Kept by a program of before, which knew no skin: two texts of no length less.
  App fourth;
  WearingRoom plain;
  auto before = plain.app.saveTypeFiles();
  ASSERT_EQ(before.size() % 5, 0u);
  before.resize(before.size() / 5 * 4);
  EXPECT_TRUE(fourth.restoreTypeFiles(before));
  room.app.setField("skin.picture", "");
  EXPECT_EQ(room.app.settings().typePictures[settings::kSkin], 0u);
}

TEST(AppPictures, ThatAreTheColourOfOneTypeBecomeItsColourMap) {
  WearingRoom room;
  room.app.groomAll(GroomEdit::Type, 2);
  room.app.setField("type2.preset", "wool");
  room.app.setField("groomType", "2");
  const auto before = room.picture();
  ASSERT_TRUE(room.app.usePicture(PictureUse::TypeColor, "red.png", 1, 1, OneColor({255, 0, 0, 255}).rgba));
  EXPECT_NE(room.app.settings().typePictures[1], 0u);
  EXPECT_TRUE(room.app.groom().paint.isPlain()) << "nothing is painted";
  EXPECT_GT(meanChannel(room.picture(), 0) - meanChannel(room.picture(), 2), meanChannel(before, 0) - meanChannel(before, 2) + 10);
  EXPECT_TRUE(room.app.takeWarnings().empty());
  ASSERT_TRUE(room.app.undo());
  EXPECT_EQ(room.picture(), before);
  room.app.setField("groomType", "4");
  ASSERT_TRUE(room.app.usePicture(PictureUse::TypeColor, "red.png", 1, 1, OneColor({255, 0, 0, 255}).rgba));
  EXPECT_EQ(room.app.takeWarnings().size(), 1u) << "that type grows nowhere";
}

TEST(AppPictures, LieOnTheAtlasOfAModelWithoutTextureCoordinates) {
  WearingRoom room;  // a primitive
  room.app.setField("textureAmount", "1");
  // Left red, right green.
  const std::vector<std::uint8_t> halves{255, 0, 0, 255, 0, 255, 0, 255};
  ASSERT_TRUE(room.app.setTypePicture(0, scene::writePng(2, 1, 4, halves), 2, 1, halves));
  const test::Picture picture = room.settled();
  int red = 0, green = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    red += picture.rgba[i] > 2 * picture.rgba[i + 1];
    green += picture.rgba[i + 1] > 2 * picture.rgba[i];
  }
  EXPECT_GT(red, 20);
  EXPECT_GT(green, 20);
}

TEST(AppPictures, HostileFilesOfColourMapsAreTypedErrorsAndNothingIsLost) {
  WearingRoom room;
  const std::string state = room.app.state();
  const auto files = room.app.saveTypeFiles();
  std::vector<std::uint8_t> wide = kGreen.png;
  wide[18] = 0x21;  // 8449 pixels
  for (const int type : {0, 1, settings::kSkin})
    for (const auto& [bytes, id] : {std::pair(std::vector<std::uint8_t>(), ErrorId::BadFile), std::pair(std::vector<std::uint8_t>(kGreen.png.begin(), kGreen.png.begin() + 20), ErrorId::BadFile),
                                    std::pair(std::vector<std::uint8_t>(64, 0x47), ErrorId::BadFile), std::pair(wide, ErrorId::TooLarge)}) {
      const Status status = room.app.setTypePicture(type, bytes, 1, 1, {0, 0, 0, 0});
      ASSERT_FALSE(status);
      EXPECT_EQ(status.error().id, id) << status.error().message;
      EXPECT_NE(status.error().message.find("colour map"), std::string::npos);
    }
  EXPECT_EQ(room.app.state(), state);
  EXPECT_EQ(room.app.saveTypeFiles(), files);
}

// Half-way up the coat: what the four patterns do to the picture of it.
TEST(AppPatterns, MarkTheCoatInTheColourOfThePaintAndPlainTakesThemAway) {
  for (const char* name : {"tabby", "spots", "rosettes", "patches"}) {
    WearingRoom room;
    room.app.setField("paintColor", "#000000");
    const auto before = room.picture();
    const auto edit = groomEditNamed(name);
    ASSERT_TRUE(edit) << name;
    room.app.groomAll(*edit, 1);
    const auto marked = room.picture();
    EXPECT_LT(meanChannel(marked, 0), meanChannel(before, 0) - 3) << name;
    const auto groom = room.app.saveGroom();
    room.app.groomAll(GroomEdit::ClearPaint);
    EXPECT_EQ(room.picture(), before) << name;
    ASSERT_TRUE(room.app.undo());
    EXPECT_EQ(room.picture(), marked) << name;
    ASSERT_TRUE(room.app.undo());
    EXPECT_EQ(room.picture(), before) << name;
    ASSERT_TRUE(room.app.restoreGroom(groom));
    EXPECT_EQ(room.picture(), marked) << name << ": as it was saved";
  }
}

}  // namespace
}  // namespace fur::app
