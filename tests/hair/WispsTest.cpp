#include "hair/Wisps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "OnEveryPlatform.h"
#include "hair/TestScalps.h"
#include "core/Fnv1a.h"
#include "core/Random.h"
#include "hair/MemberStrands.h"

namespace fur::hair {
namespace {

using test::TestScalp;
using test::guidesAt;
using Texel = groom::GroomMap::Texel;

constexpr float kFar = 0.5f;  // how far the guides of a Setting stand from the middle

// Long hair on a sphere, bent to one side.
struct Setting {
  explicit Setting(const HairValues& given = {}, int count = 30) : scalp(geometry::makeSphere()), values(given) {
    values.wisps = 200;
    const std::vector<Vec3> bends(scalp.surface.vertices.size(), Vec3(0.9f, -0.3f, 0.2f));
    guides = plantGuides(scalp.scalp(), values, count, bends).value();
    plant();
  }
  void plant() {
    roots = scalp.roots(guides);
    nodes = restNodes(guides, roots);
    wisps = plantWisps(scalp.scalp(), guides, roots, values);
  }
  WispPoint at(const Wisp& wisp, float t) const { return wispPoint(wisp, nodes, guides.nodes, shapeOf(values), t); }

  TestScalp scalp;
  HairValues values;
  Guides guides;
  std::vector<RootFrame> roots;
  std::vector<GuideNode> nodes;
  std::vector<Wisp> wisps;
};

HairValues plain() {
  HairValues v;
  v.magnet = v.rotation = v.lengthVariation = v.curl = 0;
  return v;
}

TEST(Wisps, WeightsStayWithinTheTriangleAllTheWay) {
  HairValues wandering;
  wandering.magnet = 1;
  for (const HairValues& values : {HairValues(), wandering})
    for (const Wisp& wisp : Setting(values).wisps)
      for (const float t : {0.0f, 0.3f, 1.0f}) {
        const Vec3 weights = wisp.weights + wisp.magnet * t;
        ASSERT_NEAR(weights.x + weights.y + weights.z, 1, 1e-5);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(weights[k], 0.5f, 0.5f + 1e-6f);
      }
}

TEST(Wisps, TheyStartAtTheirRoots) {
  HairValues curly;
  curly.curl = 1, curly.rotation = 1;
  const Setting s(curly);
  ASSERT_EQ(s.wisps.size(), 200u);
  for (const Wisp& wisp : s.wisps) EXPECT_LT(glm::length(s.at(wisp, 0).position - wisp.root), 1e-5f);
}

TEST(Wisps, AWispThatStandsAmongThreeGuidesHasItsRootThere) {
  const TestScalp plane(geometry::makePlane(8));
  const Guides guides = guidesAt({{-kFar, 0, -kFar}, {kFar, 0, -kFar}, {0, 0, kFar}}, [](const Vec3&) { return Vec3(0, 1, 0); });
  HairValues values = plain();
  values.wisps = 300;
  int inside = 0;
  for (const Wisp& wisp : plantWisps(plane.scalp(), guides, plane.roots(guides), values)) {
    Vec3 root(0);
    for (std::size_t k = 0; k < 3; ++k) root += guides.root(wisp.guides[k]) * wisp.weights[static_cast<int>(k)];
    const bool among = std::min({wisp.weights.x, wisp.weights.y, wisp.weights.z}) > 1e-4f;
    inside += among;
    // Guides of this triangle are within 0.63 of the middle of its circle.
    if (among) EXPECT_LT(glm::length(root - wisp.root), 0.04f * 0.63f);
    EXPECT_NEAR(glm::length(root - wisp.root), glm::length(wisp.offset), 1e-4f);
  }
  EXPECT_GT(inside, 40);
}

TEST(Wisps, OneGuideOrTwoAreEnoughAndNoneHasNone) {
  const TestScalp plane(geometry::makePlane(8));
  HairValues values = plain();
  values.wisps = 50;
  for (const std::size_t count : {1u, 2u}) {
    const std::vector<Vec3> places{{-kFar, 0, 0}, {kFar, 0, 0}};
    const Guides guides = guidesAt({places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count)}, [](const Vec3&) { return Vec3(0.2f, 1, 0); });
    const auto roots = plane.roots(guides);
    const auto wisps = plantWisps(plane.scalp(), guides, roots, values);
    ASSERT_EQ(wisps.size(), 50u);
    for (const Wisp& wisp : wisps) {
      const Vec3 tip = wispPoint(wisp, restNodes(guides, roots), guides.nodes, shapeOf(values), 1).position;
      EXPECT_LT(glm::length(tip - wisp.root - Vec3(0.2f, 1, 0)), 1e-4f);
    }
  }
  EXPECT_TRUE(plantWisps(plane.scalp(), {}, {}, values).empty());
}

TEST(Wisps, BetweenGuidesThatLeanMoreAndMoreSoDoWisps) {
  // Guides whose tips are a linear function of the place: wisps are, too, wherever among them.
  const TestScalp plane(geometry::makePlane(8));
  std::vector<Vec3> places;
  Random random(5);
  for (int i = 0; i < 60; ++i) places.push_back({random.uniform(-1, 1), 0, random.uniform(-1, 1)});
  const auto lean = [](const Vec3& p) { return Vec3(0.4f * p.x, 1, 0.3f * p.x - 0.2f * p.z); };
  const Guides guides = guidesAt(places, lean);
  HairValues values = plain();
  values.wisps = 300, values.curve = 1;
  const auto roots = plane.roots(guides);
  const auto nodes = restNodes(guides, roots);
  for (const Wisp& wisp : plantWisps(plane.scalp(), guides, roots, values)) {
    if (std::min({wisp.weights.x, wisp.weights.y, wisp.weights.z}) <= 0) continue;
    const Vec3 tip = wispPoint(wisp, nodes, guides.nodes, shapeOf(values), 1).position;
    const float farther = glm::length(lean(wisp.root + wisp.offset) - lean(wisp.root));
    EXPECT_LT(glm::length(tip - wisp.root - lean(wisp.root)), 2 * farther + 1e-3f);
    // Near the rim the normals lean outwards, and guides are one-sided.
    if (glm::length(wisp.root) < 0.5f) EXPECT_LT(glm::length(wisp.offset), 0.02f);
  }
}

TEST(Wisps, GuidesOnTheOtherSideOfASheetDoNotCount) {
  geometry::Mesh sheet = geometry::makePlane(4), back = sheet;
  const auto first = static_cast<std::uint32_t>(sheet.positions.size());
  for (std::size_t i = 0; i < back.positions.size(); ++i) {
    sheet.positions.push_back(back.positions[i] - Vec3(0, 0.01f, 0));
    sheet.normals.push_back(-back.normals[i]);
    sheet.uv.push_back(back.uv[i]);
  }
  for (std::size_t i = 0; i < back.indices.size(); i += 3)
    for (const std::size_t k : {i, i + 2, i + 1}) sheet.indices.push_back(first + back.indices[k]);
  sheet.uv.clear();
  const TestScalp scalp(sheet);
  std::vector<Vec3> places;
  for (const float y : {0.0f, -0.01f})
    for (const float x : {-0.4f, 0.4f})
      for (const float z : {-0.4f, 0.4f}) places.push_back({x, y, z});
  const Guides guides = guidesAt(places, [](const Vec3& p) { return Vec3(0, p.y < -0.005f ? -1 : 1, 0); });
  HairValues values;
  values.wisps = 200;
  for (const Wisp& wisp : plantWisps(scalp.scalp(), guides, scalp.roots(guides), values))
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(wisp.guides[k] >= 4, wisp.normal.y < 0);
}

TEST(Wisps, MapsScaleWidthLengthAndRotation) {
  Setting s(plain());
  s.values.rotation = 1;
  s.scalp.paint([](const Vec3& p) { return p.x > 0.2f ? Texel{255, 255, 255, 255} : p.x < -0.2f ? Texel{255, 0, 0, 0} : groom::GroomMap::kBlank; });
  s.plant();
  float most = 0;
  for (const Wisp& wisp : s.wisps) {
    const bool white = wisp.root.x > 0.25f;
    if (!white && wisp.root.x > -0.25f) continue;
    EXPECT_NEAR(wisp.width, white ? s.values.mostWidth : s.values.leastWidth, 1e-5);
    EXPECT_NEAR(wisp.length, white ? 1 : s.values.leastLength, 1e-5);
    if (!white) EXPECT_NEAR(wisp.rotation, 0, 1e-5);
    most = std::max(most, std::abs(wisp.rotation));
  }
  EXPECT_GT(most, 0.8f);
  EXPECT_LE(most, 1.0f);
}

TEST(Wisps, MoreOfThemOnlyAddToThose) {
  HairValues values;
  Setting s(values);
  const std::vector<Wisp> few = s.wisps;
  s.values.wisps = 500;
  s.plant();
  ASSERT_EQ(s.wisps.size(), 500u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), s.wisps.begin()));
}

