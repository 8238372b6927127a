#include "furgen/TilePicture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace fur::furgen {
namespace {

constexpr int kTileSize = 4;
constexpr std::size_t kTexels = kTileSize * kTileSize;

// Texel 0 is empty, the others are covered; otherwise all texels are alike.
LayerMaps layer() {
  LayerMaps maps;
  maps.coverage.assign(kTexels, 255);
  maps.coverage[0] = 0;
  maps.dominance.assign(kTexels, 200);
  maps.variance.assign(kTexels, 100);
  for (std::size_t i = 0; i < kTexels; ++i) {
    maps.tangent.insert(maps.tangent.end(), {127, -127, 0});
    maps.offset.insert(maps.offset.end(), {64, 0});
  }
  maps.strandId.assign(kTexels, 7);
  return maps;
}

FinMaps fin() {
  FinMaps maps;
  maps.rows = 2;
  maps.coverage = {0, 10, 20, 255, 1, 2, 3, 4};
  maps.dominance.assign(8, 255);
  maps.variance.assign(8, 60);
  maps.tangent.assign(24, 0);
  return maps;
}

std::array<int, 4> texel(const TilePicture& picture, std::size_t i) {
  return {picture.rgba[i * 4], picture.rgba[i * 4 + 1], picture.rgba[i * 4 + 2], picture.rgba[i * 4 + 3]};
}

int brightness(const std::array<int, 4>& color) { return color[0] + color[1] + color[2]; }

TEST(TilePicture, HasTheSizeOfItsMapsAndIsOpaque) {
  for (int channel = 0; channel < kTileChannels; ++channel) {
    const TilePicture tile = pictureOf(layer(), kTileSize, static_cast<TileChannel>(channel));
    EXPECT_EQ(tile.width, kTileSize);
    EXPECT_EQ(tile.height, kTileSize);
    ASSERT_EQ(tile.rgba.size(), kTexels * 4);
    const TilePicture side = pictureOf(fin(), kTileSize, static_cast<TileChannel>(channel));
    EXPECT_EQ(side.width, kTileSize);
    EXPECT_EQ(side.height, 2);
    ASSERT_EQ(side.rgba.size(), 2u * kTileSize * 4);
    for (std::size_t i = 0; i < kTexels; ++i) EXPECT_EQ(tile.rgba[i * 4 + 3], 255);
  }
}

TEST(TilePicture, ShowsCoverageAndVarianceAsTheGreysTheyAre) {
  const TilePicture coverage = pictureOf(layer(), kTileSize, TileChannel::Coverage);
  EXPECT_EQ(texel(coverage, 0), (std::array{0, 0, 0, 255}));
  EXPECT_EQ(texel(coverage, 5), (std::array{255, 255, 255, 255}));
  EXPECT_EQ(texel(pictureOf(layer(), kTileSize, TileChannel::Variance), 5), (std::array{100, 100, 100, 255}));
  const TilePicture side = pictureOf(fin(), kTileSize, TileChannel::Coverage);
  EXPECT_EQ(texel(side, 1), (std::array{10, 10, 10, 255})) << "row 0, the root, first";
  EXPECT_EQ(texel(side, 4), (std::array{1, 1, 1, 255}));
}

TEST(TilePicture, DarkensWhatNoStrandCoversInEveryOtherChannel) {
  for (int channel = 1; channel < kTileChannels; ++channel) {
    const TilePicture tile = pictureOf(layer(), kTileSize, static_cast<TileChannel>(channel));
    EXPECT_LT(brightness(texel(tile, 0)), brightness(texel(tile, 1)) / 2) << channel;
    EXPECT_GT(brightness(texel(tile, 0)), 0) << channel << ": what it carries can still be read";
  }
}

TEST(TilePicture, ShowsTangentsByTheirComponents) {
  // -127, 0 and 127 of 127 become 0, a half and 1.
  EXPECT_EQ(texel(pictureOf(layer(), kTileSize, TileChannel::Tangent), 5), (std::array{255, 0, 128, 255}));
}

TEST(TilePicture, ShowsMoreDominanceBrighter) {
  LayerMaps maps = layer();
  int last = -1;
  for (int value = 128; value <= 255; ++value) {
    maps.dominance[5] = static_cast<std::uint8_t>(value);
    const auto color = texel(pictureOf(maps, kTileSize, TileChannel::Dominance), 5);
    // Luma (Rec. 709), in ten thousandths.
    const int luma = 2126 * color[0] + 7152 * color[1] + 722 * color[2];
    EXPECT_GE(luma, last) << value;
    last = luma;
  }
}

TEST(TilePicture, ShowsOffsetsByDirectionAndLength) {
  LayerMaps maps = layer();
  const std::array<std::array<std::int16_t, 2>, 4> offsets = {{{64, 0}, {0, 64}, {-64, 0}, {0, -64}}};
  for (std::size_t i = 0; i < 4; ++i) std::copy(offsets[i].begin(), offsets[i].end(), &maps.offset[(i + 1) * 2]);
  maps.offset[10] = 256, maps.offset[11] = 0;
  maps.offset[12] = maps.offset[13] = 0;
  const TilePicture tile = pictureOf(maps, kTileSize, TileChannel::Offset);
  std::set<std::array<int, 4>> colors;
  for (std::size_t i = 1; i <= 4; ++i) colors.insert(texel(tile, i));
  EXPECT_EQ(colors.size(), 4u);
  EXPECT_GT(brightness(texel(tile, 5)), brightness(texel(tile, 1)));
  EXPECT_EQ(brightness(texel(tile, 6)), 0) << "a texel at its strand's root";
}

TEST(TilePicture, ShowsEveryStrandInOneColourAndNeighboursInOthers) {
  LayerMaps maps = layer();
  for (std::size_t i = 0; i < kTexels; ++i) maps.strandId[i] = static_cast<std::uint16_t>(1 + i / 2);
  maps.coverage.assign(kTexels, 255);
  const TilePicture tile = pictureOf(maps, kTileSize, TileChannel::Strand);
  std::set<std::array<int, 4>> colors;
  for (std::size_t i = 0; i < kTexels; ++i) {
    colors.insert(texel(tile, i));
    EXPECT_EQ(texel(tile, i), texel(tile, i - i % 2));
  }
  EXPECT_EQ(colors.size(), kTexels / 2);
}

TEST(TilePicture, ShowsTheCoverageOfAFinForChannelsThatItHasNot) {
  const TilePicture coverage = pictureOf(fin(), kTileSize, TileChannel::Coverage);
  EXPECT_EQ(pictureOf(fin(), kTileSize, TileChannel::Offset).rgba, coverage.rgba);
  EXPECT_EQ(pictureOf(fin(), kTileSize, TileChannel::Strand).rgba, coverage.rgba);
}

}  // namespace
}  // namespace fur::furgen
