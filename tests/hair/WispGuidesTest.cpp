#include "hair/WispGuides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/Random.h"

namespace fur::hair {
namespace {

std::vector<RootFrame> flat(const std::vector<Vec2>& places) {
  std::vector<RootFrame> out;
  for (const Vec2& p : places) out.push_back({{p.x, 0, p.y}, {0, 1, 0}, {1, 0, 0}});
  return out;
}
std::vector<RootFrame> scattered(int count, std::uint64_t seed) {
  std::vector<Vec2> places;
  Random random(seed);
  for (int i = 0; i < count; ++i) places.push_back({random.uniform(-1, 1), random.uniform(-1, 1)});
  return flat(places);
}
std::vector<RootFrame> grid(int side) {
  std::vector<Vec2> places;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) places.push_back({0.25f * static_cast<float>(x), 0.25f * static_cast<float>(y)});
  return flat(places);
}

// Each guide's own number, as wisps at that place see them.
float blended(const WispGuides& choice, const Vec3& place, const std::vector<float>& numbers, const Vec3& normal = {0, 1, 0}) {
  const Following f = choice.at(place, normal);
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += numbers[f.guides[k]] * f.weights[static_cast<int>(k)];
  return sum;
}
std::vector<float> numbersOf(std::size_t count) {
  Random random(8);
  std::vector<float> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(random.uniform());
  return out;
}

TEST(WispGuides, AtAGuideAWispFollowsItAlone) {
  const auto roots = grid(6);
  const WispGuides choice(roots);
  for (std::size_t g = 0; g < roots.size(); ++g) {
    const Following f = choice.at(roots[g].position, {0, 1, 0});
    float own = 0;
    for (std::size_t k = 0; k < 3; ++k) own += f.guides[k] == g ? f.weights[static_cast<int>(k)] : 0.0f;
    EXPECT_NEAR(own, 1, 1e-5);
  }
}

TEST(WispGuides, NoGuideLiesWithinTheCircleRoundTheThreeOfAWisp) {
  const auto roots = scattered(40, 2);
  const WispGuides choice(roots);
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Following f = choice.at({random.uniform(-0.7f, 0.7f), 0, random.uniform(-0.7f, 0.7f)}, {0, 1, 0});
    if (std::min({f.weights.x, f.weights.y, f.weights.z}) <= 0) continue;
    glm::dvec2 p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = {roots[f.guides[k]].position.x, roots[f.guides[k]].position.z};
    const glm::dvec2 b = p[1] - p[0], c = p[2] - p[0];
    const double d = 2 * (b.x * c.y - b.y * c.x);
    const glm::dvec2 centre((c.y * glm::dot(b, b) - b.y * glm::dot(c, c)) / d, (b.x * glm::dot(c, c) - c.x * glm::dot(b, b)) / d);
    for (const RootFrame& other : roots) {
      const double apart = glm::length(glm::dvec2(other.position.x, other.position.z) - p[0] - centre);
      // But for the trifles, by which regular grids are decided.
      EXPECT_GT(apart, glm::length(centre) * 0.99 - 0.003);
    }
  }
}

TEST(WispGuides, WhatNeighboursFollowHardlyDiffersAlsoBeyondTheOutermostGuides) {
  for (const auto& roots : {scattered(40, 4), grid(6)}) {
    const WispGuides choice(roots);
    const auto numbers = numbersOf(roots.size());
    const float step = 0.001f;
    float steepest = 0;
    for (const float z : {-1.2f, -0.31f, 0.02f, 0.27f, 0.66f, 1.3f}) {
      float before = blended(choice, {-1.5f, 0, z}, numbers);
      for (float x = -1.5f; x < 2; x += step) {
        const float now = blended(choice, {x, 0, z}, numbers);
        steepest = std::max(steepest, std::abs(now - before));
        before = now;
      }
    }
    // Guides stand 0.01 apart at the nearest; a jump would be a few tenths.
    EXPECT_LT(steepest, 0.1f);
  }
}

TEST(WispGuides, GuidesNearlyInARowServeTheWispsBetweenThemTwoAndTwo) {
  std::vector<Vec2> row;
  for (int i = 0; i < 9; ++i) row.push_back({0.2f * static_cast<float>(i), i % 2 ? 0.004f : 0.0f});
  const auto roots = flat(row);
  const WispGuides choice(roots);
  for (float x = 0.05f; x < 1.6f; x += 0.07f) {
    const Following f = choice.at({x, 0, 0.1f}, {0, 1, 0});
    float at = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      at += roots[f.guides[k]].position.x * f.weights[static_cast<int>(k)];
      if (f.weights[static_cast<int>(k)] > 0) EXPECT_LT(std::abs(roots[f.guides[k]].position.x - x), 0.21f);
    }
    EXPECT_NEAR(at, x, 0.01f);
  }
}

TEST(WispGuides, RoundASphereNeighboursAgreeAsWell) {
  std::vector<RootFrame> roots;
  Random random(6);
  while (roots.size() < 60) {
    const Vec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (glm::length(p) < 1 && glm::length(p) > 0.2f) roots.push_back({glm::normalize(p), glm::normalize(p), {1, 0, 0}});
  }
  const WispGuides choice(roots);
  const auto numbers = numbersOf(roots.size());
  std::vector<float> steps;
  float before = -1;
  for (int i = 0; i < 6000; ++i) {
    const float angle = 0.001f * static_cast<float>(i);
    const Vec3 p = glm::normalize(Vec3(std::cos(angle), 0.4f * std::sin(3 * angle), std::sin(angle)));
    const float now = blended(choice, p, numbers, p);
    if (before >= 0) steps.push_back(std::abs(now - before));
    before = now;
  }
  // As much as one guide's number can change over 0.0014 where the next is 0.1 away.
  EXPECT_LT(*std::max_element(steps.begin(), steps.end()), 0.015f);
}

TEST(WispGuides, GuidesAtOnePlaceDoNoHarm) {
  const auto roots = flat({{0, 0}, {0, 0}, {0, 0}});
  const Following f = WispGuides(roots).at({0.3f, 0, 0}, {0, 1, 0});
  EXPECT_NEAR(f.weights.x + f.weights.y + f.weights.z, 1, 1e-6);
}

}  // namespace
}  // namespace fur::hair
