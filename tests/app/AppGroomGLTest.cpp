// What a person does with comb and scissors, without a page.
#include "tests/render/Picture.h"

namespace fur::app {
namespace {

struct GroomRoom : test::Room {
  GroomRoom() : Room(160, {{"layers", "8"}, {"tileSize", "64"}, {"dryRate", "0"}}) {}
};

constexpr Tool kTools[] = {Tool::Comb, Tool::Smooth, Tool::Raise, Tool::Trim, Tool::Grow, Tool::Type, Tool::Whisker, Tool::Pluck};

// Something that each of the tools can change.
void prepare(App& app) {
  app.groomAll(GroomEdit::Comb, 0.6f, Vec3(0.2f, -1, 0));
  app.groomAll(GroomEdit::Vary, 0.8f);
}

TEST(AppGroom, EveryToolIsOneUndoStepAStroke) {
  for (const Tool tool : kTools) {
    GroomRoom salon;
    prepare(salon.app);
    salon.stroke(Tool::Comb, {60, 90}, {100, 60});
    salon.stroke(Tool::Whisker, {70, 82}, {60, 60});
    const auto before = salon.app.groomHash();
    salon.stroke(tool, {50, 80}, {110, 85});
    const auto after = salon.app.groomHash();
    EXPECT_NE(after, before) << static_cast<int>(tool);
    EXPECT_TRUE(salon.app.undo());
    EXPECT_EQ(salon.app.groomHash(), before) << static_cast<int>(tool);
    EXPECT_TRUE(salon.app.redo());
    EXPECT_EQ(salon.app.groomHash(), after) << static_cast<int>(tool);
    EXPECT_EQ(salon.app.meanWetness(), 0) << "no water is spilt";
  }
}

TEST(AppGroom, HeldStillBrushesGoOnButForThoseThatNeedAWay) {
  for (const Tool tool : kTools) {
    GroomRoom salon;
    prepare(salon.app);
    salon.stroke(Tool::Whisker, {70, 82}, {60, 60});
    const auto before = salon.app.groomHash();
    salon.app.setTool(tool);
    PointerEvent event{PointerPhase::Down};
    event.position = {80, 80};
    event.buttons = 1;
    salon.app.pointer(event);
    const auto once = salon.app.groomHash();
    for (int i = 0; i < 30; ++i) salon.app.tick(1 / 60.0f);
    const bool goesOn = tool != Tool::Comb && tool != Tool::Whisker && tool != Tool::Pluck;
    EXPECT_EQ(salon.app.groomHash() != once, goesOn) << static_cast<int>(tool);
    event.phase = PointerPhase::Up;
    salon.app.pointer(event);
    const auto after = salon.app.groomHash();
    for (int i = 0; i < 30; ++i) salon.app.tick(1 / 60.0f);
    EXPECT_EQ(salon.app.groomHash(), after);
    if (after != before) EXPECT_TRUE(salon.app.undo());
    EXPECT_EQ(salon.app.groomHash(), before) << static_cast<int>(tool);
  }
}

TEST(AppGroom, EveryEditOfTheWholeIsOneUndoStep) {
  const std::pair<GroomEdit, float> edits[] = {{GroomEdit::Length, 0.4f}, {GroomEdit::Invert, 0}, {GroomEdit::Vary, 0.5f},
                                               {GroomEdit::Type, 2},      {GroomEdit::Comb, 1},   {GroomEdit::Raise, 0},
                                               {GroomEdit::Size, 512},    {GroomEdit::Clear, 0}};
  App app;
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  std::vector<std::uint64_t> hashes{app.groomHash()};
  for (const auto& [edit, value] : edits) {
    app.groomAll(edit, value);
    hashes.push_back(app.groomHash());
    EXPECT_NE(hashes.back(), hashes[hashes.size() - 2]) << static_cast<int>(edit);
  }
  for (std::size_t i = hashes.size() - 1; i-- > 0;) {
    EXPECT_TRUE(app.undo());
    EXPECT_EQ(app.groomHash(), hashes[i]);
  }
  for (std::size_t i = 1; i < hashes.size(); ++i) {
    EXPECT_TRUE(app.redo());
    EXPECT_EQ(app.groomHash(), hashes[i]);
  }
}

TEST(AppGroom, MarkingsInAColourOfTheirOwnAreOneStepAndLeaveThatOfTheBrush) {
  App app;
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  const std::uint32_t ofBrush = app.settings().paintColor;
  app.groomAll(GroomEdit::Tabby, 1, Vec3(0), 0x102030u);
  const auto& paint = app.groom().paint.texels();
  EXPECT_TRUE(std::any_of(paint.begin(), paint.end(), [](const auto& texel) { return texel[0] == 0x10 && texel[1] == 0x20 && texel[2] == 0x30 && texel[3] > 0; }));
  EXPECT_EQ(app.settings().paintColor, ofBrush);
  EXPECT_TRUE(app.undo());
  EXPECT_FALSE(app.groomed());
  EXPECT_FALSE(app.canUndo());
}

TEST(AppGroom, WhatChangesNothingIsNoStep) {
  App app;
  app.groomAll(GroomEdit::Clear);
  app.groomAll(GroomEdit::Length, 1);
  EXPECT_FALSE(app.canUndo());
}

TEST(AppGroom, ABaldModelHasNoFurInThePicture) {
  GroomRoom salon;
  salon.app.setField("ground", "false");  // which the view of the skin leaves out
  const test::Picture furry = salon.settled();
  salon.app.groomAll(GroomEdit::Length, 0);
  const test::Picture bald = salon.settled();
  EXPECT_GT(furry.differingShare(bald, 16), 0.2f);
  salon.app.setField("furLength", "0");
  EXPECT_EQ(salon.settled().differingShare(bald, 0), 0) << "nothing but bare skin is left";
  EXPECT_TRUE(salon.app.undo());
  salon.app.groomAll(GroomEdit::Length, 1);
  EXPECT_EQ(salon.settled().differingShare(furry, 0), 0);
}

TEST(AppGroom, ACombBendsThePictureAndRaisingBringsItBack) {
  GroomRoom salon;
  const test::Picture upright = salon.settled();
  salon.app.groomAll(GroomEdit::Comb);
  EXPECT_GT(salon.settled().differingShare(upright, 16), 0.1f);
  salon.app.groomAll(GroomEdit::Raise);
  EXPECT_EQ(salon.settled().differingShare(upright, 0), 0);
}

TEST(AppGroom, ACoatLiesByItselfBeneathTheComb) {
  GroomRoom salon;
  const test::Picture upright = salon.settled();
  salon.app.setField("lie", "0.8");
  const test::Picture lying = salon.settled();
  EXPECT_GT(lying.differingShare(upright, 16), 0.1f);
  EXPECT_FALSE(salon.app.groomed()) << "nobody has combed it";
  const auto uncombed = salon.app.groomHash();
  salon.app.groomAll(GroomEdit::Raise);
  EXPECT_LT(salon.settled().differingShare(upright, 16), 0.02f) << "what is raised stands";
  salon.app.groomAll(GroomEdit::Lie);
  EXPECT_EQ(salon.settled().differingShare(lying, 0), 0);
  EXPECT_EQ(salon.app.groomHash(), uncombed);
  // A file that is combed in part says of the rest that it lies.
  salon.stroke(Tool::Comb, {50, 80}, {110, 85});
  const test::Picture before = salon.settled();
  const std::vector<std::uint8_t> file = salon.app.saveScene();
  salon.app.groomAll(GroomEdit::Lie);
  ASSERT_TRUE(salon.app.loadModel(file, "combed.glb"));
  EXPECT_LT(salon.settled().differingShare(before, 16), 0.02f);
  salon.app.setField("lie", "0");
  EXPECT_GT(salon.settled().differingShare(before, 16), 0.05f);
}

TEST(AppGroom, CombedFurSwingsOverAndComesToRest) {
  GroomRoom salon;
  salon.app.groomAll(GroomEdit::Comb);
  EXPECT_TRUE(salon.app.active());
  int ticks = 0;
  while (salon.app.active() && ticks < 600) salon.app.tick(1 / 60.0f), ++ticks;
  EXPECT_GT(ticks, 5) << "not at once";
  EXPECT_LT(ticks, 600);
}

TEST(AppGroom, AnotherFurMappingKeepsTheGroomAndItsUndo) {
  GroomRoom salon;
  const auto plain = salon.app.groomHash();
  salon.stroke(Tool::Comb, {50, 80}, {110, 85});
  salon.stroke(Tool::Trim, {50, 80}, {110, 85});
  salon.stroke(Tool::Whisker, {40, 80}, {10, 60});
  const auto groomed = salon.app.groomHash();
  salon.app.setField("furMapping", "cube");
  EXPECT_EQ(salon.app.groomHash(), groomed);
  salon.settled();
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(salon.app.undo());
  EXPECT_EQ(salon.app.groomHash(), plain);
}

TEST(AppGroom, MovesOverToAnotherProgramAsBytes) {
  GroomRoom salon;
  salon.stroke(Tool::Comb, {50, 80}, {110, 85});
  salon.stroke(Tool::Type, {50, 80}, {110, 85});
  salon.stroke(Tool::Whisker, {60, 80}, {40, 70});
  salon.stroke(Tool::Whisker, {90, 80}, {110, 70});
  const auto bytes = salon.app.saveGroom();
  App other;
  ASSERT_TRUE(other.loadPrimitive("sphere"));
  ASSERT_TRUE(other.restoreGroom(bytes));
  EXPECT_EQ(other.groomHash(), salon.app.groomHash());
  EXPECT_EQ(other.whiskerCount(), 2u);
  ASSERT_TRUE(other.loadPrimitive("plane"));
  EXPECT_EQ(other.whiskerCount(), 0u);
  EXPECT_EQ(other.groomCoverage().types[0], 1) << "it belongs to the model";
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, bytes.size() - 1, bytes.size()}) {
    const Status status = other.restoreGroom(std::span(bytes).first(size));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().id, ErrorId::BadFile);
  }
}

