#include "wet/Water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/Primitives.h"
#include "tests/OnEveryPlatform.h"
#include "wet/Clump.h"

namespace fur::wet {
namespace {

using geometry::Surface;
using geometry::SurfaceQuery;

// A model with its water, ready to run.
struct Pond {
  Surface surface;
  SurfaceQuery query;
  SurfaceWetting wetting;
  WetnessMask mask;
  Water water;
  Climate climate;

  explicit Pond(const geometry::Mesh& mesh, int size = 128)
      : surface(geometry::buildSurface(mesh).value()), query(surface), wetting(surface, size), mask(size) {
    water.prepare(wetSurface());
    climate.dryRate = 0;
  }
  WetSurface wetSurface() const { return {surface, query, wetting}; }
  bool run(int steps) {
    bool changed = false;
    for (int i = 0; i < steps; ++i) changed |= water.step(wetSurface(), mask, climate);
    return changed;
  }
  void soak() {
    std::vector<Vec4> soaked = mask.texels();
    for (std::size_t i = 0; i < soaked.size(); ++i)
      if (water.texels()->placeOf(static_cast<std::uint32_t>(i)) != SurfaceTexels::kNone) soaked[i] = Vec4(mask.texelCentre(i), 0.05f, 1);
    mask.restore(soaked);
  }
  void droplet(const Vec3& at, float radius, float wetness) {
    wetting.addDroplet(mask, surface, query, at, glm::normalize(at), radius, wetness);
  }
  // Of all water on the surface: the mean of `f` over positions.
  template <class F>
  double mean(F f) const {
    double sum = 0, all = 0;
    for (const auto& place : water.texels()->places()) {
      const double amount = place.area * (mask.texels()[place.texel].w + mask.filmAt(place.texel));
      sum += amount * f(place.position);
      all += amount;
    }
    return all > 0 ? sum / all : 0;
  }
};

geometry::Mesh sphere() {
  geometry::Mesh mesh = geometry::makeSphere();
  mesh.uv.clear();
  return mesh;
}
geometry::Mesh torus() {
  geometry::Mesh mesh = geometry::makeTorus();
  mesh.uv.clear();
  return mesh;
}

double imbalance(const Accounts& a) {
  return a.painted + a.rained - (a.held + a.film + a.drops + a.hair + a.dripped + a.evaporated + a.removed);
}

TEST(SurfaceTexels, CoverTheSurfaceOnce) {
  const Pond pond(sphere());
  double area = 0;
  for (const auto& place : pond.water.texels()->places()) area += place.area;
  EXPECT_NEAR(area, 4 * 3.14159, 0.05);  // a sphere of triangles is a little smaller
}

TEST(SurfaceTexels, LinkToWhatLiesBesideThemAcrossChartBorders) {
  for (const geometry::Mesh& mesh : {sphere(), torus(), geometry::makeSphere()}) {
    const Pond pond(mesh);
    const auto& places = pond.water.texels()->places();
    int missing = 0, far = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const std::uint32_t link : pond.water.texels()->links()[i]) {
        const auto& place = places[i];
        if (link == SurfaceTexels::kNone) {
          ++missing;
          continue;
        }
        const float apart = glm::length(places[link].position - place.position);
        far += apart > 6 * std::sqrt(place.area + places[link].area);
      }
    // Closed surfaces: water can go on everywhere but at the poles of a globe.
    EXPECT_LE(missing, static_cast<int>(places.size()) / 50);
    EXPECT_LE(far, static_cast<int>(places.size()) / 50);
  }
}

TEST(SurfaceTexels, LinkTheSameWayHoweverItIsSliced) {
  const Pond once(torus());
  Water sliced;
  while (!sliced.prepare(once.wetSurface(), 97)) {
  }
  EXPECT_EQ(once.water.texels()->links(), sliced.texels()->links());
}

// How far a texel lies from the middle of its clump, in radii.
float outwardness(const WetnessMask& mask, std::uint32_t texel, const Vec3& clump) {
  return glm::length(mask.texelCentre(texel) - Vec2(clump)) / clump.z;
}

TEST(ClumpSites, HoldEveryPlaceInItsOwnLock) {
  for (const auto& [mesh, radii] : {std::pair(sphere(), std::array{0.02f, 0.06f}), std::pair(torus(), std::array{0.035f, 0.1f})}) {
    const Pond pond(mesh, 256);
    const SurfaceTexels& texels = *pond.water.texels();
    for (const float radius : radii) {
      ClumpSites sites(texels, radius);
      sites.find(texels);
      for (std::uint32_t i = 0; i < texels.places().size(); ++i)
        ASSERT_LT(outwardness(pond.mask, texels.places()[i].texel, sites.clumpOf(texels, pond.surface, pond.query, pond.wetting, i)), 0.92f)
            << "radius " << radius << ", place " << i;
    }
  }
}

TEST(Water, InGuttersHasLocksThatReachThem) {
  Pond pond(sphere());
  for (const float side : {-1.0f, 1.0f}) pond.droplet({0, 0, side}, 0.7f, 0.6f);
  pond.run(30);
  std::size_t gutters = 0;
  for (std::uint32_t i = 0; i < pond.water.texels()->places().size(); ++i)
    pond.water.texels()->forMirrors(i, [&](std::uint32_t mirror) {
      const Vec4 &texel = pond.mask.texels()[mirror], &repeated = pond.mask.texels()[pond.water.texels()->places()[i].texel];
      ASSERT_EQ(texel.w, repeated.w);
      if (texel.w <= 0) return;
      ++gutters;
      ASSERT_LE(outwardness(pond.mask, mirror, Vec3(texel)), 1.01f) << mirror;
    });
  EXPECT_GT(gutters, 100u);
}

TEST(ClumpSites, LieApartAndLeaveNoSpotWithoutOne) {
  const Pond pond(torus());
  const SurfaceTexels& texels = *pond.water.texels();
  ClumpSites sites(texels, 0.06f);
  sites.find(texels);
  ASSERT_GT(sites.sites().size(), 100u);
  for (std::uint32_t i = 0; i < texels.places().size(); ++i) {
    const std::uint32_t site = sites.siteOf(texels, i);
    ASSERT_NE(site, SurfaceTexels::kNone);
    ASSERT_LT(glm::length(texels.places()[sites.sites()[site]].position - texels.places()[i].position), 0.06f);
  }
  for (std::size_t a = 0; a < sites.sites().size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const auto &pa = texels.places()[sites.sites()[a]], &pb = texels.places()[sites.sites()[b]];
      if (glm::dot(pa.normal, pb.normal) > 0) ASSERT_GT(glm::length(pa.position - pb.position), 0.049f);
    }
}

TEST(ClumpSites, AreTheSameHoweverTheyAreSliced) {
  const Pond pond(torus());
  const SurfaceTexels& texels = *pond.water.texels();
  ClumpSites once(texels, 0.06f), sliced(texels, 0.06f);
  once.find(texels);
  while (!sliced.find(texels, 97)) {
  }
  EXPECT_EQ(once.sites(), sliced.sites());
}

TEST(Water, OnAWholeModelAtOnceFlowsEverywhereBeforeLong) {
  Pond pond(sphere(), 256);
  pond.climate.dryRate = 0;
  // Walls all round: film on each runs.
  for (const SurfaceTexels::Place& place : pond.water.texels()->places())
    if (std::abs(place.normal.y) < 0.7f && place.texel % 5 == 0) pond.wetting.addDroplet(pond.mask, pond.surface, pond.query, place.position, place.normal, 0.05f, 1);
  pond.run(1);
  const std::vector<float> before = pond.mask.film();
  pond.run(60);
  std::size_t still = 0, all = 0;
  for (const SurfaceTexels::Place& place : pond.water.texels()->places())
    if (std::abs(place.normal.y) < 0.6f && before[place.texel] > 0.5f) ++all, still += pond.mask.filmAt(place.texel) == before[place.texel];
  ASSERT_GT(all, 1000u);
  EXPECT_EQ(still, 0u);
}

TEST(Water, DoesNothingWhereNothingIsWet) {
  Pond pond(sphere());
  EXPECT_FALSE(pond.water.active(pond.mask, pond.climate));
  EXPECT_FALSE(pond.run(10));
  EXPECT_TRUE(pond.mask.takeChanged().empty());
}

TEST(Water, KeepsItsAccountsOverTenThousandSteps) {
  Pond pond(sphere(), 32);
  pond.climate.dryRate = 0.02f;
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    pond.climate.rain = i % 2000 < 400 ? 0.5f : 0.0f;
    pond.climate.shaking = i % 2500 > 2400 ? 1.0f : 0.0f;
    const Vec3 at = glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) + 1e-3f);
    if (i % 50 == 0) pond.droplet(at, 0.15f, 0.5f);
    if (i % 70 == 0) pond.water.pour(pond.wetSurface(), pond.mask, at, at, 0.1f, 0.05f);
    if (i % 300 == 0) pond.water.wipe(pond.wetSurface(), pond.mask, at, at, 0.2f, 0.4f);
    pond.run(1);
  }
  const Accounts a = pond.water.accounts();
  EXPECT_GT(a.painted, 1);
  EXPECT_GT(a.rained, 1);
  EXPECT_GT(a.evaporated, 0.3);
  EXPECT_GT(a.dripped, 0.1);
  EXPECT_GT(a.removed, 0.05);
  // Single precision, ten thousand times: every step rounds what it moves.
  EXPECT_NEAR(imbalance(a) / (a.painted + a.rained), 0, 2e-5);
}

