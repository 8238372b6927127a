#include "render/Samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace fur::render {
namespace {

TEST(Samples, TheFirstIsThePictureItself) {
  EXPECT_EQ(sampleOffset(0), Vec2(0));
  EXPECT_EQ(sampleChance(0), Vec4(0));
}

TEST(Samples, LookAtAllOfAPixelAndNoFurther) {
  std::vector<int> cells(16);
  for (int i = 0; i < kMostSamples; ++i) {
    const Vec2 at = sampleOffset(i) + 0.5f;
    EXPECT_TRUE(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1) << i;
    ++cells[static_cast<std::size_t>(std::min(at.x * 4, 3.0f)) + 4 * static_cast<std::size_t>(std::min(at.y * 4, 3.0f))];
  }
  EXPECT_GE(*std::min_element(cells.begin(), cells.end()), 3);
  EXPECT_LE(*std::max_element(cells.begin(), cells.end()), 5);
}

// Else the picture would creep while it gets better. Sixteen: a twentieth of a pixel, where nobody sees it.
TEST(Samples, AreRoundTheMiddle) {
  for (const int count : {16, kMostSamples}) {
    Vec2 sum(0);
    for (int i = 0; i < count; ++i) sum += sampleOffset(i);
    EXPECT_LT(glm::length(sum) / static_cast<float>(count), count == 16 ? 0.07f : 0.02f) << count;
  }
}

// shell.frag makes three chances of one noise: times 7 and 13 it is as even as by itself.
TEST(Samples, ChanceIsEvenWhateverItIsMultipliedBy) {
  for (const float factor : {1.0f, 7.0f, 13.0f})
    for (int lane = 0; lane < 4; ++lane) {
      std::vector<int> parts(8);
      for (int i = 0; i < kMostSamples; ++i) ++parts[static_cast<std::size_t>(8 * glm::fract(factor * sampleChance(i)[lane]))];
      if (lane % 2 == 0 && factor == 7) continue;  // of the mip level alone
      EXPECT_GE(*std::min_element(parts.begin(), parts.end()), 5) << factor << ", " << lane;
      EXPECT_LE(*std::max_element(parts.begin(), parts.end()), 11) << factor << ", " << lane;
    }
}

}  // namespace
}  // namespace fur::render
