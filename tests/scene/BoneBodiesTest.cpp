#include "scene/BoneBodies.h"

#include <gtest/gtest.h>

#include "core/PortableMath.h"

namespace fur::scene {
namespace {

// A tube of radius 0.1 along y from 0 to 3, with a bone for each unit of it.
Rig tube(int bones = 3) {
  Rig rig;
  rig.scale = 0.5f;
  rig.centre = Vec3(0, 1.5f, 0);
  Rig::Skin skin;
  for (int k = 0; k < bones; ++k) {
    Rig::Node node;
    node.parent = k - 1;
    node.translation = Vec3(0, k > 0 ? 1 : 0, 0);
    rig.nodes.push_back(node);
    skin.joints.push_back(static_cast<std::uint32_t>(k));
    Mat4 inverse(1);
    inverse[3] = Vec4(0, -k, 0, 1);
    skin.inverseBinds.push_back(inverse);
    for (int i = 0; i < 200; ++i) {
      const float angle = 2.4f * static_cast<float>(i), y = (static_cast<float>(i) + 0.5f) / 200;
      rig.positions.push_back(Vec3(0.1f * portableCos(angle), static_cast<float>(k) + y, 0.1f * portableSin(angle)));
      rig.normals.push_back(Vec3(portableCos(angle), 0, portableSin(angle)));
      rig.joints.push_back({static_cast<std::uint16_t>(k), 0, 0, 0});
      rig.weights.push_back(Vec4(0.9f, 0.1f, 0, 0));
    }
  }
  rig.skins.push_back(skin);
  rig.parts.push_back({.firstVertex = 0, .vertices = static_cast<std::uint32_t>(rig.positions.size()), .node = 0, .skin = 0});
  return rig;
}

TEST(FitBodies, MakeACapsuleAlongEachBoneAsThickAsWhatItHolds) {
  const std::vector<hair::Body> bodies = fitBodies(tube());
  ASSERT_EQ(bodies.size(), 3u);
  std::vector<bool> seen(3);
  for (const hair::Body& body : bodies) {
    ASSERT_TRUE(body.bone >= 0 && body.bone < 3);
    seen[static_cast<std::size_t>(body.bone)] = true;
    // Model space is half as large, round the middle of the tube.
    EXPECT_NEAR(body.radius, 0.05f, 0.005f);
    for (const Vec3& end : {body.a, body.b}) {
      EXPECT_LT(glm::length(Vec2(end.x, end.z)), 0.005f);
      EXPECT_GT(end.y, 0.5f * static_cast<float>(body.bone) - 0.75f);
      EXPECT_LT(end.y, 0.5f * static_cast<float>(body.bone) - 0.25f);
    }
    EXPECT_GT(std::abs(body.b.y - body.a.y), 0.3f);
  }
  EXPECT_EQ(seen, std::vector<bool>(3, true));
}

TEST(FitBodies, AreNotThrownOffByAFewVerticesFarAway) {
  Rig rig = tube(1);
  const float radius = fitBodies(rig)[0].radius;
  for (std::size_t i = 0; i < 8; ++i) rig.positions[20 * i] *= 30.0f;
  ASSERT_EQ(fitBodies(rig).size(), 1u);
  EXPECT_NEAR(fitBodies(rig)[0].radius, radius, 0.3f * radius);
}

TEST(FitBodies, AreNoMoreThanAModelMayHaveAndNoneWithoutBones) {
  EXPECT_EQ(fitBodies(tube(hair::kMostBodies + 10)).size(), hair::kMostBodies);
  EXPECT_TRUE(fitBodies({}).empty());
}

}  // namespace
}  // namespace fur::scene
