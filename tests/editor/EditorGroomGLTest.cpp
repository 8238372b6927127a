// The brushes that programs with an editor have, at work on a sphere.
#include "app/editor/EditorGroom.h"

#include "scene/ImageDecode.h"
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct GroomRoom : test::Room {
  GroomRoom() : Room(160, {{"layers", "8"}, {"tileSize", "64"}, {"dryRate", "0"}, {"groomStrength", "1"}, {"brushRadius", "0.25"}, {"ground", "false"}}) {
    GroomStage::setEditorBrushes(&kEditorGroom);
    app.setCamera({0, 0, 3, Vec3(0)});
  }
  ~GroomRoom() { GroomStage::setEditorBrushes(nullptr); }

  Vec4 paintAt(Vec2 pixel) { return app.groom().paint.at(*app.pick(pixel)); }
};

Vec3 colorAt(const test::Picture& picture, Vec2 at) {
  Vec3 sum(0);
  for (int y = -5; y < 5; ++y)
    for (int x = -5; x < 5; ++x)
      for (int k = 0; k < 3; ++k) sum[k] += picture.at(static_cast<int>(at.x) + x, static_cast<int>(at.y) + y)[k];
  return sum / 100.0f;
}

constexpr Vec2 kRight{105, 80}, kLeft{55, 80}, kMiddle{80, 80};

TEST(EditorGroom, EveryBrushIsOneUndoStepAStroke) {
  for (const Tool tool : {Tool::Paint, Tool::Cut, Tool::Thin, Tool::Mask, Tool::Curl, Tool::Frizz, Tool::Locks}) {
    GroomRoom studio;
    const auto before = studio.app.groomHash();
    studio.stroke(tool, {60, 70}, {100, 90});
    const auto after = studio.app.groomHash();
    EXPECT_NE(after, before) << static_cast<int>(tool);
    EXPECT_TRUE(studio.app.undo());
    EXPECT_EQ(studio.app.groomHash(), before) << static_cast<int>(tool);
    EXPECT_TRUE(studio.app.redo());
    EXPECT_EQ(studio.app.groomHash(), after) << static_cast<int>(tool);
  }
}

TEST(EditorGroom, TheViewerAloneHasNoneOfThem) {
  GroomRoom studio;
  GroomStage::setEditorBrushes(nullptr);
  const auto before = studio.app.groomHash();
  studio.stroke(Tool::Paint, {60, 70}, {100, 90});
  EXPECT_EQ(studio.app.groomHash(), before);
}

TEST(EditorGroom, PaintShowsOnStrandsAndOnBareSkinAndGoesWithUndo) {
  GroomRoom studio;
  studio.app.setField("paintColor", "#0040ff");
  studio.app.setTool(Tool::None);
  const test::Picture plain = studio.settled();
  studio.stroke(Tool::Paint, {70, 80}, {90, 80});
  studio.app.setTool(Tool::None);
  const test::Picture painted = studio.settled();
  EXPECT_GT(colorAt(painted, kMiddle).z, 2 * colorAt(painted, kMiddle).x) << "sand has become blue";
  EXPECT_LT(colorAt(plain, kMiddle).z, colorAt(plain, kMiddle).x);
  EXPECT_LT(glm::length(colorAt(painted, {80, 40}) - colorAt(plain, {80, 40})), 3) << "elsewhere it is as it was";
  studio.app.groomAll(GroomEdit::Length, 0);
  const test::Picture bald = studio.settled();
  EXPECT_GT(colorAt(bald, kMiddle).z, 2 * colorAt(bald, kMiddle).x);
  EXPECT_LT(colorAt(bald, {80, 40}).z, colorAt(bald, {80, 40}).x);
  EXPECT_TRUE(studio.app.undo());
  EXPECT_TRUE(studio.app.undo());
  EXPECT_EQ(studio.settled().differingShare(plain, 0), 0);
}

TEST(EditorGroom, PaintGoesThroughASavedSceneAndToAnotherProgram) {
  GroomRoom studio;
  studio.stroke(Tool::Paint, {70, 80}, {90, 80});
  studio.stroke(Tool::Mask, {70, 50}, {90, 50});
  const auto paint = studio.app.groom().paint.hash(), mask = studio.app.groom().mask.hash();
  App other;
  ASSERT_TRUE(other.loadPrimitive("sphere"));
  ASSERT_TRUE(other.restoreGroom(studio.app.saveGroom()));
  EXPECT_EQ(other.groomHash(), studio.app.groomHash());
  ASSERT_TRUE(other.loadModel(studio.app.saveScene(), "painted.glb"));
  EXPECT_EQ(other.groom().paint.hash(), paint);
  EXPECT_EQ(other.groom().mask.hash(), mask);
  ASSERT_TRUE(other.loadPrimitive("torus"));
  EXPECT_FALSE(other.groomed()) << "it belongs to the model";
}

