#include "hair/MemberStrands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "AllocatedBytes.h"
#include "OnEveryPlatform.h"
#include "core/Fnv1a.h"

namespace fur::hair {
namespace {

constexpr int kSteps = 64;

template <class Visit>
void alongEach(const std::vector<MemberStrand>& strands, Visit visit) {
  for (const MemberStrand& s : strands)
    for (int i = 0; i <= kSteps; ++i) visit(s, static_cast<float>(i) / kSteps);
}

HairValues wild() {
  HairValues v;
  v.frizz = v.stray = v.tipVariation = 1;
  return v;
}

TEST(MemberStrands, EachKindHasItsOwnSetOfAsManyAsAreAskedFor) {
  for (const int count : {1, 2, 33, 64}) {
    const auto strands = memberStrands(count, {});
    const auto each = static_cast<std::size_t>(count);
    ASSERT_EQ(strands.size(), each * kWispKinds);
    for (std::size_t kind = 1; kind < kWispKinds; ++kind) EXPECT_NE(strands[kind * each].root, strands[0].root);
  }
  EXPECT_EQ(memberStrands(0, {}).size(), std::size_t{kWispKinds});
}

TEST(MemberStrands, RootsLieInsideAndApartAndMoreOfThemInTheMiddle) {
  const std::size_t count = 64;
  const auto strands = memberStrands(64, {});
  for (std::size_t kind = 0; kind < kWispKinds; ++kind) {
    int inner = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 root = strands[kind * count + i].root;
      EXPECT_LT(glm::length(root), 1.0f);
      inner += glm::length(root) < 0.5f;
      for (std::size_t k = 0; k < i; ++k) {
        const float apart = glm::length(root - strands[kind * count + k].root);
        // 0.23 is what so many discs keep that fill the circle.
        EXPECT_GT(apart, 0.04f);
      }
    }
    // A quarter of the area.
    EXPECT_GT(inner, 18);
  }
}

TEST(MemberStrands, TheFirstFewOfAKindAreSpreadAsWell) {
  const auto strands = memberStrands(64, {});
  for (std::size_t kind = 0; kind < kWispKinds; ++kind)
    for (std::size_t i = 0; i < 7; ++i)
      for (std::size_t k = 0; k < i; ++k) EXPECT_GT(glm::length(strands[64 * kind + i].root - strands[64 * kind + k].root), 0.35f);
}

TEST(MemberStrands, NoneLeavesTheStripAndWithoutStraysAndWavesNoneTheWisp) {
  alongEach(memberStrands(64, wild()), [](const MemberStrand& s, float t) {
    const Vec2 at = memberOffset(s, t);
    ASSERT_LE(std::max(std::abs(at.x), std::abs(at.y)), kStripReach);
  });
  HairValues tame;
  tame.frizz = tame.stray = 0;
  alongEach(memberStrands(64, tame), [](const MemberStrand& s, float t) { ASSERT_LT(glm::length(memberOffset(s, t)), 1.15f); });
}

TEST(MemberStrands, StraysAreAsManyAsAsked) {
  for (const float stray : {0.0f, 0.25f, 1.0f}) {
    HairValues v;
    v.stray = stray;
    const auto strands = memberStrands(64, v);
    const auto out = std::count_if(strands.begin(), strands.end(), [](const MemberStrand& s) { return glm::length(s.tip) > 0.89f && glm::length(s.tip - s.root) > 0.15f; });
    EXPECT_NEAR(static_cast<float>(out) / static_cast<float>(strands.size()), stray, 0.12f) << stray;
  }
}

TEST(MemberStrands, TipsAreAsUnevenAsAskedAndOneOfEachKindIsAsLongAsItsWisp) {
  HairValues v;
  v.tipVariation = 0;
  for (const MemberStrand& s : memberStrands(33, v)) EXPECT_EQ(s.length, 1.0f);
  v.tipVariation = 0.6f;
  const auto strands = memberStrands(33, v);
  float shortest = 1;
  for (std::size_t i = 0; i < strands.size(); ++i) {
    if (i % 33 == 0) EXPECT_EQ(strands[i].length, 1.0f);
    EXPECT_GE(strands[i].length, 0.4f);
    shortest = std::min(shortest, strands[i].length);
  }
  EXPECT_LT(shortest, 0.7f);
}

TEST(MemberStrands, TheyTaperToNothingAtTheirTips) {
  alongEach(memberStrands(33, wild()), [](const MemberStrand& s, float t) {
    const float width = memberWidth(s, t);
    ASSERT_GE(width, 0.0f);
    ASSERT_LE(width, memberWidth(s, t * 0.9f));
    if (t >= s.length) ASSERT_EQ(width, 0.0f);
  });
  EXPECT_EQ(memberWidth({}, 0), 1.0f);
}

TEST(MemberStrands, TheyStartAtTheirRootsAndEndNearTheirTips) {
  for (const MemberStrand& s : memberStrands(33, {})) {
    EXPECT_EQ(memberOffset(s, 0), s.root);
    EXPECT_LT(glm::length(memberOffset(s, 1) - s.tip), 2 * s.frizz);
  }
}

TEST(MemberStrands, TwentyThousandPlacesTakeNoMemory) {
  const auto strands = memberStrands(33, {});
  const std::size_t before = allocatedBytes();
  float sum = 0;
  for (int i = 0; i < 20000; ++i) sum += memberOffset(strands[static_cast<std::size_t>(i) % strands.size()], static_cast<float>(i) / 20000).x;
  EXPECT_EQ(allocatedBytes(), before);
  EXPECT_LT(std::abs(sum), 20000.0f);
}

TEST(MemberStrands, TheyAreTheSameOnEveryPlatform) {
  Fnv1a hash;
  const auto strands = memberStrands(33, wild());
  hash.addAll(strands);
  alongEach(strands, [&](const MemberStrand& s, float t) { hash.add(memberOffset(s, t)); });
  fur::test::printOnEveryPlatform("member strands", hash.value());
}

}  // namespace
}  // namespace fur::hair
