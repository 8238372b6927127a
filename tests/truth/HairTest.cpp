#include "truth/Hair.h"

#include "truth/OneStrand.h"

namespace fur::truth {
namespace {

constexpr int kWidth = 80, kHeight = 60;

// A lock that stands upright on a square of bare skin.
struct Lock {
  geometry::Surface surface = test::square(0.5f);
  furgen::Coat coat;
  std::vector<Vec4> bends = test::straight(surface);
  render::shared::FrameBlock frame = test::frameFrom({0, 0.5f, 2}, {0, 0.25f, 0}, {0, 1, 0}, kWidth, kHeight);
  render::shared::FurBlock fur = test::furOf(0, 1);
  hair::HairValues values;
  hair::Wisp wisp;
  std::vector<hair::MemberStrand> members;
  std::vector<hair::GuideNode> nodes;

  Lock() {
    coat.parameters.size = 256;
    values.strandWidth = 0.01f;
    wisp.width = 0.1f;
    members = hair::memberStrands(6, values);
    for (int i = 0; i < 4; ++i) nodes.push_back({{0, 0.15f * static_cast<float>(i), 0}, 0, {1, 0, 0, 0}});
  }
  LongHair hair() const { return {{&wisp, 1}, members, nodes, 4, values}; }
  Scene scene(std::span<const LongHair> hair) const { return {surface, coat, bends, frame, fur, dynamics::BendCurve::Arc, hair}; }
};

TEST(TruthHair, StrandsRunWhereTheirWispHasThemAndEndAsPointsAtTheirOwnLength) {
  const Lock lock;
  const LongHair hair = lock.hair();
  const Tubes tubes = placeHair(lock.scene({&hair, 1}));
  ASSERT_EQ(tubes.tubes.size(), 6u);
  const std::size_t kind = static_cast<std::size_t>(hair::wispKind(lock.wisp.random));
  for (std::size_t i = 0; i < 6; ++i) {
    const hair::MemberStrand& member = lock.members[6 * kind + i];
    const Tube& tube = tubes.tubes[i];
    const TubeNode &root = tubes.nodes[tube.firstNode], &tip = tubes.nodes[tube.firstNode + tube.nodeCount - 1];
    EXPECT_NEAR(root.position.y, 0, 1e-6f);
    EXPECT_NEAR(root.radius, 0.005f, 1e-6f);
    EXPECT_NEAR(tip.position.y, 0.45f * member.length, 1e-3f);
    EXPECT_NEAR(tip.radius, 0, 1e-6f);
    EXPECT_EQ(tube.variance, member.random);
    const hair::WispPoint middle = hair::wispPoint(lock.wisp, lock.nodes, 4, hair::shapeOf(lock.values), 0.5f);
    const Vec3 there = hair::memberPoint(middle, hair::memberOffset(member, 0.5f), lock.wisp.width, hair::shapeOf(lock.values), 0.5f);
    float nearest = 1;
    for (std::uint32_t k = tube.firstNode; k < tube.firstNode + tube.nodeCount; ++k)
      nearest = std::min(nearest, glm::distance(tubes.nodes[k].position, there));
    if (member.length > 0.5f) EXPECT_LT(nearest, 1e-5f);
  }
}

TEST(TruthHair, NeighboursInABendTurnLittle) {
  Lock lock;
  // Over, by a quarter turn within a segment of the guide.
  lock.nodes[2].position = {0.15f, 0.15f, 0};
  lock.nodes[3].position = {0.3f, 0.15f, 0};
  for (std::size_t i = 2; i < 4; ++i) lock.nodes[i].frame = glm::angleAxis(-0.5f * kPi, Vec3(0, 0, 1));
  lock.members.assign(hair::kWispKinds, {});
  const LongHair hair = lock.hair();
  const Tubes tubes = placeHair(lock.scene({&hair, 1}));
  const Tube& tube = tubes.tubes[0];
  Vec3 last(0, 1, 0);
  for (std::uint32_t k = tube.firstNode + 1; k + 1 < tube.firstNode + tube.nodeCount; ++k) {
    const Vec3 way = glm::normalize(tubes.nodes[k + 1].position - tubes.nodes[k].position);
    EXPECT_LT(glm::distance(way, last), 0.15f);
    last = way;
  }
  EXPECT_GT(last.x, 0.9f);
}

TEST(TruthHair, HairKeepsLightFromTheSkinAndFromTheHairBehindIt) {
  Lock lock;
  lock.frame.light = Vec4(glm::normalize(Vec3(1, 1, 0)), 0);
  lock.frame.sky = lock.frame.floorLight = Vec4(0);
  hair::Wisp other = lock.wisp;
  other.offset = Vec3(0.1f, 0, 0);
  const std::array wisps{lock.wisp, other};
  const auto shade = [&](std::span<const hair::Wisp> grown) {
    const LongHair hair{grown, lock.members, lock.nodes, 4, lock.values};
    const Scene scene = lock.scene({&hair, 1});
    const Tubes tubes = placeHair(scene);
    const DeepShadow none(scene.surface, {}, Vec3(lock.frame.light), 256), shadow(scene.surface, tubes, Vec3(lock.frame.light), 256);
    float sum = 0;  // of the first wisp
    const std::vector<Vec3> light = shadeHair(scene, tubes, {none, &shadow}, Light::Formula);
    const Tube& last = tubes.tubes[5];
    for (std::uint32_t k = 0; k < last.firstNode + last.nodeCount; ++k) sum += light[k].g;
    return std::pair(sum, shadeSkin(scene, {-0.1f, 0, 0}, {0, 1, 0}, 0, 0, {none, &shadow}, Light::Formula).g);
  };
  const auto [alone, skinByOne] = shade({wisps.data(), 1});
  const auto [shaded, skinByTwo] = shade(wisps);
  EXPECT_LT(shaded, 0.9f * alone);
  const Scene bald = lock.scene({});
  const DeepShadow none(bald.surface, {}, Vec3(lock.frame.light), 256);
  const float bare = shadeSkin(bald, {-0.1f, 0, 0}, {0, 1, 0}, 0, 0, {none}, Light::Formula).g;
  EXPECT_LT(skinByOne, 0.9f * bare);
  EXPECT_LT(skinByTwo, skinByOne + 1e-6f);
}

}  // namespace
}  // namespace fur::truth
