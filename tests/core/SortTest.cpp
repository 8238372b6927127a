#include "core/Sort.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/Random.h"

namespace fur {
namespace {

TEST(Sort, OrdersAsTheStandardStableSortDoes) {
  Random random(3);
  for (const std::size_t count : {0u, 1u, 2u, 3u, 7u, 64u, 65u, 1000u}) {
    std::vector<std::pair<int, int>> items(count);
    for (std::size_t i = 0; i < count; ++i) items[i] = {static_cast<int>(random.next() % 10), static_cast<int>(i)};
    auto expected = items;
    const auto byFirst = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(expected.begin(), expected.end(), byFirst);
    sortStably(items.begin(), items.end(), byFirst);
    EXPECT_EQ(items, expected) << count;
  }
}

TEST(Sort, UsesTheItemsOwnOrderWhereNoneIsGiven) {
  std::vector<float> items = {3, -1, 2, 2, 0};
  sortStably(items.begin(), items.end());
  EXPECT_TRUE(std::is_sorted(items.begin(), items.end()));
}

}  // namespace
}  // namespace fur