TEST(Water, RunsDownWhatCannotHoldMoreAndDripsFromBelow) {
  Pond pond(sphere());
  for (int i = 0; i < 8; ++i) pond.droplet(Vec3(0, 0, 1), 0.2f, 1.0f);
  pond.run(1);
  const double before = pond.mean([](const Vec3& p) { return p.y; });
  pond.run(300);
  EXPECT_LT(pond.mean([](const Vec3& p) { return p.y; }), before - 0.1);
  for (int i = 0; i < 20; ++i) pond.water.pour(pond.wetSurface(), pond.mask, Vec3(0, -1, 0), Vec3(0, -1, 0), 0.2f, 0.05f);
  pond.run(600);
  EXPECT_GT(pond.water.accounts().dripped, 0.1);
  float puddle = 0;
  for (const float water : pond.water.ground()) puddle += water;
  EXPECT_GT(puddle, 0.0f);
}

TEST(Water, RunsTheOtherWayOnATurnedModel) {
  Pond pond(sphere());
  pond.climate.worldFromModel = glm::rotate(Mat4(1), kPi / 2, Vec3(0, 0, 1));  // model x is up
  for (int i = 0; i < 8; ++i) pond.droplet(Vec3(0, 0, 1), 0.2f, 1.0f);
  pond.run(300);
  EXPECT_LT(pond.mean([](const Vec3& p) { return p.x; }), -0.1);
  EXPECT_NEAR(pond.mean([](const Vec3& p) { return p.y; }), 0.0, 0.1);
}

