// Spheres and capsules that hair does not enter, on a model with bones.
#include <gtest/gtest.h>

#include "app/stages/GrownHair.h"
#include "scene/Model.h"
#include "scene/Tentacle.h"

namespace fur::app {
namespace {

struct Arm {
  Arm() {
    auto model = scene::importModel(scene::Tentacle().build(), "tentacle.glb");
    auto surface = geometry::buildSurface(model->mesh, geometry::FurMapping::Charts);
    shape.setModel(std::move(model->mesh), std::move(*surface), std::move(model->rig));
    atlas.emplace(shape.surface(), map.size());
    settings.hairView = 6;  // shapes
  }
  std::optional<HairStep> edit(HairEdit what, float value = 1, const Vec3& direction = Vec3(0)) {
    hair.beginStroke();
    hair.edit(shape, {shape.surface(), shape.query(), *atlas, shape.points()}, {}, {what, value, direction}, warnings);
    auto step = hair.endStroke();
    update();
    return step;
  }
  void update() { hair.update({.shape = shape, .settings = settings, .wind = {}, .seconds = 0}); }
  // The middle of what is seen of the shapes.
  Vec3 middle() {
    const hair::HairView* view = hair.view({.settings = settings, .tool = Tool::None});
    EXPECT_TRUE(view && !view->lines.empty());
    Vec3 sum(0);
    for (const hair::ViewLine& line : view->lines) sum += 0.5f * (line.a + line.b) / static_cast<float>(view->lines.size());
    return sum;
  }
  const std::vector<hair::Body>& bodies() const { return hair.style().bodies; }

  ShapeStage shape;
  groom::GroomMap map;
  settings::Settings settings;
  std::optional<geometry::AtlasTexels> atlas;
  GrownHair hair;
  Warnings warnings;
};

TEST(HairBodies, FittedToBonesGoWithThem) {
  Arm arm;
  ASSERT_TRUE(arm.edit(HairEdit::FitBones));
  ASSERT_GE(arm.bodies().size(), 3u);
  const std::vector<hair::Body> asMade = arm.bodies();
  const Vec3 before = arm.middle();
  arm.shape.update({0, 0, 1});
  arm.shape.update({0.4f, 0, 1});
  arm.update();
  const Vec3 moved = arm.middle();
  EXPECT_GT(glm::distance(moved, before), 0.02f);
  EXPECT_EQ(arm.bodies(), asMade) << "where they are as made is kept";
  // As far as the skin that they stand for, on the mean.
  Vec3 skin(0);
  const auto& vertices = arm.shape.surface().vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    skin += (arm.shape.skin()->positions[i] - vertices[i].position) / static_cast<float>(vertices.size());
  EXPECT_LT(glm::distance(moved - before, skin), 0.5f * glm::length(skin));
}

TEST(HairBodies, OfNoBoneStayWhereTheyAre) {
  Arm arm;
  arm.edit(HairEdit::AddSphere, 0.2f, {0.1f, 0.2f, 0.3f});
  const Vec3 before = arm.middle();
  arm.shape.update({0, 0, 1});
  arm.shape.update({0.4f, 0, 1});
  arm.update();
  EXPECT_LT(glm::distance(arm.middle(), before), 1e-6f);
}

TEST(HairBodies, EditsChangeTheSelectedOneAndAreUndone) {
  Arm arm;
  arm.edit(HairEdit::AddSphere, 0.2f);
  arm.edit(HairEdit::AddCapsule, 0.1f, {1, 0, 0});
  EXPECT_EQ(arm.hair.selectedBody(), 1);
  EXPECT_EQ(arm.bodies()[1], (hair::Body{Vec3(1, -0.1f, 0), Vec3(1, 0.1f, 0), 0.1f}));
  EXPECT_FALSE(arm.edit(HairEdit::SelectBody, 0)) << "selecting changes nothing that is kept";
  for (const auto& [what, value, direction] : {std::tuple(HairEdit::MoveBody, 1.0f, Vec3(0, 1, 0)), {HairEdit::BodyEnds, 1.0f, Vec3(0, 0, 0.5f)},
                                               {HairEdit::BodyRadius, 0.3f, Vec3(0)}}) {
    const auto before = arm.bodies();
    const auto step = arm.edit(what, value, direction);
    ASSERT_TRUE(step) << nameOf(what);
    EXPECT_NE(arm.bodies()[0], before[0]);
    EXPECT_EQ(arm.bodies()[1], before[1]);
    arm.hair.apply(*step, true);
    EXPECT_EQ(arm.bodies(), before) << nameOf(what);
    arm.hair.apply(*step, false);
  }
  EXPECT_EQ(arm.bodies()[0], (hair::Body{Vec3(0, 1, -0.5f), Vec3(0, 1, 0.5f), 0.3f}));
  ASSERT_TRUE(arm.edit(HairEdit::RemoveBody));
  EXPECT_EQ(arm.bodies().size(), 1u);
  EXPECT_FALSE(arm.edit(HairEdit::RemoveBody)) << "none is selected";
  for (const float bad : {-1.0f, 0.0f}) EXPECT_FALSE(arm.edit(HairEdit::AddSphere, bad));
  arm.edit(HairEdit::AddSphere, 1e9f, Vec3(1e20f));
  EXPECT_EQ(arm.bodies()[1].radius, hair::kLargestBody);
  EXPECT_LT(glm::length(arm.bodies()[1].a), 1e3f);
}

TEST(HairBodies, AreDraggedInThePlaneThatFacesTheEyeInOneStep) {
  Arm arm;
  arm.edit(HairEdit::AddSphere, 0.3f);
  arm.edit(HairEdit::SelectBody, -1);
  arm.hair.beginStroke();
  const groom::GroomSurface surface{arm.shape.surface(), arm.shape.query(), *arm.atlas, arm.shape.points()};
  const auto drag = [&](const Vec2& to) {
    arm.hair.dab({Tool::HairShape, Vec3(to, 5), Vec3(0, 0, -1), std::nullopt, surface, arm.map, arm.settings, arm.shape});
    arm.update();
  };
  drag({0.1f, 0.1f});
  EXPECT_EQ(arm.hair.selectedBody(), 0);
  for (int i = 1; i <= 10; ++i) drag({0.1f + 0.05f * static_cast<float>(i), 0.1f});
  const auto step = arm.hair.endStroke();
  ASSERT_TRUE(step);
  EXPECT_LT(glm::distance(arm.bodies()[0].a, Vec3(0.5f, 0, 0)), 1e-5f);
  arm.hair.apply(*step, true);
  EXPECT_EQ(arm.bodies()[0].a, Vec3(0));
}

}  // namespace
}  // namespace fur::app
