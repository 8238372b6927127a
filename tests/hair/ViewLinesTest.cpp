#include "hair/ViewLines.h"

#include <gtest/gtest.h>

#include "hair/Mane.h"

namespace fur::hair {
namespace {

constexpr Model kShownModels[] = {Model::Spring, Model::Cascade, Model::Forest};

TEST(References, AreWhereTheNodesAreWhileHairHangsInItsShape) {
  for (const Model model : kShownModels) {
    Shaken hair;
    hair.values.model = model;
    hair.run(1);
    const std::vector<Vec3> references = hair.simulation.references();
    for (std::size_t i = 0; i < references.size(); ++i)
      EXPECT_LT(glm::distance(references[i], hair.simulation.nodes()[i].position), 1e-3f) << static_cast<int>(model) << ' ' << i;
  }
}

TEST(References, PullAgainstTheWind) {
  for (const Model model : kShownModels) {
    Shaken hair;
    hair.values.model = model;
    hair.wind.force = Vec3(1, 0, 0);
    hair.run(1);
    const std::vector<Vec3> references = hair.simulation.references();
    float pull = 0;
    for (std::size_t i = 0; i < references.size(); ++i) pull += references[i].x - hair.simulation.nodes()[i].position.x;
    EXPECT_LT(pull / static_cast<float>(references.size()), -1e-4f) << static_cast<int>(model);
  }
}

TEST(Simulation, SaysOfStaticGuidesThatNoForceMovesThem) {
  Mane mane;
  mane.guides.flags[5] = kStatic;
  const std::vector<std::uint8_t> simulated = mane.simulation().simulated();
  ASSERT_EQ(simulated.size(), mane.guides.count());
  for (std::size_t g = 0; g < simulated.size(); ++g) EXPECT_EQ(simulated[g], g != 5) << g;
}

TEST(ViewLines, GoThroughEveryNodeOfAGuide) {
  const Mane mane;
  const Simulation simulation = mane.simulation();
  const auto chain = simulation.nodes().subspan(0, 8);
  std::vector<ViewLine> lines;
  addGuide(lines, chain, true, {.dots = 3});
  for (const GuideNode& node : chain) {
    int ends = 0, dots = 0;
    for (const ViewLine& line : lines) {
      const bool from = glm::distance(line.a, node.position) < 1e-5f, to = glm::distance(line.b, node.position) < 1e-5f;
      dots += from && to;
      ends += from != to;
    }
    EXPECT_EQ(dots, 1);
    EXPECT_GE(ends, 1);
  }
}

TEST(ViewLines, OfABodyLieOnIt) {
  for (const Body& body : {Body{Vec3(1, 2, 3), Vec3(1, 2, 3), 0.5f}, Body{Vec3(0), Vec3(0.4f, 1, -0.2f), 0.3f}}) {
    std::vector<ViewLine> lines;
    addBody(lines, body, Vec4(1), 1);
    EXPECT_GT(lines.size(), 60u);
    for (const ViewLine& line : lines)
      for (const Vec3& at : {line.a, line.b}) {
        const Vec3 axis = body.b - body.a;
        const float t = glm::dot(axis, axis) > 0 ? saturate(glm::dot(at - body.a, axis) / glm::dot(axis, axis)) : 0;
        EXPECT_NEAR(glm::distance(at, body.a + axis * t), body.radius, 1e-4f);
      }
  }
}

TEST(HeatColor, RunsFromBlueToRed) {
  EXPECT_GT(heatColor(0).z, heatColor(0).x + 0.5f);
  EXPECT_GT(heatColor(1).x, heatColor(1).z + 0.5f);
  EXPECT_GT(heatColor(0.5f).y, heatColor(0.5f).x + 0.3f);
  EXPECT_EQ(heatColor(-3), heatColor(0));
  EXPECT_EQ(heatColor(7), heatColor(1));
}

}  // namespace
}  // namespace fur::hair
