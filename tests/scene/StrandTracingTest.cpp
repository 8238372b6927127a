#include "scene/StrandTracing.h"

#include <gtest/gtest.h>

namespace fur::scene {
namespace {

constexpr int kSide = 32, kLayers = 6;

// A stack to draw strands into.
struct Stack {
  std::vector<std::uint8_t> coverage = std::vector<std::uint8_t>(kSide * kSide * kLayers), variance = coverage,
                            dominance = coverage;

  // A square of 3 x 3 texels about (x, y).
  void draw(int layer, int x, int y, std::uint8_t value) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int texel = (layer * kSide + ((y + dy) & (kSide - 1))) * kSide + ((x + dx) & (kSide - 1));
        coverage[static_cast<std::size_t>(texel)] = 255;
        variance[static_cast<std::size_t>(texel)] = value;
      }
  }
  StrandTrace trace() const { return traceStrands({kSide, kSide, kLayers, 4.0f, 1.0f, coverage, variance, dominance}); }
};

TEST(StrandTracing, FollowsALeaningStrandRoundTheTile) {
  Stack stack;
  for (int layer = 0; layer < kLayers; ++layer) stack.draw(layer, 24 + 3 * layer, 31, 7);
  const StrandTrace trace = stack.trace();
  ASSERT_EQ(trace.strandCount, 1);
  ASSERT_EQ(trace.cuts.size(), std::size_t{kLayers});
  for (int layer = 0; layer < kLayers; ++layer) {
    const StrandCut& cut = trace.cuts[static_cast<std::size_t>(layer)];
    EXPECT_EQ(cut.slope, Vec2(3, 0));
    EXPECT_EQ(cut.shift, Vec2(3.0f * static_cast<float>(layer + 1), 0));  // the root is a layer below the first
    EXPECT_EQ(cut.axis, Vec2((24 + 3 * layer) % kSide + 0.5f, 31.5f));
  }
}

TEST(StrandTracing, KeepsTwinsApartThatStandApart) {
  Stack stack;
  for (int layer = 0; layer < kLayers; ++layer) stack.draw(layer, 8, 8, 7), stack.draw(layer, 20, 8, 7);
  const StrandTrace trace = stack.trace();
  EXPECT_EQ(trace.strandCount, 2);
  for (std::size_t i = 0; i < trace.cuts.size(); ++i) EXPECT_EQ(trace.cuts[i].strand, 1 + i % 2);
}

TEST(StrandTracing, KeepsNeighboursApartWhoseValuesDiffer) {
  Stack stack;
  for (int layer = 0; layer < kLayers; ++layer) stack.draw(layer, 8, 8, 7), stack.draw(layer, 11, 8, 8);
  EXPECT_EQ(stack.trace().strandCount, 2);
}

TEST(StrandTracing, BridgesALayerInWhichAStrandIsHidden) {
  Stack stack;
  for (const int layer : {0, 1, 3, 4}) stack.draw(layer, 8 + 2 * layer, 8, 7);
  const StrandTrace trace = stack.trace();
  EXPECT_EQ(trace.strandCount, 1);
  for (const StrandCut& cut : trace.cuts) EXPECT_EQ(cut.slope, Vec2(2, 0));
}

TEST(StrandTracing, TakesBothArmsOfALoopForTheirStrand) {
  Stack stack;
  stack.draw(0, 8, 8, 7);
  stack.draw(1, 8, 8, 7);
  stack.draw(2, 6, 8, 7), stack.draw(2, 11, 8, 7);
  stack.draw(3, 8, 8, 7);
  const StrandTrace trace = stack.trace();
  EXPECT_EQ(trace.strandCount, 1);
  EXPECT_EQ(trace.cuts.size(), 5u);
}

TEST(StrandTracing, RootsAStrandThatBeginsInTheAirBelowItsBeginning) {
  Stack stack;
  for (int layer = 3; layer < kLayers; ++layer) stack.draw(layer, 8 + 2 * layer, 8, 7);
  EXPECT_EQ(stack.trace().cuts[0].shift, Vec2(0));
}

TEST(StrandTracing, FindsNothingInEmptyMaps) {
  const StrandTrace trace = Stack().trace();
  EXPECT_EQ(trace.strandCount, 0);
  EXPECT_TRUE(trace.cuts.empty());
}

}  // namespace
}  // namespace fur::scene
