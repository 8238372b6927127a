#include "wet/Clump.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/Random.h"

namespace fur::wet {
namespace {

TEST(ClumpProfile, StartsAtTheSkinsShareAndEndsAtOne) {
  for (const float layers : {2.0f, 3.0f, 16.0f, 64.0f})
    for (const float w : {0.0f, 0.3f, 1.0f}) {
      EXPECT_NEAR(clumpProfile(1.0f / layers, w, layers), (1 - w) / layers, 1e-6f);
      EXPECT_NEAR(clumpProfile(1.0f, w, layers), 1.0f, 1e-6f);
    }
}

TEST(ClumpProfile, RisesWithHeight) {
  for (const float w : {0.0f, 0.3f, 1.0f})
    for (int i = 1; i <= 200; ++i)
      EXPECT_GE(clumpProfile(i / 200.0f, w, 16), clumpProfile((i - 1) / 200.0f, w, 16));
}

TEST(ClumpProfile, BendsInEarlierWithMoreShape) {
  for (const float h : {0.2f, 0.5f, 0.8f}) EXPECT_GT(clumpProfile(h, 1, 16), clumpProfile(h, 0, 16));
}

TEST(BeadSize, IsNothingOnDryAndOnSoakedStrands) {
  for (const float chance : {0.0f, 0.3f, 0.9f}) {
    EXPECT_EQ(beadSize(0, chance), 0);
    EXPECT_EQ(beadSize(0.5f, chance), 0);
    EXPECT_EQ(beadSize(1.5f, chance), 0);
  }
}

TEST(BeadSize, GrowsWithWaterAndStaysUntilBeadsRun) {
  for (const float chance : {0.0f, 0.3f, 0.6f})
    for (int i = 1; i <= 30; ++i) {
      const float rho = 0.01f * static_cast<float>(i), change = beadSize(rho, chance) - beadSize(rho - 0.01f, chance);
      EXPECT_GE(change, 0) << rho;
      EXPECT_LT(change, 0.5f) << rho << ": it does not appear at once";
    }
  EXPECT_GT(beadSize(0.2f, 0.3f), 0);
}

TEST(BeadSize, OfThoseThatAreLeftIsLargerByWhatOthersHeldAndNoneComesAgain) {
  const float alone = beadSize(0.3f, 0), late = beadSize(0.45f, 0.01f);
  EXPECT_GT(beadSize(0.4f, 0), 1.2f * alone) << "two in one";
  EXPECT_LT(late, 1.6f * alone);
  for (const float chance : {0.1f, 0.4f, 0.8f}) {
    bool gone = false;
    for (float rho = 0.3f; rho < 0.6f; rho += 0.01f) {
      const float size = beadSize(rho, chance);
      EXPECT_FALSE(gone && size > 0) << rho;
      gone = gone || size == 0;
    }
    EXPECT_TRUE(gone);
  }
  // All together never hold more than they did.
  const auto total = [](float rho) {
    double sum = 0;
    for (int k = 0; k < 1000; ++k) sum += std::pow(beadSize(rho, (static_cast<float>(k) + 0.5f) / 1000), 3.0);
    return sum;
  };
  for (float rho = 0.31f; rho < 0.5f; rho += 0.01f) EXPECT_LE(total(rho), 1.01 * total(0.3f)) << rho;
}

TEST(BeadRun, StandsStillWhileWaterIsLittleAndReachesTheRootAsTheBeadEnds) {
  for (const float chance : {0.0f, 0.3f, 0.9f})
    for (float rho = 0; rho <= 0.3f; rho += 0.05f) EXPECT_EQ(beadRun(rho, chance), 0) << rho;
  for (const float chance : {0.1f, 0.4f, 0.7f})
    for (float rho = 0.3f; rho < 0.5f; rho += 0.005f) {
      if (beadSize(rho, chance) == 0 && beadsLeft(rho) < 0.75f) EXPECT_EQ(beadRun(rho, chance), 1) << rho;
      EXPECT_GE(beadRun(rho + 0.005f, chance), beadRun(rho, chance)) << rho << ": it does not run up again";
    }
}

TEST(NearSheet, KeepsTheClumpsOfASheetThatIsSeenNearAndThoseOfShortFurNot) {
  EXPECT_EQ(nearSheet(0, 0), 0);
  for (const float shortness : {0.0f, 0.5f}) {
    EXPECT_LT(nearSheet(1, shortness), nearSheet(1, shortness + 0.5f));
    EXPECT_GT(clumpPull(1, 0.5f, 16, 1, nearSheet(1, shortness)), 0);
  }
  EXPECT_EQ(clumpPull(1, 0.5f, 16, 1, nearSheet(1, 1)), 0) << "a whole sheet draws nothing together";
}

TEST(ClumpsClosed, ShortFurHasNoneAndLongFurHasThoseThatItsSheetLeaves) {
  for (const float rho : {0.0f, 0.1f, 0.5f, 1.0f}) EXPECT_EQ(clumpsClosed(rho, sheetOf(rho, 0), 0), sheetOf(rho, 0)) << rho;
  for (const float rho : {0.05f, 0.1f, 0.5f, 1.0f}) EXPECT_EQ(clumpsClosed(rho, sheetOf(rho, 1), 1), 1) << rho;
  EXPECT_EQ(clumpsClosed(0, 0, 1), 0) << "dry fur is as it was";
}

TEST(LiesBy, OfShortFurKnowsNoClump) {
  EXPECT_EQ(liesBy(-0.4f, 0.3f, 1), liesBy(0.4f, 0.3f, 1));
  EXPECT_NE(liesBy(-0.4f, 0.3f, 0), liesBy(0.4f, 0.3f, 0));
}

TEST(LiesBy, TurnsAsManyStrandsUpAsDown) {
  Random random(3);
  double sum = 0;
  constexpr int kStrands = 20000;
  for (int k = 0; k < kStrands; ++k) {
    const float slope = liesBy(chanceOfClump({random.uniform(), random.uniform()}), random.uniform(), random.uniform());
    EXPECT_LE(std::abs(slope), 0.4f);
    sum += slope;
  }
  EXPECT_NEAR(sum / kStrands, 0, 0.01);
}

TEST(ClumpingWetness, OfHalfWetFurIsMoreThanItsWaterAndOfSoakedFurNoMore) {
  for (const float chance : {-0.5f, 0.0f, 0.5f}) {
    EXPECT_EQ(clumpingWetness(0, 0.1f, chance), 0);
    for (const float rho : {0.82f, 0.9f, 1.0f}) EXPECT_FLOAT_EQ(clumpingWetness(rho, 0.1f, chance), rho);
    EXPECT_FLOAT_EQ(clumpingWetness(3, 0.1f, chance), 1);
    for (float rho = 0.66f; rho < 0.8f; rho += 0.02f) EXPECT_GT(clumpingWetness(rho, 0.1f, chance), rho) << "all have formed";
  }
}

TEST(ClumpingWetness, OfMoreWaterNeverOpensAClump) {
  for (float chance = -0.5f; chance <= 0.5f; chance += 0.1f)
    for (float rho = 0; rho < 1; rho += 0.01f) EXPECT_GE(clumpingWetness(rho + 0.01f, 0.1f, chance), clumpingWetness(rho, 0.1f, chance)) << rho;
}

TEST(ClumpingWetness, ComesToOneClumpAfterTheOther) {
  const float rho = 0.25f;
  EXPECT_GT(clumpingWetness(rho, 0.1f, -0.5f), rho);
  EXPECT_EQ(clumpingWetness(rho, 0.1f, 0.5f), 0);
  for (float chance = -0.4f; chance <= 0.5f; chance += 0.1f) EXPECT_LE(clumpingWetness(rho, 0.1f, chance), clumpingWetness(rho, 0.1f, chance - 0.1f)) << chance;
}

TEST(ClumpingWetness, DrawsNoStrandAsideByMoreThanItsLengthAllows) {
  for (float radius = 0.1f; radius < 5; radius += 0.1f)
    for (const float rho : {0.2f, 0.6f, 1.0f, 2.0f}) EXPECT_LE(clumpingWetness(rho, radius, -0.5f) * radius, kMaxDisplacement * 1.001f) << radius;
}

TEST(LockPull, SplitsClumpsAtTheirTipsAndNeitherTheirFeetNorASheet) {
  EXPECT_EQ(lockPull(0, 1, 0), 0);
  EXPECT_EQ(lockPull(1, 1, 1), 0);
  EXPECT_EQ(lockPull(1, 0, 0), 0);
  EXPECT_LT(lockPull(0.5f, 0.6f, 0), 0.3f * lockPull(1, 0.6f, 0));
  EXPECT_LT(lockPull(1, 5, 0), 0.9f);  // 1 / (1 - pull) stays finite, however much water there is
}

TEST(Tufts, AreOfShortFurThatIsHalfWet) {
  constexpr float kRadius = 0.03f, kShort = kRadius / 0.6f;
  EXPECT_GT(tuftsOf(0.5f, kShort, kRadius), 0.99f);
  EXPECT_EQ(tuftsOf(0.5f, 4 * kRadius, kRadius), 0) << "long fur makes clumps";
  EXPECT_EQ(tuftsOf(0.5f, 0.5f * kRadius, kRadius), 0) << "no strand reaches from the rim of a tuft to its middle";
  for (const float rho : {0.0f, 0.1f, 1.0f, 2.0f}) EXPECT_EQ(tuftsOf(rho, kShort, kRadius), 0) << rho;
  EXPECT_EQ(tuftPull(0, 1, {0, 0}), 0) << "strands stay where they root";
  EXPECT_LT(tuftPull(1, 1, {0, 0}), 0.9f) << "1 / (1 - pull) stays finite";
  EXPECT_NE(tuftPull(1, 1, {0, 0}), tuftPull(1, 1, {1, 0})) << "no two are alike";
  EXPECT_EQ(tuftPull(1, 1, {1.2f, 0.3f}), tuftPull(1, 1, {1.7f, 0.6f})) << "all of a tuft agree";
}

TEST(Tufts, BeginWhereClumpsHaveNoLocksAnyMore) {
  constexpr float kRadius = 0.03f;
  for (float length = 0.5f * kRadius; length < 4 * kRadius; length += 0.01f * kRadius) {
    const float pull = lockPull(1, 1, lockSheet(0, shortnessOf(length, kRadius)));
    EXPECT_TRUE(pull == 0 || tuftsOf(0.5f, length, kRadius) == 0) << length << ": one grid of cells is both";
  }
}

TEST(ClumpShift, LeadsBackExactlyToTheRoot) {
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    const Vec2 root(random.uniform(), random.uniform()), centre(random.uniform(), random.uniform());
    const float s = clumpPull(random.uniform(), random.uniform(), 16, random.uniform());
    const Vec2 at = clumpForward(root, centre, s);
    // Single precision times the largest stretch of the way back, 1 / (1 - 0.824) = 6.
    EXPECT_NEAR(glm::length(clumpInverse(at, centre, s) - root), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::length(at + (at - centre) * (s / (1 - s)) - root), 0.0f, 1e-5f);
  }
}

TEST(ClumpShift, IsFiniteAtEveryExtreme) {
  for (const float layers : {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 64.0f})
    for (const float rho : {0.0f, 0.5f, 0.82f, 0.825f, 0.83f, 1.0f, 4.0f})
      for (const float w : {0.0f, 1.0f})
        for (const float h : {0.0f, 1e-9f, 0.5f, 1.0f, 2.0f}) {
          const float shift = clumpShift(h, w, layers, rho);
          EXPECT_TRUE(std::isfinite(shift));
          EXPECT_GE(shift, 0.0f);
          EXPECT_LE(shift, 0.824f / (1 - 0.824f));
        }
}

TEST(ClumpPull, NeverGathersAllStrandsOfAClumpInOnePoint) {
  float most = 0;
  for (int i = 0; i <= 1000; ++i) most = std::max(most, clumpPull(1, 1, 16, i / 1000.0f));
  EXPECT_NEAR(most, 0.824f, 1e-3f);
}

TEST(ClumpPull, OfLittleWaterIsOneOfTips) {
  for (const float h : {0.1f, 0.3f, 0.5f}) {
    EXPECT_FLOAT_EQ(clumpPull(h, 0.5f, 16, 0.3f), h * h * clumpProfile(h, 0.5f, 16) * 0.3f);
    EXPECT_FLOAT_EQ(clumpPull(h, 0.5f, 16, 0.7f), clumpProfile(h, 0.5f, 16) * 0.7f) << "Silva Eq. 1";
  }
  EXPECT_FLOAT_EQ(clumpPull(1, 0.5f, 16, 0.3f), 0.3f) << "tips go as far as by Eq. 1";
}

TEST(ClumpShift, IsNothingInDryFur) { EXPECT_EQ(clumpShift(1, 0.5f, 16, 0), 0.0f); }

TEST(ClumpShift, LeavesAClumpOfNoSizeWhereItIs) {
  EXPECT_EQ(clumpInverse(Vec2(0.3f), Vec2(0.3f), 0.85f), Vec2(0.3f));
}

TEST(WetTop, LeavesUprightStrandsOfClumpsTheirHeightAndAllTheirLength) {
  EXPECT_FLOAT_EQ(wetTop(upright(0.5f, 0), 0, 0, 0), 1);
  for (const float held : {0.1f, 0.3f, 0.5f, 0.7f})
    for (const float aside : {0.0f, 0.05f, 0.1f, 0.2f, 0.4f}) {
      const float lean = wetLean(aside, held, 0), top = wetTop(upright(held, 0), aside, lean, 0), length = glm::length(Vec2(aside, 1));
      // How far aside they bend is taken at the height that they have without it.
      EXPECT_NEAR(alongStrand(top, lean + aside * top * top), length, 0.05f * length) << held << " " << aside;
      EXPECT_LE(top, 1);
    }
}

TEST(WetTop, SinksASheetAsFarAsItSinks) {
  for (const float aside : {0.0f, 0.3f}) EXPECT_FLOAT_EQ(wetTop(upright(1, 1), aside, wetLean(aside, 1, 1), 1), upright(1, 1)) << aside;
}

TEST(Sheet, OfShortFurComesWithLessWaterAndNeverGoesAsThereIsMore) {
  for (const float shortness : {0.0f, 0.3f, 1.0f}) {
    float before = 0;
    for (int i = 0; i <= 100; ++i) {
      const float rho = i / 100.0f, sheet = sheetOf(rho, shortness);
      EXPECT_GE(sheet, before);
      EXPECT_GE(sheet, sheetOf(rho));
      before = sheet;
    }
    EXPECT_EQ(sheetOf(0, shortness), 0);
    EXPECT_EQ(before, 1);
  }
}

// Half wet, short fur is a sheet and long fur clumps: a step between them would be a border across the coat.
TEST(Sheet, ChangesEvenlyAsFurGrowsShorter) {
  for (const float rho : {0.1f, 0.25f, 0.5f, 0.75f, 0.95f}) {
    for (int i = 0; i < 100; ++i) {
      const float shorter = sheetOf(rho, (i + 1) / 100.0f) - sheetOf(rho, i / 100.0f);
      EXPECT_GE(shorter, -1e-6f);
      EXPECT_LE(shorter, 0.01f + 1e-6f);
    }
  }
}

TEST(Sheet, IsThatOfLongFurWhereClumpsAreSlender) {
  EXPECT_EQ(shortnessOf(0.12f, 0.035f), 0);  // the settings' own
  EXPECT_EQ(shortnessOf(0.01f, 0.011f), 1);  // an otter's face
}

TEST(Lock, ComesToAPoint) {
  const Vec2 way(3, 1);
  const auto wide = [&](float along) { return 1 / std::abs(onLock(along * way + Vec2(-0.03f, 0.09f), way, 0.6f).y); };
  EXPECT_NEAR(onLock(0.4f * way, way, 0.6f).x, 0.4f, 1e-6f);
  EXPECT_NEAR(onLock(0.4f * way, way, 0.6f).y, 0, 1e-6f);
  for (int i = 1; i < 9; ++i) EXPECT_GT(wide(i / 10.0f), wide((i + 1) / 10.0f));
}

}  // namespace
}  // namespace fur::wet