// Mean colour of a square of the picture, 0..255.
Vec3 colorAt(const test::Picture& picture, int x, int y) {
  Vec3 sum(0);
  for (int dy = -6; dy < 6; ++dy)
    for (int dx = -6; dx < 6; ++dx) sum += Vec3(picture.at(x + dx, y + dy)[0], picture.at(x + dx, y + dy)[1], picture.at(x + dx, y + dy)[2]);
  return sum / 144.0f;
}

TEST(AppGroom, EachFurTypeGrowsWhereItIsPaintedAndElsewhereNothingChanges) {
  GroomRoom salon;
  salon.app.setField("brushRadius", "0.3");
  salon.app.setField("groomStrength", "1");
  salon.app.setField("type2", "otter");
  const test::Picture one = salon.settled();
  for (int i = 0; i < 10; ++i) salon.stroke(Tool::Type, {75, 78}, {85, 82});
  const test::Picture two = salon.settled();
  // Dark brown for sand.
  EXPECT_LT(colorAt(two, 80, 80).x, 0.6f * colorAt(one, 80, 80).x);
  EXPECT_NEAR(colorAt(two, 80, 40).x, colorAt(one, 80, 40).x, 4) << "the types' strands are the same there";
  salon.app.setField("type2", "persian");
  EXPECT_GT(colorAt(salon.settled(), 80, 80).x, colorAt(one, 80, 80).x) << "cream";
  salon.app.clearGroom();
  EXPECT_EQ(salon.settled().differingShare(one, 0), 0);
}

