#include "hair/PlantGuides.h"

#include <gtest/gtest.h>

#include <limits>

#include "hair/TestScalps.h"

namespace fur::hair {
namespace {

using test::TestScalp;

TEST(PlantGuides, TheyStandStraightOutOfTheSkinAndAreAsLongAsAsked) {
  const TestScalp sphere(geometry::makeSphere());
  HairValues values;
  values.guideLength = 0.8f, values.nodes = 6;
  Guides guides = plantGuides(sphere.scalp(), values, 40).value();
  ASSERT_EQ(guides.count(), 40u);
  EXPECT_EQ(guides.nodes, 6);
  EXPECT_TRUE(makeSound(guides));
  for (std::size_t g = 0; g < guides.count(); ++g) {
    EXPECT_NEAR(lengthOf(guides.of(g)), 0.8f, 1e-4);
    const Vec3 way = glm::normalize(guides.of(g).back() - guides.root(g));
    EXPECT_GT(glm::dot(way, glm::normalize(guides.root(g))), 0.999f);
  }
}

TEST(PlantGuides, TheyBendTheWayTheFurIsCombedAndKeepTheirLength) {
  TestScalp plane(geometry::makePlane(8));
  // Towards the rim the normals lean outwards.
  plane.paint([](const Vec3& p) -> groom::GroomMap::Texel { return {static_cast<std::uint8_t>(glm::length(p) < 0.4f ? 255 : 0), 255, 255, 255}; });
  HairValues values;
  values.nodes = 16;
  const std::vector<Vec3> comb(plane.surface.vertices.size(), Vec3(1, 0.5f, 0));
  const Guides guides = plantGuides(plane.scalp(), values, 20, comb).value();
  for (std::size_t g = 0; g < guides.count(); ++g) {
    const auto chain = guides.of(g);
    EXPECT_GT(chain.back().x - chain[0].x, 0.2f);
    EXPECT_NEAR(chain.back().z, chain[0].z, 1e-5);
    EXPECT_NEAR(lengthOf(chain), values.guideLength, 0.01f);
    // By 1 rad at the tip.
    const Vec3 tip = glm::normalize(chain[15] - chain[14]);
    EXPECT_NEAR(std::atan2(tip.x, tip.y), 1 - 0.5f / 15, 0.01f);
  }
}

TEST(PlantGuides, WhatCannotBeIsAnErrorThatSaysWhy) {
  TestScalp sphere(geometry::makeSphere());
  for (const int count : {0, -3, 1025}) {
    const auto guides = plantGuides(sphere.scalp(), {}, count);
    ASSERT_FALSE(guides);
    EXPECT_EQ(guides.error().id, ErrorId::TooLarge);
    EXPECT_EQ(guides.error().message, "guides: " + std::to_string(count) + " of them; a scalp has 1 to 1024");
  }
  sphere.paint([](const Vec3&) { return groom::GroomMap::kBlank; });
  const auto guides = plantGuides(sphere.scalp(), {}, 10);
  ASSERT_FALSE(guides);
  EXPECT_EQ(guides.error().id, ErrorId::BadFile);
  EXPECT_EQ(guides.error().message, "guides: the scalp covers nothing: its density is 0 everywhere");
}

TEST(PlantGuides, AtASpacingTheyAreAboutThatFarApart) {
  const TestScalp sphere(geometry::makeSphere());
  for (const float spacing : {0.2f, 0.5f}) {
    const Guides guides = plantGuides(sphere.scalp(), {}, guidesAtSpacing(sphere.scalp(), spacing)).value();
    float sum = 0;
    for (std::size_t a = 0; a < guides.count(); ++a) {
      float nearest = 9;
      for (std::size_t b = 0; b < guides.count(); ++b)
        if (a != b) nearest = std::min(nearest, glm::length(guides.root(a) - guides.root(b)));
      sum += nearest;
    }
    EXPECT_NEAR(sum / static_cast<float>(guides.count()), spacing, 0.2f * spacing);
  }
  EXPECT_EQ(guidesAtSpacing(sphere.scalp(), 100), 1);
  EXPECT_EQ(guidesAtSpacing(sphere.scalp(), 0), static_cast<int>(kMostGuides));
}

TEST(RootFrames, TheyStandOnTheSkinAndArePerpendicular) {
  const TestScalp sphere(geometry::makeSphere());
  const Guides guides = plantGuides(sphere.scalp(), {}, 60).value();
  const auto roots = sphere.roots(guides);
  for (std::size_t g = 0; g < roots.size(); ++g) {
    EXPECT_EQ(roots[g].position, guides.root(g));
    EXPECT_GT(glm::dot(roots[g].normal, glm::normalize(roots[g].position)), 0.99f);
    EXPECT_NEAR(glm::length(roots[g].tangent), 1, 1e-5);
    EXPECT_NEAR(glm::dot(roots[g].tangent, roots[g].normal), 0, 1e-5);
  }
}

TEST(RootFrames, TangentsTurnSmoothlyButAtTheUnderside) {
  for (float y = -0.95f; y <= 1; y += 0.05f)
    for (float angle = 0; angle < 6.2f; angle += 0.1f) {
      const auto normal = [&](float a) { const float r = std::sqrt(1 - y * y); return Vec3(r * std::cos(a), y, r * std::sin(a)); };
      EXPECT_GT(glm::dot(evenTangent(normal(angle)), evenTangent(normal(angle + 0.1f))), 0.9f);
    }
  for (const Vec3& n : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0)}) EXPECT_NEAR(glm::length(evenTangent(n)), 1, 1e-6);
}

TEST(RootFrames, GuidesFarOffTheSkinOrOfNoNumbersGetOneAsWell) {
  const TestScalp sphere(geometry::makeSphere());
  Guides guides = test::guidesAt({{0, 3, 0}, {0, 90, 0}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}}, [](const Vec3&) { return Vec3(0, 1, 0); });
  const auto roots = sphere.roots(guides);
  for (const RootFrame& root : roots) EXPECT_EQ(root.normal.y > 0.99f, true);
}

}  // namespace
}  // namespace fur::hair
