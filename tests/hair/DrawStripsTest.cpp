#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "OnEveryPlatform.h"
#include "core/Fnv1a.h"
#include "hair/MemberStrands.h"

namespace fur::hair {
namespace {

constexpr int kWidth = StripPicture::kWidth, kHeight = StripPicture::kHeight;
constexpr float kWide = 0.045f, kTip = 0.35f;

StripPicture drawn(int count, float strandWidth, const HairValues& values = {}) {
  return drawStrips(memberStrands(count, values), strandWidth, kWide, kTip);
}
const StripPicture::Texel& texel(const StripPicture::Level& level, int x, int y) { return level[static_cast<std::size_t>(y * kWidth + x)]; }

// The same of all kinds.
StripPicture drawnOf(const std::vector<MemberStrand>& kind, float strandWidth = 0.006f, float tipWidth = 1) {
  std::vector<MemberStrand> all;
  for (int k = 0; k < kWispKinds; ++k) all.insert(all.end(), kind.begin(), kind.end());
  return drawStrips(all, strandWidth, kWide, tipWidth);
}
MemberStrand straight(float x, float z, float random) {
  MemberStrand s;
  s.root = s.tip = {x, z};
  s.random = random;
  return s;
}

double shareAboveHalf(const StripPicture::Level& level) {
  const auto above = std::count_if(level.begin(), level.end(), [](const auto& t) { return t[0] > 127; });
  return static_cast<double>(above) / static_cast<double>(level.size());
}
double deviation(const StripPicture::Level& level) {
  double sum = 0, squares = 0;
  for (const auto& t : level) sum += t[0], squares += t[0] * t[0];
  const auto count = static_cast<double>(level.size());
  return std::sqrt(squares / count - sum * sum / (count * count)) / 255;
}

// What the strands of a kind cover of a row, by asking at many places whether one is there.
double coveredByStrands(std::span<const MemberStrand> strands, float strandWidth, int y) {
  constexpr int kAcross = 2048, kLines = 4;
  int covered = 0;
  for (int line = 0; line < kLines; ++line) {
    const float t = (static_cast<float>(y) + (static_cast<float>(line) + 0.5f) / kLines) / kHeight;
    for (int i = 0; i < kAcross; ++i) {
      const float x = kStripReach * (2 * (static_cast<float>(i) + 0.5f) / kAcross - 1);
      covered += std::any_of(strands.begin(), strands.end(), [&](const MemberStrand& s) {
        return std::abs(memberOffset(s, t).x - x) < memberWidth(s, t) * strandWidth / (kWide * wispWidth(kTip, t));
      });
    }
  }
  return covered / double{kAcross * kLines};
}

TEST(DrawStrips, AStripShowsWhatTheStrandsOfItsKindCover) {
  const int count = 24;
  const auto strands = memberStrands(count, {});
  const StripPicture picture = drawStrips(strands, 0.003f, kWide, kTip);
  for (std::size_t kind = 0; kind < kWispKinds; ++kind)
    for (const int y : {0, 60, 128, 200, 240}) {
      double sum = 0;
      for (int x = 0; x < kWidth; ++x) sum += texel(picture.levels[kind][0], x, y)[0] / 255.0;
      const std::span<const MemberStrand> own(&strands[kind * count], count);
      EXPECT_NEAR(sum / kWidth, coveredByStrands(own, 0.003f, y), 0.005) << "kind " << kind << ", row " << y;
    }
}

TEST(DrawStrips, StrandsInFrontHideThoseBehindThem) {
  const StripPicture picture = drawnOf({straight(0, -0.5f, 0.2f), straight(0, 0.5f, 0.8f), straight(-0.8f, -1, 0.4f)});
  const auto& level = picture.levels[0][0];
  const auto& front = texel(level, kWidth / 2, 10);
  EXPECT_EQ(front[0], 255);
  EXPECT_NEAR(front[2], 0.8f * 255, 1);
  EXPECT_NEAR(front[3], (0.5f + 0.25f / kStripReach) * 255, 1);
  const auto& aside = texel(level, static_cast<int>(0.5f * (1 - 0.8f / kStripReach) * kWidth), 10);
  EXPECT_NEAR(aside[2], 0.4f * 255, 1);
}

TEST(DrawStrips, ItSaysHowStrandsSlope) {
  MemberStrand leaning = straight(-0.5f, 0, 0.5f);
  leaning.tip.x = 0.5f;
  const StripPicture picture = drawnOf({leaning});
  for (const int y : {40, 128, 200}) {
    const float t = (static_cast<float>(y) + 0.5f) / kHeight;
    const float slope = (memberOffset(leaning, t + 0.01f).x - memberOffset(leaning, t - 0.01f).x) / 0.02f;
    const int x = static_cast<int>(0.5f * (1 + memberOffset(leaning, t).x / kStripReach) * kWidth);
    EXPECT_NEAR(texel(picture.levels[0][0], x, y)[1] / 255.0f, 0.5f + slope / 8, 0.01f);
  }
}

TEST(DrawStrips, PlacesWithoutAStrandSayWhatTheNextOneIs) {
  const StripPicture picture = drawnOf({straight(-0.5f, 0, 0.2f), straight(0.5f, 0, 0.9f)});
  const auto& level = picture.levels[0][0];
  EXPECT_EQ(texel(level, 0, 50)[0], 0);
  EXPECT_NEAR(texel(level, 0, 50)[2], 0.2f * 255, 1);
  EXPECT_NEAR(texel(level, kWidth - 1, 50)[2], 0.9f * 255, 1);
}

TEST(DrawStrips, EveryLevelKeepsTheCoverageAtTheThreshold) {
  HairValues wild;
  wild.frizz = 0.8f, wild.stray = 0.5f;
  for (const HairValues& values : {HairValues(), wild})
    for (const int count : {4, 16, 33, 64})
      for (const float width : {0.002f, 0.004f}) {
        const StripPicture picture = drawn(count, width, values);
        for (const auto& levels : picture.levels)
          for (std::size_t level = 1; level < levels.size(); ++level)
            EXPECT_NEAR(shareAboveHalf(levels[level]), shareAboveHalf(levels[0]), 0.02) << count << " strands, level " << level;
      }
}

TEST(DrawStrips, SmallerLevelsStayAsSharp) {
  const StripPicture picture = drawn(33, 0.002f);
  for (const auto& levels : picture.levels)
    for (std::size_t level = 1; level < levels.size(); ++level) {
      EXPECT_EQ(levels[level].size(), levels[0].size() >> (2 * level));
      EXPECT_NEAR(deviation(levels[level]), deviation(levels[0]), 0.06) << level;
    }
}

TEST(DrawStrips, MeansAreThoseOfWhatIsCovered) {
  // Beside a strand there is nothing: its number stays.
  const StripPicture picture = drawnOf({straight(0, 0, 0.75f)}, 0.002f);
  for (const auto& level : picture.levels[0])
    for (const auto& t : level) ASSERT_NEAR(t[2], 0.75f * 255, 1);
}

TEST(DrawStrips, StrandsAreNotNarrowerWhereTheWispIs) {
  const auto covered = [](float tipWidth) {
    const StripPicture picture = drawnOf({straight(0, 0, 0.5f)}, 0.004f, tipWidth);
    double sum = 0;
    for (int x = 0; x < kWidth; ++x) sum += texel(picture.levels[0][0], x, kHeight / 2)[0];
    return sum;
  };
  EXPECT_NEAR(covered(0.5f) / covered(1), 1 / 0.75, 0.03);
  EXPECT_GT(covered(0), covered(0.5f));
}

TEST(DrawStrips, WithoutStrandsItIsEmpty) {
  const StripPicture picture = drawStrips({}, 0.004f, kWide, kTip);
  for (const auto& levels : picture.levels)
    for (const auto& level : levels)
      for (const auto& t : level) ASSERT_EQ(t[0], 0);
}

TEST(DrawStrips, ItIsTheSameOnEveryPlatform) {
  Fnv1a hash;
  const StripPicture picture = drawn(33, 0.003f);
  for (const auto& levels : picture.levels)
    for (const auto& level : levels) hash.addAll(level);
  fur::test::printOnEveryPlatform("strips of strands", hash.value());
}

}  // namespace
}  // namespace fur::hair
