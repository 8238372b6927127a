#include "hair/AmbientOcclusion.h"

#include "tests/hair/TestScalps.h"

#include <algorithm>
#include <numeric>

#include "geometry/Primitives.h"

namespace fur::hair {
namespace {

constexpr std::size_t kPoints = kStripSegments + 1;

// Straight hair all over a sphere, and how much light comes to each of its points.
struct Ball {
  explicit Ball(int wisps, int strands = 33) : sphere(geometry::makeSphere()) {
    values.wisps = wisps, values.strands = strands;
    values.lengthVariation = 0, values.curl = 0;
    const Guides guides = plantGuides(sphere.scalp(), values, 60).value();
    const auto roots = sphere.roots(guides);
    const auto wispsOnIt = plantWisps(sphere.scalp(), guides, roots, values);
    light = ambientVisibility(sphere.surface, wispsOnIt, restNodes(guides, roots), guides.nodes, values);
  }
  // The mean over all wisps.
  float at(std::size_t point) const {
    float sum = 0;
    for (std::size_t i = point; i < light.size(); i += kPoints) sum += light[i];
    return sum / static_cast<float>(light.size() / kPoints);
  }

  test::TestScalp sphere;
  HairValues values;
  std::vector<std::uint8_t> light;
};

TEST(AmbientOcclusion, SaysHowMuchLightComesToEachPointOfEachWisp) {
  EXPECT_EQ(Ball(40).light.size(), 40 * kPoints);
  EXPECT_TRUE(Ball(0).light.empty());
}

TEST(AmbientOcclusion, AFewThinHairsTakeLittleLightFromEachOther) {
  const Ball few(12, 1);
  // The sphere hides half of all directions at a root, and less further out; the grid is coarse.
  EXPECT_GT(few.at(0), 0.85f * 255);
  EXPECT_GT(few.at(kPoints - 1), 0.99f * 255);
}

TEST(AmbientOcclusion, HairIsDarkerTheDeeperAmongOthersItLies) {
  const Ball dense(3000);
  for (std::size_t i = 4; i < kPoints; i += 4) EXPECT_GT(dense.at(i), dense.at(i - 4) + 5);
}

TEST(AmbientOcclusion, MoreStrandsTakeMoreLight) {
  const Ball thin(1000, 8), thick(1000, 40);
  EXPECT_LT(thick.at(0), thin.at(0) - 10);
  EXPECT_LT(thick.at(kPoints / 2), thin.at(kPoints / 2) - 10);
}

TEST(AmbientOcclusion, EveryWispOfAnEvenBallGetsAboutTheSame) {
  const Ball even(1500);
  std::vector<std::uint8_t> middle;
  for (std::size_t i = kPoints / 2; i < even.light.size(); i += kPoints) middle.push_back(even.light[i]);
  std::sort(middle.begin(), middle.end());
  // Of the 14 directions and the grid's cells some of it is left.
  EXPECT_LT(middle[middle.size() * 9 / 10] - middle[middle.size() / 10], 60);
}

}  // namespace
}  // namespace fur::hair
