#include "furgen/Strands.h"

#include <gtest/gtest.h>

#include "furgen/Strand.h"

namespace fur::furgen {
namespace {

FurParameters smallCoat() {
  FurParameters p;
  p.size = 128;
  p.layers = 16;
  return p;
}

// The largest overlap of two strands on any layer, in texels, every pair compared.
float worstOverlap(const std::vector<Strand>& strands, const FurParameters& p) {
  float worst = -1e9f;
  for (int layer = -1; layer < p.layers; ++layer) {
    const float h = layerHeight(layer, p.layers);
    std::vector<Vec3> discs;
    for (const Strand& strand : strands)
      if (const float r = strandRadius(strand, h); r > 0) discs.emplace_back(strand.root + strandShift(strand, h), r);
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const float size = static_cast<float>(p.size);
        const Vec2 apart(torusDelta(discs[i].x, discs[j].x, size), torusDelta(discs[i].y, discs[j].y, size));
        worst = std::max(worst, discs[i].z + discs[j].z - glm::length(apart));
      }
  }
  return worst;
}

TEST(Strands, NeverOverlapOnAnyLayerRoundTheTorus) {
  for (const float curl : {0.0f, 0.3f, 1.0f})
    for (const float thickness : {0.0f, 0.5f, 1.0f})
      for (const float clump : {0.0f, 1.0f}) {
        FurParameters p = smallCoat();
        p.density = 1;
        p.curl = curl;
        p.thickness = thickness;
        p.clump = clump;
        // Single precision of coordinates up to 128.
        EXPECT_LT(worstOverlap(growStrands(p), p), 1e-4f) << curl << ' ' << thickness << ' ' << clump;
      }
}

TEST(Strands, AreAsManyAsTheFormulaAsksForWhileThereIsRoom) {
  FurParameters p;
  p.density = 0.6f;
  p.thickness = 0.4f;
  p.curl = 0;
  // d m (1 - 0.7 t) with m = 1500 (Sheppard Eq. 4.1).
  EXPECT_EQ(wantedStrands(p), 648);
  EXPECT_EQ(growStrands(p).size(), 648u);
  p.size = 512;
  EXPECT_EQ(wantedStrands(p), 4 * 648);
}

TEST(Strands, OfASparseCoatStayInADenserOne) {
  FurParameters p = smallCoat();
  p.density = 0.3f;
  const auto sparse = growStrands(p);
  p.density = 0.8f;
  const auto dense = growStrands(p);
  ASSERT_GT(dense.size(), sparse.size());
  for (std::size_t i = 0; i < sparse.size(); ++i) EXPECT_EQ(sparse[i].root, dense[i].root);
}

TEST(Strands, StandStraightWithoutCurlAndClump) {
  FurParameters p = smallCoat();
  p.curl = 0;
  for (const Strand& strand : growStrands(p)) EXPECT_EQ(strandShift(strand, 0.7f), Vec2(0));
}

TEST(Strands, StartAtTheirRoots) {
  FurParameters p = smallCoat();
  p.curl = p.clump = 1;
  for (const Strand& strand : growStrands(p)) EXPECT_EQ(strandShift(strand, 0.0f), Vec2(0));
}

TEST(Strands, KeepTheirDrawsWithinTheStatedRanges) {
  FurParameters p = smallCoat();
  p.curl = 1;
  p.lengthVariation = 1;
  for (const Strand& strand : growStrands(p)) {
    EXPECT_GE(strand.length, layerHeight(0, p.layers));
    EXPECT_LE(strand.length, 1.0f);
    EXPECT_GE(strand.dominance, 0.5f);
    EXPECT_LE(strand.dominance, 1.0f);
    for (int curve = 0; curve < 2; ++curve)
      for (int axis = 0; axis < 2; ++axis) {
        EXPECT_LE(std::abs(strand.magnitude[curve][axis]), 4.0f * strand.radius);
        EXPECT_LE(strand.phase[curve][axis], 7.0f);
      }
  }
}

TEST(Strands, GatherIntoLocksTowardsTheirTipsWhenClumped) {
  FurParameters p = smallCoat();
  p.curl = 0;
  p.clump = 1;
  const auto strands = growStrands(p);
  double away = 0, awayAtTip = 0;
  for (const Strand& strand : strands) {
    away += glm::length(strand.toLock);
    awayAtTip += glm::length(strand.toLock - strandShift(strand, 1.0f));
  }
  // A lock closes by 0.95 of how much a strand thins, 1 - 0.286 / 0.815.
  EXPECT_NEAR(awayAtTip / away, 1 - 0.95 * (1 - 0.2857 / 0.8148), 0.001);
}

TEST(StrandThinning, FallsFromSkinToTipAndEndsThere) {
  EXPECT_FLOAT_EQ(strandThinning(0.0f), 1.0f - 1.0f / 5.4f);
  EXPECT_NEAR(strandThinning(1.0f), 1.0f - 1.0f / 1.4f, 1e-6f);
  EXPECT_EQ(strandThinning(1.001f), 0.0f);
  for (int i = 1; i <= 100; ++i)
    EXPECT_LT(strandThinning(static_cast<float>(i) / 100), strandThinning(static_cast<float>(i - 1) / 100));
}

TEST(StrandExists, FullyWhereTheTypeIsPresentAndNowhereWhereItIsNot) {
  for (const float dominance : {0.5f, 0.75f, 1.0f}) {
    EXPECT_TRUE(strandExists(1.0f, 1.0f, dominance));
    EXPECT_FALSE(strandExists(0.01f, 0.0f, dominance));
  }
}

TEST(StrandExists, LongerForDominantStrands) {
  EXPECT_TRUE(strandExists(0.9f, 0.6f, 1.0f));    // 2 - 0.8 / 1 = 1.2
  EXPECT_FALSE(strandExists(0.9f, 0.6f, 0.5f));   // 2 - 0.8 / 0.5 = 0.4
  EXPECT_TRUE(strandExists(0.3f, 0.6f, 0.5f));
}

}  // namespace
}  // namespace fur::furgen