TEST(Wisps, GuidesOfAnotherShapeAreFollowedAsIfPlantedAgain) {
  Setting s;
  std::vector<Wisp> wisps = s.wisps;
  Random random(2);
  for (std::size_t g = 0; g < s.guides.count(); ++g)
    for (Vec3& p : s.guides.of(g).subspan(1)) p += 0.05f * Vec3(random.uniform(), 0, 0);
  s.plant();
  EXPECT_NE(s.wisps, wisps);
  followGuides(wisps, s.guides, s.roots, shapeOf(s.values));
  EXPECT_EQ(s.wisps, wisps);
}

TEST(Wisps, WhereGuidesAreMovedAsOneWispsMoveAlong) {
  HairValues curly;
  curly.curl = 0.7f;
  const Setting s(curly);
  const Quat turn = glm::normalize(Quat(0.8f, 0.3f, -0.4f, 0.2f));
  const Vec3 move(0.3f, -1, 2);
  std::vector<GuideNode> moved = s.nodes;
  for (GuideNode& node : moved) node.position = turn * node.position + move, node.frame = turn * node.frame;
  for (const Wisp& wisp : s.wisps)
    for (const float t : {0.0f, 0.4f, 1.0f}) {
      const WispPoint before = s.at(wisp, t), after = wispPoint(wisp, moved, s.guides.nodes, shapeOf(s.values), t);
      EXPECT_LT(glm::length(after.position - (turn * before.position + move)), 1e-4f);
      EXPECT_LT(glm::length(after.across - turn * before.across), 1e-3f);
    }
}

