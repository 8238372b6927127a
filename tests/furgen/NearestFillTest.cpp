#include "furgen/NearestFill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/Random.h"

namespace fur::furgen {
namespace {

int squaredOnTorus(int ax, int ay, int bx, int by, int size) {
  int dx = std::abs(ax - bx), dy = std::abs(ay - by);
  dx = std::min(dx, size - dx);
  dy = std::min(dy, size - dy);
  return dx * dx + dy * dy;
}

// Checks against every seed; ties may go either way.
void expectNearest(const std::vector<std::uint32_t>& seeds, const std::vector<std::uint32_t>& filled, int size) {
  for (int i = 0; i < size * size; ++i) {
    int best = 1 << 30, taken = 1 << 30;
    for (int j = 0; j < size * size; ++j) {
      if (!seeds[j]) continue;
      const int squared = squaredOnTorus(i % size, i / size, j % size, j / size, size);
      best = std::min(best, squared);
      if (seeds[j] == filled[i]) taken = std::min(taken, squared);
    }
    ASSERT_EQ(taken, best) << "texel " << i % size << ", " << i / size;
  }
}

TEST(NearestFill, AgreesWithBruteForceHoweverManySeeds) {
  const int size = 32;
  for (const int count : {1, 2, 3, 10, 100, 600}) {
    Random random(static_cast<std::uint64_t>(count));
    std::vector<std::uint32_t> seeds(size * size, 0);
    for (int k = 1; k <= count; ++k) seeds[random.next() % (size * size)] = static_cast<std::uint32_t>(k);
    auto filled = seeds;
    NearestFill(size).fill(filled.data());
    expectNearest(seeds, filled, size);
  }
}

TEST(NearestFill, WrapsRoundTheTile) {
  const int size = 16;
  std::vector<std::uint32_t> ids(size * size, 0);
  ids[0] = 1;
  ids[10 + 8 * size] = 2;
  NearestFill(size).fill(ids.data());
  EXPECT_EQ(ids[15 + 15 * size], 1);
}

TEST(NearestFill, LeavesAnEmptyTileEmpty) {
  std::vector<std::uint32_t> ids(16 * 16, 0);
  NearestFill(16).fill(ids.data());
  EXPECT_TRUE(std::all_of(ids.begin(), ids.end(), [](std::uint32_t id) { return id == 0; }));
}

}  // namespace
}  // namespace fur::furgen
