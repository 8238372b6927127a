#include "hair/StrandShading.h"

#include <gtest/gtest.h>

#include "core/Random.h"

namespace fur::hair {
namespace {

Vec3 randomUnit(Random& random) {
  for (;;) {
    Vec3 v;
    v.x = random.uniform(-1, 1);
    v.y = random.uniform(-1, 1);
    v.z = random.uniform(-1, 1);
    if (glm::length(v) > 0.1f) return glm::normalize(v);
  }
}

TEST(KajiyaSpecular, PeaksOnTheConeOppositeTheLight) {
  Random random(4);
  for (int k = 0; k < 500; ++k) {
    const Vec3 t = randomUnit(random), l = randomUnit(random);
    // Mirror the light's component along the strand, then turn about the strand at will.
    const Vec3 axis = glm::cross(t, randomUnit(random));
    if (glm::length(axis) < 0.1f) continue;
    const float tl = glm::dot(t, l);
    const Vec3 onCone = -tl * t + std::sqrt(std::max(1 - tl * tl, 0.0f)) * glm::normalize(axis);
    EXPECT_NEAR(kajiyaSpecular(t, l, onCone, 24), 1.0f, 1e-4f);
    EXPECT_LE(kajiyaSpecular(t, l, randomUnit(random), 24), 1.0f);
  }
}

TEST(KajiyaSpecular, IsTheSameWithLightAndEyeExchangedOrTheStrandTurnedRound) {
  Random random(5);
  for (int k = 0; k < 500; ++k) {
    const Vec3 t = randomUnit(random), l = randomUnit(random), v = randomUnit(random);
    EXPECT_FLOAT_EQ(kajiyaSpecular(t, l, v, 10), kajiyaSpecular(t, v, l, 10));
    EXPECT_FLOAT_EQ(kajiyaSpecular(t, l, v, 10), kajiyaSpecular(-t, l, v, 10));
  }
}

TEST(KajiyaSpecular, FallsOffFasterWithAHigherExponent) {
  const Vec3 t(0, 1, 0), l(1, 0, 0), v = glm::normalize(Vec3(1, 0.4f, 0));
  EXPECT_LT(kajiyaSpecular(t, l, v, 50), kajiyaSpecular(t, l, v, 5));
}

TEST(ShiftedCosine, IsTheHighlightsCosineTurnedByTheShift) {
  Random random(6);
  for (int k = 0; k < 500; ++k) {
    const Vec3 t = randomUnit(random), l = randomUnit(random), v = randomUnit(random);
    const float x = std::asin(glm::dot(t, l)) + std::asin(glm::dot(t, v));
    for (const float shift : {-0.3f, 0.0f, 0.2f}) EXPECT_NEAR(shiftedCosine(t, l, v, shift), std::cos(x - shift), 1e-4f);
    EXPECT_NEAR(std::pow(std::max(shiftedCosine(t, l, v, 0), 0.0f), 9.0f), kajiyaSpecular(t, l, v, 9), 1e-4f);
  }
}

TEST(KajiyaLobe, IsThePowerWithinAnEightBitGlance) {
  for (const float p : {8.0f, 12.0f, 60.0f, 200.0f})
    for (int i = 0; i <= 100; ++i) {
      const float c = i / 100.0f;
      EXPECT_NEAR(kajiyaLobe(c, p), std::pow(c, p), 0.05f);
    }
  EXPECT_EQ(kajiyaLobe(1, 40), 1.0f);
}

TEST(LobeShifts, StandsThePrimaryTowardsTheRootOfTheSecondaryOnEveryStrand) {
  for (const float strand : {0.0f, 0.5f, 1.0f}) EXPECT_LT(lobeShifts(strand).x, lobeShifts(strand).y);
  EXPECT_NE(lobeShifts(0), lobeShifts(1));
}

TEST(RimLight, ShinesOnlyThroughTheEdgeAndFromBehind) {
  EXPECT_FLOAT_EQ(rimLight(-1, 0, 1), 1.0f);
  for (const float facing : {-1.0f, 1.0f}) EXPECT_EQ(rimLight(-1, facing, 1), 0.0f);
  for (const float front : {0.0f, 0.5f, 1.0f}) EXPECT_EQ(rimLight(front, 0, 1), 0.0f);
  EXPECT_GT(rimLight(-0.9f, 0.2f, 1), rimLight(-0.9f, 0.2f, 0.3f));
}

TEST(KajiyaDiffuse, IsTheSineOfTheAngle) {
  const Vec3 t(0, 1, 0);
  EXPECT_FLOAT_EQ(kajiyaDiffuse(t, Vec3(1, 0, 0)), 1.0f);
  EXPECT_FLOAT_EQ(kajiyaDiffuse(t, t), 0.0f);
  EXPECT_NEAR(kajiyaDiffuse(t, glm::normalize(Vec3(1, 1, 0))), std::sqrt(0.5f), 1e-6f);
}

TEST(FurShadow, IsNoneUnderLightAlongTheNormal) {
  for (const float h : {0.0f, 0.5f, 1.0f}) EXPECT_EQ(furShadow(h, 0.5f, 1.0f), 1.0f);
}

TEST(FurShadow, StaysWithinNoughtAndOneAndNeverDarkensUpwards) {
  for (const float density : {0.0f, 0.1f, 0.5f, 1.0f})
    for (const float nDotL : {-1.0f, 0.0f, 0.3f, 0.9f, 0.99999f, 1.0f, 1.1f}) {
      float last = 0;
      for (int i = 0; i <= 50; ++i) {
        const float s = furShadow(i / 50.0f, density, nDotL);
        ASSERT_GE(s, last);
        ASSERT_LE(s, 1.0f);
        last = s;
      }
    }
}

TEST(FurShadow, FollowsThePrintedFormula) {
  // F = 0.8: (4 * 0.35 / 0.5 - 2.4) / 0.8
  EXPECT_NEAR(furShadow(0.35f, 0.5f, 0.2f), 0.5f, 1e-5f);
}

TEST(WhiteLobe, FallsToAnEighthUnderWaterAndMostOfTheWayWithTheFirstOfIt) {
  EXPECT_NEAR(whiteLobe(1) / whiteLobe(0), 0.125f, 0.01f);
  EXPECT_EQ(whiteLobe(1), whiteLobe(1.25f)) << "a film is as good as more of it";
  EXPECT_LT(whiteLobe(0.5f), 0.2f * whiteLobe(0));
  for (float rho = 0.05f; rho <= 1; rho += 0.05f) EXPECT_LT(whiteLobe(rho), whiteLobe(rho - 0.05f)) << rho;
}

TEST(WaterGloss, IsNoBlunterOnBluntFur) {
  const Vec3 along(1, 0, 0), up(0, 0, 1), light = glm::normalize(Vec3(0.3f, 0.4f, 1)), view = glm::normalize(Vec3(-0.2f, 0.1f, 1));
  EXPECT_EQ(waterGloss(along, up, light, view, 1, 0.5f, 1, 20, 0.6f), waterGloss(along, up, light, view, 1, 0.5f, 1, 60, 0.6f));
  EXPECT_NE(waterGloss(along, up, light, view, 1, 0.5f, 1, 90, 0.6f), waterGloss(along, up, light, view, 1, 0.5f, 1, 60, 0.6f));
}

TEST(WaterGloss, IsSpreadWiderAndAsMuchFainterByWhatIsTooSmallToBeSeen) {
  const Vec3 along(0, 1, 0), up(0, 0, 1), view = up;
  const auto mirrored = [&](float slope, float smoothness) {
    return waterGloss(along, up, glm::normalize(Vec3(0, slope, 1)), view, 1, 1, 1, 60, 0, smoothness).x;
  };
  EXPECT_LT(mirrored(0, 0.2f), 0.3f * mirrored(0, 1));
  EXPECT_GT(mirrored(1.5f, 0.2f), mirrored(1.5f, 1));
  EXPECT_GT(mirrored(1.5f, 0.2f), 0);
}

TEST(PassedOn, LeavesAllLightToWhiteFurAndItsShareToBlack) {
  EXPECT_FLOAT_EQ(passedOn(0.4f, Vec3(1)).x, 1);
  EXPECT_FLOAT_EQ(passedOn(0.4f, Vec3(0)).x, 0.4f);
  EXPECT_GT(passedOn(0.4f, Vec3(0.5f)).x, 0.4f);
  for (const float albedo : {0.0f, 0.3f, 0.9f}) EXPECT_FLOAT_EQ(passedOn(1, Vec3(albedo)).x, 1) << albedo;
}

TEST(WetCoatAlbedo, LeavesWhiteFurLightAndDarkensAllOtherTheMostBetweenWhiteAndBlack) {
  EXPECT_EQ(wetCoatAlbedo(Vec3(0.5f), 0), Vec3(0.5f));
  const auto left = [](float albedo) { return wetCoatAlbedo(Vec3(albedo), 1).x / albedo; };
  for (const float albedo : {0.1f, 0.3f, 0.5f, 0.7f, 0.9f}) {
    EXPECT_LT(wetCoatAlbedo(Vec3(albedo), 1).x, wetAlbedo(Vec3(albedo), 1).x) << albedo;
    if (albedo > 0.25f) EXPECT_LT(left(albedo), left(albedo + 0.1f)) << albedo;
  }
  EXPECT_FLOAT_EQ(left(1), 1);
  EXPECT_GT(left(0.9f), 0.7f);
  EXPECT_LT(left(0.3f), 0.5f) << "by half; the rest is shade between clumps";
  EXPECT_GT(left(0.02f), 1.1f * left(0.2f)) << "little light that comes out of black fur has met several strands";
}

TEST(ClumpShade, TakesOfTheKeyLightAloneWhatStrandsShadeAndFarSidesMiss) {
  for (const float facing : {-1.0f, 0.0f, 1.0f}) EXPECT_FLOAT_EQ(clumpShade(facing, 0, 0, 1, 1, 0), clumpShade(0, 0, 0, 1, 1, 0)) << facing;
  EXPECT_GT(clumpShade(1, 0, 1, 1, 1, 0), clumpShade(-1, 0, 1, 1, 1, 0));
  EXPECT_LT(clumpShade(0.5f, 0, 1, 1, 1, 0), 0.5f * clumpShade(0.5f, 0, 0, 1, 1, 0));
  EXPECT_FLOAT_EQ(clumpShade(-1, 0, 1, 0.2f, 0, 0), 1) << "dry";
}

TEST(ClumpShade, ShowsClumpsInShadeByTheSkyTheyTurnTo) {
  EXPECT_GT(clumpShade(0, 0.3f, 0, 1, 1, 0), 1.5f * clumpShade(0, -0.3f, 0, 1, 1, 0));
  EXPECT_FLOAT_EQ(clumpShade(0.5f, 0.3f, 1, 1, 1, 0), clumpShade(0.5f, -0.3f, 1, 1, 1, 0)) << "where all light is the key light's";
  EXPECT_FLOAT_EQ(clumpShade(0, 0.3f, 0, 1, 0, 0), 1) << "dry";
}

TEST(MirroredSky, IsThreeTimesTheAmbientLightInShadeAndLessTheMoreOfTheKeyLightComes) {
  EXPECT_FLOAT_EQ(mirroredSky(0), 3);
  EXPECT_FLOAT_EQ(mirroredSky(1), 1);
  for (const float keyed : {0.1f, 0.5f, 0.9f}) EXPECT_LT(mirroredSky(keyed), mirroredSky(keyed - 0.1f)) << keyed;
}

TEST(WetLight, IsUnchangedWhereSigmaIsNought) {
  EXPECT_EQ(wetSpecularExponent(24, 0.3f, 0), 24.0f);
  EXPECT_EQ(occlusionFactor(0.2f, 0), 1.0f);
  EXPECT_EQ(wetDarkening(0.7f, 0), 1.0f);
}

TEST(WetLight, DarkensStrandsByAsMuchAsTheyAreNotWhite) {
  EXPECT_EQ(strandDarkening(Vec3(1), 1, 0.5f), Vec3(1));
  EXPECT_EQ(strandDarkening(Vec3(0), 1, 0.5f), Vec3(wetDarkening(1, 0.5f))) << "Eq. 5";
  EXPECT_EQ(strandDarkening(Vec3(0.4f), 0, 0.5f), Vec3(1)) << "dry";
}

TEST(WetLight, IsSharperDarkerAndBrighterAtTheTip) {
  EXPECT_FLOAT_EQ(wetSpecularExponent(24, 1, 0.8f), 24.0f);
  EXPECT_LT(wetSpecularExponent(24, 0, 0.8f), wetSpecularExponent(24, 1, 0.8f));
  EXPECT_LT(wetDarkening(1, 0.5f), wetDarkening(0, 0.5f));
  EXPECT_LT(occlusionFactor(0, 0.6f), occlusionFactor(1, 0.6f));
  EXPECT_FLOAT_EQ(occlusionFactor(1, 0.6f), 1.0f);
}

}  // namespace
}  // namespace fur::hair