TEST(Wisps, FramesArePerpendicularAndRunAlongTheHair) {
  HairValues curly;
  curly.curl = 0.5f, curly.curls = 2, curly.magnet = 1;
  const Setting s(curly);
  const float step = 1e-3f;
  for (const Wisp& wisp : s.wisps)
    for (const float t : {0.11f, 0.52f, 0.93f}) {
      const WispPoint p = s.at(wisp, t);
      for (const Vec3& axis : {p.across, p.along, p.out}) EXPECT_NEAR(glm::length(axis), 1, 1e-4);
      EXPECT_NEAR(glm::dot(p.across, p.along), 0, 1e-4);
      EXPECT_LT(glm::length(glm::cross(p.across, p.along) - p.out), 1e-4f);
      const Vec3 way = glm::normalize(s.at(wisp, t + step).position - s.at(wisp, t - step).position);
      // The turning of the frame along the hair is left out.
      EXPECT_GT(glm::dot(way, p.along), 0.98f);
    }
}

TEST(Wisps, CurlsAreAsWideAsAskedAndGrowFromTheRoot) {
  HairValues curly = plain();
  curly.curl = 0.5f;
  Setting s(curly), straight(plain());
  for (std::size_t i = 0; i < s.wisps.size(); ++i) {
    const auto away = [&](float t) { return glm::length(s.at(s.wisps[i], t).position - straight.at(straight.wisps[i], t).position); };
    EXPECT_NEAR(away(0), 0, 1e-5);
    EXPECT_LT(away(0.1f), away(0.3f));
    EXPECT_NEAR(away(0.7f), 0.5f * s.wisps[i].width, 1e-5);
  }
}

TEST(Wisps, SplitsFoldTheStripLess) {
  HairValues curly;
  curly.curl = 0.8f;
  for (const HairValues& values : {HairValues(), curly}) {
    const Setting s(values);
    int set = 0;
    for (const Wisp& wisp : s.wisps) {
      set += std::popcount(wisp.splits);
      EXPECT_EQ(wisp.splits >> kStripSegments, 0u);
      for (int segment = 0; segment < kStripSegments; ++segment) {
        Vec3 corners[2][2];
        for (int end = 0; end < 2; ++end)
          for (int side = 0; side < 2; ++side) {
            const float t = static_cast<float>(segment + end) / kStripSegments;
            corners[end][side] = memberPoint(s.at(wisp, t), {side ? kStripReach : -kStripReach, 0}, wisp.width, shapeOf(s.values), t);
          }
        const auto fold = [&](bool other) {
          const Vec3 a = corners[0][other ? 0 : 1], b = corners[1][other ? 1 : 0];
          const Vec3 c = corners[other ? 1 : 0][0], d = corners[other ? 0 : 1][1];
          return glm::dot(glm::normalize(glm::cross(b - a, c - a)), glm::normalize(glm::cross(d - a, b - a)));
        };
        const bool split = wisp.splits >> segment & 1;
        EXPECT_GT(fold(split), fold(!split) - 2e-4f);
      }
    }
    if (values.curl > 0) EXPECT_GT(set, 100);
  }
}