TEST(AppGroom, WhereTypesMeetStrandsOfBothStand) {
  GroomRoom salon;
  salon.app.setField("type2", "otter");
  salon.app.setField("furLength", "0.07");  // as long as the otter's
  salon.app.setField("view", "types");
  const std::uint8_t half[] = {128, 0, 0, 255};
  salon.app.groomFromImage(groom::ImageOf::Types, 1, 1, half);
  const test::Picture both = salon.settled();
  int first = 0, second = 0;
  for (int y = 60; y < 100; ++y)
    for (int x = 60; x < 100; ++x) {
      const std::uint8_t* pixel = both.at(x, y);
      // White is type 1, red is type 2.
      (pixel[1] > 3 * pixel[0] / 4 ? first : second) += 1;
    }
  // The otter's undercoat is denser: not half and half.
  EXPECT_GT(first, 1600 / 8);
  EXPECT_GT(second, 1600 / 8);
}

TEST(AppGroom, ABaldTypeShowsTheSkin) {
  GroomRoom salon;
  salon.app.setField("type4", "bald");
  salon.app.setField("skinColor", "#00c000");
  const std::uint8_t all[] = {0, 0, 255, 255};
  salon.app.groomFromImage(groom::ImageOf::Types, 1, 1, all);
  const test::Picture bald = salon.settled();
  const Vec3 skin = colorAt(bald, 80, 80);
  EXPECT_GT(skin.y, 2 * skin.x);
  salon.app.setField("furLength", "0");
  // Without any fur the skin is lit by the pixel instead of by the vertex, and nothing casts a shadow on it.
  EXPECT_LT(salon.settled().differingShare(bald, 24), 0.02f);
}

