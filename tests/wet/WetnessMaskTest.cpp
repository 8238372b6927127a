#include "wet/WetnessMask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/Random.h"
#include "tests/OnEveryPlatform.h"

namespace fur::wet {
namespace {

Droplet randomDroplet(Random& random) {
  Droplet d;
  d.centre.x = random.uniform(-0.1f, 1.1f);
  d.centre.y = random.uniform(-0.1f, 1.1f);
  d.radius = random.uniform(0.03f, 0.2f);
  d.wetness = random.uniform(0.05f, 1.0f);
  return d;
}

// Silva Algorithm 1 line by line, dryness asked of rho.
void transcribed(std::vector<Vec4>& mask, int size, const Droplet& d) {
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Vec2 at((x + 0.5f) / size, (y + 0.5f) / size);
      if (glm::length(at - d.centre) > d.radius) continue;
      Vec4& m = mask[static_cast<std::size_t>(y) * size + x];
      if (m.w != 0 && glm::length(Vec2(m.x, m.y) - d.centre) <= d.radius) {
        const float total = glm::clamp(m.w + d.wetness, 0.0f, 1.0f);
        if (total != 0) {
          const float alpha = d.wetness / total;
          m.x = (1 - alpha) * m.x + alpha * d.centre.x;
          m.y = (1 - alpha) * m.y + alpha * d.centre.y;
          m.z = (1 - alpha) * m.z + alpha * d.radius;
        }
        m.w = total;
      } else {
        m = Vec4(d.centre, d.radius, d.wetness);
      }
    }
}

TEST(WetnessMask, FollowsAlgorithm1OnRandomDroplets) {
  const int size = 64;
  Random random(7);
  WetnessMask mask(size);
  std::vector<Vec4> expected(size * size, Vec4(0));
  int apart = 0;
  for (int k = 0; k < 200; ++k) {
    const Droplet d = randomDroplet(random);
    mask.addDroplet(d);
    transcribed(expected, size, d);
  }
  // A texel on the rim may fall either way by rounding, and then differ in everything.
  for (int i = 0; i < size * size; ++i) apart += glm::length(mask.texels()[i] - expected[i]) > 1e-5f;
  EXPECT_LE(apart, 3);
}

TEST(WetnessMask, TakesTheFirstDropletEvenAtTheOrigin) {
  WetnessMask mask(64);
  mask.addDroplet({Vec2(0.01f), 0.05f, 0.4f});
  const Vec4 texel = mask.at(0.01f, 0.01f);
  EXPECT_EQ(texel, Vec4(0.01f, 0.01f, 0.05f, 0.4f));
}

TEST(WetnessMask, BlendsANearDropletByItsShareOfTheWater) {
  WetnessMask mask(64);
  mask.addDroplet({Vec2(0.5f, 0.5f), 0.1f, 0.6f});
  mask.addDroplet({Vec2(0.55f, 0.5f), 0.2f, 0.2f});
  // alpha = 0.2 / 0.8
  EXPECT_NEAR(glm::length(mask.at(0.5f, 0.5f) - Vec4(0.5125f, 0.5f, 0.125f, 0.8f)), 0.0f, 1e-6f);
}

TEST(WetnessMask, StartsAClumpOfItsOwnWhereTheOldCentreIsFar) {
  WetnessMask mask(64);
  mask.addDroplet({Vec2(0.3f, 0.5f), 0.2f, 0.6f});
  mask.addDroplet({Vec2(0.45f, 0.5f), 0.1f, 0.3f});
  EXPECT_EQ(mask.at(0.45f, 0.5f), Vec4(0.45f, 0.5f, 0.1f, 0.3f));
  EXPECT_EQ(mask.at(0.2f, 0.5f), Vec4(0.3f, 0.5f, 0.2f, 0.6f));
}

TEST(WetnessMask, NeverGetsDrierByDropletsNearTheClumpsCentre) {
  Random random(3);
  WetnessMask mask(64);
  float last = 0;
  for (int k = 0; k < 50; ++k) {
    mask.addDroplet({Vec2(random.uniform(0.48f, 0.52f), random.uniform(0.48f, 0.52f)), 0.1f, 0.07f});
    EXPECT_GE(mask.at(0.5f, 0.5f).w, last);
    last = mask.at(0.5f, 0.5f).w;
  }
  EXPECT_EQ(last, 1.0f);
}

TEST(WetnessMask, DryingNeverMovesAClumpCentre) {
  Random random(11);
  WetnessMask mask(64);
  for (int k = 0; k < 40; ++k) mask.addDroplet(randomDroplet(random));
  const auto before = mask.texels();
  mask.dry(2.0f, 0.1f);
  mask.dryAt({Vec2(0.5f), 0.2f, 0.3f});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec4 now = mask.texels()[i];
    ASSERT_LE(now.w, before[i].w);
    ASSERT_EQ(Vec3(now), now.w > 0 ? Vec3(before[i]) : Vec3(0));
  }
}

