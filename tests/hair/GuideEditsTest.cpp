#include "hair/GuideEdits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/Random.h"
#include "hair/GuideChain.h"
#include "hair/TestScalps.h"

namespace fur::hair {
namespace {

// Guides that hang in bows off a plane, 0.3 apart.
struct Locks {
  Locks() {
    guides.nodes = 10;
    Random random(4);
    for (int g = 0; g < 9; ++g) {
      Vec3 at(0.3f * static_cast<float>(g % 3 - 1), 0, 0.3f * static_cast<float>(g / 3 - 1)), way(0, 1, 0);
      roots.push_back({at, {0, 1, 0}, {1, 0, 0}});
      guides.flags.push_back(0);
      for (int i = 0; i < guides.nodes; ++i) {
        guides.positions.push_back(at);
        way = glm::normalize(way + 0.3f * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
        at += way * random.uniform(0.05f, 0.07f);
      }
    }
    before = guides;
  }
  groom::Brush brush(std::size_t guide, std::size_t node, float radius = 0.12f, float strength = 1) const {
    return {.centre = before.of(guide)[node], .radius = radius, .strength = strength};
  }
  // Roots stay, and what lies out of reach; lengths are kept.
  void expectShape(const groom::Brush& brush) const {
    for (std::size_t g = 0; g < guides.count(); ++g) {
      EXPECT_EQ(guides.root(g), before.root(g));
      if (weightOfLine(brush, before.of(g)) == 0) EXPECT_TRUE(std::equal(guides.of(g).begin(), guides.of(g).end(), before.of(g).begin()));
    }
  }
  void expectLengths() const {
    for (std::size_t g = 0; g < guides.count(); ++g) {
      const auto now = segmentLengths(guides.of(g)), then = segmentLengths(before.of(g));
      for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], then[i], 2e-6) << "guide " << g << ", segment " << i;
    }
  }

