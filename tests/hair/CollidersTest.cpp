#include "hair/Colliders.h"

#include <gtest/gtest.h>

#include "hair/Mane.h"

namespace fur::hair {
namespace {

// How deep a point is inside, or negative.
float depthIn(const Collider& c, const Vec3& p) {
  const Vec3 axis = c.b - c.a;
  const float squared = glm::dot(axis, axis), t = squared > 0 ? saturate(glm::dot(p - c.a, axis) / squared) : 0.0f;
  return c.radius - glm::length(p - (c.a + axis * t));
}

// The deepest that nodes from 2 on and the middles of their segments lie inside.
float deepest(const Shaken& hair, std::span<const Collider> colliders) {
  float worst = -1;
  const auto n = static_cast<std::size_t>(hair.mane.guides.nodes);
  for (std::size_t k = 0; k < hair.nodes().size(); ++k) {
    if (k % n < 2) continue;
    const Vec3 node = hair.nodes()[k].position, middle = 0.5f * (node + hair.nodes()[k - 1].position);
    for (const Collider& c : colliders) {
      if (!(depthIn(c, node) <= worst)) worst = depthIn(c, node);
      if (!(depthIn(c, middle) <= worst)) worst = depthIn(c, middle);
    }
  }
  return worst;
}

// Spheres and a capsule that dash about among the guides and leave alone only where these are held, nodes 0 and 1.
std::vector<Collider> hostile(const Mane& mane, float t, Random& random) {
  std::vector<Collider> out;
  for (int i = 0; i < 4; ++i) {
    const float s = t * (1.5f + 0.8f * static_cast<float>(i)) + static_cast<float>(i);
    Vec3 at(0.7f * portableSin(1.3f * s), 0.7f + 0.4f * portableSin(2.1f * s + 1), 0.6f * portableSin(1.7f * s + 2));
    if (random.uniform() < 0.01f) at = Vec3(random.uniform(-1, 1), random.uniform(0, 1.5f), random.uniform(-1, 1));
    Collider c{at, i == 3 ? at + Vec3(0.2f, 0.1f, 0.3f) : at, 0.12f + 0.05f * static_cast<float>(i)};
    for (std::size_t k = 0; k < mane.roots.size(); ++k)
      for (std::size_t j = 0; j < 2; ++j) c.radius = std::min(c.radius, depthIn(c, mane.guides.of(k)[j]) * -1 + c.radius - 0.01f);
    c.radius = std::max(c.radius, 0.001f);
    out.push_back(c);
  }
  return out;
}

TEST(Colliders, HaveNoGuideInsideOverTenThousandHostileSteps) {
#ifdef __SANITIZE_ADDRESS__
  constexpr int steps = 2500;  // takes as long as ten thousand without sanitizers, which are taken as wasm
#else
  constexpr int steps = 10000;
#endif
  for (const Model model : {Model::Spring, Model::Cascade, Model::Forest}) {
    Shaken hair;
    hair.values.model = model;
    Random random(7);
    // What is shown is the step before, so that it is held against the colliders of then.
    std::vector<Collider> before;
    float worst = -1, longest = 0;
    for (int step = 0; step < steps; ++step) {
      hair.colliders = hostile(hair.mane, static_cast<float>(step) * kStep, random);
      hair.advance(kStep);
      worst = std::max(worst, deepest(hair, before));
      longest = std::max(longest, stretch(hair.mane, hair.nodes()));
      before = hair.colliders;
    }
    EXPECT_LT(worst, 2e-5f) << static_cast<int>(model);
    EXPECT_LT(longest, 1e-3f) << static_cast<int>(model);
  }
}

TEST(Colliders, PushHairAsideAndLetItBack) {
  Shaken hair;
  hair.run(1);
  const Vec3 tip = hair.nodes().back().position;
  hair.colliders = {{tip + Vec3(0.3f, 0, 0), tip + Vec3(0.3f, 0, 0), 0.15f}};
  for (int i = 0; i < 60; ++i) {
    hair.colliders[0].a.x -= 0.006f;
    hair.colliders[0].b = hair.colliders[0].a;
    hair.advance(1 / 60.0f);
  }
  EXPECT_GT(glm::length(hair.nodes().back().position - tip), 0.05f);
  hair.colliders.clear();
  hair.run(15);
  EXPECT_LT(farFromRest(hair.mane, hair.nodes()), 0.01f);
}

TEST(Colliders, ThatCannotBeReachedDoNotWakeHair) {
  Shaken hair;
  hair.run(3);
  ASSERT_TRUE(hair.simulation.atRest());
  hair.colliders = {{Vec3(5, 0, 0), Vec3(5, 0, 0), 0.5f}};
  EXPECT_FALSE(hair.advance(1 / 60.0f));
  hair.colliders[0].a = hair.colliders[0].b = Vec3(0.3f, 1, 0);
  EXPECT_TRUE(hair.advance(1 / 60.0f));
}

}  // namespace
}  // namespace fur::hair
