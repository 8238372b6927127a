#include "hair/VolumeShadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fur::hair {
namespace {

TEST(Transmittance, MultipliesWhereOpacitiesAdd) {
  EXPECT_EQ(transmittance(5, 0), 1.0f);
  EXPECT_NEAR(transmittance(2, 0.3f) * transmittance(2, 0.5f), transmittance(2, 0.8f), 1e-6f);
}

TEST(OpacityLookup, MeetsEachLayerAndRunsStraightBetween) {
  const std::vector<double> layers = {0.0, 0.1, 0.5, 0.9};
  const float dz = 0.25f;
  for (std::size_t i = 0; i < layers.size(); ++i)
    EXPECT_NEAR(opacityLookup(layers, dz * static_cast<float>(i), dz), layers[i], 1e-6);
  EXPECT_NEAR(opacityLookup(layers, 1.5f * dz, dz), 0.3f, 1e-6f);
}

TEST(OpacityLookup, NeverFallsOnTheWayInAndKeepsItsEnds) {
  const std::vector<double> layers = {0.05, 0.1, 0.1, 0.7, 1.3};
  float last = 0;
  for (int i = -20; i <= 100; ++i) {
    const float sigma = opacityLookup(layers, static_cast<float>(i) * 0.01f, 0.1f);
    EXPECT_GE(sigma, last);
    last = sigma;
  }
  EXPECT_NEAR(opacityLookup(layers, -1, 0.1f), 0.05f, 1e-6f);
  EXPECT_NEAR(opacityLookup(layers, 9, 0.1f), 1.3f, 1e-6f);
}

TEST(OpacityLookup, OfNothingIsNothing) {
  const std::vector<double> layers = {0.3, 0.6};
  EXPECT_EQ(opacityLookup({}, 0.5f, 0.1f), 0.0f);
  EXPECT_EQ(opacityLookup(layers, 0.5f, 0), 0.0f);
}

}  // namespace
}  // namespace fur::hair