TEST(Water, IsTurnedAsideByCombedFur) {
  Pond pond(sphere());
  // Combed to the right and down, in 45 degrees.
  std::vector<Vec3> lay(pond.surface.vertices.size(), Vec3(0.7f, -0.7f, 0));
  pond.water.setLay(lay);
  for (int i = 0; i < 8; ++i) pond.droplet(Vec3(0, 0, 1), 0.2f, 1.0f);
  pond.run(240);
  EXPECT_GT(pond.mean([](const Vec3& p) { return p.x; }), 0.05);
}

TEST(Water, CreepsFartherAlongTheStrandsThanAcross) {
  Pond pond(geometry::makePlane());
  pond.water.setLay(std::vector<Vec3>(pond.surface.vertices.size(), Vec3(1, 0, 0)));
  pond.wetting.addDroplet(pond.mask, pond.surface, pond.query, Vec3(0), Vec3(0, 1, 0), 0.1f, 0.9f);
  // Of what is wet, the mean square of the distance along the strands and across.
  const auto spread = [&] { return Vec2(pond.mean([](const Vec3& p) { return p.x * p.x; }), pond.mean([](const Vec3& p) { return p.z * p.z; })); };
  const Vec2 before = spread();
  pond.run(900);
  const Vec2 grown = spread() - before;
  EXPECT_GT(grown.y, 0.0f);
  EXPECT_GT(grown.x, 1.5f * grown.y);
}

