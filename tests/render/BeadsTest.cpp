// The strands that may hold a bead of water.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/Primitives.h"
#include "geometry/Surface.h"
#include "render/passes/bead/BeadPass.h"

namespace fur::render {
namespace {

TEST(Beads, HangOnStrandsThatRootOnTheSurfaceAndStandUprightThere) {
  const geometry::Surface sphere = geometry::buildSurface(geometry::makeSphere()).value();
  const std::vector<groom::WhiskerHair> strands = strandsForBeads(sphere);
  ASSERT_FALSE(strands.empty());
  for (const groom::WhiskerHair& strand : strands) {
    // Within the sag of the sphere's triangles.
    EXPECT_NEAR(glm::length(strand.root), 1, 0.02f);
    EXPECT_GT(glm::dot(strand.direction, glm::normalize(strand.root)), 0.99f);
    EXPECT_NEAR(strand.weights.x + strand.weights.y + strand.weights.z, 1, 1e-5f);
    EXPECT_TRUE(strand.shade >= 0 && strand.shade < 1 && strand.atlasU >= 0 && strand.atlasU <= 1 && strand.atlasV >= 0 && strand.atlasV <= 1);
  }
}

TEST(Beads, AreSpreadByArea) {
  const geometry::Surface sphere = geometry::buildSurface(geometry::makeSphere()).value();
  const std::vector<groom::WhiskerHair> strands = strandsForBeads(sphere);
  // Bands of a sphere that are as high have the same area.
  constexpr int kBands = 8;
  std::vector<int> bands(kBands, 0);
  for (const groom::WhiskerHair& strand : strands) ++bands[static_cast<std::size_t>(glm::clamp((strand.root.y + 1) * 0.5f * kBands, 0.0f, kBands - 1.0f))];
  // Four standard deviations of a count by chance alone.
  const auto even = static_cast<float>(strands.size()) / kBands;
  for (const int count : bands) EXPECT_NEAR(static_cast<float>(count), even, 4 * std::sqrt(even));
}

TEST(Beads, AreTheSameEachTime) {
  const geometry::Surface sphere = geometry::buildSurface(geometry::makeSphere()).value();
  const auto one = strandsForBeads(sphere), two = strandsForBeads(sphere);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_TRUE(one[i].root == two[i].root && one[i].shade == two[i].shade);
}

}  // namespace
}  // namespace fur::render