TEST(WetnessMask, DriesAtTheSamePaceInOneStepOrMany) {
  WetnessMask one(32), many(32);
  for (WetnessMask* mask : {&one, &many}) mask->addDroplet({Vec2(0.5f), 0.2f, 0.9f});
  one.dry(2.0f, 0.2f);
  for (int k = 0; k < 200; ++k) many.dry(0.01f, 0.2f);
  EXPECT_NEAR(one.meanWetness(), many.meanWetness(), 1e-5f);  // 200 roundings of single precision
}

TEST(WetnessMask, DriesOutCompletelyAndForgetsItsClumps) {
  WetnessMask mask(32);
  mask.addDroplet({Vec2(0.5f), 0.3f, 0.5f});
  EXPECT_FALSE(mask.isDry());
  mask.dry(10.0f, 0.1f);
  EXPECT_TRUE(mask.isDry());
  EXPECT_EQ(mask.hash(), WetnessMask(32).hash());
}

TEST(WetnessMask, DoesNotCareAboutTheOrderOfDropletsFarApart) {
  const Droplet a{Vec2(0.2f), 0.1f, 0.5f}, b{Vec2(0.7f), 0.15f, 0.8f};
  WetnessMask ab(64), ba(64);
  ab.addDroplet(a), ab.addDroplet(b);
  ba.addDroplet(b), ba.addDroplet(a);
  EXPECT_EQ(ab.hash(), ba.hash());
}

TEST(WetnessMask, ReportsExactlyTheRectangleThatChanged) {
  Random random(5);
  WetnessMask mask(64);
  for (int k = 0; k < 100; ++k) {
    const auto before = mask.texels();
    switch (k % 4) {
      case 0: mask.dryAt(randomDroplet(random)); break;
      case 1: mask.dry(0.3f, 0.5f); break;
      default: mask.addDroplet(randomDroplet(random)); break;
    }
    if (k == 90) mask.clear();
    TexelRect expected;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x)
        if (before[y * 64 + x] != mask.texels()[y * 64 + x]) expected = unite(expected, {x, y, x + 1, y + 1});
    const TexelRect changed = mask.takeChanged();
    if (k == 90) continue;  // two steps in one: the union may be wider than what is left of it
    ASSERT_EQ(changed.empty(), expected.empty()) << k;
    if (changed.empty()) continue;
    ASSERT_EQ(changed.x0, expected.x0) << k;
    ASSERT_EQ(changed.y0, expected.y0) << k;
    ASSERT_EQ(changed.x1, expected.x1) << k;
    ASSERT_EQ(changed.y1, expected.y1) << k;
    EXPECT_TRUE(mask.takeChanged().empty());
  }
}

TEST(WetnessMask, WetsOnlyTheChartItIsToldTo) {
  const int size = 32;
  std::vector<std::uint16_t> charts(size * size);
  for (int i = 0; i < size * size; ++i) charts[i] = static_cast<std::uint16_t>(i % size < 16 ? 4 : 9);
  WetnessMask mask(size);
  mask.addDroplet({Vec2(0.5f), 0.3f, 0.5f}, charts.data(), 9);
  for (int i = 0; i < size * size; ++i)
    ASSERT_TRUE(charts[i] != 4 || mask.texels()[i] == Vec4(0));
  EXPECT_GT(mask.at(0.55f, 0.5f).w, 0.0f);
}

