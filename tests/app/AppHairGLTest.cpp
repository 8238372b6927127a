// Long hair in pictures and files.
#include "tests/app/Salon.h"

namespace fur::app {
namespace {

struct HairSalon : test::Salon {
  HairSalon() : test::Salon(160, 60) {}
};

TEST(AppHair, IsSeenAndUndoTakesItOutOfThePicture) {
  HairSalon salon;
  const test::Picture bare = salon.picture();
  salon.grow();
  EXPECT_GT(salon.picture().differingShare(bare, 8), 0.2f);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(salon.app.undo());
  EXPECT_FALSE(salon.app.haired());
  EXPECT_EQ(salon.picture().differingShare(bare, 0), 0);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(salon.app.redo());
  EXPECT_GT(salon.picture().differingShare(bare, 8), 0.2f);
}

TEST(AppHair, IsDrawnAsItIsNowThoughNoTimeHasGoneByAfterAnEdit) {
  HairSalon salon;
  const test::Picture bare = salon.picture();
  salon.grow();
  EXPECT_GT(salon.stage.draw(salon.app).differingShare(bare, 8), 0.2f);
  salon.app.editHair(HairEdit::Remove);
  EXPECT_EQ(salon.stage.draw(salon.app).differingShare(bare, 0), 0);
  salon.app.undo();
  EXPECT_GT(salon.stage.draw(salon.app).differingShare(bare, 8), 0.2f);
}

TEST(AppHair, GoesWhileAnotherCoatGrows) {
  HairSalon salon;
  const test::Picture bare = salon.picture();
  salon.grow();
  salon.app.editHair(HairEdit::Clear);
  salon.app.setField("layers", "6");
  salon.app.setField("layers", "8");
  salon.app.settle();
  EXPECT_LT(salon.picture().differingShare(bare, 8), 0.1f);
}

// Strips show pictures of the very strands: means over the hair agree, single pixels need not.
TEST(AppHair, LooksAlikeAsStripsAndAsStrands) {
  HairSalon salon;
  salon.grow();
  const test::Picture strips = salon.pictureWith("hairDetail", "strips");
  const test::Picture strands = salon.pictureWith("hairDetail", "strands");
  EXPECT_GT(strands.differingShare(strips, 0), 0.01f);
  EXPECT_NEAR(strands.brightness(), strips.brightness(), 6);
}

// Far away fewer wisps are drawn, and wider; strands are always of all.
TEST(AppHair, TakesAsMuchOfAPictureFarAwayAsAllItsWispsDo) {
  HairSalon salon;
  salon.app.setField("furLength", "0");
  salon.app.setCamera({0.5f, 0.3f, 9.0f, Vec3(0)});
  const float bare = salon.picture().brightness();
  salon.grow();
  const float all = salon.pictureWith("hairDetail", "strands").brightness();
  const float fewer = salon.pictureWith("hairDetail", "strips").brightness();
  EXPECT_GT(std::abs(bare - all), 1);
  // A sixth of the difference that hair makes: what strips differ by near, too.
  EXPECT_NEAR(fewer, all, std::abs(bare - all) / 6);
}

TEST(AppHair, IsTheSamePictureWhereItsDepthIsDrawnFirst) {
  HairSalon salon;
  salon.grow();
  const test::Picture plain = salon.picture();
  salon.app.setField("hairTransparency", "depthFirst");
  EXPECT_EQ(salon.picture().differingShare(plain, 0), 0);
}

TEST(AppHair, LooksAlikeBlendedFromBackToFront) {
  HairSalon salon;
  salon.grow();
  const test::Picture plain = salon.pictureWith("hairDetail", "strips");
  const test::Picture blended = salon.pictureWith("hairTransparency", "blended");
  EXPECT_GT(blended.differingShare(plain, 0), 0.01f);
  EXPECT_NEAR(blended.brightness(), plain.brightness(), 3);
  // Edges alone differ: most pixels are about the same.
  EXPECT_LT(blended.differingShare(plain, 32), 0.2f);
}

TEST(AppHair, HidesTheSkinUnderItAsFarAsItIsAskedTo) {
  HairSalon salon;
  salon.app.setField("furLength", "0");
  salon.app.setField("skinColor", "#ff0000");
  salon.grow();
  // Without a wisp the skin is all there is to see.
  EXPECT_TRUE(salon.app.setHairValue(0, "wisps", "20"));
  const test::Picture covered = salon.picture();
  EXPECT_TRUE(salon.app.setHairValue(0, "skinCover", "0"));
  EXPECT_GT(salon.picture().brightness(), covered.brightness() + 4);
}

TEST(AppHair, IsDarkerWhereOtherHairKeepsOffTheLight) {
  HairSalon salon;
  salon.grow();
  EXPECT_TRUE(salon.app.setHairValue(0, "wisps", "2000"));
  const test::Picture open = salon.pictureWith("hairOcclusion", "0");
  salon.app.setField("hairOcclusion", "1");
  EXPECT_LT(salon.picture().brightness(), open.brightness() - 1);
}

TEST(AppHair, UploadsTheNodesOfGuidesAndNothingWhileItSleeps) {
  HairSalon salon;
  salon.grow();
  salon.picture();
  const std::size_t still = (salon.picture(), salon.app.stats().uploadedBytes);
  salon.app.setField("wind", "1");
  for (int i = 0; i < 20; ++i) salon.app.tick(1 / 60.0f);
  salon.stage.draw(salon.app);
  const std::size_t moving = salon.app.stats().uploadedBytes;
  // The coat's own bends are in it, 16 bytes a vertex.
  const std::size_t bends = salon.app.bends().size() * sizeof(Vec4), nodes = salon.app.hairstyle().scalps[0].guides.positions.size();
  EXPECT_EQ(moving - still, bends + 16 * nodes);
}

TEST(AppHair, GoesIntoASceneAndComesBackTheSame) {
  HairSalon salon;
  salon.grow();
  salon.app.editHair(HairEdit::AddSphere, 0.9f);
  EXPECT_TRUE(salon.app.setHairValue(0, "name", "mane"));
  const std::vector<std::uint8_t> scene = salon.app.saveScene();
  const hair::Hairstyle before = salon.app.hairstyle();
  const test::Picture picture = salon.picture();
  ASSERT_TRUE(salon.app.loadModel(scene, "saved.glb"));
  salon.app.settle();
  ASSERT_EQ(salon.app.hairstyle().scalps.size(), 1u);
  const hair::Scalp& scalp = salon.app.hairstyle().scalps[0];
  EXPECT_EQ(scalp.name, "mane");
  EXPECT_EQ(scalp.values, before.scalps[0].values);
  EXPECT_EQ(scalp.map.hash(), before.scalps[0].map.hash());
  EXPECT_EQ(salon.app.hairstyle().bodies.size(), 1u);
  ASSERT_EQ(scalp.guides.positions.size(), before.scalps[0].guides.positions.size());
  for (std::size_t i = 0; i < scalp.guides.positions.size(); ++i)
    EXPECT_LT(glm::distance(scalp.guides.positions[i], before.scalps[0].guides.positions[i]), 1e-5f);
  EXPECT_LT(salon.picture().differingShare(picture, 24), 0.02f);
}

TEST(AppHair, BytesOfItGoToAnotherAppWithTheSameModel) {
  HairSalon salon;
  salon.grow();
  const auto bytes = salon.app.saveHair();
  const test::Picture picture = salon.picture();
  salon.app.editHair(HairEdit::Clear);
  EXPECT_GT(salon.picture().differingShare(picture, 8), 0.2f);
  ASSERT_TRUE(salon.app.restoreHair(bytes, true));
  salon.app.settle();
  EXPECT_EQ(salon.picture().differingShare(picture, 8), 0);
  const std::uint8_t noise[] = {9, 9, 9, 9};
  const Status refused = salon.app.restoreHair(noise);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().id, ErrorId::BadFile);
  EXPECT_EQ(salon.app.saveHair(), bytes);
}

TEST(AppHair, GetsWetWithTheSkinThatItGrowsFromAndDriesWithIt) {
  HairSalon salon;
  salon.app.setField("stayWet", "true");
  salon.grow();
  const test::Picture dry = salon.picture();
  salon.app.setWetness(1);
  for (int i = 0; i < 60; ++i) salon.app.tick(1 / 60.0f);
  EXPECT_LT(salon.picture().brightness(), dry.brightness() - 4);
  salon.app.setWetness(0);
  for (int i = 0; i < 600 && salon.app.active(); ++i) salon.app.tick(1 / 60.0f);
  EXPECT_LT(salon.picture().differingShare(dry, 24), 0.05f);
}

double missing(const App& app) {
  const wet::Accounts a = app.water().accounts();
  return a.painted + a.rained - (a.held + a.film + a.drops + a.hair + a.dripped + a.evaporated + a.removed);
}

void run(App& app, float seconds) {
  for (int i = 0; i < static_cast<int>(60 * seconds); ++i) app.tick(1 / 60.0f);
}

TEST(AppHair, WaterBalancesWhileItRainsIsShakenAndDries) {
  HairSalon salon;
  salon.grow();
  salon.app.setField("rain", "1");
  run(salon.app, 1.5f);
  salon.app.setField("rain", "0");
  const wet::Accounts rained = salon.app.water().accounts();
  EXPECT_GT(rained.hair, 0.05 * rained.rained);
  EXPECT_NEAR(missing(salon.app), 0, 1e-4 * rained.rained);
  salon.app.shake();
  run(salon.app, 1.2f);
  const wet::Accounts shaken = salon.app.water().accounts();
  EXPECT_LT(shaken.hair, 0.8 * rained.hair);
  salon.app.setField("dryRate", "0.2");
  run(salon.app, 2);
  EXPECT_LT(salon.app.water().accounts().hair, shaken.hair);
  EXPECT_GT(salon.app.water().accounts().evaporated, shaken.evaporated);
  EXPECT_NEAR(missing(salon.app), 0, 1e-4 * rained.rained);
}

TEST(AppHair, UndoOfAWetStrokeTakesItsWaterOutOfHairAndRedoBringsItBack) {
  HairSalon salon;
  salon.app.setField("stayWet", "true");
  salon.grow();
  salon.app.setWetness(0.5f);
  run(salon.app, 0.1f);
  const auto hair = [&] { return run(salon.app, 0.05f), salon.app.water().accounts().hair; };
  const double half = hair();
  ASSERT_TRUE(salon.app.splashPixel({80, 80}, 0.8f, 1));
  const double more = hair();
  EXPECT_GT(more, 1.01 * half);
  EXPECT_GT(salon.app.drops().size(), 0u);
  EXPECT_TRUE(salon.app.undo());
  EXPECT_EQ(salon.app.drops().size(), 0u) << "nor does what hung or fell go on dripping";
  EXPECT_NEAR(hair(), half, 1e-3 * half);
  EXPECT_TRUE(salon.app.redo());
  EXPECT_NEAR(hair(), more, 1e-2 * more);
  salon.app.setWetness(0);
  EXPECT_EQ(hair(), 0);
  EXPECT_NEAR(missing(salon.app), 0, 1e-4 * more);
}

TEST(AppHair, ToolsOfWaterMeetItBesideTheSkin) {
  HairSalon salon;
  salon.grow();
  std::optional<Vec2> beside;
  for (float x = 159; x > 80 && !beside; x -= 2)
    if (!salon.app.pick({x, 90}) && salon.app.splashPixel({x, 90}, 0.1f, 0.8f)) beside = Vec2(x, 90);
  ASSERT_TRUE(beside);
  run(salon.app, 0.05f);
  EXPECT_GT(salon.app.water().accounts().hair, 0);
  EXPECT_EQ(salon.app.meanWetness(), 0);
  // It is in the record, and done again it wets the same hair.
  const std::string strokes = salon.app.recordedStrokes();
  salon.app.setWetness(0);
  run(salon.app, 0.05f);
  ASSERT_TRUE(salon.app.replay(strokes));
  run(salon.app, 0.05f);
  EXPECT_GT(salon.app.water().accounts().hair, 0);
  salon.app.setTool(Tool::Hose);
  const double before = salon.app.water().accounts().hair;
  PointerEvent event{.phase = PointerPhase::Down, .position = *beside};
  event.buttons = 1;
  EXPECT_TRUE(salon.app.pointer(event));
  run(salon.app, 0.5f);
  event.phase = PointerPhase::Up;
  salon.app.pointer(event);
  EXPECT_GT(salon.app.water().accounts().hair, 1.2 * before);
}

// A pixel that shows hair and no skin.
std::optional<Vec2> besideTheSkin(HairSalon& salon) {
  salon.app.setTool(Tool::Droplet);
  for (float x = 159; x > 80; x -= 2)
    if (const Vec2 at(x, 90); !salon.app.pick(at) && !salon.app.brushRing(at).empty()) return at;
  return std::nullopt;
}
void drag(App& app, Vec2 from, Vec2 to) {
  app.pointer({PointerPhase::Down, PointerKind::Mouse, 1, from, 1});
  for (int k = 1; k <= 8; ++k) app.pointer({PointerPhase::Move, PointerKind::Mouse, 1, from + (to - from) * (static_cast<float>(k) / 8), 1});
  app.pointer({PointerPhase::Up, PointerKind::Mouse, 1, to, 0});
}

TEST(AppHair, BrushesOfTheCoatCombAndTrimItWhereTheyMeetIt) {
  for (const Tool tool : {Tool::Comb, Tool::Trim}) {
    HairSalon salon;
    salon.grow();
    const auto beside = besideTheSkin(salon);
    ASSERT_TRUE(beside);
    const auto before = salon.app.hairstyle().scalps[0].guides.positions;
    const float yaw = salon.app.camera().yaw;
    salon.app.setTool(tool);
    EXPECT_FALSE(salon.app.brushRing(*beside).empty());
    drag(salon.app, *beside, *beside + Vec2(0, 20));
    EXPECT_EQ(salon.app.camera().yaw, yaw);
    EXPECT_NE(salon.app.hairstyle().scalps[0].guides.positions, before);
    EXPECT_TRUE(salon.app.undo());
    EXPECT_EQ(salon.app.hairstyle().scalps[0].guides.positions, before);
  }
}

TEST(AppHair, IsPettedAndPressedBesideTheSkin) {
  for (const Tool tool : {Tool::Pet, Tool::Ball}) {
    HairSalon salon;
    salon.grow();
    // Wide enough to meet guides, which are some way from each other.
    salon.app.setField("brushRadius", "0.4");
    salon.app.setField("ballSize", "0.4");
    const auto beside = besideTheSkin(salon);
    ASSERT_TRUE(beside);
    run(salon.app, 0.2f);
    const auto nodes = [&] { return std::vector<hair::GuideNode>(salon.app.hairNodes(0).begin(), salon.app.hairNodes(0).end()); };
    const auto before = nodes();
    const float yaw = salon.app.camera().yaw;
    salon.app.setTool(tool);
    salon.app.pointer({PointerPhase::Down, PointerKind::Mouse, 1, *beside, 1});
    run(salon.app, 0.3f);
    salon.app.pointer({PointerPhase::Move, PointerKind::Mouse, 1, *beside + Vec2(0, 10), 1});
    run(salon.app, 0.3f);
    EXPECT_EQ(salon.app.camera().yaw, yaw);
    float most = 0;
    for (std::size_t i = 0; i < before.size(); ++i) most = std::max(most, glm::distance(nodes()[i].position, before[i].position));
    EXPECT_GT(most, 0.01f);
  }
}

TEST(AppHair, WaterInItGoesToAnotherAppAndIntoAScene) {
  HairSalon salon, other;
  salon.app.setField("stayWet", "true");
  salon.grow();
  salon.app.setWetness(0.6f);
  run(salon.app, 0.05f);
  ASSERT_TRUE(other.app.restoreHair(salon.app.saveHair()));
  ASSERT_TRUE(other.app.restoreWater(salon.app.saveWater()));
  const double before = salon.app.water().accounts().hair;
  run(other.app, 0.05f);
  EXPECT_GT(before, 0.01);
  EXPECT_NEAR(other.app.water().accounts().hair, before, 1e-3 * before);
  const auto scene = salon.app.saveScene();
  ASSERT_TRUE(other.app.loadModel(scene, "saved.glb"));
  run(other.app, 0.05f);
  // A byte a node.
  EXPECT_NEAR(other.app.water().accounts().hair, before, 0.02 * before);
}

TEST(AppHair, UploadsNothingWhileWetHairIsAtRest) {
  HairSalon salon;
  salon.app.setField("stayWet", "true");
  salon.grow();
  salon.app.setWetness(0.6f);
  for (int i = 0; i < 1200 && salon.app.active(); ++i) {
    salon.app.tick(1 / 60.0f);
    if (i % 60 == 0) salon.stage.draw(salon.app);
  }
  salon.stage.draw(salon.app);
  salon.stage.draw(salon.app);
  EXPECT_EQ(salon.app.stats().uploadedBytes, (salon.app.tick(1), salon.stage.draw(salon.app), salon.app.stats().uploadedBytes));
  EXPECT_FALSE(salon.app.active());
}

TEST(AppHair, IsLitToItsTipsWhereTheEyeIsAtTheLight) {
  HairSalon salon;
  for (const auto& [name, value] : {std::pair("lightYaw", "0"), std::pair("lightPitch", "0.05")}) salon.app.setField(name, value);
  salon.app.setCamera({.yaw = 0, .pitch = 0.05f, .distance = 7});
  salon.app.editHair(HairEdit::AddScalp);
  salon.app.editHair(HairEdit::Cover, 1);
  EXPECT_TRUE(salon.app.setHairValue(0, "guideLength", "1.2"));
  salon.app.editHair(HairEdit::Plant, 100);
  salon.app.settle();
  const test::Picture shaded = salon.picture();
  const test::Picture open = salon.pictureWith("shadows", "none");
  int dark = 0, hair = 0;
  for (std::size_t i = 0; i < open.rgba.size(); i += 4) {
    hair += open.rgba[i] > open.rgba[i + 2] + 30;
    dark += shaded.rgba[i] < 0.6f * open.rgba[i];
  }
  ASSERT_GT(hair, 4000);
  // At the edges of strips, as a texel of the map is larger than a pixel here and holds what lies before: one in thirty. Twice as
  // much is dark where hair comes out of the map.
  EXPECT_LT(dark, 0.05 * hair) << hair;
}

TEST(AppHair, DarkensTheCoatAndTheGroundBelowIt) {
  HairSalon salon;
  salon.app.setCamera({.yaw = 0.4f, .pitch = 0.5f, .distance = 6});
  const test::Picture bare = salon.picture();
  salon.app.editHair(HairEdit::AddScalp);
  salon.app.setField("brushRadius", "0.5");
  salon.app.editHair(HairEdit::Cover, 1);
  EXPECT_TRUE(salon.app.setHairValue(0, "guideLength", "0.7"));
  salon.app.editHair(HairEdit::Plant, 60);
  salon.app.settle();
  const test::Picture haired = salon.picture();
  // The corner of the ground away from the light: wider shadow, no hair.
  double before = 0, after = 0;
  for (int y = 110; y < 150; ++y)
    for (int x = 100; x < 159; ++x) before += bare.at(x, y)[1], after += haired.at(x, y)[1];
  EXPECT_LT(after, 0.97 * before);
}

TEST(AppHair, DarkensTheSkinRightBelowIt) {
  HairSalon salon;
  for (const auto& [name, value] : {std::pair("furLength", "0"), std::pair("density", "0"), std::pair("skinColor", "#808080"), std::pair("ambient", "0.2")})
    salon.app.setField(name, value);
  salon.app.setCamera({.yaw = 0.4f, .pitch = 0.4f, .distance = 2.8f});
  const test::Picture bare = salon.picture();
  salon.app.editHair(HairEdit::AddScalp);
  salon.app.editHair(HairEdit::Cover, 1);
  // Blue, and close to the skin.
  for (const auto& [name, value] : {std::pair("wisps", "1500"), std::pair("rootColor", "#0000ff"), std::pair("tipColor", "#0000ff"), std::pair("gloss", "0"), std::pair("skinCover", "0")})
    EXPECT_TRUE(salon.app.setHairValue(0, name, value));
  salon.app.editHair(HairEdit::Plant, 60);
  salon.app.editHair(HairEdit::Hang, 1);
  salon.app.settle();
  const test::Picture haired = salon.picture();
  float skin = 0, lit = 0;
  for (int y = 50; y < 110; ++y)
    for (int x = 50; x < 110; ++x) {
      if (haired.at(x, y)[0] < 0.8f * haired.at(x, y)[2]) continue;
      ++skin;
      lit += static_cast<float>(haired.at(x, y)[0]) / static_cast<float>(bare.at(x, y)[0]);
    }
  ASSERT_GT(skin, 300);
  EXPECT_LT(lit / skin, 0.85f) << "in the open: 1";
}

}  // namespace
}  // namespace fur::app
