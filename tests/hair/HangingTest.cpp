#include "hair/Hanging.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/Scalp.h"
#include "hair/TestScalps.h"

namespace fur::hair {
namespace {

using test::TestScalp;

constexpr float kClearance = 0.02f;

Guides planted(const TestScalp& scalp, float length = 0.6f) {
  HairValues values;
  values.guideLength = length, values.nodes = 10;
  return plantGuides(scalp.scalp(), values, 60).value();
}

TEST(Hanging, HairKeepsItsLengthOutsideOfTheSkin) {
  const TestScalp sphere(geometry::makeSphere());
  Guides guides = planted(sphere);
  ASSERT_TRUE(hang(guides, sphere.surface, sphere.query, Vec3(0, -1, 0), 0.8f, kClearance));
  for (std::size_t g = 0; g < guides.count(); ++g) {
    EXPECT_NEAR(lengthOf(guides.of(g)), 0.6f, 1e-4);
    for (const Vec3& p : guides.of(g)) EXPECT_GT(glm::length(p), 0.99f);
    EXPECT_LT(guides.of(g).back().y, guides.root(g).y + 0.05f);
  }
}

TEST(Hanging, HairLiesOnALevelTopInsteadOfStandingUpThere) {
  const TestScalp sphere(geometry::makeSphere());
  Guides guides = planted(sphere);
  hang(guides, sphere.surface, sphere.query, Vec3(0, -1, 0), 1, kClearance);
  for (std::size_t g = 0; g < guides.count(); ++g)
    for (const Vec3& p : guides.of(g))
      if (guides.root(g).y > 0.9f) EXPECT_LT(glm::length(p), 1.06f) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(Hanging, APartingSendsHairToItsTwoSides) {
  const TestScalp sphere(geometry::makeSphere());
  Guides guides = planted(sphere);
  ASSERT_TRUE(part(guides, sphere.roots(guides), Vec3(0.1f, 0, 0), 0.9f));
  for (std::size_t g = 0; g < guides.count(); ++g) {
    const Vec3 root = guides.root(g), tip = guides.of(g).back();
    if (root.y < 0.8f) continue;
    if (root.x < 0.1f) EXPECT_LT(tip.x, root.x - 0.3f);
    else EXPECT_GT(tip.x, root.x + 0.3f);
    EXPECT_NEAR(lengthOf(guides.of(g)), 0.6f, 1e-4);
  }
}

TEST(Hanging, GatheredHairRunsAlongTheSkinAndEndsAtOnePlace) {
  TestScalp sphere(geometry::makeSphere());
  sphere.paint([](const Vec3& p) -> groom::GroomMap::Texel { return {static_cast<std::uint8_t>(p.y > 0 ? 255 : 0), 255, 255, 255}; });
  const Vec3 tie(0, 0.8f, -0.75f);
  Guides guides = planted(sphere);
  ASSERT_TRUE(gather(guides, sphere.surface, sphere.query, tie, 1, kClearance));
  for (std::size_t g = 0; g < guides.count(); ++g) {
    const auto chain = guides.of(g);
    EXPECT_LT(glm::distance(chain.back(), tie), 0.02f);
    const float most = glm::pi<float>() / 2 * glm::distance(chain[0], tie) + 0.1f;
    EXPECT_LT(lengthOf(chain), most) << "no detours";
    for (std::size_t i = 1; i < chain.size(); ++i) {
      EXPECT_GT(glm::length(chain[i]), 0.99f);
      EXPECT_NEAR(glm::distance(chain[i], chain[i - 1]), lengthOf(chain) / 9, 0.02f);
    }
  }
}

TEST(Hanging, ABundleIsAsRoundAtItsTipsAsAtItsRoots) {
  Guides guides;
  guides.nodes = 8;
  for (int g = 0; g < 12; ++g) {
    // Out of a disc in x and y, along z, then down.
    const float angle = 2 * glm::pi<float>() * static_cast<float>(g) / 12;
    for (int i = 0; i < guides.nodes; ++i) {
      const float bent = glm::half_pi<float>() * static_cast<float>(i) / 7;
      guides.positions.push_back(Vec3(0.1f * std::cos(angle), 0.1f * std::sin(angle) + std::cos(bent), std::sin(bent)));
    }
    guides.flags.push_back(0);
  }
  ASSERT_TRUE(bundle(guides, 1));
  for (std::size_t node : {std::size_t{0}, std::size_t{4}, std::size_t{7}}) {
    Vec3 middle(0);
    for (std::size_t g = 0; g < guides.count(); ++g) middle += guides.of(g)[node] / 12.0f;
    for (std::size_t g = 0; g < guides.count(); ++g) EXPECT_NEAR(glm::distance(guides.of(g)[node], middle), 0.1f, 1e-4f);
  }
  const Vec3 across = guides.of(3)[7] - guides.of(9)[7];
  EXPECT_GT(std::abs(across.z), 0.15f) << "where it hangs it is as deep as it is wide";
  EXPECT_FALSE(bundle(guides, 0));
}

TEST(Hanging, HiddenGuidesAndSharesOfNothingChangeNothing) {
  const TestScalp sphere(geometry::makeSphere());
  Guides guides = planted(sphere);
  const Guides before = guides;
  EXPECT_FALSE(hang(guides, sphere.surface, sphere.query, Vec3(0), 1, kClearance));
  EXPECT_FALSE(part(guides, sphere.roots(guides), Vec3(0), 0));
  EXPECT_FALSE(gather(guides, sphere.surface, sphere.query, Vec3(NAN), 1, kClearance));
  guides.flags.assign(guides.count(), kHidden);
  EXPECT_FALSE(hang(guides, sphere.surface, sphere.query, Vec3(0, -1, 0), 1, kClearance));
  EXPECT_EQ(guides.positions, before.positions);
}

TEST(Scalp, PaintedDensityFillsABallAndFadesAtItsRim) {
  TestScalp sphere(geometry::makeSphere());
  sphere.paint([](const Vec3&) -> groom::GroomMap::Texel { return {0, 10, 20, 30}; });
  const groom::SurfacePoints points(sphere.surface);
  const Vec4 ball(0, 1, 0, 0.5f);
  paintDensity(sphere.map, {sphere.surface, sphere.query, sphere.atlas, points}, {&ball, 1}, 1);
  for (std::uint32_t t = 0; t < sphere.surface.triangleCount(); ++t)
    sphere.atlas.forTexelsOf(sphere.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const float far = glm::distance(positionAt(sphere.surface, geometry::SurfacePoint{t, weights, 0}), Vec3(0, 1, 0));
      const groom::GroomMap::Texel value = sphere.map.texels()[texel];
      if (far < 0.43f) EXPECT_EQ(value[0], 255);
      if (far > 0.51f) EXPECT_EQ(value[0], 0);
      EXPECT_EQ(value[1], 10) << "width, length and rotation stay";
    });
}

}  // namespace
}  // namespace fur::hair
