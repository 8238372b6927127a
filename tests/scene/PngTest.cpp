#include "scene/Png.h"

#include <gtest/gtest.h>

#include "core/Random.h"
#include "scene/import/ImageHeader.h"

namespace fur::scene {
namespace {

TEST(Png, HasTheSizeThatWasAskedFor) {
  const std::vector<std::uint8_t> pixels(7 * 5 * 4, 200);
  const auto file = writePng(7, 5, 4, pixels);
  const auto header = readImageHeader(file);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->width, 7u);
  EXPECT_EQ(header->height, 5u);
  EXPECT_EQ(header->mimeType, std::string("image/png"));
}

TEST(Png, WhatIsAllAlikeIsSmall) {
  const std::vector<std::uint8_t> pixels(512 * 512 * 3, 120);
  EXPECT_LT(writePng(512, 512, 3, pixels).size(), 10'000u);
}

TEST(Png, NoiseGrowsByAFewHundredthsOnly) {
  std::vector<std::uint8_t> pixels(64 * 64);
  Random random(3);
  for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(random.next());
  EXPECT_LT(writePng(64, 64, 1, pixels).size(), 64 * 64 * 1.1 + 100);
}

}  // namespace
}  // namespace fur::scene