TEST(Water, ComesToRestAndLeavesTheFurWet) {
  Pond pond(torus());
  for (int i = 0; i < 4; ++i) pond.droplet(Vec3(0.8f, 0.3f, 0), 0.15f, 0.7f);
  pond.run(1);
  EXPECT_TRUE(pond.water.active(pond.mask, pond.climate));
  int steps = 0;
  while (pond.water.active(pond.mask, pond.climate) && steps < 20000) pond.run(1), ++steps;
  EXPECT_LT(steps, 60 * 60);
  EXPECT_FALSE(pond.mask.isDry());
  EXPECT_FALSE(pond.run(10));
}

TEST(Water, DriesWithoutMovingAClumpsCentre) {
  Pond pond(sphere());
  pond.climate.dryRate = 0.2f;
  Random random(5);
  for (int i = 0; i < 30; ++i)
    pond.droplet(glm::normalize(Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) + 1e-3f), 0.12f, 0.25f);
  pond.run(60);
  for (int k = 0; k < 6; ++k) {
    const auto before = pond.mask.texels();
    pond.run(30);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Vec4 now = pond.mask.texels()[i];
      if (before[i].w > 0 && now.w > 0) ASSERT_EQ(Vec3(now), Vec3(before[i]));
    }
  }
  pond.run(1200);
  EXPECT_TRUE(pond.mask.isDry());
  EXPECT_FALSE(pond.water.active(pond.mask, pond.climate));
}

TEST(Water, DriesFasterInWindAndUnderADryer) {
  double left[3];
  for (int k = 0; k < 3; ++k) {
    Pond pond(sphere());
    pond.climate.dryRate = 0.05f;
    if (k == 1) pond.climate.wind = Vec3(1, 0, 0);
    if (k == 2) pond.climate.blowCentre = Vec3(0, 0, 1), pond.climate.blowRadius = 0.4f, pond.climate.blow = 0.5f;
    pond.droplet(Vec3(0, 0, 1), 0.2f, 0.6f);
    pond.run(120);
    left[k] = pond.water.accounts().held;
  }
  EXPECT_LT(left[1], 0.95 * left[0]);
  EXPECT_LT(left[2], 0.7 * left[0]);
}

TEST(Water, ThatRainsMakesLocksAtTheirSites) {
  Pond pond(sphere());
  pond.climate.rain = 1;
  pond.climate.clumpSize = 0.15f;
  pond.run(240);
  EXPECT_FALSE(pond.mask.isDry());
  EXPECT_GT(pond.water.drops().size(), 10u);
  int wet = 0, below = 0;
  for (const auto& place : pond.water.texels()->places()) {
    const Vec4 texel = pond.mask.texels()[place.texel];
    if (texel.w <= 0) continue;
    ++wet;
    below += place.normal.y < -0.5f;
    ASSERT_GT(texel.z, 0.0f);
    const Vec2 at((place.texel % 128 + 0.5f) / 128, (place.texel / 128 + 0.5f) / 128);
    // A texel lies within the clump that it belongs to; the cells of rims stretch a little.
    ASSERT_LE(glm::length(at - Vec2(texel)), 1.5f * texel.z);
  }
  EXPECT_GT(wet, 100);
  EXPECT_LT(below, wet / 10);
}

TEST(Water, ShakenFliesOffAsDrops) {
  Pond pond(sphere());
  for (int i = 0; i < 5; ++i) pond.droplet(Vec3(0, 0.6f, 0.8f), 0.4f, 0.9f);
  pond.run(1);
  const double before = pond.water.accounts().held + pond.water.accounts().film;
  pond.climate.shaking = 1;
  pond.run(20);
  EXPECT_GT(pond.water.drops().size(), 5u);
  pond.run(40);
  EXPECT_LT(pond.water.accounts().held + pond.water.accounts().film, 0.9 * before);
  EXPECT_NEAR(imbalance(pond.water.accounts()), 0, 1e-6);
}

