#include "scene/StrandTracing.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/Random.h"
#include "furgen/Coat.h"

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

// Maps as large as those of a type set, of as many layers as are needed.
struct Tile {
  static constexpr int kSide = 128;
  int layers;
  std::vector<std::uint8_t> coverage, variance, dominance;

  // `value` of (layer, x, y); below 0: nothing is there.
  Tile(int count, const std::function<int(int, int, int)>& value) : layers(count) {
    for (int i = 0; i < layers * kSide * kSide; ++i) {
      const int v = value(i / (kSide * kSide), i % kSide, i / kSide % kSide);
      coverage.push_back(v < 0 ? 0 : 255);
      variance.push_back(static_cast<std::uint8_t>(v < 0 ? 0 : v));
    }
    dominance.resize(coverage.size());
  }
  MapStack maps() const { return {kSide, kSide, layers, 17.0f, 0.75f, coverage, variance, dominance}; }
  StrandTrace trace() const { return traceStrands(maps()); }
};

// The strand of every cut, found by looking at every cut below it.
std::vector<std::uint32_t> strandsByLookingAtAll(const MapStack& maps, const StrandTrace& trace) {
  std::vector<int> layerOf(trace.cuts.size()), valueOf(trace.cuts.size());
  for (std::size_t i = 0; i < trace.cutOf.size(); ++i) {
    if (trace.cutOf[i] == 0) continue;
    layerOf[trace.cutOf[i] - 1] = static_cast<int>(i / static_cast<std::size_t>(maps.width * maps.height));
    valueOf[trace.cutOf[i] - 1] = maps.variance[i] * 256 + maps.dominance[i];
  }
  std::vector<std::uint32_t> strand(trace.cuts.size());
  std::vector<int> goesOnIn(trace.cuts.size(), maps.layers);
  std::uint32_t strands = 0;
  for (std::size_t cut = 0; cut < trace.cuts.size(); ++cut) {
    float least = 1e30f;
    std::size_t parent = cut;
    for (std::size_t tip = 0; layerOf[tip] < layerOf[cut]; ++tip) {
      const int steps = layerOf[cut] - layerOf[tip];
      if (valueOf[tip] != valueOf[cut] || steps > 2 || goesOnIn[tip] < layerOf[cut]) continue;
      const Vec2 from = trace.cuts[tip].axis, to = trace.cuts[cut].axis;
      const float distance = glm::length(Vec2(furgen::torusDelta(to.x, from.x, static_cast<float>(maps.width)),
                                              furgen::torusDelta(to.y, from.y, static_cast<float>(maps.height))));
      const float cost = distance + maps.reach * static_cast<float>(steps - 1);
      if (distance <= maps.reach * static_cast<float>(steps) && cost < least) least = cost, parent = tip;
    }
    strand[cut] = parent == cut ? ++strands : strand[parent];
    if (parent != cut) goesOnIn[parent] = std::min(goesOnIn[parent], layerOf[cut]);
  }
  return strand;
}

void expectTheNearest(const MapStack& maps) {
  const StrandTrace trace = traceStrands(maps);
  const std::vector<std::uint32_t> expected = strandsByLookingAtAll(maps, trace);
  ASSERT_GT(trace.cuts.size(), 1000u);
  for (std::size_t cut = 0; cut < expected.size(); ++cut) ASSERT_EQ(trace.cuts[cut].strand, expected[cut]) << cut;
}

TEST(StrandTracing, GoesOnFromTheNearestCutOfItsKind) {
  Random random(5);
  const Tile sparse(5, [&](int, int, int) { return random.next() % 64 ? -1 : static_cast<int>(random.next() % 4); });
  expectTheNearest(sparse.maps());
  for (const float curl : {0.0f, 0.25f, 1.0f}) {
    furgen::FurParameters p;
    p.size = 128;
    p.curl = curl;
    const furgen::FurVolume v = furgen::generateFur(p);
    expectTheNearest({v.size, v.size, v.layers, 17.0f, 0.75f, v.coverage, v.variance, v.dominance});
  }
}

TEST(StrandTracing, WeighsAFewTipsACutHoweverManyAreAlike) {
  Random random(2);
  const auto nine = [](int x, int y) { return y % 3 * 3 + x % 3; };
  const std::pair<const char*, Tile> tiles[] = {
      {"dots that are never above one another", {3, [](int l, int x, int y) { return x % 3 == l % 2 && y % 3 == l % 3 ? 0 : -1; }}},
      {"every texel a cut of its own, in nine values", {3, [&](int l, int x, int y) { return nine(x, y + l); }}},
      {"the same in stripes that change places", {3, [&](int l, int x, int y) { return nine(x, y) + ((y / 16 + l) % 2 ? 9 : 0); }}},
      {"the same in columns", {3, [&](int l, int x, int y) { return nine(x, y) + ((x / 16 + l) % 2 ? 9 : 0); }}},
      {"the same two layers below", {4, [&](int l, int x, int y) { return nine(x, y) + (y / 32 + l) % 4 * 9; }}},
      {"noise", {3, [&](int, int, int) { return static_cast<int>(random.next() % 64); }}}};
  for (const auto& [what, tile] : tiles) {
    const StrandTrace trace = tile.trace();
    EXPECT_GT(trace.cuts.size(), 5'000u) << what;
    // All that are within reach would be hundreds.
    EXPECT_LT(trace.tipsWeighed, 100 * trace.cuts.size()) << what;
  }
}

}  // namespace
}  // namespace fur::scene
