// Fur types with coats of their own, as a whole program has them.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "app/App.h"
#include "render/Frame.h"
#include "scene/Png.h"
#include "settings/FurTypes.h"
#include "render/Picture.h"

namespace fur::app {
namespace {

// A model all of type 2.
struct Types : test::Room {
  Types() : Room(48, {{"layers", "8"}, {"tileSize", "64"}, {"breath", "0"}, {"ground", "false"}}) {
    app.groomAll(GroomEdit::Type, 2);
    app.settle();
  }
  auto picture() { return settled().rgba; }
};

using test::OneColor, test::meanChannel;

TEST(AppTypes, AreDrawnWithTheirOwnColoursLightAndLength) {
  Types room;
  const auto before = room.picture();
  for (const auto& [name, value] : {std::pair("type2.rootColor", "#0000ff"), std::pair("type2.specular", "2"), std::pair("type2.furLength", "0.3"), std::pair("type2.occlusion", "0")}) {
    room.app.setField(name, value);
    EXPECT_NE(room.picture(), before) << name;
    ASSERT_TRUE(room.app.undo());
    EXPECT_EQ(room.picture(), before) << name;
  }
}

TEST(AppTypes, LieAtTheirOwnLengthsInTheFirstPicture) {
  Types room;
  room.app.setField("type2.furLength", "0.03");
  room.app.setField("type2.gravity", "1");
  room.app.settle();
  const auto scene = room.app.saveScene();
  for (const bool afterAnother : {false, true}) {
    test::Stage stage{48, 48};
    App app;
    stage.attach(app);
    if (afterAnother) app.settle();
    ASSERT_TRUE(app.loadModel(scene, "scene.glb"));
    while (app.workOnPicture(0, true) != Work::Done) {
    }
    app.tick(0, 0);
    const std::vector<Vec4> first(app.bends().begin(), app.bends().end());
    ASSERT_FALSE(first.empty());
    app.settle();
    EXPECT_EQ(first, std::vector<Vec4>(app.bends().begin(), app.bends().end())) << afterAnother;
    app.detach(false);
  }
}

TEST(AppTypes, AColourMapIsOneStepOfUndoAndGoesWithTheScene) {
  Types room;
  room.app.setField("type2.preset", "wool");
  const auto before = room.picture();
  const OneColor red({255, 0, 0, 255});
  ASSERT_TRUE(room.app.setTypePicture(1, red.png, 1, 1, red.rgba));
  const auto reddish = room.picture();
  EXPECT_GT(meanChannel(reddish, 0) - meanChannel(reddish, 2), meanChannel(before, 0) - meanChannel(before, 2) + 10);
  ASSERT_TRUE(room.app.undo());
  EXPECT_EQ(room.picture(), before);
  ASSERT_TRUE(room.app.redo());
  EXPECT_EQ(room.picture(), reddish);

  const settings::Settings settings = room.app.settings();
  const auto scene = room.app.saveScene();
  App other;
  ASSERT_TRUE(other.loadModel(scene, "scene.glb"));
  EXPECT_EQ(other.settings(), settings);
  ASSERT_EQ(other.pendingPictures().size(), 1u);
  EXPECT_EQ(other.typePicture(settings.typePictures[1]).bytes, red.png);
}

TEST(AppTypes, ATypeSetIsOneStepOfUndoAndGoesWithTheScene) {
  Types room;
  room.app.setField("type2", "bald");
  const auto bald = room.picture();
  const auto set = room.app.saveTypeSet();
  ASSERT_TRUE(room.app.loadTypeSet(set, "coat.fts", 1));
  EXPECT_TRUE(room.app.coatGiven(1));
  EXPECT_FALSE(room.app.coatGiven(0));
  const auto furry = room.picture();
  EXPECT_NE(furry, bald);
  ASSERT_TRUE(room.app.undo());
  EXPECT_FALSE(room.app.coatGiven(1));
  EXPECT_EQ(room.picture(), bald);
  ASSERT_TRUE(room.app.redo());
  EXPECT_EQ(room.app.saveTypeSet(1), set) << "byte by byte";
  const auto scene = room.app.saveScene();
  ASSERT_TRUE(room.app.loadPrimitive("sphere"));
  ASSERT_TRUE(room.app.loadModel(scene, "scene.glb"));
  EXPECT_TRUE(room.app.coatGiven(1));
  EXPECT_EQ(room.app.saveTypeSet(1), set);
  room.app.setField("type2.curl", "0.9");
  EXPECT_FALSE(room.app.coatGiven(1)) << "a setting asks for another coat";
}

TEST(AppTypes, FilesOfTypesMoveToAnotherProgramWithTheState) {
  Types room;
  const OneColor red({255, 0, 0, 255});
  ASSERT_TRUE(room.app.loadTypeSet(room.app.saveTypeSet(), "coat.fts", 2));
  ASSERT_TRUE(room.app.setTypePicture(3, red.png, 1, 1, red.rgba));
  App other;
  ASSERT_TRUE(other.setState(room.app.state()));
  ASSERT_TRUE(other.restoreTypeFiles(room.app.saveTypeFiles()));
  EXPECT_TRUE(other.coatGiven(2));
  ASSERT_EQ(other.pendingPictures().size(), 1u);
  EXPECT_EQ(other.typePicture(other.pendingPictures()[0]).bytes, red.png);
}

TEST(AppTypes, HostileFilesAreRefusedAndNothingIsLost) {
  Types room;
  room.app.setField("type2.preset", "wool");
  const std::string state = room.app.state();
  const auto files = room.app.saveTypeFiles();
  auto set = room.app.saveTypeSet(1);
  const auto refused = [&](std::vector<std::uint8_t> bytes) {
    const Status status = room.app.loadTypeSet(bytes, "bad.fts", 1);
    return !status && status.error().id == ErrorId::BadFile && status.error().message.find("bad.fts") != std::string::npos;
  };
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({1, 2, 3}));
  EXPECT_TRUE(refused({set.begin(), set.end() - 1}));
  for (const float number : {-1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    auto bad = set;
    std::memcpy(&bad[bad.size() - 4], &number, 4);
    EXPECT_TRUE(refused(bad)) << number;
  }
  EXPECT_FALSE(room.app.setTypePicture(1, {1, 2, 3}, 1, 1, {0, 0, 0, 0}));
  EXPECT_EQ(room.app.saveTypeFiles(), files);
  EXPECT_FALSE(room.app.restoreTypeFiles(set));
  for (std::size_t size : {1u, 4u, 7u, 31u}) EXPECT_FALSE(room.app.restoreTypeFiles(std::vector<std::uint8_t>(size, 255))) << size;
  EXPECT_EQ(room.app.state(), state);
}

TEST(AppTypes, AreAsHeavyAndAsStiffAsTheirOwnCoat) {
  Types room;
  const auto lean = [&] {
    room.app.settle();
    float sum = 0;
    for (const Vec4& bend : room.app.bends()) sum += glm::length(Vec3(bend));
    return sum;
  };
  room.app.setField("gravity", "0.3");
  room.app.setField("type2.gravity", "0.3");
  const float before = lean();
  room.app.setField("type2.gravity", "1");
  const float heavy = lean();
  EXPECT_GT(heavy, 1.5f * before);
  room.app.setField("type2.stiffness", "1");
  EXPECT_LT(lean(), 0.8f * heavy) << "stiff strands hang less";
}

}  // namespace
}  // namespace fur::app