TEST(Water, WhatTheGroundCannotTakeUpSpreadsOverIt) {
  Pond pond(sphere(), 32);
  pond.climate.groundHeight = -1;
  for (int i = 0; i < 40; ++i) pond.water.launch(Vec3(2, -0.9f, 0), Vec3(0, -1, 0), 0.01f);
  const auto measure = [&] {
    std::array<double, 3> out{};  // all of it, the most in a cell, wet cells
    for (const float amount : pond.water.ground()) out = {out[0] + amount, std::max(out[1], double{amount}), out[2] + (amount > 0.01f)};
    return out;
  };
  pond.run(20);
  const auto fallen = measure();
  for (int i = 0; i < 200; ++i) {
    pond.water.launch(Vec3(-2, 3, 0), Vec3(0), 1e-9f);  // time goes by only where something happens
    pond.run(2);
  }
  const auto later = measure();
  const double cell = 2.0 * kGroundReach / kGroundCells;
  EXPECT_NEAR(fallen[0] * cell * cell, 0.4, 1e-4);
  EXPECT_NEAR(later[0] * cell * cell, 0.4, 1e-3);
  EXPECT_LT(later[1], 0.2 * fallen[1]);
  EXPECT_GT(later[2], 4 * fallen[2]);
}

// A soaked model stood in water that spread for minutes by less and less, and its picture was drawn anew for each step of it.
TEST(Water, PuddlesThatSpreadChangeByWhatIsSeenOfThem) {
  Pond pond(sphere(), 32);
  pond.climate.groundHeight = -1;
  for (int i = 0; i < 40; ++i) pond.water.launch(Vec3(2, -0.9f, 0), Vec3(0, -1, 0), 0.01f);
  pond.run(60);
  ASSERT_TRUE(pond.water.drops().empty());
  float first = 0, last = 0;
  for (int i = 0; i < 1200; ++i) {
    const std::vector<float> before(pond.water.ground().begin(), pond.water.ground().end());
    pond.run(1);
    float most = 0;
    for (std::size_t k = 0; k < before.size(); ++k) most = std::max(most, std::abs(seenOfPuddle(pond.water.ground()[k]) - seenOfPuddle(before[k])));
    ASSERT_EQ(pond.water.change(), most);
    (i < 60 ? first : last) += i < 60 || i >= 1140 ? most : 0;
  }
  EXPECT_GT(first, 0.05f);
  EXPECT_LT(last, 0.5f * first);
}

TEST(Water, DropsHangFromAndHitTheModelWhereItIsShown) {
  Pond pond(sphere(), 128);  // texels of coarser ones hold more than a drop
  const Vec3 aside(1.5f, 0.5f, 0);
  std::vector<Vec3> positions, normals;
  for (const auto& vertex : pond.surface.vertices) {
    positions.push_back(vertex.position + aside);
    normals.push_back(vertex.normal);
  }
  SurfaceQuery shown = pond.query;
  shown.follow(pond.surface, positions);
  WetSurface posed{pond.surface, pond.query, pond.wetting, positions, normals, &shown};
  pond.climate.groundHeight = -3;
  pond.water.pour(posed, pond.mask, Vec3(0.1f, -0.995f, 0), Vec3(0.1f, -0.995f, 0), 0.2f, 0.6f);
  bool hung = false;
  for (int i = 0; i < 120; ++i) {
    pond.water.step(posed, pond.mask, pond.climate);
    for (const Drop& drop : pond.water.drops()) {
      if (!drop.hangs() || drop.water == 0) continue;
      hung = true;
      EXPECT_NEAR(glm::length(drop.position - aside), 1.07, 0.12);
    }
  }
  EXPECT_TRUE(hung);
  // One that falls on it wets its top; beside it there is nothing.
  pond.mask.clear();
  pond.water.clear();
  pond.water.launch(Vec3(1.5f, 2, 0), Vec3(0, -1, 0), 0.002f);
  pond.water.launch(Vec3(0, 2, 0), Vec3(0, -1, 0), 0.002f);
  for (int i = 0; i < 40; ++i) pond.water.step(posed, pond.mask, pond.climate);
  EXPECT_GT(pond.mean([](const Vec3& at) { return at.y; }), 0.9);
  EXPECT_NEAR(pond.water.accounts().held + pond.water.accounts().film, 0.002, 2e-4);
}

