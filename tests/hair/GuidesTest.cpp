#include "hair/Guides.h"

#include <gtest/gtest.h>

#include <limits>

#include "hair/Mane.h"

namespace fur::hair {
namespace {

// A quarter of a circle of radius 1.
std::vector<Vec3> arc(int nodes) {
  std::vector<Vec3> out;
  for (int i = 0; i < nodes; ++i) {
    const float angle = 0.5f * kPi * static_cast<float>(i) / static_cast<float>(nodes - 1);
    out.push_back({1 - std::cos(angle), std::sin(angle), 0});
  }
  return out;
}

TEST(Guides, KeepTheirLengthWithAnyNumberOfNodes) {
  for (const int nodes : {4, 5, 8, 16, 32}) {
    const std::vector<Vec3> chain = resampled(arc(12), nodes);
    ASSERT_EQ(chain.size(), static_cast<std::size_t>(nodes));
    EXPECT_EQ(chain[0], Vec3(0));
    EXPECT_NEAR(lengthOf(chain) / lengthOf(arc(12)), 1, 1e-5f);
    for (std::size_t i = 1; i < chain.size(); ++i)
      EXPECT_NEAR(glm::length(chain[i] - chain[i - 1]), lengthOf(chain) / static_cast<float>(nodes - 1), 0.02f * lengthOf(chain) / static_cast<float>(nodes - 1));
  }
}

TEST(Guides, AreAsTheyWereWithAsManyNodes) {
  const std::vector<Vec3> chain = arc(9), again = resampled(chain, 9);
  for (std::size_t i = 0; i < chain.size(); ++i) EXPECT_LT(glm::length(again[i] - chain[i]), 1e-5f);
}

TEST(Guides, OfNothingOrOneNodeResampleToWhatThereIs) {
  EXPECT_TRUE(resampled({}, 5).empty());
  const Vec3 one(1, 2, 3);
  for (const Vec3& p : resampled({&one, 1}, 4)) EXPECT_EQ(p, one);
}

TEST(Guides, FramesTurnWithTheHairAndNotAboutIt) {
  const std::vector<Vec3> chain = arc(20);
  std::vector<GuideNode> nodes(chain.size());
  frameNodes(chain, {}, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(nodes[i].position, chain[i]);
    const Vec3 along = nodes[i].frame * Vec3(0, 1, 0);
    const Vec3 before = i > 0 ? chain[i] - chain[i - 1] : chain[1] - chain[0], after = i + 1 < chain.size() ? chain[i + 1] - chain[i] : before;
    EXPECT_LT(glm::length(along - glm::normalize(glm::normalize(before) + glm::normalize(after))), 1e-5f);
    // The arc lies in the plane of x and y: z stays.
    EXPECT_LT(glm::length(nodes[i].frame * Vec3(0, 0, 1) - Vec3(0, 0, 1)), 1e-5f);
  }
}

TEST(Guides, FramesOfAStraightHairAreItsRoots) {
  RootFrame root;
  root.normal = glm::normalize(Vec3(1, 2, 0.5f));
  root.tangent = glm::normalize(glm::cross(root.normal, Vec3(0, 0, 1)));
  std::vector<Vec3> chain;
  for (int i = 0; i < 6; ++i) chain.push_back(root.normal * static_cast<float>(i));
  std::vector<GuideNode> nodes(6);
  frameNodes(chain, root, nodes);
  for (const GuideNode& node : nodes) {
    EXPECT_LT(glm::length(node.frame * Vec3(1, 0, 0) - root.tangent), 1e-5f);
    EXPECT_LT(glm::length(node.frame * Vec3(0, 1, 0) - root.normal), 1e-5f);
  }
}

TEST(Guides, FramesAreUnitWhereHairTurnsBackOrStandsStill) {
  const std::vector<Vec3> chain = {Vec3(0), Vec3(0, 1, 0), Vec3(0), Vec3(0), Vec3(0, -1, 0), Vec3(0, -1, 0)};
  std::vector<GuideNode> nodes(chain.size());
  frameNodes(chain, {}, nodes);
  for (const GuideNode& node : nodes) EXPECT_NEAR(glm::dot(node.frame, node.frame), 1, 1e-5f);
}

TEST(Guides, FromOutsideAreMadeSoundOrRefused) {
  Guides guides = Mane().guides;
  EXPECT_TRUE(makeSound(guides));
  EXPECT_EQ(guides, Mane().guides);
  guides.positions[3] = guides.positions[2];
  EXPECT_TRUE(makeSound(guides));
  EXPECT_GT(glm::length(guides.positions[3] - guides.positions[2]), 0);
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    Guides spoilt = Mane().guides;
    spoilt.positions[5].y = bad;
    EXPECT_FALSE(makeSound(spoilt));
  }
  Guides few = Mane().guides;
  few.positions.pop_back();
  EXPECT_FALSE(makeSound(few));
  few.nodes = 1;
  EXPECT_FALSE(makeSound(few));
}

}  // namespace
}  // namespace fur::hair