  Guides guides, before;
  std::vector<RootFrame> roots;
};

constexpr std::size_t kMiddle = 4;

TEST(GuideEdits, ANodeComesToWhereItIsTakenAndTheRestFollows) {
  Locks locks;
  const Vec3 to = locks.before.of(kMiddle)[6] + Vec3(0.1f, -0.12f, 0.05f);
  EXPECT_TRUE(moveNode(locks.guides, kMiddle, 6, to));
  EXPECT_LT(glm::length(locks.guides.of(kMiddle)[6] - to), 1e-3f);
  locks.expectLengths();
  locks.expectShape(locks.brush(kMiddle, 6, 1e-4f));
  EXPECT_NE(locks.guides.of(kMiddle)[9], locks.before.of(kMiddle)[9]);
  EXPECT_FALSE(moveNode(locks.guides, kMiddle, 0, to));
  EXPECT_FALSE(moveNode(locks.guides, 99, 1, to));
  EXPECT_FALSE(moveNode(locks.guides, kMiddle, 10, to));
}

TEST(GuideEdits, ANodeTakenTooFarStretchesItsGuideThere) {
  Locks locks;
  EXPECT_TRUE(moveNode(locks.guides, kMiddle, 9, {5, 0, 0}));
  locks.expectLengths();
  EXPECT_NEAR(locks.guides.of(kMiddle)[9].x, lengthOf(locks.before.of(kMiddle)), 0.01f);
  EXPECT_TRUE(moveNode(locks.guides, kMiddle, 5, locks.guides.root(kMiddle)));
  locks.expectLengths();
}

TEST(GuideEdits, CombingDragsNodesAlong) {
  Locks locks;
  const auto brush = locks.brush(kMiddle, 6);
  EXPECT_TRUE(comb(locks.guides, brush, {0.05f, 0, 0}));
  EXPECT_GT(locks.guides.of(kMiddle)[6].x, locks.before.of(kMiddle)[6].x + 0.02f);
  locks.expectLengths();
  locks.expectShape(brush);
}

TEST(GuideEdits, ALongStrokeKeepsLengths) {
  Locks locks;
  for (int i = 0; i < 300; ++i) {
    const float x = -0.6f + 0.004f * static_cast<float>(i);
    comb(locks.guides, {.centre = {x, 0.3f, 0}, .radius = 0.25f, .strength = 0.8f}, {0.004f, -0.002f, 0});
  }
  for (std::size_t g = 0; g < 9; ++g) EXPECT_NEAR(lengthOf(locks.guides.of(g)), lengthOf(locks.before.of(g)), 2e-5f);
}

TEST(GuideEdits, CutsAreWhereTheBrushIsMetFirst) {
  Locks locks;
  const auto brush = locks.brush(kMiddle, 6, 0.05f);
  const float before = lengthBefore(brush, locks.before.of(kMiddle));
  EXPECT_TRUE(cut(locks.guides, brush));
  locks.expectShape(brush);
  EXPECT_NEAR(lengthOf(locks.guides.of(kMiddle)), before, 1e-4f);
  // The same line as before, as nearly as its nodes show it.
  for (const Vec3& node : locks.guides.of(kMiddle)) {
    float nearest = 1;
    const auto chain = locks.before.of(kMiddle);
    for (std::size_t i = 1; i < chain.size(); ++i)
      for (int k = 0; k <= 20; ++k) nearest = std::min(nearest, glm::length(glm::mix(chain[i - 1], chain[i], static_cast<float>(k) / 20) - node));
    EXPECT_LT(nearest, 0.01f);
  }
  EXPECT_TRUE(cut(locks.guides, {.centre = locks.before.root(kMiddle), .radius = 0.01f}));
  EXPECT_NEAR(lengthOf(locks.guides.of(kMiddle)), kLeastGuideLength, 1e-4f);
  EXPECT_FALSE(cut(locks.guides, {.centre = {9, 9, 9}, .radius = 1}));
}

TEST(GuideEdits, LengtheningKeepsTheShapeAndTheLimits) {
  Locks locks;
  const auto brush = locks.brush(kMiddle, 9, 0.1f);
  EXPECT_TRUE(lengthen(locks.guides, brush, 1.5f));
  locks.expectShape(brush);
  EXPECT_NEAR(lengthOf(locks.guides.of(kMiddle)), 1.5f * lengthOf(locks.before.of(kMiddle)), 1e-4f);
  for (int i = 0; i < 40; ++i) lengthen(locks.guides, {.centre = {0, 0, 0}, .radius = 9, .strength = 1}, 2);
  for (std::size_t g = 0; g < 9; ++g) EXPECT_NEAR(lengthOf(locks.guides.of(g)), kMostGuideLength, 1e-3f);
  for (int i = 0; i < 40; ++i) lengthen(locks.guides, {.centre = {0, 0, 0}, .radius = 9, .strength = 1}, 0.5f);
  for (std::size_t g = 0; g < 9; ++g) EXPECT_NEAR(lengthOf(locks.guides.of(g)), kLeastGuideLength, 1e-4f);
  EXPECT_FALSE(lengthen(locks.guides, {.centre = {0, 0, 0}, .radius = 9}, 0));
}

float bentness(std::span<const Vec3> chain) { return 1 - glm::length(chain.back() - chain[0]) / lengthOf(chain); }

TEST(GuideEdits, StraighteningMakesStraighter) {
  Locks locks;
  const groom::Brush brush{.centre = {0, 0.3f, 0}, .radius = 3, .strength = 1};
  for (int i = 0; i < 30; ++i) straighten(locks.guides, brush);
  locks.expectLengths();
  for (std::size_t g = 0; g < 9; ++g) EXPECT_LT(bentness(locks.guides.of(g)), 0.1f * bentness(locks.before.of(g)));
}

TEST(GuideEdits, CurlsWindAndKeepLengths) {
  Locks locks;
  for (int i = 0; i < 60; ++i) straighten(locks.guides, {.centre = {0, 0.3f, 0}, .radius = 3, .strength = 1});
  const Guides straight = locks.guides;
  const auto brush = locks.brush(kMiddle, 5, 0.8f);
  EXPECT_TRUE(curl(locks.guides, locks.roots, brush, 2, 0.6f));
  locks.expectLengths();
  EXPECT_GT(bentness(locks.guides.of(kMiddle)), bentness(straight.of(kMiddle)) + 0.02f);
}

TEST(GuideEdits, TwistTurnsTheTipAboutTheMiddleLine) {
  Locks locks;
  EXPECT_TRUE(twist(locks.guides, locks.brush(kMiddle, 5, 0.1f), 1));
  locks.expectLengths();
  EXPECT_NE(locks.guides.of(kMiddle)[6], locks.before.of(kMiddle)[6]);
  Locks again;
  twist(again.guides, again.brush(kMiddle, 5, 0.1f), 0);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_LT(glm::length(again.guides.of(kMiddle)[i] - again.before.of(kMiddle)[i]), 1e-5f);
}

TEST(GuideEdits, NeighboursTakeTheShapeAsItStandsOnTheSkin) {
  Locks locks;
  // The skin of the others is turned by a quarter about the normal.
  for (std::size_t g = 0; g < 9; ++g)
    if (g != kMiddle) locks.roots[g].tangent = {0, 0, -1};
  EXPECT_TRUE(copyShape(locks.guides, locks.roots, {.centre = {0, 0.2f, 0}, .radius = 9, .strength = 1, .falloff = groom::Falloff::Flat}, kMiddle));
  const auto own = locks.guides.of(kMiddle);
  EXPECT_TRUE(std::equal(own.begin(), own.end(), locks.before.of(kMiddle).begin()));
  for (std::size_t g = 0; g < 9; ++g) {
    if (g == kMiddle) continue;
    const Vec3 tip = own.back() - own[0], there = locks.guides.of(g).back() - locks.guides.root(g);
    EXPECT_LT(glm::length(there - Vec3(tip.z, tip.y, -tip.x)), 1e-5f);
  }
  Locks half;
  EXPECT_TRUE(copyShape(half.guides, half.roots, half.brush(0, 5, 0.15f, 0.5f), kMiddle));
  half.expectShape(half.brush(0, 5, 0.15f));
}

TEST(GuideEdits, MirroredGuidesAreOnBothSidesAlike) {
  Locks locks;
  const Guides both = mirrored(locks.guides, {}).value();
  ASSERT_EQ(both.count(), 9u);
  EXPECT_TRUE(std::is_permutation(both.flags.begin(), both.flags.end(), locks.guides.flags.begin()));
  for (std::size_t g = 0; g < both.count(); ++g) {
    const Vec3 root = both.root(g);
    if (std::abs(root.x) < 0.01f) continue;
    bool found = false;
    for (std::size_t h = 0; h < both.count(); ++h) {
      const Vec3 tip = both.of(h).back();
      found |= both.root(h) == Vec3(-root.x, root.y, root.z) && Vec3(-tip.x, tip.y, tip.z) == both.of(g).back();
    }
    EXPECT_TRUE(found);
  }
  const Guides again = mirrored(both, {}).value();
  EXPECT_EQ(again.count(), both.count());
  Guides many = test::guidesAt(std::vector<Vec3>(600, Vec3(1, 0, 0)), [](const Vec3&) { return Vec3(0, 1, 0); });
  const auto tooMany = mirrored(many, {});
  ASSERT_FALSE(tooMany);
  EXPECT_EQ(tooMany.error().id, ErrorId::TooLarge);
  EXPECT_EQ(tooMany.error().message, "guides: mirrored they are 1200; a scalp has at most 1024");
}

TEST(GuideEdits, HiddenGuidesAreLeftAloneUntilTheyAreShown) {
  Locks locks;
  const auto brush = locks.brush(kMiddle, 5);
  EXPECT_TRUE(setFlag(locks.guides, brush, kHidden, true));
  EXPECT_FALSE(setFlag(locks.guides, brush, kHidden, true));
  const Guides hidden = locks.guides;
  EXPECT_FALSE(setFlag(locks.guides, brush, kStatic, true));
  comb(locks.guides, brush, {0.1f, 0, 0}), cut(locks.guides, brush), lengthen(locks.guides, brush, 2), straighten(locks.guides, brush);
  curl(locks.guides, locks.roots, brush, 3), twist(locks.guides, brush, 1), removeGuides(locks.guides, brush);
  EXPECT_TRUE(std::equal(hidden.of(kMiddle).begin(), hidden.of(kMiddle).end(), locks.guides.of(kMiddle).begin()));
  EXPECT_TRUE(setFlag(locks.guides, kHidden, false));
  EXPECT_TRUE(setFlag(locks.guides, brush, kStatic, true));
  EXPECT_EQ(locks.guides.flags[kMiddle], kStatic);
}

TEST(GuideEdits, GuidesInTheBallAreRemoved) {
  Locks locks;
  EXPECT_TRUE(removeGuides(locks.guides, locks.brush(kMiddle, 0, 0.02f)));
  ASSERT_EQ(locks.guides.count(), 8u);
  EXPECT_EQ(locks.guides.positions.size(), 80u);
  EXPECT_EQ(locks.guides.root(kMiddle), locks.before.root(kMiddle + 1));
  EXPECT_FALSE(removeGuides(locks.guides, locks.brush(kMiddle, 0, 0.02f)));
}

TEST(GuideEdits, WhatIsNoNumberDoesNothing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  Locks locks;
  const groom::Brush good = locks.brush(kMiddle, 5);
  EXPECT_FALSE(moveNode(locks.guides, kMiddle, 3, {0, kNan, 0}));
  EXPECT_FALSE(comb(locks.guides, good, {kInf, 0, 0}));
  EXPECT_FALSE(lengthen(locks.guides, good, kNan));
  EXPECT_FALSE(curl(locks.guides, locks.roots, good, kInf));
  EXPECT_FALSE(twist(locks.guides, good, kNan));
  for (const groom::Brush& bad : {groom::Brush{.centre = {kNan, 0, 0}}, groom::Brush{.radius = kInf}, groom::Brush{.radius = 0}, groom::Brush{.strength = kNan}}) {
    EXPECT_FALSE(comb(locks.guides, bad, {1, 0, 0}));
    EXPECT_FALSE(cut(locks.guides, bad));
    EXPECT_FALSE(straighten(locks.guides, bad));
    EXPECT_FALSE(copyShape(locks.guides, locks.roots, bad, 0));
    EXPECT_FALSE(setFlag(locks.guides, bad, kStatic, true));
    EXPECT_FALSE(removeGuides(locks.guides, bad));
  }
  EXPECT_EQ(locks.guides, locks.before);
}

}  // namespace
}  // namespace fur::hair