TEST(Water, DropsHangFromWhereWetFurEndsWhichIsLowerWhereItLies) {
  float highest[2] = {};
  for (const int lies : {0, 1}) {
    Pond pond(sphere(), 128);  // texels of coarser ones hold more than a drop
    pond.climate.groundHeight = -3;
    std::vector<Vec3> lay;
    for (const auto& vertex : pond.surface.vertices) lay.push_back(static_cast<float>(lies) * normalizeOr(glm::cross(vertex.normal, Vec3(0, 0, 1)), Vec3(0)));
    pond.water.setLay(lay);
    pond.water.pour(pond.wetSurface(), pond.mask, Vec3(0.1f, -0.995f, 0), Vec3(0.1f, -0.995f, 0), 0.2f, 0.6f);
    for (int i = 0; i < 120; ++i) {
      pond.run(1);
      for (const Drop& drop : pond.water.drops()) {
        if (!drop.hangs() || drop.water == 0) continue;
        const float height = glm::length(drop.position) - drop.radius - 1, held = pond.mask.texels()[pond.water.texels()->places()[drop.place].texel].w;
        EXPECT_LT(height, standsTo(held, 0) * Climate{}.furLength);
        highest[lies] = std::max(highest[lies], height);
      }
    }
    EXPECT_GT(highest[lies], 0.0f);
  }
  // A strand that is combed as far as strands are ends a fifth lower.
  EXPECT_LT(highest[1], 0.9f * highest[0]);
}

TEST(Water, ThatLandsLeavesARingOnTheGroundForAMomentAndAJetThrowsSpray) {
  Pond pond(sphere(), 64);
  pond.climate.groundHeight = -1;
  pond.water.launch(Vec3(2, -0.9f, 0), Vec3(0, -6, 0), 0.002f);
  pond.run(3);
  ASSERT_EQ(pond.water.drops().size(), 1u);
  EXPECT_GT(pond.water.drops()[0].splash, 0);
  EXPECT_EQ(pond.water.drops()[0].water, 0);
  EXPECT_EQ(pond.water.drops()[0].position.y, -1);
  EXPECT_NEAR(pond.water.accounts().dripped, 0.002, 1e-8);
  pond.run(30);
  EXPECT_TRUE(pond.water.drops().empty());
  // On fur a drop only goes in; a jet sprays, and none of it is lost.
  for (const float jet : {0.0f, Water::kJet}) {
    pond.water.launch(Vec3(0, 1.3f, 0), Vec3(0, -9, 0), 0.002f, jet);
    pond.run(4);
    EXPECT_EQ(pond.water.drops().size() > 3, jet > 0);
    EXPECT_NEAR(imbalance(pond.water.accounts()), 0, 1e-7);
    EXPECT_EQ(pond.water.accounts().drops, 0);
    pond.run(60);
    EXPECT_TRUE(pond.water.drops().empty());
  }
}

TEST(Water, HasTheSameBitsOnEveryPlatform) {
  Pond pond(torus(), 64);
  pond.climate.dryRate = 0.05f;
  pond.climate.rain = 1;
  pond.climate.wind = Vec3(0.3f, 0, 0.1f);
  pond.droplet(Vec3(0.8f, 0.3f, 0), 0.2f, 1.0f);
  pond.run(120);
  pond.climate.shaking = 1;
  pond.run(60);
  pond.climate = Climate{};
  pond.run(120);
  test::printOnEveryPlatform("rain, shaking and drying", pond.water.hash(pond.mask));
}

TEST(Water, SoakedRunsDownDripsWhatItCannotHoldAndComesToRest) {
  for (const geometry::Mesh& mesh : {sphere(), torus()}) {
    Pond pond(mesh, 112);  // through smaller texels water runs more slowly
    pond.soak();
    pond.run(1);
    const double all = pond.water.accounts().held;
    pond.run(600);
    EXPECT_GT(pond.water.accounts().dripped, 0.1 * all);
    // A quarter is more than fur can hold (kField in Flow.cpp).
    for (int i = 0; i < 180 && pond.water.active(pond.mask, pond.climate); ++i) pond.run(60);
    EXPECT_FALSE(pond.run(10));
    EXPECT_NEAR(pond.water.accounts().dripped / all, 0.24, 0.02);
    EXPECT_NEAR(imbalance(pond.water.accounts()) / all, 0, 2e-5);  // as over ten thousand steps
  }
}

