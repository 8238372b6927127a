// Water in long hair by itself, on a small mane whose every guide has some wisps.
#include "hair/HairWater.h"

#include <gtest/gtest.h>

#include "core/Fnv1a.h"
#include "tests/OnEveryPlatform.h"
#include "tests/hair/Mane.h"

namespace fur::hair {
namespace {

struct WetMane : Shaken {
  std::vector<Wisp> wisps;
  HairWater water;
  HairAir air;
  std::vector<HairDrop> left;
  double taken = 0, dried = 0, gone = 0;

  explicit WetMane(int across = 4, int nodes = 8) : Shaken(Mane(across, nodes)) {
    std::vector<float> lengths;
    for (std::uint32_t g = 0; g < mane.guides.count(); ++g) {
      for (int k = 0; k < 8; ++k) {
        Wisp wisp;
        wisp.root = mane.roots[g].position;
        wisp.guides = {g, g, g};
        wisp.offset = {0.01f * static_cast<float>(k % 3 - 1), 0, 0.01f * static_cast<float>(k / 3 - 1)};
        wisps.push_back(wisp);
      }
      lengths.push_back(mane.length);
    }
    water.assign(shown(), lengths);
    water.move(nodes_(), 0);
  }
  std::span<const GuideNode> nodes_() const { return Shaken::nodes(); }
  ShownHair shown() const { return {wisps, nodes_(), mane.guides.nodes, {}}; }
  std::size_t each() const { return static_cast<std::size_t>(mane.guides.nodes); }
  void step() {
    wetness.assign(water.wetness().begin(), water.wetness().end());
    if (advance(HairWater::kStep)) water.move(nodes_(), HairWater::kStep);
    else water.rest();
    const std::size_t before = left.size();
    dried += water.step(shown(), air, left, 100);
    for (std::size_t i = before; i < left.size(); ++i) gone += left[i].water;
  }
  void rain(Random& chance, int drops) {
    for (int i = 0; i < drops; ++i) {
      const Vec3 from{chance.uniform(-0.6f, 0.9f), chance.uniform(0.2f, 1.1f), chance.uniform(-0.6f, 0.6f)};
      taken += water.take(shown(), from, Vec3(0, -0.08f, 0), 1.6e-3f);
    }
  }
  // The mean over all guides of a node's wetness.
  float mean(std::size_t node) const {
    float sum = 0;
    for (std::size_t g = 0; g < mane.guides.count(); ++g) sum += water.wetness()[g * each() + node];
    return sum / static_cast<float>(mane.guides.count());
  }
};

// The same bits on every platform, which glm::rotate() is not.
Mat4 aboutY(float angle) {
  const float c = portableCos(angle), s = portableSin(angle);
  return Mat4(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1);
}

// Rain, then shaking, then drying.
std::uint64_t session(WetMane& hair) {
  Random chance(3);
  hair.air.dryRate = 0.05f;
  for (int i = 0; i < 400; ++i) {
    if (i < 150) hair.rain(chance, 20);
    if (i >= 150 && i < 220) hair.place(kHere * aboutY(0.4f * portableSin(0.5f * static_cast<float>(i - 150))));
    hair.step();
  }
  Fnv1a hash;
  for (const float w : hair.water.wetness()) hash.add(w);
  hash.addAll(hair.left);
  return hash.value();
}

TEST(HairWater, BalancesWhileItRainsIsShakenAndDries) {
  WetMane hair;
  session(hair);
  EXPECT_GT(hair.taken, 0.02);
  EXPECT_GT(hair.gone, 0.2 * hair.taken);
  EXPECT_GT(hair.dried, 0);
  EXPECT_GT(hair.water.water(), 0);
  // Sums of floats, each rounded to 6e-8 of itself.
  EXPECT_NEAR(hair.taken, hair.water.water() + hair.gone + hair.dried, 1e-5 * hair.taken);
}

TEST(HairWater, OfASessionIsTheSameOnEveryPlatform) {
  WetMane hair, again;
  const std::uint64_t hash = session(hair);
  EXPECT_EQ(session(again), hash);
  fur::test::printOnEveryPlatform("water in hair", hash);
}

TEST(HairWater, DriesFromTheTipsUp) {
  WetMane hair;
  hair.water.soak(0.6f);
  hair.air.dryRate = 0.2f;
  bool tipWasDryFirst = false;
  for (int i = 0; i < 3000 && !hair.water.isDry(); ++i) {
    hair.step();
    for (std::size_t node = 2; node < hair.each(); ++node) ASSERT_LE(hair.mean(node), hair.mean(node - 1)) << "node " << node << " after " << i << " steps";
    tipWasDryFirst |= hair.mean(hair.each() - 1) == 0 && hair.mean(1) > 0.2f;
  }
  EXPECT_TRUE(tipWasDryFirst);
  EXPECT_TRUE(hair.water.isDry());
  EXPECT_TRUE(hair.left.empty());
}

TEST(HairWater, DriesAtOnceAsInManySteps) {
  WetMane slow, quick;
  slow.water.soak(0.6f);
  quick.water.soak(0.6f);
  slow.air.dryRate = 0.05f;
  for (int i = 0; i < 240; ++i) slow.water.step(slow.shown(), slow.air, slow.left, 0);
  quick.water.dry(240 * HairWater::kStep * slow.air.dryRate);
  // Within a step water creeps where hair is drier, too.
  for (std::size_t node = 0; node < slow.each(); ++node) EXPECT_NEAR(slow.mean(node), quick.mean(node), 0.02f);
}

TEST(HairWater, RunsDownAndDripsFromTheTips) {
  WetMane hair;
  for (std::size_t i = 0; i < hair.mane.guides.positions.size(); ++i) hair.mane.guides.positions[i] = hair.mane.roots[i / hair.each()].position - Vec3(0, 0.08f * static_cast<float>(i % hair.each()), 0);
  hair.simulation = hair.mane.simulation();
  hair.water.move(hair.nodes_(), 0);
  hair.water.soak(1);
  const float above = hair.mean(1);
  std::size_t hung = 0;
  for (int i = 0; i < 300; ++i) {
    hair.step();
    hung = std::max(hung, hair.water.hanging(hair.shown()).size());
  }
  EXPECT_GT(hung, hair.mane.guides.count()) << "several from each guide's wisps";
  EXPECT_LT(hair.mean(1), above);
  EXPECT_GT(hair.mean(hair.each() - 1), hair.mean(1) - 1e-3f);
  ASSERT_FALSE(hair.left.empty());
  for (const HairDrop& drop : hair.left) {
    float nearest = 1e9f;
    for (std::size_t g = 0; g < hair.mane.guides.count(); ++g)
      nearest = std::min(nearest, glm::distance(drop.position, hair.nodes()[(g + 1) * hair.each() - 1].position));
    EXPECT_LT(nearest, 0.05f);
  }
  // What hangs is there to be drawn, and falls no lighter than that.
  for (const HairWater::Hanging& hanging : hair.water.hanging(hair.shown())) EXPECT_LT(hanging.water, 2e-3f);
}

TEST(HairWater, CreepsDownwardsFasterThanUpwards) {
  WetMane hair;
  for (std::size_t i = 0; i < hair.mane.guides.positions.size(); ++i) hair.mane.guides.positions[i] = hair.mane.roots[i / hair.each()].position - Vec3(0, 0.08f * static_cast<float>(i % hair.each()), 0);
  hair.simulation = hair.mane.simulation();
  hair.water.move(hair.nodes_(), 0);
  std::vector<float> state = hair.water.state();
  for (std::size_t g = 0; g < hair.mane.guides.count(); ++g) state[g * hair.each() + 4] = 0.5f;
  hair.water.setState(state);
  for (int i = 0; i < 60; ++i) hair.step();
  EXPECT_GT(hair.mean(3), 0.02f);
  EXPECT_GT(hair.mean(5), 1.2f * hair.mean(3));
  EXPECT_GT(hair.mean(6), 0.02f);
}

TEST(HairWater, LetsNothingGoWhileThereIsNoRoomForDrops) {
  WetMane hair;
  hair.water.soak(1);
  const double before = hair.water.water();
  for (int i = 0; i < 100; ++i) hair.water.step(hair.shown(), hair.air, hair.left, 0);
  EXPECT_TRUE(hair.left.empty());
  EXPECT_NEAR(hair.water.water(), before, 1e-5 * before);
}

TEST(HairWater, IsThrownOutTheWayThatHairMoves) {
  WetMane hair, calm;
  for (WetMane* one : {&hair, &calm}) {
    one->water.soak(0.55f);
    for (int i = 0; i < 40; ++i) {
      if (one == &hair) one->place(glm::translate(kHere, Vec3(0.3f * portableSin(0.6f * static_cast<float>(i)), 0, 0)));
      one->step();
    }
  }
  EXPECT_TRUE(calm.left.empty());
  ASSERT_GT(hair.left.size(), 10u);
  EXPECT_LT(hair.water.water(), 0.9 * calm.water.water());
  Vec3 along(0);
  for (const HairDrop& drop : hair.left) along += glm::abs(drop.velocity);
  EXPECT_GT(along.x, 2 * along.z);
}

TEST(HairWater, TakesNoMoreThanItHasRoomFor) {
  WetMane hair;
  const Vec3 at = hair.nodes()[5].position;
  float caught = 0;
  for (int i = 0; i < 2000; ++i) caught = hair.water.take(hair.shown(), at + Vec3(0, 0.05f, 0), Vec3(0, -0.1f, 0), 0.01f);
  EXPECT_LT(caught, 1e-6f);
  for (const float w : hair.water.wetness()) EXPECT_LE(w, HairWater::kFull);
  EXPECT_EQ(hair.water.take(hair.shown(), Vec3(0, -3, 0), Vec3(0, -0.1f, 0), 0.01f), 0);
}

TEST(HairWater, SleepsWhenNothingChangesAndWakesWhenHairMoves) {
  WetMane hair;
  EXPECT_FALSE(hair.water.active(hair.air));
  hair.water.soak(1);
  for (int i = 0; i < 6000 && hair.water.active(hair.air); ++i) hair.step();
  ASSERT_FALSE(hair.water.active(hair.air));
  EXPECT_GT(hair.water.water(), 0);
  const std::vector<float> state = hair.water.state();
  hair.step();
  EXPECT_EQ(hair.water.state(), state);
  hair.place(glm::translate(kHere, Vec3(0.1f, 0, 0)));
  hair.step();
  EXPECT_TRUE(hair.water.active(hair.air));
}

TEST(HairWater, ComesBackWithItsState) {
  WetMane hair, other;
  session(hair);
  other.water.setState(hair.water.state());
  EXPECT_EQ(other.water.state(), hair.water.state());
  EXPECT_DOUBLE_EQ(other.water.water(), hair.water.water());
  std::vector<float> unsound = hair.water.state();
  unsound[0] = NAN, unsound[1] = -5, unsound[2] = 1e9f;
  other.water.setState(unsound);
  EXPECT_EQ(other.water.wetness()[0], 0);
  EXPECT_EQ(other.water.wetness()[1], 0);
  EXPECT_LE(other.water.wetness()[2], HairWater::kFull);
}

TEST(HairWater, MeetsARayWhereAWispIs) {
  WetMane hair;
  const Vec3 at = hair.nodes()[6].position;
  const auto met = hair.water.meet(hair.shown(), at + Vec3(0, 0, 3), Vec3(0, 0, -1));
  ASSERT_TRUE(met);
  EXPECT_LT(glm::length(Vec2(met->position) - Vec2(at)), 0.1f);
  EXPECT_FALSE(hair.water.meet(hair.shown(), Vec3(5, 5, 3), Vec3(0, 0, -1)));
}

TEST(HairWater, DrawsWispsToTheirNearestGuideAndLeavesTheirRoots) {
  WetMane hair;
  std::vector<GuideNode> nodes(hair.nodes_().begin(), hair.nodes_().end());
  Wisp wisp;
  wisp.guides = {0, 1, 4};
  wisp.weights = {0.5f, 0.3f, 0.2f};
  const auto apart = [&](float t) {
    return glm::distance(wispPoint(wisp, nodes, hair.mane.guides.nodes, {}, t).position, guidePoint(std::span(nodes).first(hair.each()), t * static_cast<float>(hair.each() - 1), true).position);
  };
  const float root = apart(0), tip = apart(1);
  for (GuideNode& node : nodes) node.wetness = 1;
  EXPECT_FLOAT_EQ(apart(0), root);
  EXPECT_LT(apart(1), 0.5f * tip);
}

}  // namespace
}  // namespace fur::hair
