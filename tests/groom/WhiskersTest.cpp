#include "groom/Whiskers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/Random.h"
#include "groom/GroomBrush.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

Whisker on(const Vec3& direction, std::uint32_t hairs = 1) {
  Whisker w;
  w.root = w.direction = glm::normalize(direction);
  w.hairs = hairs;
  return w;
}

struct Muzzle : Setting {
  std::vector<Whisker> whiskers;
  // The coat leans everywhere by this vector across the normal.
  std::vector<Vec4> leaning(const Vec3& lean) const {
    std::vector<Vec4> out;
    for (const auto& v : surface.vertices) out.emplace_back(lean - v.normal * glm::dot(lean, v.normal), 1);
    return out;
  }
  std::vector<WhiskerHair> hairs() const { return whiskerHairs(whiskers, surface, query); }
};

bool sameBytes(const std::vector<WhiskerHair>& a, const std::vector<WhiskerHair>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(WhiskerHair)) == 0;
}

TEST(Whiskers, TheSameWhiskersGiveTheSameBytesAndAnotherSeedOthers) {
  Muzzle a, b;
  a.whiskers = b.whiskers = {on({1, 2, 3}, 8), on({-1, 0, 0.2f}, 3)};
  EXPECT_EQ(a.hairs().size(), 11u);
  EXPECT_TRUE(sameBytes(a.hairs(), b.hairs()));
  b.whiskers[0].seed = 2;
  EXPECT_FALSE(sameBytes(a.hairs(), b.hairs()));
}

TEST(Whiskers, HairsKeepTheirLengthHoweverTheyAreBent) {
  Muzzle m;
  Random random(5);
  const auto any = [&] { return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
  for (int i = 0; i < 60; ++i) {
    m.whiskers.push_back(on(any(), 1 + random.next() % 8));
    m.whiskers.back().direction = pulledDirection(m.whiskers.back().root, 0.5f, any());
    m.whiskers.back().stiffness = random.uniform();
    m.whiskers.back().seed = random.next();
  }
  for (const Vec3& lean : {Vec3(0), Vec3(1.35f, 0, 0), Vec3(0, -1.35f, 0), Vec3(0.3f, 0.2f, -0.9f)}) {
    const auto bends = m.leaning(lean);
    for (const WhiskerHair& hair : m.hairs()) {
      const auto points = hairPoints(hair, bends);
      float length = 0;
      for (std::size_t k = 1; k < points.size(); ++k) length += glm::length(points[k] - points[k - 1]);
      ASSERT_TRUE(std::isfinite(length));
      // Seven chords of an arc of at most 2 rad: 1 - (2 / 7)^2 / 24 of it.
      ASSERT_LE(length, hair.length * 1.0001f);
      ASSERT_GE(length, hair.length * 0.996f);
      ASSERT_EQ(points[0], hair.root);
      ASSERT_NEAR(glm::length(hair.root), 1, 0.01f) << "on the skin";
      ASSERT_NEAR(glm::dot(hair.curve, hair.direction), 0, 1e-5f);
    }
  }
}

TEST(Whiskers, LeanWithTheCoatByLessTheStifferTheyAre) {
  Muzzle m;
  m.whiskers = {on({0, 1, 0}), on({0, 1, 0}), on({0, 1, 0})};
  m.whiskers[0].stiffness = 1;
  m.whiskers[1].stiffness = 0.5f;
  m.whiskers[2].stiffness = 0;
  const auto hairs = m.hairs();
  const auto tip = [&](std::size_t i, const Vec3& lean) { return hairPoints(hairs[i], m.leaning(lean)).back(); };
  const Vec3 wind(0.8f, 0, 0);
  EXPECT_EQ(tip(0, wind), tip(0, Vec3(0)));
  EXPECT_GT(tip(1, wind).x, tip(1, Vec3(0)).x + 0.05f);
  EXPECT_GT(tip(2, wind).x, tip(1, wind).x + 0.05f);
}

TEST(Whiskers, ATuftFansOutFromItsMiddleHair) {
  Muzzle m;
  const auto widest = [&](float spread) {
    m.whiskers = {on({0, 0, 1}, 8)};
    m.whiskers[0].spread = spread;
    const auto hairs = m.hairs();
    EXPECT_EQ(hairs[0].direction, Vec3(0, 0, 1));
    EXPECT_EQ(hairs[0].length, m.whiskers[0].length);
    float angle = 0;
    for (const WhiskerHair& hair : hairs) {
      angle = std::max(angle, std::acos(std::min(glm::dot(hair.direction, Vec3(0, 0, 1)), 1.0f)));
      EXPECT_LE(hair.length, m.whiskers[0].length);
    }
    return angle;
  };
  EXPECT_LT(widest(0), 1e-3f);
  EXPECT_GT(widest(0.5f), 0.2f);
  EXPECT_GT(widest(1), widest(0.5f) + 0.1f);
  // Aside is at most the diagonal of a square of two units.
  EXPECT_LE(widest(1), std::atan(0.9f * std::sqrt(3.0f)));
}

TEST(Whiskers, AnotherFurMappingLeavesThemWhereTheyStand) {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  Muzzle charts, cube;
  const Setting boxed(256, geometry::buildSurface(mesh, geometry::FurMapping::Cube).value());
  charts.whiskers = {on({0.3f, 0.9f, 0.2f}, 4), on({-0.7f, 0.1f, 0.7f}, 2)};
  const auto a = charts.hairs(), b = whiskerHairs(charts.whiskers, boxed.surface, boxed.query);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LT(glm::length(a[i].root - b[i].root), 1e-6f);
    EXPECT_LT(glm::length(a[i].curve - b[i].curve), 1e-5f);
  }
}