TEST(Water, OfSoakedFurRunsThroughTheBordersOfCharts) {
  for (const geometry::Mesh& mesh : {sphere(), torus()}) {
    Pond pond(mesh, 256);
    pond.soak();
    pond.run(90);
    const SurfaceTexels& texels = *pond.water.texels();
    // By height, as it runs off from above; those in the middle of charts and those whose neighbours are another chart's.
    double sums[2] = {}, counts[2] = {}, low = 0;
    for (const auto& place : texels.places()) {
      if (place.position.y > 0.2f || place.position.y < -0.5f) continue;
      const int x = static_cast<int>(place.texel) % 256, y = static_cast<int>(place.texel) / 256;
      std::size_t border = 0;
      for (const auto& step : SurfaceTexels::kSteps) {
        const auto beside = static_cast<std::uint32_t>((y + step[1]) * 256 + x + step[0]);
        const std::uint32_t there = texels.placeOf(beside);
        border |= there == SurfaceTexels::kNone || texels.places()[there].texel != beside;
      }
      const double water = pond.mask.texels()[place.texel].w + pond.mask.filmAt(place.texel);
      sums[border] += water;
      ++counts[border];
      low += border && water < 0.85;
    }
    EXPECT_NEAR(sums[1] / counts[1], sums[0] / counts[0], 0.02);
    EXPECT_LT(low / counts[1], 0.1);  // tips of charts that few texels lead to
  }
}

TEST(Water, RunsAsFastInAllChartsHoweverTheyLie) {
  Pond pond(sphere(), 256);
  pond.soak();
  pond.run(180);
  // The charts that have much of a belt which the front has reached.
  std::map<std::uint16_t, std::pair<double, int>> charts;
  for (const auto& place : pond.water.texels()->places()) {
    if (std::abs(place.position.y - 0.6f) > 0.1f) continue;
    auto& [water, count] = charts[pond.wetting.chartOfTexel()[place.texel]];
    water += pond.mask.texels()[place.texel].w;
    ++count;
  }
  double least = 2, most = 0;
  for (const auto& [chart, sum] : charts) {
    if (sum.second < 100) continue;
    least = std::min(least, sum.first / sum.second);
    most = std::max(most, sum.first / sum.second);
  }
  EXPECT_LT(most - least, 0.022);
  EXPECT_GT(most, 0.8);
}

TEST(Water, IsAtRestWhereverItIsTakenTo) {
  for (const auto& [size, drops] : {std::pair(64, 1), std::pair(64, 2), std::pair(64, 6), std::pair(128, 2)}) {
    Pond pond(sphere(), size);
    for (int i = 0; i < drops; ++i) pond.droplet(Vec3(0, 0.6f, 0.8f), 0.25f, 0.9f);
    for (int i = 0; i < 200 && pond.water.active(pond.mask, pond.climate); ++i) pond.run(60);
    ASSERT_FALSE(pond.water.active(pond.mask, pond.climate));
    Pond other(sphere(), size);
    other.mask.restore(pond.mask.texels(), pond.mask.film());
    other.run(120);
    EXPECT_EQ(other.mask.hash(), pond.mask.hash()) << drops << " drops on " << size;
  }
}

TEST(Water, StaysFiniteWhereThereIsNoSize) {
  Pond pond(sphere(), 16);
  pond.climate.clumpSize = 0.01f;
  pond.climate.dryRate = 1;
  pond.droplet(Vec3(0, 1, 0), 1e-6f, 1.0f);
  pond.droplet(Vec3(0, 1, 0), 3.0f, 1.0f);
  pond.water.pour(pond.wetSurface(), pond.mask, Vec3(0, 0, 1), Vec3(0, 0, 1), 0.0f, 1.0f);
  pond.water.launch(Vec3(0, 3, 0), Vec3(std::nanf("")), 0.01f);
  pond.run(120);
  for (const Vec4& texel : pond.mask.texels()) ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z + texel.w));
  for (const float film : pond.mask.film()) ASSERT_TRUE(std::isfinite(film));
  EXPECT_TRUE(std::isfinite(pond.water.accounts().held));
}

}  // namespace
}  // namespace fur::wet
