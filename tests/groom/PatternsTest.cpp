// Markings made of the place in space.
#include "groom/Patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/Primitives.h"
#include "tests/groom/GroomSetting.h"

namespace fur::groom {
namespace {

constexpr Pattern kPatterns[] = {Pattern::Tabby, Pattern::Spots, Pattern::Rosettes, Pattern::Patches};
const Vec3 kAlong(1, 0, 0);

// Places all over the unit sphere (Fibonacci's spiral).
std::vector<Vec3> places(int count) {
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i) {
    const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / static_cast<float>(count), angle = 2.39996f * static_cast<float>(i), r = std::sqrt(1 - y * y);
    out.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
  }
  return out;
}

float shareOf(Pattern pattern, float size = 1, std::uint32_t seed = 1) {
  float sum = 0;
  const auto all = places(4000);
  for (const Vec3& at : all) sum += patternAt(pattern, at, at, kAlong, size, seed);
  return sum / static_cast<float>(all.size());
}

// Mean change over a step of 0.01.
float changeOf(Pattern pattern, float size) {
  float sum = 0;
  for (const Vec3& at : places(4000)) {
    const Vec3 beside = at + Vec3(0.01f, 0, 0);
    sum += std::abs(patternAt(pattern, beside, at, kAlong, size, 1) - patternAt(pattern, at, at, kAlong, size, 1));
  }
  return sum;
}

TEST(Patterns, CoverPartOfTheSkinAndLeavePartOfItFree) {
  for (const Pattern pattern : kPatterns) {
    int free = 0, full = 0;
    for (const Vec3& at : places(4000)) {
      const float share = patternAt(pattern, at, at, kAlong, 1, 1);
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      free += share < 0.05f;
      full += share > 0.5f;
    }
    // A tenth of the skin or more is either: less would be seen as no marking, or as another colour of the coat.
    EXPECT_GT(free, 400) << static_cast<int>(pattern);
    EXPECT_GT(full, 400) << static_cast<int>(pattern);
  }
}

TEST(Patterns, AreOthersWithAnotherSeedAndAsDense) {
  for (const Pattern pattern : kPatterns) {
    int other = 0;
    for (const Vec3& at : places(500)) other += patternAt(pattern, at, at, kAlong, 1, 1) != patternAt(pattern, at, at, kAlong, 1, 2);
    EXPECT_GT(other, 100) << static_cast<int>(pattern);
    EXPECT_NEAR(shareOf(pattern, 1, 1), shareOf(pattern, 1, 2), 0.2f) << static_cast<int>(pattern);
  }
}

TEST(Patterns, AreCoarserWhereTheyAreLarger) {
  for (const Pattern pattern : kPatterns) EXPECT_LT(changeOf(pattern, 2), 0.8f * changeOf(pattern, 1)) << static_cast<int>(pattern);
}

TEST(Patterns, OfSizesOutOfRangeAreThoseAtTheEnds) {
  const Vec3 at(0.3f, 0.2f, 0.5f);
  for (const Pattern pattern : kPatterns) {
    EXPECT_EQ(patternAt(pattern, at, at, kAlong, 0, 1), patternAt(pattern, at, at, kAlong, 0.1f, 1));
    EXPECT_EQ(patternAt(pattern, at, at, kAlong, 1e9f, 1), patternAt(pattern, at, at, kAlong, 10, 1));
  }
}

TEST(Patterns, ArePaintedInOneColourInPlaceOfAllPaint) {
  Setting s(128, geometry::buildSurface(geometry::makeSphere()).value());
  for (const Pattern pattern : kPatterns) {
    s.groom.paint = GroomMap(s.groom.map.size(), {9, 9, 9, 255});
    paintPattern(s.groom, s.groomSurface(), pattern, 1, 0x102030, 1);
    std::set<int> shares;
    for (std::uint32_t t = 0; t < s.surface.triangleCount(); ++t)
      s.atlas.forTexelsOf(s.surface, t, [&](std::uint32_t texel, const Vec3&) {
        const GroomMap::Texel& is = s.groom.paint.texels()[texel];
        EXPECT_EQ((GroomMap::Texel{is[0], is[1], is[2], 0}), (GroomMap::Texel{0x10, 0x20, 0x30, 0}));
        shares.insert(is[3]);
      });
    EXPECT_GT(shares.size(), 10u) << static_cast<int>(pattern);
  }
}

TEST(Patterns, StripesAreThinnerOnTheUnderside) {
  float above = 0, below = 0;
  for (const Vec3& at : places(4000)) (at.y > 0 ? above : below) += patternAt(Pattern::Tabby, at, at, kAlong, 1, 1);
  EXPECT_LT(below, 0.8f * above);
}

}  // namespace
}  // namespace fur::groom
