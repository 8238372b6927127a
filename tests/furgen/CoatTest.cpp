#include "furgen/Coat.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "furgen/Strand.h"

namespace fur::furgen {
namespace {

FurParameters smallCoat() {
  FurParameters p;
  p.size = 128;
  return p;
}

// Coats that between them use everything that bends a strand.
std::vector<FurParameters> variedCoats() {
  std::vector<FurParameters> coats;
  for (const float thickness : {0.0f, 1.0f}) {
    FurParameters p = smallCoat();
    p.density = 1;
    p.thickness = thickness;
    p.curl = 1;
    coats.push_back(p);
    p.curl = 0.2f;
    p.undercoat = 1;
    p.frizz = 0.6f;
    coats.push_back(p);
    p.clump = p.roll = p.wave = p.tipBreak = 1;
    p.taper = 0.9f;
    coats.push_back(p);
    p = smallCoat();
    p.density = 1;
    p.thickness = thickness;
    p.coil = 0.7f;
    p.clump = 0.6f;
    coats.push_back(p);
  }
  return coats;
}

struct Disc {
  Vec2 at;
  float radius;
  std::size_t strand;
};

// Where the strands pass a height.
std::vector<Disc> discsAt(const Coat& coat, float h) {
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < coat.strands.size(); ++i) {
    const auto nodes = coat.nodesOf(coat.strands[i]);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      const float low = std::min(nodes[k].height, nodes[k + 1].height), high = std::max(nodes[k].height, nodes[k + 1].height);
      if (h < low || h > high || low == high) continue;
      const float t = (h - nodes[k].height) / (nodes[k + 1].height - nodes[k].height);
      discs.push_back({coat.strands[i].root + nodes[k].shift + (nodes[k + 1].shift - nodes[k].shift) * t,
                       nodes[k].radius + (nodes[k + 1].radius - nodes[k].radius) * t, i});
    }
  }
  return discs;
}

// The largest overlap of two strands at that height, in texels, every pair compared.
float worstOverlap(const Coat& coat, float h) {
  const float size = static_cast<float>(coat.parameters.size);
  const auto discs = discsAt(coat, h);
  float worst = -1e9f;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (discs[i].strand == discs[j].strand) continue;
      const Vec2 apart(torusDelta(discs[i].at.x, discs[j].at.x, size), torusDelta(discs[i].at.y, discs[j].at.y, size));
      worst = std::max(worst, discs[i].radius + discs[j].radius - glm::length(apart));
    }
  return worst;
}

void expectSame(const Coat& a, const Coat& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) ASSERT_EQ(a.nodes[i].shift, b.nodes[i].shift);
}

TEST(Coat, HasNoTwoStrandsThatOverlapAtAnyHeightRoundTheTorus) {
  int coatIndex = 0;
  for (const FurParameters& p : variedCoats()) {
    const Coat coat = growCoat(p);
    // Heights on planes, between planes, and odd ones.
    for (const float h : {0.0f, 0.0313f, 0.1f, 0.25f, 0.333f, 0.5f, 0.515625f, 0.77f, 0.9f, 0.99f})
      // Single precision of coordinates up to 128, through a division by a piece's height.
      EXPECT_LT(worstOverlap(coat, h), 2e-4f) << "coat " << coatIndex << " at " << h;
    ++coatIndex;
  }
}

TEST(Coat, HasAsManyStrandsAsTheFormulaAsksForWhileThereIsRoom) {
  FurParameters p;
  p.density = 0.6f;
  p.thickness = 0.4f;
  p.curl = 0;
  // d m (1 - 0.7 t) with m = 1500 (Sheppard Eq. 4.1).
  EXPECT_EQ(wantedStrands(p), 648);
  EXPECT_EQ(growCoat(p).strands.size(), 648u);
  p.size = 512;
  EXPECT_EQ(wantedStrands(p), 4 * 648);
  p.size = 256;
  p.undercoat = 1;
  EXPECT_EQ(wantedUndercoat(p), 972);
}

TEST(Coat, KeepsRoomEvenForItsWildestStrands) {
  // Curls that fold back take up more of the volume each, so fewer find room; a coat must be left.
  for (const FurParameters& p : variedCoats()) EXPECT_GT(growCoat(p).strands.size(), 20u);
}

TEST(Coat, KeepsTheStrandsOfASparseCoatInADenserOne) {
  FurParameters p = smallCoat();
  p.density = 0.3f;
  const Coat sparse = growCoat(p);
  p.density = 0.8f;
  const Coat dense = growCoat(p);
  ASSERT_GT(dense.strands.size(), sparse.strands.size());
  for (std::size_t i = 0; i < sparse.strands.size(); ++i) EXPECT_EQ(sparse.strands[i].root, dense.strands[i].root);
}

TEST(Coat, IsTheSameHoweverItsGrowthIsSliced) {
  for (const FurParameters& p : variedCoats()) {
    const Coat whole = growCoat(p);
    CoatGrower grower(p);
    float last = 0;
    while (!grower.step(7)) {
      EXPECT_GE(grower.progress(), last);
      last = grower.progress();
    }
    expectSame(whole, grower.take());
  }
}

TEST(Coat, DoesNotDependOnTheLayersThatItIsCutInto) {
  FurParameters p = smallCoat();
  p.layers = 8;
  const Coat few = growCoat(p);
  p.layers = 128;
  expectSame(few, growCoat(p));
}

TEST(Coat, StandsStraightWithoutAnythingThatBendsIt) {
  FurParameters p = smallCoat();
  p.curl = 0;
  for (const Node& node : growCoat(p).nodes) EXPECT_EQ(node.shift, Vec2(0));
}

