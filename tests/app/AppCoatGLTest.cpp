// The coat while it grows: slices, changes on the way, type sets, presets.
#include "app/stages/CoatStage.h"
#include "settings/Presets.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

constexpr float kSlice = 1e-6f;  // seconds: one piece of work a tick

struct CoatRoom : test::Room {
  CoatRoom() : Room(120, {{"layers", "8"}}) {}

  // Ticks in slices until the coat is whole; returns how many it took.
  int growInSlices() {
    int ticks = 0;
    while (app.coatProgress() < 1 && ticks < 10000) app.tick(0, kSlice), ++ticks;
    return ticks;
  }
  std::vector<std::uint8_t> firstLayer() { return app.tilePicture(0, furgen::TileChannel::Coverage).rgba; }
};

TEST(AppCoat, GrowsInSlicesWhileTheOldOneStaysAndEndsAsIfGrownAtOnce) {
  test::Picture atOnce;
  std::vector<std::uint8_t> layer;
  {
    CoatRoom desk;
    desk.app.setField("curl", "0.9");
    desk.app.tick(0);
    atOnce = desk.stage.draw(desk.app);
    layer = desk.firstLayer();
  }
  CoatRoom desk;
  const auto before = desk.firstLayer();
  desk.app.setField("curl", "0.9");
  desk.app.tick(0, kSlice);
  EXPECT_LT(desk.app.coatProgress(), 1);
  EXPECT_EQ(desk.firstLayer(), before);
  EXPECT_GT(desk.growInSlices(), 10);
  EXPECT_NE(desk.firstLayer(), before);
  EXPECT_EQ(desk.firstLayer(), layer);
  EXPECT_EQ(desk.stage.draw(desk.app).differingShare(atOnce, 0), 0);
}

TEST(AppCoat, ProgressRisesToOneAndNotBefore) {
  CoatRoom desk;
  const auto revision = desk.app.coatRevision();
  desk.app.setField("density", "0.4");
  float last = -1;
  while (desk.app.coatProgress() < 1) {
    EXPECT_EQ(desk.app.coatRevision(), revision);
    EXPECT_GE(desk.app.coatProgress(), last);
    last = desk.app.coatProgress();
    EXPECT_TRUE(desk.app.active());
    desk.app.tick(0, kSlice);
  }
  EXPECT_NE(desk.app.coatRevision(), revision);
}

TEST(AppCoat, ASliderThatIsDraggedShowsCoatsOnTheWayAndEndsWithTheNewest) {
  CoatRoom desk;
  const auto first = desk.app.coatRevision();
  for (int i = 0; i < 120; ++i) {
    desk.app.setField("density", std::to_string(0.2 + 0.005 * i));
    desk.app.tick(0, kSlice);
  }
  EXPECT_GT(desk.app.coatRevision(), first) << "a coat came while the slider moved";
  desk.growInSlices();
  CoatRoom other;
  other.app.setField("density", std::to_string(0.2 + 0.005 * 119));
  other.app.tick(0);
  EXPECT_EQ(desk.firstLayer(), other.firstLayer());
}

TEST(AppCoat, AGeneratorSettingAsksForNoFrameBeforeItsCoatIsThere) {
  CoatRoom desk;
  desk.app.setField("curl", "0.9");
  EXPECT_FALSE(desk.app.tick(0, kSlice));
  desk.growInSlices();
  EXPECT_EQ(desk.app.coatProgress(), 1);
  desk.app.setField("curl", "0.1");
  desk.app.setField("exposure", "1.5");
  EXPECT_TRUE(desk.app.tick(0, kSlice));
}

TEST(AppCoat, ATypeSetStaysUntilAGeneratorSettingChanges) {
  CoatRoom desk;
  desk.app.setField("coil", "0.6");
  desk.app.tick(0);
  const auto bytes = desk.app.saveTypeSet();
  const auto coiled = desk.app.coverageByHeight()[0];
  desk.app.setField("coil", "0");
  desk.app.tick(0);
  ASSERT_TRUE(desk.app.loadTypeSet(bytes, "coils.fts"));
  EXPECT_EQ(desk.app.coatLayers(), 16);
  EXPECT_NE(desk.app.coverageByHeight()[0], coiled) << "16 layers against 8";
  const auto loaded = desk.firstLayer();
  desk.app.setField("exposure", "1.2");
  desk.app.tick(0);
  EXPECT_EQ(desk.firstLayer(), loaded);
  desk.app.setField("seed", "7");
  desk.app.tick(0);
  EXPECT_EQ(desk.app.coatLayers(), 8);
}

TEST(AppCoat, ABadTypeSetLeavesTheCoatAsItWas) {
  CoatRoom desk;
  const auto before = desk.firstLayer();
  const auto revision = desk.app.coatRevision();
  const std::uint8_t bytes[] = {1, 2, 3};
  const Status status = desk.app.loadTypeSet(bytes, "bad.fts");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().id, ErrorId::BadFile);
  EXPECT_NE(status.error().message.find("bad.fts"), std::string::npos);
  EXPECT_EQ(desk.app.coatRevision(), revision);
  EXPECT_EQ(desk.firstLayer(), before);
}

TEST(AppCoat, APresetIsOneUndoStep) {
  CoatRoom desk;
  const settings::Settings before = desk.app.settings();
  ASSERT_TRUE(desk.app.applyPreset("wool"));
  EXPECT_NE(desk.app.settings(), before);
  EXPECT_EQ(desk.app.settings().layers, 8) << "presets leave layers alone";
  EXPECT_TRUE(desk.app.undo());
  EXPECT_EQ(desk.app.settings(), before);
  EXPECT_FALSE(desk.app.applyPreset("granite"));
  EXPECT_EQ(desk.app.settings(), before);
}

TEST(AppCoat, ATileTooLargeForTheGpuGetsFewerLayersAndAWarning) {
  settings::Settings s;
  s.tileSize = 4;  // 1024
  s.layers = 128;
  Warnings warnings;
  const furgen::FurParameters p = coatParameters(s, 1, &warnings)[0];
  EXPECT_EQ(p.size, 1024);
  EXPECT_LT(p.layers, 128);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("192 MiB"), std::string::npos);
}

TEST(AppCoat, EveryGeneratorSettingReachesTheGenerator) {
  // Each field of the generator's groups but for colour and size on the model, moved alone, asks for another coat.
  const settings::Settings standard;
  for (const char* name : {"density", "thickness", "taper", "lengthVariation", "curl", "wave", "coil", "frizz", "clump",
                           "lockSize", "roll", "stray", "tipBreak", "undercoat", "undercoatLength", "tileSize", "layers", "seed"}) {
    const settings::Field* field = settings::findField(name);
    ASSERT_NE(field, nullptr) << name;
    settings::Settings other = standard;
    field->set(other, field->get(standard) == field->high ? field->low : field->high);
    EXPECT_NE(coatParameters(other, 15), coatParameters(standard, 15)) << name;
    EXPECT_TRUE(differOnlyInCoat(standard, other)) << name;
  }
}

}  // namespace
}  // namespace fur::app