TEST(AppGroom, AWetCoatDoesNotCrackWhereChartsMeet) {
  GroomRoom salon;
  for (int i = 0; i < 6; ++i) salon.app.splashPixel({60.0f + 8 * static_cast<float>(i), 80}, 0.3f, 0.8f);
  salon.app.settle();
  const auto& vertices = salon.app.surface().vertices;
  const groom::SurfacePoints points(salon.app.surface());
  std::vector<int> first(points.count(), -1);
  int pairs = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    int& same = first[points.pointOf[i]];
    if (same < 0) same = static_cast<int>(i);
    if (same == static_cast<int>(i) || glm::distance(vertices[i].normal, vertices[static_cast<std::size_t>(same)].normal) > 1e-4f) continue;
    ++pairs;
    ASSERT_LT(glm::distance(salon.app.bends()[i], salon.app.bends()[static_cast<std::size_t>(same)]), 1e-3f);
  }
  EXPECT_GT(pairs, 10) << "charts meet somewhere";
}

TEST(AppGroom, ASavedSceneOpensAsItWas) {
  GroomRoom salon;
  salon.app.setField("tipColor", "#336699");
  salon.app.setCamera({0.8f, 0.2f, 3.5f, Vec3(0)});
  salon.stroke(Tool::Comb, {50, 80}, {110, 85});
  salon.stroke(Tool::Trim, {80, 50}, {85, 110});
  salon.stroke(Tool::Type, {60, 60}, {85, 110});
  salon.app.setField("whiskerHairs", "8");
  salon.app.setField("whiskerWidth", "0.02");
  salon.stroke(Tool::Whisker, {40, 80}, {10, 60});
  const test::Picture before = salon.settled();
  const auto map = salon.app.groomMap().hash();
  const auto file = salon.app.saveScene();
  salon.app.loadPrimitive("torus").value();
  salon.app.setField("tipColor", "#000000");
  EXPECT_EQ(salon.app.whiskerCount(), 0u) << "they belong to the model";
  ASSERT_TRUE(salon.app.loadModel(file, "saved.glb"));
  EXPECT_TRUE(salon.app.takeWarnings().empty());
  EXPECT_EQ(salon.app.groomMap().hash(), map);
  EXPECT_EQ(salon.app.whiskerCount(), 1u);
  EXPECT_EQ(salon.app.settings().tipColor, 0x336699u);
  EXPECT_FALSE(salon.app.canUndo());
  // The model is fitted anew: rounding moves a pixel here and there.
  EXPECT_LT(salon.settled().differingShare(before, 24), 0.01f);
  // And once more, for what is saved again.
  ASSERT_TRUE(salon.app.loadModel(salon.app.saveScene(), "again.glb"));
  EXPECT_EQ(salon.app.groomMap().hash(), map);
}

TEST(AppGroom, WhatASavedSceneLeavesOutIsToldBefore) {
  App::keepDocuments(&scene::kDocumentKeeping);
  GroomRoom salon;
  EXPECT_EQ(salon.app.lostBySaving(), Warnings{});
  const std::string text = R"({"asset":{"version":"2.0"},"images":[{"uri":"gone.png"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "nodes":[{"mesh":0}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const std::vector<std::uint8_t> file(text.begin(), text.end());
  ASSERT_TRUE(salon.app.loadModel(file, "triangle.gltf"));
  const Warnings lost{"the image file \"gone.png\", which stays beside it"};
  EXPECT_EQ(salon.app.lostBySaving(), lost);
  EXPECT_FALSE(salon.app.loadModel(std::span(file).first(9), "broken.gltf"));
  EXPECT_EQ(salon.app.lostBySaving(), lost) << "the old model is still there";
  ASSERT_TRUE(salon.app.loadPrimitive("sphere"));
  EXPECT_EQ(salon.app.lostBySaving(), Warnings{}) << "the file is gone with its model";
  App::keepDocuments(nullptr);
}