TEST(Coat, HasStrandsThatStartAtTheirRootsAndStayInTheVolume) {
  for (const FurParameters& p : variedCoats()) {
    const Coat coat = growCoat(p);
    for (const Strand& strand : coat.strands) {
      const auto nodes = coat.nodesOf(strand);
      ASSERT_GE(nodes.size(), 2u);
      EXPECT_EQ(nodes[0].shift, Vec2(0));
      EXPECT_EQ(nodes[0].height, 0.0f);
      float highest = 0;
      for (const Node& node : nodes) {
        ASSERT_GE(node.height, 0.0f);
        ASSERT_LE(node.height, 1.0f);
        ASSERT_GE(node.radius, 0.0f);
        highest = std::max(highest, node.height);
      }
      EXPECT_EQ(highest, strand.length);
    }
  }
}

TEST(Coat, HasNoPieceThatCrossesAPlane) {
  for (const FurParameters& p : variedCoats()) {
    const Coat coat = growCoat(p);
    for (const Strand& strand : coat.strands) {
      const auto nodes = coat.nodesOf(strand);
      for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const float low = std::min(nodes[k].height, nodes[k + 1].height) * kPlanes;
        const float high = std::max(nodes[k].height, nodes[k + 1].height) * kPlanes;
        // The node on a plane is where single precision puts it.
        EXPECT_LE(high, std::floor(low + 1e-4f) + 1.0001f);
      }
    }
  }
}

TEST(Coat, FoldsBackOnItselfOnceItIsCoiled) {
  const auto falls = [](float coil) {
    FurParameters p = smallCoat();
    p.coil = coil;
    const Coat coat = growCoat(p);
    int count = 0;
    for (std::size_t i = 0; i + 1 < coat.strands.size(); ++i) {
      const auto nodes = coat.nodesOf(coat.strands[i]);
      for (std::size_t k = 0; k + 1 < nodes.size(); ++k) count += nodes[k + 1].height < nodes[k].height;
    }
    return count;
  };
  EXPECT_EQ(falls(0.2f), 0);
  EXPECT_GT(falls(0.5f), 100);
}

TEST(Coat, GathersIntoLocksTowardsTheTips) {
  // Neighbours at the skin come nearer at the tip when they belong to one lock: the mean distance of the
  // nearest neighbour falls below that of straight strands, which keep theirs.
  const auto nearest = [](float clump, float h) {
    FurParameters p = smallCoat();
    p.curl = p.lengthVariation = p.stray = 0;
    p.clump = clump;
    const auto discs = discsAt(growCoat(p), h);
    double sum = 0;
    for (const Disc& a : discs) {
      float best = 1e9f;
      for (const Disc& b : discs)
        if (a.strand != b.strand) best = std::min(best, glm::length(Vec2(torusDelta(a.at.x, b.at.x, 128), torusDelta(a.at.y, b.at.y, 128))));
      sum += best;
    }
    return sum / static_cast<double>(discs.size());
  };
  EXPECT_NEAR(nearest(0, 0.9f) / nearest(0, 0.1f), 1, 1e-5);
  EXPECT_LT(nearest(1, 0.9f) / nearest(1, 0.1f), 0.6);
}

TEST(Coat, LeavesTheShareOfStraysOutOfItsLocks) {
  FurParameters p = smallCoat();
  p.curl = 0;
  p.clump = 1;
  for (const float stray : {0.0f, 0.5f, 1.0f}) {
    p.stray = stray;
    const Coat coat = growCoat(p);
    int straight = 0;
    for (const Strand& strand : coat.strands) straight += coat.nodesOf(strand).back().shift == Vec2(0);
    // Some 300 draws: two standard deviations, and strays stand in the way of locks that close round them.
    EXPECT_NEAR(static_cast<float>(straight) / static_cast<float>(coat.strands.size()), stray, 0.12f);
  }
}

TEST(Coat, HasAFinerShorterUndercoatBesideTheSameGuardHairs) {
  FurParameters p = smallCoat();
  const Coat plain = growCoat(p);
  p.undercoat = 1;
  const Coat both = growCoat(p);
  ASSERT_GT(both.strands.size(), plain.strands.size() * 3 / 2);
  for (std::size_t i = 0; i < plain.strands.size(); ++i) ASSERT_EQ(plain.strands[i].root, both.strands[i].root);
  float guard = 0, under = 0;
  for (std::size_t i = 0; i < both.strands.size(); ++i) {
    const Strand& strand = both.strands[i];
    (i < plain.strands.size() ? guard : under) = std::max(i < plain.strands.size() ? guard : under, both.nodesOf(strand)[0].radius);
    if (i >= plain.strands.size()) EXPECT_LE(strand.length, p.undercoatLength + 1e-6f);
  }
  EXPECT_LT(under, 0.6f * guard);
}

TEST(StrandThinning, NeverWidensAndKeepsSheppardsLawInTheMiddle) {
  for (float taper = 0; taper <= 1; taper += 0.125f)
    for (float s = 0.02f; s <= 1; s += 0.02f) EXPECT_LE(strandThinning(s, taper), strandThinning(s - 0.02f, taper) + 1e-6f);
  EXPECT_FLOAT_EQ(strandThinning(0.4f, 0.5f), strandThinning(0.4f));
  EXPECT_FLOAT_EQ(strandThinning(1, 0), strandThinning(0));
  EXPECT_NEAR(strandThinning(1, 1), 0, 1e-6f);
  EXPECT_EQ(strandThinning(1.01f, 0.3f), 0.0f);
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
