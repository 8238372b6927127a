#include "core/PortableMath.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/Math.h"
#include "core/Random.h"

namespace fur {
namespace {

TEST(PortableMath, AgreesWithTheCLibraryOnSineAndCosine) {
  Random random(1);
  for (int k = 0; k < 100000; ++k) {
    const float x = k % 2 ? random.uniform(-10, 10) : random.uniform(-1e4f, 1e4f);
    // The documented error.
    ASSERT_NEAR(portableSin(x), std::sin(static_cast<double>(x)), 2e-7) << x;
    ASSERT_NEAR(portableCos(x), std::cos(static_cast<double>(x)), 2e-7) << x;
  }
}

TEST(PortableMath, AgreesWithTheCLibraryOnLogarithmAndExponential) {
  Random random(2);
  for (int k = 0; k < 100000; ++k) {
    const float x = random.uniform(-80, 80);
    const double e = std::exp(static_cast<double>(x));
    ASSERT_NEAR(portableExp(x), e, 1e-6 * e) << x;
    const float y = static_cast<float>(e);
    if (std::fpclassify(y) != FP_NORMAL) continue;
    const double logarithm = std::log(static_cast<double>(y));
    ASSERT_NEAR(portableLog(y), logarithm, 1e-6 * std::abs(logarithm) + 1e-12) << y;
  }
}

TEST(PortableMath, AgreesWithTheCLibraryOnTheArcTangent) {
  Random random(3);
  for (int k = 0; k < 100000; ++k) {
    const float x = k % 3 ? random.uniform(-2, 2) : random.uniform(-1, 1) * portableExp(random.uniform(-80, 80));
    const double angle = std::atan(static_cast<double>(x));
    ASSERT_NEAR(portableAtan(x), angle, 1e-6 * std::abs(angle)) << x;
  }
}

TEST(PortableMath, IsExactWhereItMatters) {
  EXPECT_EQ(portableSin(0.0f), 0.0f);
  EXPECT_EQ(portableExp(0.0f), 1.0f);
  EXPECT_EQ(portableLog(1.0f), 0.0f);
}

TEST(NormalizeOr, GivesTheFallbackForWhatHasNoDirection) {
  const Vec3 up(0, 1, 0);
  EXPECT_EQ(normalizeOr(Vec3(0), up), up);
  EXPECT_EQ(normalizeOr(Vec3(std::nanf("")), up), up);
  EXPECT_EQ(normalizeOr(Vec3(INFINITY, 0, 0), up), up);
  EXPECT_NEAR(glm::length(normalizeOr(Vec3(3, 4, 5), up)), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace fur
