#include "furgen/Streaks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/Random.h"

namespace fur::furgen {
namespace {

constexpr int kLevelSize = 32;

// White along one line through the corner, black elsewhere.
std::vector<std::uint8_t> lineAlong(int stepX, int stepY) {
  std::vector<std::uint8_t> level(kLevelSize * kLevelSize * 4, 0);
  for (int k = 0; k < kLevelSize; ++k)
    for (int c = 0; c < 4; ++c)
      level[static_cast<std::size_t>((k * stepY % kLevelSize * kLevelSize + k * stepX % kLevelSize) * 4 + c)] = 255;
  return level;
}

TEST(Streaks, KeepALineOfTheirOwnDirectionAndSpreadOneAcross) {
  struct Case { int x, y; float turn; };
  for (const Case& own : {Case{1, 0, 0.0f}, Case{1, 1, 0.25f}, Case{0, 1, 0.5f}}) {
    const auto line = lineAlong(own.x, own.y);
    EXPECT_EQ(streaks(line, kLevelSize, own.turn), line) << own.turn;
    const auto across = streaks(line, kLevelSize, own.turn + 0.5f);
    // A streak meets a line that it crosses in one texel; one along the diagonal has each of its texels once or twice.
    for (std::size_t i = 0; i < across.size(); ++i) ASSERT_LE(across[i], 2 * 255 / kStreakTexels + 1) << own.turn;
  }
}

TEST(Streaks, KeepTheMeanOfALevelThatRepeats) {
  Random random(7);
  std::vector<std::uint8_t> level(kLevelSize * kLevelSize * 4);
  double before = 0;
  for (auto& byte : level) before += byte = static_cast<std::uint8_t>(random.next() & 255u);
  for (float turn = 0; turn < 1; turn += 0.1f) {
    double after = 0;
    for (const auto byte : streaks(level, kLevelSize, turn)) after += byte;
    // Every texel is rounded by itself, evenly up and down.
    EXPECT_NEAR(after / before, 1, 2e-3) << turn;
  }
}

TEST(Streaks, OfOneTexelAreThatTexel) {
  const std::vector<std::uint8_t> texel = {1, 2, 200, 255};
  EXPECT_EQ(streaks(texel, 1, 0.3f), texel);
}

}  // namespace
}  // namespace fur::furgen
