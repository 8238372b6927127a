#include "core/Numbering.h"

#include <gtest/gtest.h>

#include <map>

#include "core/Random.h"

namespace fur {
namespace {

TEST(Numbering, CountsInTheOrderOfFirstAppearance) {
  Numbering numbers;
  EXPECT_EQ(numbers.count(), 0u);
  EXPECT_EQ(numbers.of(7), 0u);
  EXPECT_EQ(numbers.of(0), 1u);
  EXPECT_EQ(numbers.of(~0ull), 2u);
  EXPECT_EQ(numbers.of(7), 0u);
  EXPECT_EQ(numbers.of(0), 1u);
  EXPECT_EQ(numbers.count(), 3u);
}

TEST(Numbering, GivesEachOfManyKeysItsOwnNumberAndKeepsIt) {
  Numbering numbers;
  std::map<std::uint64_t, std::uint32_t> expected;
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    // Pairs as they come, many of them twice, that differ in the upper half only, in the lower half only or in both.
    const std::uint64_t key = std::uint64_t{random.next() % 97} << 32 | (random.next() % 200);
    const std::uint32_t number = expected.try_emplace(key, static_cast<std::uint32_t>(expected.size())).first->second;
    ASSERT_EQ(numbers.of(key), number);
  }
  EXPECT_EQ(numbers.count(), expected.size());
  for (const auto& [key, number] : expected) ASSERT_EQ(numbers.of(key), number);
}

}  // namespace
}  // namespace fur
