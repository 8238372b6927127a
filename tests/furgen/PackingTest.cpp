#include "furgen/Packing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fur::furgen {
namespace {

FurVolume coat(float curl) {
  FurParameters p;
  p.size = 128;
  p.layers = 4;
  p.curl = curl;
  p.density = 0.4f;
  return generateFur(p);
}

std::vector<PackedLevel> levelsOf(const FurVolume& v, int layer) {
  const std::size_t texels = static_cast<std::size_t>(v.size) * v.size, first = texels * static_cast<std::size_t>(layer);
  return packLevels(v.size, v.size, {std::span(v.coverage).subspan(first, texels), std::span(v.dominance).subspan(first, texels),
                                     std::span(v.variance).subspan(first, texels), std::span(v.tangent).subspan(first * 3, texels * 3),
                                     std::span(v.offset).subspan(first * 2, texels * 2)});
}

double meanCover(const PackedLevel& level) {
  double sum = 0;
  for (const std::uint8_t cover : level.coverage) sum += cover;
  return sum / static_cast<double>(level.coverage.size());
}

TEST(PackLevels, HoldsEveryMapAtItsFirstLevel) {
  const FurVolume v = coat(1);
  const auto levels = levelsOf(v, 0);
  const PackedLevel& packed = levels[0];
  for (std::size_t i = 0; i < packed.coverage.size(); i += 97) {
    EXPECT_EQ(packed.coverage[i], v.coverage[i]);
    EXPECT_EQ(packed.strand[i * 4 + 2], v.variance[i]);
    EXPECT_EQ(packed.strand[i * 4 + 3], v.dominance[i]);
    // A byte is 1/255 of the tile, which has 128 texels.
    for (std::size_t k : {0u, 1u}) EXPECT_NEAR((packed.offset[i * 2 + k] / 255.0 - 0.5) * 128, v.offset[i * 2 + k] / 64.0, 0.26);
    // Half a step of 1/255 doubled, the stored tangent being exact to 1/127.
    EXPECT_NEAR(packed.strand[i * 4] / 255.0 * 2 - 1, v.tangent[i * 3] / 127.0, 0.0041);
    EXPECT_NEAR(packed.strand[i * 4 + 1] / 255.0 * 2 - 1, v.tangent[i * 3 + 1] / 127.0, 0.0041);
  }
}

TEST(PackLevels, GoesDownToOneTexelAlsoWhereOneSideIsShorter) {
  const FurVolume v = coat(0);
  const auto levels = packLevels(v.size, v.finRows, {v.finCoverage, v.finDominance, v.finVariance, v.finTangent, {}});
  ASSERT_EQ(levels.size(), 8u);
  EXPECT_EQ(levels[6].width, 2);
  EXPECT_EQ(levels[6].height, 1);
  EXPECT_EQ(levels[7].strand.size(), 4u);
}

TEST(PackLevels, KeepsTheCoverageAtEveryLevel) {
  for (const float curl : {0.0f, 1.0f})
    for (int layer = 0; layer < 4; ++layer) {
      const auto levels = levelsOf(coat(curl), layer);
      // 2 % of full coverage; a byte rounds by half a step, and the first byte of a faint layer is a step of many percent.
      for (const PackedLevel& level : levels) EXPECT_NEAR(meanCover(level), meanCover(levels[0]), 0.5 + 1e-6) << level.width;
      for (const PackedLevel& level : levels) EXPECT_LT(std::abs(meanCover(level) - meanCover(levels[0])) / 255, 0.02);
    }
}

TEST(PackLevels, OfCoverageAloneHoldsTheSameCoverageAndNothingElse) {
  const FurVolume v = coat(1);
  const auto whole = levelsOf(v, 1), alone = packLevels(v.size, v.size, {std::span(v.coverage).subspan(v.coverage.size() / 4, v.coverage.size() / 4), {}, {}, {}, {}});
  ASSERT_EQ(alone.size(), whole.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].coverage, whole[i].coverage);
    EXPECT_TRUE(alone[i].strand.empty() && alone[i].offset.empty());
  }
}

TEST(CoatShape, TwoLayersShareTheStrandsOfTheLowerOneUnlessTheyCoil) {
  CoatShape shape{.layers = 5, .sharesStrands = true};
  EXPECT_EQ(shape.strandLayers(), 3);
  EXPECT_TRUE(shape.hasStrands(2) && !shape.hasStrands(3) && shape.strandLayer(2) == 1 && shape.strandLayer(3) == 1);
  shape.sharesStrands = false;
  EXPECT_EQ(shape.strandLayers(), 5);
  EXPECT_TRUE(shape.hasStrands(3) && shape.strandLayer(3) == 3);
  FurParameters coils;
  EXPECT_TRUE(sharesStrands(coils));
  coils.coil = 0.3f;
  EXPECT_FALSE(sharesStrands(coils));
}

TEST(PackLevels, AStrandThatALayerHasStandsInTheOneBelowIt) {
  const FurVolume v = coat(0);
  const std::size_t texels = static_cast<std::size_t>(v.size) * v.size;
  int covered = 0, others = 0;
  for (std::size_t i = 0; i < texels; ++i)
    if (v.coverage[texels + i] > 128) ++covered, others += v.variance[texels + i] != v.variance[i];
  ASSERT_GT(covered, 1000);
  EXPECT_LT(others, covered / 20);  // where strands lean over one another
}

TEST(PackLevels, AveragesVarianceOverTheStrandsAndNotOverTheGapsBetweenThem) {
  // A quarter of the texels is covered and bright; the nearest-strand fill of the rest counts for next to nothing.
  const std::vector<std::uint8_t> coverage{255, 0, 0, 0}, variance{200, 10, 10, 10};
  const std::vector<std::int8_t> tangent{0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127};
  const auto levels = packLevels(2, 2, {coverage, coverage, variance, tangent, {}});
  EXPECT_EQ(levels[1].coverage[0], 64);
  EXPECT_NEAR(levels[1].strand[2], 200, 3);  // three texels of weight 1 beside one of 256
}

TEST(PackLevels, MakesMeanTangentsUnitAgain) {
  // Two strands that lean apart by 90 degrees stand for one that leans 45 to neither side.
  const std::vector<std::uint8_t> coverage{255, 255}, variance{0, 0};
  const std::vector<std::int8_t> tangent{90, 0, 90, 0, 90, 90};
  const auto levels = packLevels(2, 1, {coverage, coverage, variance, tangent, {}});
  const double x = levels[1].strand[0] / 255.0 * 2 - 1, y = levels[1].strand[1] / 255.0 * 2 - 1;
  // (1, 1, 2) / sqrt 6, to a step of a byte.
  EXPECT_NEAR(x, 1 / std::sqrt(6.0), 0.005);
  EXPECT_NEAR(y, 1 / std::sqrt(6.0), 0.005);
}

}  // namespace
}  // namespace fur::furgen
