#include "wet/Drying.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fur::wet {
namespace {

TEST(Drying, OfALongTimeIsThatOfManyShortSteps) {
  for (const float wetness : {0.3f, 0.7f, 1.0f})
    for (const float drying : {1e-6f, 0.01f, 0.06f, 0.2f}) {
      double left = wetness;
      for (int i = 0; i < 100000; ++i) left -= 1e-5 * drying * (1.4 - 0.8 * left);
      EXPECT_NEAR(wetness - dryingLoss(wetness, longDrying(drying)), left, 1e-6) << wetness << ' ' << drying;
    }
}

TEST(Drying, OfHalfWetFurIsTheRate) { EXPECT_FLOAT_EQ(dryingLoss(0.5f, 0.01f), 0.01f); }

// web/page.js says how long soaked fur takes.
TEST(Drying, OfSoakedFurTakes106TimesWhatTheRateSays) {
  EXPECT_LT(dryingLoss(1.0f, longDrying(1.05f)), 1.0f);
  EXPECT_GT(dryingLoss(1.0f, longDrying(1.06f)), 1.0f);
}

TEST(Drying, OfAnyTimeIsANumberAndGrows) {
  float last = 0;
  for (const float drying : {1e-20f, 0.049f, 0.051f, 1.0f, 30.0f, 64.0f}) {
    EXPECT_GT(longDrying(drying), last);
    last = longDrying(drying);
  }
  EXPECT_TRUE(std::isfinite(longDrying(std::numeric_limits<float>::infinity())));
  EXPECT_FALSE(longDrying(std::nanf("")) > 0.0f);
  EXPECT_LE(longDrying(-1.0f), 0.0f);
}

}  // namespace
}  // namespace fur::wet