TEST(Wisps, HairThatLiesFlatKeepsItsDiagonals) {
  Setting s(plain(), 1);
  s.guides = guidesAt({{0, 1, 0}}, [](const Vec3&) { return Vec3(0, 1, 0); });
  s.plant();
  for (const Wisp& wisp : s.wisps) EXPECT_EQ(wisp.splits, 0u);
}

TEST(GuidePoint, BothCurvesGoThroughTheNodesAndTheCubicOneIsSmoothThere) {
  const std::vector<Vec3> chain{{0, 0, 0}, {0, 1, 0}, {0.6f, 1.8f, 0}, {1.4f, 1.9f, 0.6f}, {2, 1.2f, 1}};
  std::vector<GuideNode> nodes(chain.size());
  frameNodes(chain, {}, nodes);
  for (const bool cubic : {false, true})
    for (std::size_t i = 0; i < chain.size(); ++i)
      EXPECT_LT(glm::length(guidePoint(nodes, static_cast<float>(i), cubic).position - chain[i]), 1e-5f);
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const float at = static_cast<float>(i), step = 1e-3f;
    const auto way = [&](float from, bool cubic) {
      return glm::normalize(guidePoint(nodes, from + step, cubic).position - guidePoint(nodes, from, cubic).position);
    };
    EXPECT_GT(glm::dot(way(at - step, true), way(at, true)), 0.9999f);
    EXPECT_LT(glm::dot(way(at - step, false), way(at, false)), 0.95f);
    const Vec3 slope = (guidePoint(nodes, at + 0.3f + step, true).position - guidePoint(nodes, at + 0.3f - step, true).position) / (2 * step);
    EXPECT_LT(glm::length(slope - guidePoint(nodes, at + 0.3f, true).step), 1e-3f);
  }
}

TEST(Wisps, TheyAreTheSameOnEveryPlatform) {
  HairValues values;
  values.curl = 0.3f;
  const Setting s(values);
  Fnv1a hash;
  for (const Wisp& wisp : s.wisps) {
    hash.add(wisp);
    for (const float t : {0.2f, 0.9f}) hash.add(s.at(wisp, t).position);
  }
  fur::test::printOnEveryPlatform("wisps", hash.value());
}

TEST(Wisps, FollowOneSideOfAPartingAndBothAgainWhereItIsGone) {
  TestScalp plane(geometry::makePlane(8));
  HairValues values;
  values.wisps = 200, values.magnet = 0.5f;
  std::vector<Vec3> places;
  for (int k = 0; k < 64; ++k) places.emplace_back(-0.7f + 0.2f * static_cast<float>(k % 8), 0, -0.7f + 0.2f * static_cast<float>(k / 8));
  Guides parted = test::guidesAt(places, [](const Vec3& p) { return Vec3(p.x < 0 ? -0.4f : 0.4f, 0.2f, 0); });
  const Guides upright = test::guidesAt(places, [](const Vec3&) { return Vec3(0, 0.5f, 0); });
  auto wisps = plantWisps(plane.scalp(), parted, plane.roots(parted), values);
  int between = 0;
  for (const Wisp& wisp : wisps)
    for (const float t : {0.0f, 1.0f}) {
      float sides[2] = {0, 0};
      const Vec3 weights = wisp.weights + t * wisp.magnet;
      for (std::size_t k = 0; k < 3; ++k) sides[parted.root(wisp.guides[k]).x < 0] += weights[static_cast<int>(k)];
      EXPECT_NEAR(sides[0] + sides[1], 1, 1e-5);
      EXPECT_LT(std::min(sides[0], sides[1]), 1e-5f);
      between += wisp.weights != wisp.weightsByPlace;
    }
  EXPECT_GT(between, 10);
  followGuides(wisps, upright, plane.roots(upright), shapeOf(values));
  EXPECT_EQ(wisps, plantWisps(plane.scalp(), upright, plane.roots(upright), values));
  for (const Wisp& wisp : wisps) EXPECT_EQ(wisp.weights, wisp.weightsByPlace);
}

}  // namespace
}  // namespace fur::hair
