#include "core/Random.h"

#include <gtest/gtest.h>

namespace fur {
namespace {

TEST(Random, GivesTheReferenceSequenceOfPcg32) {
  // The demo of the PCG reference code: seed 42, stream 54.
  Random random(42, 54);
  for (const std::uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
    EXPECT_EQ(random.next(), expected);
}

TEST(Random, IsUniformInTheHalfOpenUnitInterval) {
  Random random(1);
  double sum = 0, squares = 0;
  constexpr int kDraws = 100000;
  for (int k = 0; k < kDraws; ++k) {
    const float x = random.uniform();
    ASSERT_GE(x, 0.0f);
    ASSERT_LT(x, 1.0f);
    sum += x;
    squares += double{x} * x;
  }
  // Five standard errors: 5 * sqrt(1/12) / sqrt(n), and of x^2 5 * sqrt(4/45) / sqrt(n).
  EXPECT_NEAR(sum / kDraws, 0.5, 0.0046);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 0.0047);
}

TEST(Random, DiffersBetweenStreams) {
  Random a(1, 1), b(1, 2);
  EXPECT_NE(a.next(), b.next());
}

}  // namespace
}  // namespace fur
