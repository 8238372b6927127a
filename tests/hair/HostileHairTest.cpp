// What a simulation of hair bears.
#include <gtest/gtest.h>

#include <limits>

#include "core/Fnv1a.h"
#include "hair/Mane.h"
#include "tests/OnEveryPlatform.h"

namespace fur::hair {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr Model kEveryModel[] = {Model::Spring, Model::Cascade, Model::Forest};

bool sound(const Shaken& hair) {
  for (const GuideNode& node : hair.nodes())
    if (!std::isfinite(node.position.x + node.position.y + node.position.z + node.wetness) || std::abs(glm::dot(node.frame, node.frame) - 1) > 1e-3f) return false;
  return stretch(hair.mane, hair.nodes()) < 0.01f;
}

TEST(HostileHair, OddTimesDoNothing) {
  Shaken hair;
  hair.run(0.5f);
  hair.wind.force = Vec3(1, 0, 0);
  const std::vector<GuideNode> before(hair.nodes().begin(), hair.nodes().end());
  for (const float seconds : {0.0f, -1.0f, kNaN, -kInf}) EXPECT_FALSE(hair.advance(seconds));
  EXPECT_EQ(farApart(hair.nodes(), before), 0);
}

TEST(HostileHair, PausesTakeHairAlongAsItIs) {
  for (const float seconds : {0.3f, 1e9f, kInf}) {
    Shaken hair;
    hair.run(0.5f);
    const Mat4 far = glm::rotate(glm::translate(kHere, Vec3(0.5f, 0, 0)), 1.0f, Vec3(1, 0, 0));
    hair.place(far);
    EXPECT_TRUE(hair.advance(seconds));
    EXPECT_LT(farFromRest(hair.mane, hair.nodes(), far), 1e-4f);
  }
}

TEST(HostileHair, TeleportsTakeHairAlongAsItIs) {
  for (const Model model : kEveryModel) {
    Shaken hair;
    hair.values.model = model;
    hair.run(0.5f);
    const Mat4 far = glm::translate(kHere, Vec3(0, 3, 40));
    hair.place(far);
    hair.advance(1 / 60.0f);
    EXPECT_LT(farFromRest(hair.mane, hair.nodes(), far), 1e-3f);
    hair.run(0.5f);
    EXPECT_LT(farFromRest(hair.mane, hair.nodes(), far), 1e-3f);
  }
}

TEST(HostileHair, RootsThatAreNoFramesCountAsTheLastOnes) {
  Shaken hair;
  hair.run(3);
  for (const float bad : {kNaN, kInf, 1e20f}) {
    hair.roots[2].position.x = bad;
    hair.roots[3].normal = Vec3(0);
    hair.roots[4].tangent = Vec3(bad);
    hair.roots[5].tangent = hair.roots[5].normal;
    hair.run(0.2f);
    EXPECT_LT(farFromRest(hair.mane, hair.nodes()), 1e-4f);
  }
  EXPECT_TRUE(sound(hair));
}

TEST(HostileHair, TenfoldSpeedTearsNothing) {
  for (const Model model : kEveryModel)
    for (const float stiffness : {0.0f, 1.0f}) {
      Shaken hair{Mane(4, 16)};
      hair.values.model = model;
      hair.values.stiffness = stiffness;
      for (int frame = 0; frame < 240; ++frame) {
        const float t = 10 * static_cast<float>(frame) / 60.0f;
        hair.place(glm::rotate(glm::translate(kHere, Vec3(0.4f * portableSin(3 * t), 0.3f * portableSin(5 * t), 0)), 2 * portableSin(2 * t), Vec3(0.1f, 1, 0)));
        hair.advance(frame % 3 == 0 ? 10 / 60.0f : 1 / 60.0f);
        ASSERT_TRUE(sound(hair)) << static_cast<int>(model) << ' ' << frame;
      }
      hair.place(kHere);
      hair.run(25);
      EXPECT_TRUE(hair.simulation.atRest());
      EXPECT_LT(farFromRest(hair.mane, hair.nodes()), 0.02f) << static_cast<int>(model);
    }
}

TEST(HostileHair, AnyValuesWindsAndCollidersLeaveItWhole) {
  Random random(5);
  const auto any = [&] {
    const float kinds[] = {kNaN, kInf, -kInf, 0, -1, 1, 1e30f, -1e30f, 1e-30f, random.uniform(-2, 2)};
    return kinds[random.next() % 10];
  };
  for (int run = 0; run < 40; ++run) {
    Shaken hair{Mane(3, 4 + static_cast<int>(random.next() % 29))};
    for (int frame = 0; frame < 30; ++frame) {
      hair.values = {static_cast<Model>(random.next() % 5), any(), static_cast<int>(random.next() % 9) - 3, any(), any(), any(), any(), frame % 2 == 0};
      hair.wind = {Vec3(any(), any(), any()), any(), any(), static_cast<double>(any())};
      hair.up = Vec3(any(), any(), any());
      hair.wetness.assign(hair.mane.guides.positions.size(), any());
      hair.colliders = {{Vec3(any(), any(), any()), Vec3(any(), any(), any()), any()}, {Vec3(0, 0.7f, 0), Vec3(0, 0.7f, 0), random.uniform()}};
      hair.advance(random.uniform() * 0.1f);
      ASSERT_TRUE(sound(hair)) << run << ' ' << frame;
    }
  }
}

TEST(HostileHair, SegmentsWithoutLengthAndKinksStayFinite) {
  for (const Model model : kEveryModel) {
    Mane mane;
    for (std::size_t i = 3; i < 8; ++i) mane.guides.of(0)[i] = mane.guides.of(0)[2];
    for (std::size_t i = 1; i < 8; ++i) mane.guides.of(1)[i] = mane.guides.root(1);
    mane.guides.of(2)[4] = mane.guides.of(2)[2];
    Shaken hair(mane);
    hair.values.model = model;
    for (int frame = 0; frame < 240; ++frame) {
      hair.place(glm::translate(kHere, Vec3(0.2f * portableSin(0.2f * static_cast<float>(frame)), 0, 0)));
      hair.advance(1 / 60.0f);
      for (const GuideNode& node : hair.nodes()) ASSERT_TRUE(std::isfinite(node.position.x + node.position.y + node.position.z));
    }
  }
}

TEST(HostileHair, NoGuidesAreNoWork) {
  Simulation simulation;
  simulation.reset({}, {});
  simulation.advance(1 / 60.0f, {}, {});
  EXPECT_TRUE(simulation.nodes().empty());
  simulation.settle({}, {});
  EXPECT_TRUE(simulation.atRest());
}

TEST(HostileHair, HasTheSamePathOnEveryPlatform) {
  for (const Model model : kEveryModel) {
    Shaken hair{Mane(6, 9)};
    hair.values.model = model;
    hair.wind = {Vec3(0.4f, 0.1f, 0.2f), 0.5f, 0.4f, 0};
    hair.wetness.assign(hair.mane.guides.positions.size(), 0.0f);
    Fnv1a hash;
    for (int frame = 0; frame < 200; ++frame) {
      const float t = static_cast<float>(frame) / 60.0f;
      hair.place(glm::translate(kHere, frame < 100 ? Vec3(0.3f * portableSin(5 * t), 0.1f * portableSin(7 * t), 0) : Vec3(0)));
      hair.wind.time = static_cast<double>(t);
      for (std::size_t i = 0; i < hair.wetness.size(); i += 5) hair.wetness[i] = saturate(0.01f * static_cast<float>(frame));
      const Vec3 at(0.8f * portableSin(3 * t), 0.9f, 0.1f);
      hair.colliders = {{at, at + Vec3(0, 0.2f, 0.2f), 0.15f}, {Vec3(0, 0.3f, 0), Vec3(0, 0.3f, 0), 0.1f}};
      hair.advance(1 / 50.0f);
      for (const GuideNode& node : hair.nodes()) hash.add(node);
    }
    const char* names[] = {"guides on springs", "guides in a cascade", "guides as a forest"};
    fur::test::printOnEveryPlatform(names[static_cast<int>(model)], hash.value());
    EXPECT_TRUE(sound(hair));
  }
}

}  // namespace
}  // namespace fur::hair
