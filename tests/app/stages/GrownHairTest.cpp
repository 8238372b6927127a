// Long hair without a context: what a person does to it, how it is kept, and how it moves with the model.
#include "app/stages/GrownHair.h"

#include <gtest/gtest.h>

#include "geometry/Primitives.h"
#include "groom/Groom.h"

namespace fur::app {
namespace {

struct Head {
  Head() {
    geometry::Mesh mesh = geometry::makeSphere();
    mesh.uv.clear();
    auto surface = geometry::buildSurface(mesh, geometry::FurMapping::Charts);
    shape.setModel(std::move(mesh), std::move(*surface), {});
    atlas.emplace(shape.surface(), groom.map.size());
  }
  groom::GroomSurface skin() const { return {shape.surface(), shape.query(), *atlas, shape.points()}; }
  GrownHair::Inputs inputs(float seconds, const Mat4& worldFromModel = Mat4(1)) const {
    return {.shape = shape, .settings = settings, .worldFromModel = worldFromModel, .wind = {}, .seconds = seconds};
  }
  std::optional<HairStep> edit(HairEdit what, float value = 1, const Vec3& direction = Vec3(0)) {
    hair.beginStroke();
    hair.edit(shape, skin(), {}, {what, value, direction}, warnings);
    return hair.endStroke();
  }
  std::optional<HairStep> paint(const Vec3& towards) {
    hair.beginStroke();
    dab(Tool::Scalp, 3.0f * towards, -towards);
    return hair.endStroke();
  }
  void dab(Tool tool, const Vec3& origin, const Vec3& direction) {
    hair.dab({tool, origin, direction, shape.query().castRay(origin, direction), skin(), groom.mask, settings, shape});
  }
  // A stroke along a row of rays in -z; the step that it makes.
  std::optional<HairStep> stroke(Tool tool, const Vec2& from, const Vec2& to) {
    hair.beginStroke();
    for (int i = 0; i <= 10; ++i) {
      dab(tool, Vec3(glm::mix(from, to, static_cast<float>(i) / 10), 4), Vec3(0, 0, -1));
      hair.update(inputs(0));
    }
    return hair.endStroke();
  }
  const hair::Guides& guides() const { return hair.style().scalps[0].guides; }
  void growEverywhere() {
    edit(HairEdit::AddScalp);
    edit(HairEdit::Cover, 1);
    edit(HairEdit::Plant, 40);
    hair.update(inputs(0));
  }
  Vec3 tip() const { return hair.nodes(0)[static_cast<std::size_t>(hair.style().scalps[0].guides.nodes) - 1].position; }

