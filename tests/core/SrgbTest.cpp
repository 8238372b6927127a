#include "core/Srgb.h"

#include <gtest/gtest.h>

namespace fur {
namespace {

TEST(LinearColor, KeepsBlackWhiteAndTheMiddleOfTheCurve) {
  EXPECT_EQ(linearColor(0x000000), Vec3(0));
  EXPECT_NEAR(glm::length(linearColor(0xffffff) - Vec3(1)), 0.0f, 1e-6f);
  // sRGB 188 is the byte nearest to half the light.
  EXPECT_NEAR(linearColor(0xbc0000).x, 0.5f, 0.005f);
  EXPECT_EQ(linearColor(0xbc0000).y, 0.0f);
}

TEST(Srgb, ComesBackFromLinearLight) {
  for (int i = 0; i <= 255; ++i) {
    const Vec3 shown(static_cast<float>(i) / 255);
    EXPECT_NEAR(encodeSrgb(decodeSrgb(shown)).x, shown.x, 2e-5f) << i;  // the standard's two branches meet within that
  }
}

}  // namespace
}  // namespace fur