// As a program does that keeps models: web/host.js, native/window.
TEST(AppGroom, UndoAndRedoLeadFromModelToModelAndBackToEachOnesSteps) {
  GroomRoom salon;
  App& app = salon.app;
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  EXPECT_FALSE(app.canUndo());
  app.groomAll(GroomEdit::Length, 0.5f);
  app.setField("furLength", "0.2");
  app.splashAt(0.5f, 0.5f, 0.1f, 0.5f);
  app.undo();
  const auto groom = app.saveGroom(), water = app.saveWater(), left = app.saveHistory(true);
  const auto hash = app.groomHash();

  ASSERT_TRUE(app.loadPrimitive("torus"));
  EXPECT_FALSE(app.canUndo());
  app.followModel();
  app.groomAll(GroomEdit::Length, 0.3f);
  EXPECT_TRUE(app.undo());
  EXPECT_EQ(app.takeModelStep(), 0);
  EXPECT_TRUE(app.canUndo());
  EXPECT_TRUE(app.undo());
  EXPECT_EQ(app.takeModelStep(), -1);
  EXPECT_EQ(app.takeModelStep(), 0) << "it is told once";
  const auto torus = app.saveHistory();

  ASSERT_TRUE(app.loadPrimitive("sphere"));
  ASSERT_TRUE(app.restoreGroom(groom));
  ASSERT_TRUE(app.restoreWater(water));
  ASSERT_TRUE(app.restoreHistory(left));
  EXPECT_EQ(app.groomHash(), hash);
  EXPECT_FLOAT_EQ(app.settings().furLength, 0.2f);
  EXPECT_TRUE(app.redo()) << "what was undone there can be redone no more: it leads to the torus";
  EXPECT_EQ(app.takeModelStep(), 1);
  for (int step = 0; step < 2; ++step) EXPECT_TRUE(app.undo());
  EXPECT_FALSE(app.groomed());
  EXPECT_FALSE(app.canUndo());
  for (int step = 0; step < 2; ++step) EXPECT_TRUE(app.redo());
  EXPECT_EQ(app.groomHash(), hash);
  EXPECT_EQ(app.takeModelStep(), 0);

  ASSERT_TRUE(app.loadPrimitive("torus"));
  ASSERT_TRUE(app.restoreHistory(torus));
  EXPECT_TRUE(app.redo());
  EXPECT_EQ(app.takeModelStep(), 0);
  EXPECT_TRUE(app.groomed());
}

TEST(AppGroom, AHistoryThatIsCutShortIsRefused) {
  GroomRoom salon;
  salon.app.groomAll(GroomEdit::Length, 0.5f);
  const auto bytes = salon.app.saveHistory();
  EXPECT_FALSE(salon.app.restoreHistory(std::span(bytes).first(bytes.size() - 1)));
  EXPECT_TRUE(salon.app.canUndo()) << "the old one stays";
  EXPECT_TRUE(salon.app.restoreHistory({}));
  EXPECT_FALSE(salon.app.canUndo());
}

TEST(AppGroom, ASceneCanBeOpenedWithoutItsSettings) {
  App app;
  app.setField("furLength", "0.3");
  app.groomAll(GroomEdit::Length, 0.5f);
  const auto file = app.saveScene();
  app.setField("furLength", "0.1");
  ASSERT_TRUE(app.loadModel(file, "saved.glb", {}, true));
  EXPECT_FLOAT_EQ(app.settings().furLength, 0.1f);
  EXPECT_NEAR(app.groomCoverage().length, 0.5, 0.01);
}

TEST(AppGroom, TheLookThatASceneBringsGoesWithItUnlessItWasChanged) {
  App app;
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  app.setField("furLength", "0.3");
  app.setCamera({0.8f, 0.2f, 3.5f, Vec3(0)});
  const auto file = app.saveScene();
  app.setField("furLength", "0.1");
  app.setField("furMapping", "cube");
  app.setCamera({0.1f, 0.1f, 5.0f, Vec3(0)});
  const std::string own = app.state();
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(app.loadModel(file, "saved.glb"));
  EXPECT_FLOAT_EQ(app.settings().furLength, 0.3f);
  EXPECT_FLOAT_EQ(app.camera().distance, 3.5f);
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  EXPECT_EQ(app.state(), own);
  EXPECT_FALSE(app.canUndo());
  ASSERT_TRUE(app.loadModel(file, "saved.glb"));
  app.setField("curl", "0.9");
  ASSERT_TRUE(app.loadPrimitive("sphere"));
  EXPECT_FLOAT_EQ(app.settings().furLength, 0.3f);
}

TEST(AppGroom, LengthsAndTypesGoThroughAFo) {
  GroomRoom salon;
  for (int i = 0; i < 4; ++i) salon.stroke(Tool::Trim, {80, 50}, {85, 110});
  for (int i = 0; i < 8; ++i) salon.stroke(Tool::Type, {50, 80}, {110, 85});
  const groom::Coverage before = salon.app.groomCoverage();
  EXPECT_LT(before.length, 0.99f);
  EXPECT_GT(before.types[1], 0.01f);
  ASSERT_TRUE(salon.app.loadModel(salon.app.saveFo(), "saved.fo"));
  const groom::Coverage after = salon.app.groomCoverage();
  // A value a vertex instead of one a texel.
  EXPECT_NEAR(after.length, before.length, 0.02f);
  EXPECT_NEAR(after.types[1], before.types[1], 0.03f);
}

