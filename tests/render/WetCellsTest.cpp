#include "render/WetCells.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "shared/Wet.h"

namespace fur::render {
namespace {

wet::MaskTexels dryMask(int size) {
  return {size, {0, 0, size, size}, std::vector<Vec4>(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), Vec4(0))};
}
int wetCells(const WetCells& cells) {
  int count = 0;
  for (std::uint32_t i = 0; i < WetCells::kAcross * WetCells::kAcross; ++i) count += cells.isWet(i);
  return count;
}

TEST(WetCells, AreWetWhereAnyTexelOfTheMaskIs) {
  for (const int size : {16, 64, 256}) {
    WetCells cells;
    wet::MaskTexels mask = dryMask(size);
    cells.update(mask);
    EXPECT_EQ(wetCells(cells), 0);
    mask.texels[static_cast<std::size_t>(3 * size + 5)].w = 0.1f;
    cells.update(mask);
    std::vector<std::uint16_t> there;
    addCells(Vec2(5.5f, 3.5f) / static_cast<float>(size), Vec2(5.5f, 3.5f) / static_cast<float>(size), there);
    ASSERT_EQ(there.size(), 1u);
    EXPECT_TRUE(cells.isWet(there[0])) << size;
    EXPECT_EQ(wetCells(cells), std::max(WetCells::kAcross / size, 1) * std::max(WetCells::kAcross / size, 1)) << size;
  }
}

TEST(WetCells, AreWetWhereFurLiesDownBesideWetFur) {
  WetCells cells;
  wet::MaskTexels mask = dryMask(64);
  mask.texels[70].z = FUR_LYING_STEP * 80;
  mask.texels[90].z = FUR_LYING_STEP * 4;  // by so little that nobody sees it
  cells.update(mask);
  EXPECT_EQ(wetCells(cells), 1);
}

TEST(WetCells, FollowPartsOfAMaskAndCountWhatChanges) {
  WetCells cells;
  cells.update(dryMask(256));
  const unsigned long dry = cells.revision();
  wet::MaskTexels part{256, {10, 20, 12, 21}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 0, -1)}};
  cells.update(part);
  EXPECT_EQ(wetCells(cells), 1);
  const unsigned long wet = cells.revision();
  EXPECT_NE(wet, dry);
  part.texels[0].w = 0.5f;
  cells.update(part);
  EXPECT_EQ(cells.revision(), wet) << "as wet cells as before";
  part.texels[0].w = 0;
  cells.update(part);
  EXPECT_EQ(wetCells(cells), 0);
}

TEST(WetCells, OfABoxAreThoseThatItTouches) {
  std::vector<std::uint16_t> cells;
  addCells(Vec2(-3, 0.5f), Vec2(0.02f, 0.52f), cells);  // beside the atlas there is none
  EXPECT_EQ(cells, (std::vector<std::uint16_t>{32 * 64, 32 * 64 + 1, 33 * 64, 33 * 64 + 1}));
}

}  // namespace
}  // namespace fur::render