TEST(EditorGroom, ShapesChangeStrandsWhereTheBrushWasAndGoByItAgain) {
  for (const Tool tool : {Tool::Curl, Tool::Frizz, Tool::Locks}) {
    GroomRoom studio;
    studio.app.setCamera({0, 0, 2.6f, Vec3(0)});  // strands as wide as pixels
    const test::Picture plain = studio.settled();
    studio.app.setField("brushFalloff", "flat");
    studio.stroke(tool, {70, 80}, {90, 80});
    const test::Picture shaped = studio.settled();
    EXPECT_GT(shaped.differingShare(plain, 24), 0.02f) << static_cast<int>(tool);
    EXPECT_LT(glm::length(colorAt(shaped, {80, 15}) - colorAt(plain, {80, 15})), 3) << "elsewhere it is as it was";
    App other;
    ASSERT_TRUE(other.loadModel(studio.app.saveScene(), "shaped.glb"));
    EXPECT_EQ(other.groom().shape.hash(), studio.app.groom().shape.hash());
    studio.app.detach(false);
    studio.stage.attach(studio.app);
    EXPECT_EQ(studio.settled().differingShare(shaped, 0), 0) << "another context shows the same";
    studio.app.setField("brushErases", "true");
    studio.app.setField("brushRadius", "0.5");
    studio.stroke(tool, {60, 80}, {100, 80});
    EXPECT_TRUE(studio.app.groom().shape.isPlain()) << static_cast<int>(tool);
    EXPECT_TRUE(studio.app.undo());
    studio.app.groomAll(GroomEdit::ClearShape);
    EXPECT_TRUE(studio.app.groom().shape.isPlain()) << static_cast<int>(tool);
    EXPECT_EQ(studio.settled().differingShare(plain, 0), 0) << static_cast<int>(tool);
  }
}

TEST(EditorGroom, AnotherContextShowsTheSamePaintAndNoneAfterItIsCleared) {
  GroomRoom studio;
  const test::Picture plain = studio.settled();
  studio.stroke(Tool::Paint, {70, 80}, {90, 80});
  const test::Picture painted = studio.settled();
  EXPECT_GT(painted.differingShare(plain, 24), 0.02f);
  studio.app.detach(false);
  studio.stage.attach(studio.app);
  EXPECT_EQ(studio.settled().differingShare(painted, 0), 0);
  studio.app.groomAll(GroomEdit::ClearPaint);
  EXPECT_EQ(studio.settled().differingShare(plain, 0), 0);
  // What was painted before does not come back with the next stroke.
  studio.app.setField("brushRadius", "0.05");
  studio.stroke(Tool::Paint, {80, 30}, {80, 30});
  EXPECT_LT(glm::length(colorAt(studio.settled(), kMiddle) - colorAt(plain, kMiddle)), 3);
}

TEST(EditorGroom, AColourIsPickedFromPaintAndFromTheCoat) {
  GroomRoom studio;
  studio.app.setField("rootColor", "#804020");
  studio.app.setField("tipColor", "#804020");
  EXPECT_EQ(studio.app.colorAt(kMiddle), 0x804020u);
  studio.app.setField("paintColor", "#123456");
  studio.app.setField("brushFalloff", "flat");
  studio.stroke(Tool::Paint, kMiddle, kMiddle);
  EXPECT_EQ(studio.app.colorAt(kMiddle), 0x123456u);
  EXPECT_FALSE(studio.app.colorAt({2, 2}));
}

TEST(EditorGroom, AMirroredStrokeIsOnBothSidesAndOneStep) {
  for (const Tool tool : {Tool::Paint, Tool::Trim, Tool::Comb, Tool::Mask}) {
    GroomRoom studio;
    studio.app.setField("mirror", "x");
    const auto before = studio.app.groomHash();
    studio.stroke(tool, kRight, {110, 95});
    const groom::Groom& groom = studio.app.groom();
    const groom::SurfacePoints points(studio.app.surface());
    // Some of a sphere's points lie in pairs.
    std::vector<Vec3> others = points.positions;
    for (Vec3& place : others) place.x = -place.x;
    const std::vector<std::uint32_t> pairs = points.at(others);
    int compared = 0, changed = 0;
    for (std::size_t i = 0; i < points.count(); ++i) {
      if (pairs[i] == groom::SurfacePoints::kNoPoint) continue;
      ++compared;
      Vec3 comb = groom.comb[pairs[i]];
      comb.x = -comb.x;
      changed += comb != Vec3(0);
      EXPECT_LT(glm::distance(comb, groom.comb[i]), 0.02f);
    }
    EXPECT_GT(compared, 30);
    if (tool == Tool::Comb) EXPECT_GT(changed, 0);
    const Vec2 at = *studio.app.pick({107, 85}), there = *studio.app.pick({53, 85});
    if (tool == Tool::Paint) EXPECT_NEAR(groom.paint.at(at).w, groom.paint.at(there).w, 0.05);
    if (tool == Tool::Paint) EXPECT_GT(groom.paint.at(there).w, 0.5f);
    if (tool == Tool::Trim) EXPECT_LT(groom.map.lengthAt(there), 0.5f);
    if (tool == Tool::Mask) EXPECT_GT(groom.mask.at(there).w, 0.5f);
    EXPECT_TRUE(studio.app.undo());
    EXPECT_EQ(studio.app.groomHash(), before);
  }
}