TEST(WetnessMask, KeepsWhatAlgorithm1LetsGoOf) {
  Random random(21);
  WetnessMask mask(64);
  double brought = 0;
  for (int k = 0; k < 200; ++k) {
    const Droplet d = randomDroplet(random);
    for (std::size_t i = 0; i < mask.texels().size(); ++i) {
      const Vec2 way = mask.texelCentre(i) - d.centre;
      if (glm::dot(way, way) <= d.radius * d.radius) brought += d.wetness;
    }
    mask.addDroplet(d);
  }
  double there = 0;
  for (std::size_t i = 0; i < mask.texels().size(); ++i) there += mask.texels()[i].w + mask.filmAt(i);
  EXPECT_NEAR(there / brought, 1, 1e-3);  // texels on rims fall either way by rounding
}

TEST(WetnessMask, TellsItsChangesInPartsThatCoverThem) {
  WetnessMask mask(256);
  mask.addDroplet({Vec2(0.1f, 0.1f), 0.02f, 0.5f});
  mask.addDroplet({Vec2(0.9f, 0.8f), 0.02f, 0.5f});
  const std::vector<Vec4> texels = mask.texels();
  const std::vector<TexelRect> parts = mask.takeChangedParts();
  EXPECT_GE(parts.size(), 2u);
  long area = 0;
  for (const TexelRect& part : parts) area += long{part.x1 - part.x0} * (part.y1 - part.y0);
  EXPECT_LT(area, 4000);
  for (int i = 0; i < 256 * 256; ++i) {
    bool covered = texels[i].w <= 0;
    for (const TexelRect& part : parts) covered |= i % 256 >= part.x0 && i % 256 < part.x1 && i / 256 >= part.y0 && i / 256 < part.y1;
    ASSERT_TRUE(covered);
  }
  EXPECT_TRUE(mask.takeChangedParts().empty());
}

TEST(WetnessMask, WetsTheTexelUnderADropletFinerThanATexel) {
  WetnessMask mask(16);
  mask.addDroplet({Vec2(0.5f), 1e-4f, 0.5f});
  EXPECT_FALSE(mask.isDry());
}

TEST(WetnessMask, IgnoresDropletsThatAreNone) {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  WetnessMask mask(32);
  for (const Droplet& d : {Droplet{Vec2(nan, 0.5f), 0.1f, 0.5f}, Droplet{Vec2(0.5f), nan, 0.5f},
                           Droplet{Vec2(0.5f), infinity, 0.5f}, Droplet{Vec2(0.5f), 0.1f, nan},
                           Droplet{Vec2(0.5f), 0.0f, 0.5f}, Droplet{Vec2(0.5f), 0.1f, 0.0f},
                           Droplet{Vec2(0.5f), -1.0f, 0.5f}, Droplet{Vec2(1e9f), 0.1f, 0.5f}})
    EXPECT_TRUE(mask.addDroplet(d).empty());
  EXPECT_TRUE(mask.isDry());
}

TEST(WetnessMask, ComesBackFromItsTexels) {
  WetnessMask mask(32), copy(32);
  mask.addDroplet({Vec2(0.4f), 0.2f, 0.7f});
  copy.restore(mask.texels());
  EXPECT_EQ(copy.hash(), mask.hash());
  EXPECT_EQ(copy.takeChanged().x1, 32);
  copy.dry(100.0f, 1.0f);
  EXPECT_TRUE(copy.isDry());
}

TEST(WetnessMask, TakesUnsoundTexelsForDry) {
  std::vector<Vec4> texels(32 * 32, Vec4(std::nanf(""), 0, 1, 1));
  texels[5] = Vec4(0.5f, 0.5f, 0.1f, 7.0f);
  WetnessMask mask(32);
  mask.restore(texels);
  EXPECT_EQ(mask.texels()[0], Vec4(0));
  EXPECT_EQ(mask.texels()[5].w, 1.0f);
}

TEST(WetnessMask, HasTheSameBytesOnEveryPlatform) {
  Random random(42);
  WetnessMask mask(64);
  for (int k = 0; k < 60; ++k) mask.addDroplet(randomDroplet(random));
  mask.dry(1.0f, 0.1f);
  test::printOnEveryPlatform("droplets that dry", mask.hash());
}

}  // namespace
}  // namespace fur::wet
