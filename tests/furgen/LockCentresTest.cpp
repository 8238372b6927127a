#include "furgen/LockCentres.h"

#include <gtest/gtest.h>

#include "core/Math.h"

namespace fur::furgen {
namespace {

constexpr int kSize = 64, kAcross = 8;

Vec2 wayAt(const std::vector<std::array<std::uint8_t, 2>>& texels, int x, int y) {
  const auto& texel = texels[static_cast<std::size_t>((y + kSize) % kSize * kSize + (x + kSize) % kSize)];
  return (Vec2(texel[0], texel[1]) / 255.0f - 0.5f) * 4.0f;
}

TEST(LockCentres, NeighboursHaveTheSameLockOrOneAsFar) {
  const auto texels = lockCentres(kSize, kAcross);
  ASSERT_EQ(texels.size(), static_cast<std::size_t>(kSize * kSize));
  // A texel is 1/8 lock wide; the bytes round by 0.016. Across the tile's end, too.
  const float step = static_cast<float>(kAcross) / kSize;
  int borders = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec2 here = wayAt(texels, x, y), next = wayAt(texels, x + 1, y);
      if (glm::distance(here, next + Vec2(step, 0)) < 0.05f) continue;
      ++borders;
      EXPECT_LT(std::abs(glm::length(here) - glm::length(next)), step + 0.05f) << x << ", " << y;
    }
  EXPECT_GT(borders, kAcross * kSize / 2) << "there are about as many locks in each row";
  EXPECT_LT(borders, 2 * kAcross * kSize);
}

TEST(LockCentres, EachLockHasItsMiddleInIt) {
  const auto texels = lockCentres(kSize, kAcross);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const Vec2 way = wayAt(texels, x, y) * (static_cast<float>(kSize) / kAcross);
      const Vec2 there = wayAt(texels, x + static_cast<int>(std::lround(way.x)), y + static_cast<int>(std::lround(way.y)));
      EXPECT_LT(glm::length(there), 0.15f) << x << ", " << y;
    }
}

}  // namespace
}  // namespace fur::furgen