TEST(EditorGroom, TheRingOfAMirroredBrushIsWhereItWorksToo) {
  GroomRoom studio;
  studio.app.setTool(Tool::Trim);
  const auto middleOf = [](const std::vector<Vec2>& ring) {
    Vec2 sum(0);
    for (const Vec2& point : ring) sum += point;
    return sum / static_cast<float>(ring.size());
  };
  EXPECT_TRUE(studio.app.brushRing(kRight, true).empty()) << "no mirror, no other ring";
  studio.app.setField("mirror", "x");
  const auto here = studio.app.brushRing(kRight), there = studio.app.brushRing(kRight, true);
  ASSERT_FALSE(there.empty());
  EXPECT_NEAR(middleOf(here).x + middleOf(there).x, 160, 3) << "the sphere is seen from the front";
  EXPECT_NEAR(middleOf(here).y, middleOf(there).y, 3);
}

TEST(EditorGroom, MirroredWhiskersPointBothWays) {
  GroomRoom studio;
  studio.app.setField("mirror", "x");
  studio.stroke(Tool::Whisker, kRight, {150, 60});
  const auto& whiskers = studio.app.groom().whiskers;
  ASSERT_EQ(whiskers.size(), 2u);
  EXPECT_NEAR(whiskers[0].root.x, -whiskers[1].root.x, 0.01);
  EXPECT_GT(whiskers[0].direction.x, 0.3f);
  EXPECT_NEAR(whiskers[0].direction.x, -whiskers[1].direction.x, 0.05);
  EXPECT_NEAR(whiskers[0].direction.y, whiskers[1].direction.y, 0.05);
  EXPECT_TRUE(studio.app.undo());
  EXPECT_EQ(whiskers.size(), 0u);
}

TEST(EditorGroom, MirroredWaterIsRecordedAsItWas) {
  GroomRoom studio;
  studio.app.setField("mirror", "x");
  studio.stroke(Tool::Droplet, kRight, {110, 95});
  // The wettest spot of those round there.
  const auto wet = [&](Vec2 pixel) {
    float most = 0;
    for (float y = -12; y <= 12; y += 2)
      for (float x = -12; x <= 12; x += 2) {
        const Vec2 at = *studio.app.pick(pixel + Vec2(x, y));
        most = std::max(most, studio.app.wetnessAt(at.x, at.y));
      }
    return most;
  };
  EXPECT_GT(wet({107, 85}), 0);
  EXPECT_GT(wet({53, 85}), 0);
  const float mean = studio.app.meanWetness();
  const std::string strokes = studio.app.recordedStrokes();
  EXPECT_TRUE(studio.app.undo());
  EXPECT_EQ(studio.app.meanWetness(), 0);
  App again;
  ASSERT_TRUE(again.loadPrimitive("sphere"));
  again.setSettings(studio.app.settings());
  ASSERT_TRUE(again.replay(strokes));
  EXPECT_NEAR(again.meanWetness(), mean, 0.02f * mean) << "text rounds where the spots lay";
}

TEST(EditorGroom, TheMaskShowsOnlyWhileOneGrooms) {
  GroomRoom studio;
  studio.app.setTool(Tool::None);
  const test::Picture plain = studio.settled();
  studio.stroke(Tool::Mask, {70, 80}, {90, 80});
  EXPECT_GT(colorAt(studio.settled(), kMiddle).x, 1.5f * colorAt(studio.settled(), kMiddle).y) << "red";
  studio.app.setTool(Tool::None);
  EXPECT_EQ(studio.settled().differingShare(plain, 0), 0);
  studio.app.setTool(Tool::Comb);
  EXPECT_GT(studio.settled().differingShare(plain, 24), 0.02f);
  studio.app.groomAll(GroomEdit::ClearMask);
  EXPECT_EQ(studio.settled().differingShare(plain, 0), 0);
}