TEST(AppGroom, AnotherContextDrawsTheSameGroom) {
  GroomRoom salon;
  salon.stroke(Tool::Trim, {50, 80}, {110, 85});
  salon.app.groomAll(GroomEdit::Comb, 0.5f);
  salon.stroke(Tool::Whisker, {40, 80}, {10, 60});
  const test::Picture before = salon.settled();
  salon.app.detach(false);
  salon.stage.attach(salon.app);
  EXPECT_EQ(salon.settled().differingShare(before, 0), 0);
}

TEST(AppGroom, SpaceGroomsTheMiddleOfTheView) {
  for (const Tool tool : {Tool::Comb, Tool::Trim, Tool::Whisker}) {
    GroomRoom salon;
    salon.app.setTool(tool);
    const auto before = salon.app.groomHash();
    EXPECT_TRUE(salon.app.key({" "}));
    EXPECT_NE(salon.app.groomHash(), before);
    EXPECT_TRUE(salon.app.undo());
    EXPECT_EQ(salon.app.groomHash(), before);
  }
}

TEST(AppGroom, AWhiskerIsPlantedWhereTheStrokeBeginsAndPointsWhereItEnds) {
  GroomRoom salon;
  salon.stroke(Tool::Whisker, {80, 80}, {20, 80});
  EXPECT_EQ(salon.app.whiskerCount(), 1u) << "a drag aims, it plants no row";
  const auto left = salon.app.groomHash();
  EXPECT_TRUE(salon.app.undo());
  EXPECT_EQ(salon.app.whiskerCount(), 0u);
  salon.stroke(Tool::Whisker, {80, 80}, {140, 80});
  EXPECT_NE(salon.app.groomHash(), left);
  // And they are pulled out where they stand, not where their tips are.
  salon.app.setField("brushRadius", "0.1");
  salon.stroke(Tool::Pluck, {125, 80}, {120, 80});
  EXPECT_EQ(salon.app.whiskerCount(), 1u);
  salon.stroke(Tool::Pluck, {82, 80}, {81, 80});
  EXPECT_EQ(salon.app.whiskerCount(), 0u);
}

TEST(AppGroom, WhiskersEndAtTheirLimitWithAWarning) {
  GroomRoom salon;
  for (std::size_t i = 0; i < groom::kMostWhiskers; ++i) salon.stroke(Tool::Whisker, {80, 80}, {80, 80});
  EXPECT_EQ(salon.app.whiskerCount(), groom::kMostWhiskers);
  EXPECT_TRUE(salon.app.takeWarnings().empty());
  salon.stroke(Tool::Whisker, {80, 80}, {80, 60});
  EXPECT_EQ(salon.app.whiskerCount(), groom::kMostWhiskers);
  EXPECT_EQ(salon.app.takeWarnings().size(), 1u);
  salon.app.clearGroom();
  EXPECT_FALSE(salon.app.groomed());
}

TEST(AppGroom, AnEditBeginsFromTheLieOfTheSettingsHoweverShortlyBeforeTheyChanged) {
  const auto combed = [](const char* first, const char* then) {
    GroomRoom salon;
    salon.app.setField("lie", first);
    salon.app.settle();
    salon.app.setField("lie", then);
    salon.app.groomAll(GroomEdit::Comb, 0.5f, Vec3(0.2f, -1, 0));
    return salon.app.groomHash();
  };
  EXPECT_EQ(combed("0.8", "0"), combed("0", "0"));
  EXPECT_EQ(combed("0", "0.8"), combed("0.8", "0.8"));
  EXPECT_NE(combed("0", "0"), combed("0.8", "0.8"));
}

TEST(AppGroom, WaterStaysWaterWhateverTheTool) {
  GroomRoom salon;
  salon.app.setTool(Tool::Comb);
  salon.app.splashPixel({80, 80}, 0.1f, 0.5f);
  EXPECT_GT(salon.app.meanWetness(), 0);
  EXPECT_TRUE(salon.app.undo());
  EXPECT_EQ(salon.app.meanWetness(), 0);
}

}  // namespace
}  // namespace fur::app
