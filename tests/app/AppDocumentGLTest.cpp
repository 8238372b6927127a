// What is saved of a document opens as it was: picture and state, to the bit.
#include "scene/Tentacle.h"
#include "tests/app/Salon.h"

namespace fur::app {
namespace {

struct DocumentRoom : test::Room {
  DocumentRoom() : Room(120, {{"layers", "8"}, {"tileSize", "64"}, {"breath", "0"}, {"wind", "0"}, {"animationSpeed", "0"}}) {
    EXPECT_TRUE(test::growsHair);
    App::keepDocuments(&scene::kDocumentKeeping);
  }
  ~DocumentRoom() { App::keepDocuments(nullptr); }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) app.tick(1 / 60.0f);
  }
};

// Groom, whisker, long hair and its body on a bone, wet while drops fall, with a coat from a file.
void furnish(DocumentRoom& salon) {
  App& app = salon.app;
  salon.stroke(Tool::Comb, {60, 30}, {60, 90});
  salon.stroke(Tool::Trim, {55, 50}, {65, 70});
  app.setField("tipColor", "#336699");
  app.editHair(HairEdit::AddScalp);
  app.editHair(HairEdit::Cover, 1);
  EXPECT_TRUE(app.setHairValue(0, "guideLength", "0.3"));
  app.editHair(HairEdit::Plant, 8);
  app.editHair(HairEdit::FitBones);
  EXPECT_TRUE(app.loadTypeSet(app.saveTypeSet(), "coat.fts"));
  app.setWetness(0.6f);
  app.setField("dryRate", "0.01");
  app.splashAt(0.4f, 0.4f, 0.1f, 3);
  app.setField("rain", "0.5");
  salon.run(40);
}

TEST(AppDocument, OpensWithTheSameStateToTheBit) {
  DocumentRoom salon;
  App& app = salon.app;
  ASSERT_TRUE(app.loadModel(scene::Tentacle().build(), "tentacle.glb"));
  furnish(salon);
  ASSERT_FALSE(app.drops().empty());
  const auto groom = app.saveGroom(), hair = app.saveHair(), file = app.saveScene();
  const std::uint64_t water = app.water().hash(app.wetnessMask());
  const std::string state = app.state(), animations = app.animations();
  ASSERT_TRUE(app.loadPrimitive("torus"));
  app.setField("tipColor", "#000000");
  ASSERT_TRUE(app.loadModel(file, "tentacle.glb"));
  EXPECT_EQ(app.takeWarnings(), Warnings{});
  EXPECT_EQ(app.saveGroom(), groom);
  EXPECT_EQ(app.saveHair(), hair);
  EXPECT_EQ(app.water().hash(app.wetnessMask()), water);
  EXPECT_EQ(app.state(), state);
  EXPECT_EQ(app.animations(), animations);
  EXPECT_TRUE(app.coatGiven());
}

// As when the element hands its scene to the program that saves.
TEST(AppDocument, SavesTheSameWithASurfaceThatWasGiven) {
  const auto model = scene::Tentacle().build();
  std::vector<std::uint8_t> files[2], surface;
  for (auto& file : files) {
    DocumentRoom salon;
    if (!surface.empty()) salon.app.giveSurface(surface);
    ASSERT_TRUE(salon.app.loadModel(model, "tentacle.glb"));
    surface = salon.app.saveSurface();
    furnish(salon);
    file = salon.app.saveScene();
  }
  EXPECT_EQ(files[0], files[1]);
}

TEST(AppDocument, OpensWithTheSamePicture) {
  DocumentRoom salon;
  App& app = salon.app;
  ASSERT_TRUE(app.loadModel(scene::Tentacle().build(), "tentacle.glb"));
  salon.stroke(Tool::Comb, {60, 30}, {60, 90});
  app.setWetness(0.6f);
  const auto file = app.saveScene();
  const auto drawn = [&] {
    app.settle();
    app.tick(0);
    return salon.stage.draw(app);
  };
  ASSERT_TRUE(app.loadModel(file, "tentacle.glb"));
  const test::Picture once = drawn();
  ASSERT_TRUE(app.loadPrimitive("torus"));
  ASSERT_TRUE(app.loadModel(file, "tentacle.glb"));
  EXPECT_EQ(drawn().differingShare(once, 0), 0);
}

TEST(AppDocument, WhoseCoatIsNoneLeavesWhatWasOpen) {
  DocumentRoom salon;
  App& app = salon.app;
  ASSERT_TRUE(app.loadModel(scene::Tentacle().build(), "tentacle.glb"));
  ASSERT_TRUE(app.loadTypeSet(app.saveTypeSet(), "coat.fts"));
  auto file = app.saveScene();
  // The coat's weight, its last number, becomes 2^127.
  file[file.size() - 1] = 0x7f;
  ASSERT_TRUE(app.loadPrimitive("torus"));
  const Status status = app.loadModel(file, "spoilt.glb");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().id, ErrorId::BadFile);
  EXPECT_EQ(status.error().message.find("spoilt.glb: its weight is"), 0u) << status.error().message;
  EXPECT_EQ(app.modelName(), "torus");
}

// Every number of the water that a file may hold.
TEST(AppDocument, HostileWaterIsLeftOutWithAWarning) {
  DocumentRoom salon;
  App& app = salon.app;
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  app.splashAt(0.4f, 0.4f, 0.1f, 3);
  app.setField("rain", "1");
  salon.run(30);
  const auto good = app.saveWater();
  ASSERT_TRUE(app.restoreWater(good));
  std::size_t refused = 0;
  for (std::size_t at = 4; at + 4 <= good.size(); at += 4 * (good.size() / 400)) {  // a hundred of them
    auto bad = good;
    for (const std::uint8_t byte : {0xff, 0x7f}) bad[at + 3] = byte, bad[at + 2] = 0xc0;
    if (!app.restoreWater(bad)) ++refused;
    else salon.run(1);
  }
  EXPECT_GT(refused, 90u);
}

}  // namespace
}  // namespace fur::app