TEST(EditorGroom, ThinningTakesStrandsByTheTypeThatIsBald) {
  GroomRoom studio;
  studio.stroke(Tool::Thin, {70, 80}, {90, 80});
  EXPECT_GT(studio.app.groomCoverage().types[3], 0.01f) << "type 4 is bald at first";
  studio.app.setField("brushErases", "true");
  for (int i = 0; i < 20; ++i) studio.stroke(Tool::Thin, {70, 80}, {90, 80});
  EXPECT_LT(studio.app.groomCoverage().types[3], 0.001f);
}

TEST(EditorGroom, EverySelectionIsOneUndoStep) {
  GroomRoom studio;
  studio.stroke(Tool::Paint, {70, 80}, {90, 80});
  studio.app.groomAll(GroomEdit::Vary, 0.8f);
  studio.stroke(Tool::Mask, {70, 60}, {90, 60});
  const auto place = studio.app.placeAt(kMiddle);
  ASSERT_TRUE(place);
  const struct {
    GroomEdit edit;
    float value;
    Vec3 direction;
  } edits[] = {{GroomEdit::SelectConnected, 1, *place}, {GroomEdit::SelectType, 2, Vec3(0)}, {GroomEdit::SelectLength, 1, Vec3(0, 0.5f, 0)},
               {GroomEdit::SelectPaint, 0.1f, *place},  {GroomEdit::GrowMask, 0.05f, Vec3(0)}, {GroomEdit::ShrinkMask, 0.05f, Vec3(0)},
               {GroomEdit::SmoothMask, 0.05f, Vec3(0)}};
  for (const auto& one : edits) {
    const auto before = studio.app.groomHash(), coat = studio.app.groom().map.hash();
    studio.app.groomAll(one.edit, one.value, one.direction);
    const auto after = studio.app.groomHash();
    EXPECT_NE(after, before) << static_cast<int>(one.edit);
    EXPECT_EQ(studio.app.groom().map.hash(), coat) << "only the mask is another";
    EXPECT_TRUE(studio.app.undo());
    EXPECT_EQ(studio.app.groomHash(), before) << static_cast<int>(one.edit);
    EXPECT_TRUE(studio.app.redo());
    EXPECT_EQ(studio.app.groomHash(), after);
    EXPECT_TRUE(studio.app.undo());
  }
}

TEST(EditorGroom, WhatIsNotSelectedKeepsItsFur) {
  GroomRoom studio;
  studio.app.setField("paintColor", "#ff0000");
  studio.stroke(Tool::Paint, {70, 80}, {90, 80});
  const auto place = studio.app.placeAt(kMiddle);
  ASSERT_TRUE(place);
  studio.app.groomAll(GroomEdit::SelectPaint, 0.1f, *place);
  studio.app.groomAll(GroomEdit::Length, 0);
  EXPECT_LT(studio.app.groomMap().lengthAt(*studio.app.pick(kMiddle)), 0.02f);
  EXPECT_GT(studio.app.groomMap().lengthAt(*studio.app.pick({80, 45})), 0.98f);
}

TEST(EditorGroom, SavedMapsComeBackByTheNamesOfTheirFiles) {
  GroomRoom studio;
  studio.app.groomAll(GroomEdit::Vary, 0.8f);
  studio.stroke(Tool::Paint, {70, 80}, {90, 80});
  studio.stroke(Tool::Curl, {70, 100}, {90, 100});
  studio.stroke(Tool::Mask, {70, 50}, {90, 50});
  const groom::Groom before = studio.app.groom();
  const auto files = studio.app.saveMaps();
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"sphere-map-length.png", "sphere-map-types.png", "sphere-map-paint.png", "sphere-map-mask.png",
                                             "sphere-map-shape.png", "sphere-map-comb.png", "sphere-map-wetness.png", "sphere-map-layout.png"}));
  studio.app.clearGroom();
  for (const std::size_t i : {0, 1, 2, 4, 3}) {
    auto image = scene::decodeImage(files[i].bytes);
    ASSERT_TRUE(image) << files[i].name;
    // As somebody drops it: what it is asked to be is a length map.
    studio.app.groomFromFile(groom::ImageOf::Length, files[i].name, image->width, image->height, image->rgba);
  }
  // What is protected by then is not: the mask came last.
  for (const auto map : groom::kMaps)
    for (std::size_t i = 0; i < (before.*map).texels().size(); ++i)
      for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR((before.*map).texels()[i][k], (studio.app.groom().*map).texels()[i][k], 1) << i;
  EXPECT_TRUE(studio.app.undo());
  EXPECT_TRUE(studio.app.groom().mask.isPlain()) << "each is one step";
}

}  // namespace
}  // namespace fur::app