TEST(Whiskers, HostileOnesAreBroughtWithinBoundsOrLeftOut) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  const Whisker good = on({0, 1, 0});
  for (float Whisker::*number : {&Whisker::length, &Whisker::width, &Whisker::spread, &Whisker::stiffness})
    for (const float value : {kNaN, kInfinity, -kInfinity}) {
      Whisker bad = good;
      bad.*number = value;
      EXPECT_FALSE(makeSound(bad));
    }
  for (Vec3 Whisker::*vector : {&Whisker::root, &Whisker::direction}) {
    Whisker bad = good;
    (bad.*vector).y = kNaN;
    EXPECT_FALSE(makeSound(bad));
  }
  Whisker nowhere = good;
  nowhere.direction = Vec3(0);
  EXPECT_FALSE(makeSound(nowhere));

  Whisker wild = good;
  wild.direction = Vec3(0, 300, 400);
  wild.length = 1e30f;
  wild.width = -1;
  wild.spread = 7;
  wild.stiffness = -7;
  wild.hairs = 4000000000u;
  wild.color = 0xff123456u;
  Whisker tamed = wild;
  EXPECT_TRUE(makeSound(tamed));
  EXPECT_LT(glm::length(tamed.direction - Vec3(0, 0.6f, 0.8f)), 1e-6f);
  EXPECT_LE(tamed.length, 2);
  EXPECT_EQ(tamed.width, 0);
  EXPECT_EQ(tamed.spread, 1);
  EXPECT_EQ(tamed.stiffness, 0);
  EXPECT_EQ(tamed.hairs, kMostHairs);
  EXPECT_EQ(tamed.color, 0x123456u);
  Whisker again = tamed;
  EXPECT_TRUE(makeSound(again));
  EXPECT_EQ(again, tamed) << "what is sound keeps its bits";

  Muzzle m;
  Whisker far = good;
  far.root = Vec3(0, 1.2f, 0);
  m.whiskers = {far};
  EXPECT_TRUE(m.hairs().empty());
  m.whiskers.insert(m.whiskers.end(), 600, good);
  keepSound(m.whiskers, m.query);
  EXPECT_EQ(m.whiskers, std::vector<Whisker>(kMostWhiskers, good));
  m.whiskers[0].direction = Vec3(0, -1, 0);
  EXPECT_EQ(m.hairs().size(), kMostWhiskers - 1) << "it points into the skin";
}

TEST(Whiskers, GoThroughBytes) {
  const std::vector<Whisker> whiskers = {on({0, 1, 0}, 3), on({1, 0, 0}, 8)};
  const auto* first = reinterpret_cast<const std::uint8_t*>(whiskers.data());
  EXPECT_EQ(readWhiskers({first, 2 * kWhiskerBytes}), whiskers);
  EXPECT_EQ(readWhiskers({first, 2 * kWhiskerBytes - 1}).size(), 1u);
  EXPECT_TRUE(readWhiskers({}).empty());
}

TEST(Whiskers, ArePulledToWhereTheHandIsButNeverIntoTheSkin) {
  const Vec3 up(0, 1, 0);
  EXPECT_EQ(pulledDirection(up, 0.4f, Vec3(0)), up);
  EXPECT_GT(pulledDirection(up, 0.4f, Vec3(0.4f, 0, 0)).x, 0.9f);
  for (const Vec3& pull : {Vec3(1, -1, 0), Vec3(0, -9, 0), Vec3(100, -100, 3)}) EXPECT_GT(pulledDirection(up, 0.4f, pull).y, 0);
}

TEST(Whiskers, ArePluckedByTheirRoots) {
  Setting s;
  s.groom.whiskers = {on({0, 1, 0}), on({0, 1, 0.1f}), on({0, 1, 1}), on({0, -1, 0})};
  EXPECT_FALSE(s.groom.isPlain());
  EXPECT_FALSE(pluck(s.groom, s.groomSurface(), {Vec3(1, 0, 0), Vec3(1, 0, 0), 0.3f, 1}));
  EXPECT_FALSE(pluck(s.groom, s.groomSurface(), {Vec3(0, 1, 0), Vec3(0, 1, 0), std::numeric_limits<float>::quiet_NaN(), 1}));
  EXPECT_TRUE(pluck(s.groom, s.groomSurface(), {Vec3(0, 1, 0), Vec3(0, 1, 0), 0.3f, 0.1f}));
  EXPECT_EQ(s.groom.whiskers, (std::vector<Whisker>{on({0, 1, 1}), on({0, -1, 0})}));
  // What stands on the far side of something thin stays.
  EXPECT_FALSE(pluck(s.groom, s.groomSurface(), {Vec3(0, -1, 0), Vec3(0, 1, 0), 0.3f, 1}));
}

}  // namespace
}  // namespace fur::groom
