#include "hair/Springs.h"

#include <gtest/gtest.h>

namespace fur::hair {
namespace {

TEST(Springs, AVerletStepOfAFallIsItsParabola) {
  constexpr float kDt = 0.01f;
  Vec3 before(0), p(0, -0.5f * 10 * kDt * kDt, 0);
  for (int step = 1; step < 100; ++step) {
    const Vec3 next = verletStep(p, before, Vec3(0, -10, 0), 1.0f, kDt);
    before = p;
    p = next;
  }
  EXPECT_NEAR(p.y, -5, 1e-3f);
  EXPECT_EQ(verletStep(Vec3(1, 2, 3), Vec3(0), Vec3(0), 0.0f, 1.0f), Vec3(1, 2, 3));  // damping 0 keeps nothing
}

TEST(Springs, SoftenFromRootToTip) {
  for (int a = 1; a <= 3; ++a) {
    EXPECT_FLOAT_EQ(springStiffness(5, 0.25f, 4, a), 5);
    EXPECT_FLOAT_EQ(springStiffness(5, 0.5f, 4, a), 5 / std::pow(2.0f, static_cast<float>(a)));
    EXPECT_TRUE(std::isfinite(springStiffness(5, 0, 4, a)));
  }
}

TEST(Springs, KeepTheirLeastUpsideDown) {
  EXPECT_FLOAT_EQ(tiltStiffness(8, 2, 1), 8);
  EXPECT_FLOAT_EQ(tiltStiffness(8, 2, 0), 5);
  EXPECT_FLOAT_EQ(tiltStiffness(8, 2, -1), 2);
}

}  // namespace
}  // namespace fur::hair