  ShapeStage shape;
  settings::Settings settings;
  groom::Groom groom{groom::GroomMap(), {}, {}};
  std::optional<geometry::AtlasTexels> atlas;
  GrownHair hair;
  Warnings warnings;
};

TEST(GrownHair, GrowsWhereItsScalpIsPaintedAndNowhereElse) {
  Head head;
  head.edit(HairEdit::AddScalp);
  head.settings.brushRadius = 0.5f;
  head.settings.groomStrength = 1;
  ASSERT_TRUE(head.paint({0, 1, 0}));
  head.edit(HairEdit::Plant, 20);
  EXPECT_TRUE(head.hair.update(head.inputs(0)));
  ASSERT_EQ(head.hair.scalpCount(), 1u);
  EXPECT_GT(head.hair.growth(0).wisps.size(), 100u);
  for (const hair::Wisp& wisp : head.hair.growth(0).wisps) EXPECT_LT(glm::distance(wisp.root, Vec3(0, 1, 0)), 0.55f);
  EXPECT_EQ(head.hair.nodes(0).size(), head.hair.style().scalps[0].guides.positions.size());
}

TEST(GrownHair, EveryEditIsOneStepThatUndoTakesBackAndRedoBringsAgain) {
  Head head;
  head.growEverywhere();
  // Some to let swing and to show again.
  head.settings.brushRadius = 0.3f;
  head.settings.groomStrength = 1;
  ASSERT_TRUE(head.stroke(Tool::HairHold, {-0.2f, 0.1f}, {0.2f, 0.1f}));
  ASSERT_TRUE(head.stroke(Tool::HairHide, {-0.2f, 0.1f}, {0.2f, 0.1f}));
  for (const auto& [what, value] : {std::pair(HairEdit::ShowAll, 0.0f), {HairEdit::FreeAll, 0.0f}, {HairEdit::Hang, 0.7f}, {HairEdit::Curl, 2.0f},
                                    {HairEdit::Twist, 1.0f}, {HairEdit::Straighten, 0.5f}, {HairEdit::Lengthen, 1.5f}, {HairEdit::Mirror, 1.0f},
                                    {HairEdit::AddScalp, 1.0f}, {HairEdit::Select, 0.0f}, {HairEdit::Select, 1.0f}, {HairEdit::Cover, 0.5f}, {HairEdit::AddSphere, 0.5f},
                                    {HairEdit::ClearBodies, 0.0f}, {HairEdit::AddCapsule, 0.5f}, {HairEdit::ClearBodies, 0.0f}, {HairEdit::Remove, 0.0f},
                                    {HairEdit::Plant, 30.0f}, {HairEdit::HoldAll, 0.0f}, {HairEdit::InvertHidden, 0.0f}, {HairEdit::Clear, 0.0f}}) {
    const auto before = head.hair.save();
    const auto step = head.edit(what, value);
    ASSERT_TRUE(step) << nameOf(what);
    const auto after = head.hair.save();
    EXPECT_NE(before, after) << nameOf(what);
    head.hair.apply(*step, true);
    EXPECT_EQ(head.hair.save(), before) << nameOf(what);
    head.hair.apply(*step, false);
    EXPECT_EQ(head.hair.save(), after) << nameOf(what);
  }
  EXPECT_TRUE(head.warnings.empty());
}

TEST(GrownHair, EditsThatHaveNothingToWorkOnSayWhyAndLeaveNoStep) {
  Head head;
  EXPECT_FALSE(head.edit(HairEdit::Plant, 20));
  ASSERT_EQ(head.warnings.size(), 1u);
  EXPECT_NE(head.warnings[0].find("no scalp yet"), std::string::npos);
  head.edit(HairEdit::AddScalp);
  EXPECT_FALSE(head.edit(HairEdit::Plant, 20));  // nothing is painted
  EXPECT_FALSE(head.edit(HairEdit::Plant, 1e9f));
  EXPECT_EQ(head.warnings.size(), 3u);
  for (std::size_t i = 1; i < hair::kMostScalps; ++i) EXPECT_TRUE(head.edit(HairEdit::AddScalp));
  EXPECT_FALSE(head.edit(HairEdit::AddScalp));
  EXPECT_NE(head.warnings.back().find("at most 8 scalps"), std::string::npos);
}

TEST(GrownHair, IsTheSameAfterItWasSavedAndRestored) {
  Head head, other;
  head.growEverywhere();
  ASSERT_TRUE(head.hair.setValue(0, "curl", "0.7", head.warnings));
  ASSERT_TRUE(head.hair.setValue(0, "rootColor", "#102030", head.warnings));
  ASSERT_TRUE(head.hair.setValue(0, "name", "mane", head.warnings));
  head.edit(HairEdit::AddSphere, 0.4f, {0, 0.1f, 0});
  ASSERT_TRUE(other.hair.restore(head.hair.save()));
  EXPECT_EQ(other.hair.save(), head.hair.save());
  EXPECT_EQ(other.hair.style().scalps[0].name, "mane");
  EXPECT_EQ(other.hair.style().scalps[0].values, head.hair.style().scalps[0].values);
  EXPECT_EQ(other.hair.style().bodies, head.hair.style().bodies);
  head.hair.update(head.inputs(0));
  other.hair.update(other.inputs(0));
  EXPECT_EQ(other.hair.growth(0).wisps, head.hair.growth(0).wisps);
}

TEST(GrownHair, RefusesBytesThatAreCutOrOfAnotherKindAndStaysAsItIs) {
  Head head;
  head.growEverywhere();
  const std::vector<std::uint8_t> bytes = head.hair.save();
  for (std::size_t size = 1; size < bytes.size(); size += 1 + bytes.size() / 97)
    EXPECT_FALSE(head.hair.restore(std::span(bytes).first(size))) << size;
  std::vector<std::uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(head.hair.restore(longer));
  std::vector<std::uint8_t> other = bytes;
  other[0] ^= 0xff;
  EXPECT_FALSE(head.hair.restore(other));
  EXPECT_EQ(head.hair.save(), bytes);
}

TEST(GrownHair, ValuesOfAnUnknownNameOrScalpAreErrorsThatNameThem) {
  Head head;
  head.growEverywhere();
  const Status name = head.hair.setValue(0, "sharpness", "1", head.warnings);
  ASSERT_FALSE(name);
  EXPECT_NE(name.error().message.find("sharpness"), std::string::npos);
  const Status scalp = head.hair.setValue(3, "curl", "1", head.warnings);
  ASSERT_FALSE(scalp);
  EXPECT_NE(scalp.error().message.find("scalp 3"), std::string::npos);
  EXPECT_TRUE(head.hair.setValue(0, "curl", "7", head.warnings));  // clamped, with a warning
  EXPECT_EQ(head.hair.style().scalps[0].values.curl, 1);
  EXPECT_EQ(head.warnings.size(), 1u);
}

TEST(GrownHair, KeepsNamesOfAtMost64BytesWithoutCuttingACharacter) {
  Head head;
  head.growEverywhere();
  std::string name(63, 'm');
  const std::string kept = name;
  name += "\xc3\xa4hne";
  ASSERT_TRUE(head.hair.setValue(0, "name", name, head.warnings));
  EXPECT_EQ(head.hair.style().scalps[0].name, kept);
}

TEST(GrownHair, SwingsWhenTheModelMovesAndThenSleeps) {
  Head head;
  head.growEverywhere();
  const Vec3 before = head.tip();
  EXPECT_FALSE(head.hair.active(head.inputs(0)));
  const Mat4 moved = glm::translate(Mat4(1), Vec3(0.3f, 0, 0));
  // It stays behind: seen from the model it goes the other way.
  EXPECT_TRUE(head.hair.update(head.inputs(1 / 30.0f, moved)));
  EXPECT_LT(head.tip().x, before.x - 0.05f);
  int steps = 0;
  while (head.hair.active(head.inputs(0, moved)) && steps < 3000) head.hair.update(head.inputs(1 / 60.0f, moved)), ++steps;
  EXPECT_LT(steps, 3000);
  EXPECT_LT(glm::distance(head.tip(), before), 0.02f);
  const std::uint64_t revision = head.hair.revision();
  EXPECT_FALSE(head.hair.update(head.inputs(1 / 60.0f, moved)));
  EXPECT_EQ(head.hair.revision(), revision);
}

TEST(GrownHair, GoesOnSwingingWhereOnlyItsLooksChange) {
  Head head;
  head.growEverywhere();
  const Mat4 moved = glm::translate(Mat4(1), Vec3(0.3f, 0, 0));
  head.hair.update(head.inputs(1 / 30.0f, moved));
  const Vec3 swinging = head.tip();
  ASSERT_TRUE(head.hair.setValue(0, "tipColor", "#ff0000", head.warnings));
  head.hair.update(head.inputs(0, moved));
  EXPECT_EQ(head.tip(), swinging);
  EXPECT_TRUE(head.hair.active(head.inputs(0, moved)));
}

TEST(GrownHair, IsShapedByToolsWhereItIsSeenEachStrokeAStepOfUndo) {
  Head head;
  head.settings.groomStrength = 1;
  head.growEverywhere();
  const auto grown = head.hair.save();
  for (const Tool tool : {Tool::HairComb, Tool::HairMove, Tool::HairCut, Tool::HairLength, Tool::HairCurl, Tool::HairTwist, Tool::HairCopy,
                          Tool::HairHold, Tool::HairHide, Tool::Scalp}) {
    head.settings.brushRadius = tool == Tool::HairMove ? 0.6f : 0.3f;  // which takes hold within half of that
    if (tool == Tool::Scalp) head.edit(HairEdit::Cover, 0);
    // Shapes to copy and to twist.
    const bool needsCurls = tool == Tool::HairCopy || tool == Tool::HairTwist;
    const auto curls = needsCurls ? head.stroke(Tool::HairCurl, {-0.2f, 0.1f}, {0, 0.1f}) : std::nullopt;
    ASSERT_EQ(curls.has_value(), needsCurls);
    const auto before = head.hair.save();
    const auto step = head.stroke(tool, {-0.2f, 0.1f}, {0.2f, 0.1f});
    ASSERT_TRUE(step) << nameOf(tool);
    head.hair.apply(*step, true);
    EXPECT_EQ(head.hair.save(), before) << nameOf(tool);
    if (curls) head.hair.apply(*curls, true);
    if (tool != Tool::Scalp) EXPECT_EQ(head.hair.save(), grown) << nameOf(tool);
  }
}

TEST(GrownHair, KeepsItsLengthUnderTheCombAndFollowsIt) {
  Head head;
  head.settings.brushRadius = 0.4f;
  head.settings.groomStrength = 1;
  head.growEverywhere();
  const hair::Guides before = head.guides();
  ASSERT_TRUE(head.stroke(Tool::HairComb, {-0.2f, 0}, {0.3f, 0}));
  const hair::Guides& after = head.guides();
  float most = 0, moved = 0;
  for (std::size_t g = 0; g < before.count(); ++g) {
    most = std::max(most, std::abs(hair::lengthOf(after.of(g)) - hair::lengthOf(before.of(g))) / hair::lengthOf(before.of(g)));
    moved = std::max(moved, (after.of(g).back() - before.of(g).back()).x);
  }
  EXPECT_LT(most, 0.01f);
  EXPECT_GT(moved, 0.1f);
}

TEST(GrownHair, TakesEveryDabOfAFastStrokeThoughNoTimeGoesByBetween) {
  const auto lengthAfter = [](int dabs) {
    Head head;
    head.settings.brushRadius = 0.3f;
    head.settings.groomStrength = 1;
    head.growEverywhere();
    head.hair.beginStroke();
    for (int i = 0; i < dabs; ++i) head.dab(Tool::HairLength, Vec3(0, 0.1f, 4), Vec3(0, 0, -1));
    head.hair.endStroke();
    float sum = 0;
    for (std::size_t g = 0; g < head.guides().count(); ++g) sum += hair::lengthOf(head.guides().of(g));
    return sum;
  };
  EXPECT_GT(lengthAfter(4), lengthAfter(1) + 0.05f);
}

TEST(GrownHair, WorksOutItsOcclusionWhenAStrokeEndsAndNotAtEachDab) {
  Head head;
  head.settings.brushRadius = 0.5f;
  head.settings.groomStrength = 1;
  head.growEverywhere();
  const std::vector<std::uint8_t> before = head.hair.growth(0).ambient;
  head.hair.beginStroke();
  for (int i = 0; i < 8; ++i) {
    head.dab(Tool::HairLength, Vec3(0, 0.1f, 4), Vec3(0, 0, -1));
    head.hair.update(head.inputs(0));
    ASSERT_EQ(head.hair.growth(0).ambient, before);
  }
  head.hair.endStroke();
  EXPECT_TRUE(head.hair.active(head.inputs(0)));
  head.hair.update(head.inputs(0));
  EXPECT_NE(head.hair.growth(0).ambient, before);
}

TEST(GrownHair, HangsOutsideOfTheSkinAndLosesNoLength) {
  Head head;
  head.growEverywhere();
  const hair::Guides before = head.guides();
  ASSERT_TRUE(head.edit(HairEdit::Hang, 1));
  for (std::size_t g = 0; g < before.count(); ++g) {
    const auto chain = head.guides().of(g);
    EXPECT_NEAR(hair::lengthOf(chain), hair::lengthOf(before.of(g)), 1e-4f);
    // The model is the unit sphere; its triangles lie a little inside.
    for (const Vec3& node : chain) EXPECT_GT(glm::length(node), 0.97f);
    EXPECT_LE(chain.back().y, before.of(g).back().y + 1e-4f);
  }
}

TEST(GrownHair, IsWorkedOnThroughTheMirrorAsWell) {
  Head head;
  head.settings.brushRadius = 0.3f;
  head.settings.groomStrength = 1;
  head.settings.mirror = 1;
  head.growEverywhere();
  ASSERT_TRUE(head.edit(HairEdit::Mirror, 1));
  head.hair.update(head.inputs(0));
  ASSERT_TRUE(head.stroke(Tool::HairComb, {0.3f, 0}, {0.5f, 0}));
  // Each guide has its twin on the other side.
  for (std::size_t g = 0; g < head.guides().count(); ++g) {
    const Vec3 tip = head.guides().of(g).back();
    float nearest = 1;
    for (std::size_t other = 0; other < head.guides().count(); ++other)
      nearest = std::min(nearest, glm::distance(head.guides().of(other).back(), tip * Vec3(-1, 1, 1)));
    EXPECT_LT(nearest, 1e-3f) << g;
  }
}

TEST(GrownHair, LiesOnTheGroundAndHangsThroughItOnlyWhereNoneIsDrawn) {
  Head head;
  head.edit(HairEdit::AddScalp);
  head.edit(HairEdit::Paint, 1, Vec3(0, 1, 0));
  ASSERT_TRUE(head.hair.setValue(0, "guideLength", "2.8", head.warnings));
  head.edit(HairEdit::Plant, 40);
  head.edit(HairEdit::Hang, 1);
  const auto lowest = [&] {
    float low = 0;
    for (const hair::GuideNode& node : head.hair.nodes(0)) low = std::min(low, node.position.y);
    return low - head.shape.groundHeight();
  };
  head.settings.ground = false;
  head.hair.settle(head.inputs(0));
  EXPECT_LT(lowest(), -0.3f);
  head.settings.ground = true;
  for (int i = 0; i < 120; ++i) head.hair.update(head.inputs(1.0f / 60));
  EXPECT_GT(lowest(), -0.03f);
  head.hair.settle(head.inputs(0));
  EXPECT_GT(lowest(), -0.03f);
  for (int i = 0; i < 240; ++i) head.hair.update(head.inputs(1.0f / 60));
  EXPECT_FALSE(head.hair.active(head.inputs(0))) << "it sleeps there";
}

TEST(GrownHair, PlantsWispsAnewOnlyWhereRootsMapOrValuesAreOthers) {
  Head head;
  head.growEverywhere();
  const std::vector<hair::Wisp> before = head.hair.growth(0).wisps;
  const auto sameRoots = [&] {
    const auto& now = head.hair.growth(0).wisps;
    return now.size() == before.size() && std::equal(now.begin(), now.end(), before.begin(), [](const auto& a, const auto& b) { return a.root == b.root && a.weightsByPlace == b.weightsByPlace; });
  };
  head.edit(HairEdit::Hang, 1);
  head.hair.update(head.inputs(0));
  EXPECT_TRUE(sameRoots());
  EXPECT_NE(head.hair.growth(0).wisps, before);  // they follow guides of another shape
  ASSERT_TRUE(head.hair.setValue(0, "seed", "9", head.warnings));
  head.hair.update(head.inputs(0));
  EXPECT_FALSE(sameRoots());
}

TEST(GrownHair, GoesIntoAHairFileStrandByStrandAndComesBackAsGuides) {
  Head head, other;
  head.growEverywhere();
  const auto bytes = head.hair.writeFile();
  ASSERT_TRUE(bytes);
  other.hair.beginStroke();
  ASSERT_TRUE(other.hair.readFile(other.shape, other.skin(), bytes.value(), "locks.hair"));
  EXPECT_TRUE(other.hair.endStroke());
  ASSERT_EQ(other.hair.style().scalps.size(), 1u);
  EXPECT_EQ(other.hair.style().scalps[0].name, "locks");
  EXPECT_EQ(other.guides().count(), 128u);  // of 9,900 strands
  other.hair.update(other.inputs(0));
  EXPECT_GT(other.hair.growth(0).wisps.size(), 100u);
  float mean = 0;
  for (std::size_t g = 0; g < other.guides().count(); ++g) mean += hair::lengthOf(other.guides().of(g)) / 128;
  EXPECT_NEAR(mean, head.hair.style().scalps[0].values.guideLength, 0.25f);
}

TEST(GrownHair, OfAHairFileGrowsWhereItsStrandsAreRooted) {
  Head head, other;
  head.edit(HairEdit::AddScalp);
  head.edit(HairEdit::Paint, 0.9f, Vec3(0, 1, 0));
  head.edit(HairEdit::Plant, 60);
  head.hair.update(head.inputs(0));
  const auto bytes = head.hair.writeFile();
  ASSERT_TRUE(bytes);
  other.hair.beginStroke();
  ASSERT_TRUE(other.hair.readFile(other.shape, other.skin(), bytes.value(), "cap.hair"));
  EXPECT_TRUE(other.hair.endStroke());
  other.hair.update(other.inputs(0));
  ASSERT_GT(other.hair.growth(0).wisps.size(), 200u);
  for (const hair::Wisp& wisp : other.hair.growth(0).wisps) EXPECT_LT(glm::distance(wisp.root, Vec3(0, 1, 0)), 1.2f);
}

TEST(GrownHair, RefusesAHairFileThatIsNoneAndStaysAsItIs) {
  Head head;
  head.growEverywhere();
  const auto before = head.hair.save();
  std::vector<std::uint8_t> lie(40, 0);
  std::copy_n("HAIR\x40\x42\x0f\x00", 8, lie.begin());  // a million strands in 40 bytes
  head.hair.beginStroke();
  const Status refused = head.hair.readFile(head.shape, head.skin(), lie, "lie.hair");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("lie.hair"), std::string::npos);
  EXPECT_FALSE(head.hair.endStroke());
  EXPECT_EQ(head.hair.save(), before);
  Head bald;
  EXPECT_FALSE(bald.hair.writeFile());
}

TEST(HairStage, OfAProgramWithoutHairHasNone) {
  HairStage none;
  Warnings warnings;
  EXPECT_EQ(none.scalpCount(), 0u);
  EXPECT_EQ(none.describe(), "[]");
  EXPECT_TRUE(none.save().empty());
  EXPECT_TRUE(none.restore({}));
  const std::uint8_t some[] = {1, 2, 3};
  EXPECT_FALSE(none.restore(some));
  EXPECT_FALSE(none.setValue(0, "curl", "1", warnings));
}

TEST(GrownHair, GrowsInPiecesAsAtOnce) {
  Head head, other;
  other.growEverywhere();
  head.hair.setStyle(other.hair.style());
  int pieces = 1;
  while (!head.hair.workOnGrowth(head.inputs(0))) ++pieces;
  EXPECT_GE(pieces, 5);
  EXPECT_FALSE(head.hair.update(head.inputs(0)));  // nothing is left to do
  ASSERT_EQ(head.hair.scalpCount(), 1u);
  EXPECT_EQ(head.hair.growth(0).wisps.size(), other.hair.growth(0).wisps.size());
  EXPECT_EQ(head.hair.growth(0).ambient, other.hair.growth(0).ambient);
  EXPECT_EQ(head.tip(), other.tip());
}

}  // namespace
}  // namespace fur::app
