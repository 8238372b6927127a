#include "truth/Flip.h"

#include <gtest/gtest.h>

#include "core/Random.h"

namespace fur::truth {
namespace {

constexpr int kSide = 64;

Picture flat(const Vec3& color) { return {kSide, kSide, std::vector<Vec3>(kSide * kSide, color)}; }

// Soft stripes with noise over them.
Picture noisy(float amount, std::uint64_t seed) {
  Random random(seed);
  Picture out{kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float stripe = 0.5f + 0.2f * std::sin(static_cast<float>(x + 2 * y) * 0.2f);
      Vec3 pixel(stripe, stripe * 0.9f, stripe * 0.7f);
      for (int k = 0; k < 3; ++k) pixel[k] = saturate(pixel[k] + amount * random.uniform(-1, 1));
      out.pixels.push_back(pixel);
    }
  return out;
}

Picture mirrored(const Picture& p) {
  Picture out = p;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      out.pixels[static_cast<std::size_t>(y * p.width + x)] = p.pixels[static_cast<std::size_t>(y * p.width + p.width - 1 - x)];
  return out;
}

TEST(Flip, IsNoughtBetweenAPictureAndItself) {
  const Picture picture = noisy(0.3f, 1);
  for (const float value : flip(picture, picture).map) EXPECT_EQ(value, 0.0f);
}

TEST(Flip, IsNearlyOneBetweenBlackAndWhite) {
  // By hand: HyAB is 100; redistributed 0.95 + 0.05 (100^0.7 - 0.4 c) / (0.6 c), with c = 41.3 from green and blue.
  const Difference difference = flip(flat(Vec3(0)), flat(Vec3(1)));
  EXPECT_GT(difference.mean, 0.96f);
  EXPECT_LE(difference.mean, 1.0f);
}

TEST(Flip, IsTheSameWithThePicturesExchanged) {
  const Picture a = noisy(0.1f, 1), b = noisy(0.3f, 2);
  EXPECT_NEAR(flip(a, b).mean, flip(b, a).mean, 1e-5f);
}

TEST(Flip, IsTheSameInAMirror) {
  const Picture a = noisy(0.1f, 1), b = noisy(0.3f, 2);
  EXPECT_NEAR(flip(a, b).mean, flip(mirrored(a), mirrored(b)).mean, 1e-5f);
}

TEST(Flip, GrowsWithTheNoise) {
  const Picture clean = noisy(0, 1);
  float last = 0;
  for (const float amount : {0.02f, 0.05f, 0.1f, 0.2f, 0.4f}) {
    const float mean = flip(clean, noisy(amount, 3)).mean;
    EXPECT_GT(mean, last);
    last = mean;
  }
}

TEST(Flip, OverlooksAPatternTooFineForTheEyeButNotTheSameFromNearBy) {
  Picture board = flat(Vec3(0));
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) board.pixels[static_cast<std::size_t>(y * kSide + x)] = Vec3(0.5f + ((x + y) % 2 ? 0.1f : -0.1f));
  const Picture even = flat(Vec3(0.505f));  // the same mean in linear light
  EXPECT_LT(flip(even, board, 200).mean, 0.5f * flip(even, board, 20).mean);
}

TEST(Flip, ADotIsSeenWhereItIs) {
  const Picture clean = flat(Vec3(0.5f));
  Picture dotted = clean;
  dotted.pixels[20 * kSide + 40] = Vec3(1);
  const Difference difference = flip(clean, dotted);
  EXPECT_EQ(std::max_element(difference.map.begin(), difference.map.end()) - difference.map.begin(), 20 * kSide + 40);
  EXPECT_EQ(difference.map[50 * kSide + 5], 0.0f);
}

TEST(Lab, IsThatOfTheStandardForTheCornersOfSrgb) {
  // From the definition, to the two places in which it is commonly printed.
  const std::vector<Vec3> lab = labOf({4, 1, {Vec3(0), Vec3(1), Vec3(0, 1, 0), Vec3(0, 0, 1)}});
  const Vec3 expected[] = {{0, 0, 0}, {100, 0, 0}, {87.74f, -86.18f, 83.18f}, {32.30f, 79.19f, -107.86f}};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(glm::distance(lab[k], expected[k]), 0.02f) << k;
}

TEST(HeatPicture, GrowsBrighterWithTheDifference) {
  const Picture heat = heatPicture({5, 1, {0, 0.25f, 0.5f, 0.75f, 1}, 0.5f});
  for (std::size_t k = 1; k < 5; ++k)
    EXPECT_GT(glm::dot(heat.pixels[k], Vec3(0.2f, 0.7f, 0.1f)), glm::dot(heat.pixels[k - 1], Vec3(0.2f, 0.7f, 0.1f)));
}

}  // namespace
}  // namespace fur::truth
