// Files of FurGLe, written by hand as the tables of Sheppard 2004 have them: .fo after 4.3.1, .fts after 4.2.1.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "geometry/Primitives.h"
#include "groom/Groom.h"
#include "scene/FoModel.h"
#include "scene/Model.h"
#include "scene/TextFile.h"
#include "scene/TypeSet.h"

namespace fur::scene {
namespace {

// A square of side 2 in the plane z = 0, whose unit sphere has the radius of the square root of 2. `vertices`: normal, length and
// type of each of its corners.
std::vector<std::uint8_t> square(const char* a, const char* b, const char* c, const char* d) {
  return textFile("v -1 -1 0 " + std::string(a) + "\nv 1 -1 0 " + b + "\nv 1 1 0 " + c + "\nv -1 1 0 " + d +
                  "\nt 0 0 0 0\nt 1 0 1 0\nt 1 1 1 1\nt 0 1 0 1\np 1/1 2/2 3/3\np 1/1 3/3 4/4\n");
}

TEST(FurGleFile, TypesCountFromOneAndFourIsBald) {
  const auto model = importFo(square("0 0 1 0.2 1", "0 0 1 0.2 2", "0 0 1 0.2 3", "0 0 1 0.2 4"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().fur.types, (std::vector<int>{1, 2, 3, 1}));
  EXPECT_EQ(model.value().fur.lengths, (std::vector<float>{1, 1, 1, 0}));
  EXPECT_TRUE(model.value().warnings.empty());
}

TEST(FurGleFile, ABaldModelIsBald) {
  const auto model = importFo(square("0 0 1 0.2 4", "0 0 1 0.2 4", "0 0 1 0.2 4", "0 0 1 0.2 4"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().fur.lengths, std::vector<float>(4, 0.0f));
}

TEST(FurGleFile, LengthsAreInTheUnitsOfTheModel) {
  const auto model = importFo(square("0 0 1 0.1 1", "0 0 1 0.2 1", "0 0 1 0.4 1", "0 0 1 0 1"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_NEAR(model.value().furLength, 0.4f / std::sqrt(2.0f), 1e-6f);
  EXPECT_EQ(model.value().fur.lengths, (std::vector<float>{0.25f, 0.5f, 1, 0}));
  const auto even = importFo(square("0 0 1 0.3 1", "0 0 1 0.3 1", "0 0 1 0.3 1", "0 0 1 0.3 1"), "fox.fo");
  ASSERT_TRUE(even);
  EXPECT_NEAR(even.value().furLength, 0.3f / std::sqrt(2.0f), 1e-6f);
  EXPECT_TRUE(even.value().fur.lengths.empty());
}

TEST(FurGleFile, NormalsAreTheDirectionOfTheHair) {
  // Leaning by 30 degrees towards +x at one corner.
  const auto model = importFo(square("0.5 0 0.8660254 0.2 1", "0 0 1 0.2 1", "0 0 1 0.2 1", "0 0 1 0.2 1"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  for (const Vec3& normal : model.value().mesh.normals) EXPECT_NEAR(normal.z, 1, 1e-6f);
  const std::vector<Vec3>& comb = model.value().fur.comb;
  ASSERT_EQ(comb.size(), 4u);
  // An arc from root to tip leans by half of what its tip has turned.
  EXPECT_NEAR(comb[0].x, 2 * kPi / 6, 1e-5f);
  EXPECT_NEAR(comb[0].y, 0, 1e-6f);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LT(glm::length(comb[i]), 2e-3f);
}

TEST(FurGleFile, NormalsOfTheSurfaceCombNothing) {
  const auto model = importFo(square("0.1 0 0.995 0.2 1", "0 0 1 0.2 1", "0 0 1 0.2 1", "0 0 1 0.2 1"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model.value().fur.comb.empty());
  EXPECT_GT(model.value().mesh.normals[0].x, 0.09f) << "they stay as they are";
}

TEST(FurGleFile, CombingGoesOutAndComesIn) {
  const geometry::Mesh sphere = geometry::makeSphere();
  auto surface = geometry::buildSurface(sphere);
  ASSERT_TRUE(surface);
  FoFur fur;
  const Vec3 way(0.3f, -1, 0.2f);
  for (const geometry::SurfaceVertex& v : surface->vertices) {
    fur.lengths.push_back(0.1f);
    fur.types.push_back(1);
    fur.bends.push_back(0.8f * (way - v.normal * glm::dot(way, v.normal)));
  }
  auto model = importFo(writeFo(foFromSurface(*surface, 1, fur)), "sphere.fo");
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model->fur.comb.size(), model->mesh.positions.size());
  EXPECT_FLOAT_EQ(model->furLength, 0.1f);
  for (std::size_t i = 0; i < model->mesh.positions.size(); ++i) {
    const Vec3 n = model->mesh.positions[i];  // of a unit sphere
    Vec3 bend = 0.8f * (way - n * glm::dot(way, n));
    if (glm::length(bend) > groom::kMaxComb) bend *= groom::kMaxComb / glm::length(bend);
    EXPECT_LT(glm::length(model->fur.comb[i] - bend), 0.03f) << i;
  }
}

TEST(FurGleFile, FilesWithOtherTypesAreReadAsThisProgramOnceWroteThem) {
  const auto model = importFo(square("0 0 1 1 0", "0 0 1 0.5 1", "0 0 1 1 2", "0 0 1 1 3"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().fur.types, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(model.value().fur.lengths, (std::vector<float>{1, 0.5f, 1, 1}));
  EXPECT_EQ(model.value().furLength, 0) << "shares say nothing of lengths";
}

// A .fts byte by byte: one strand of 4 x 4 texels straight up through all layers, and the same in the fin map.
std::vector<std::uint8_t> typeSetByHand(float density, float weight) {
  std::vector<std::uint8_t> bytes;
  const auto map = [&](int rows, auto covers) {
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < 256; ++x) {
        bytes.push_back(200);                       // variance
        bytes.push_back(150);                       // dominance
        bytes.push_back(covers(x, y) ? 255 : 0);    // alpha
      }
  };
  for (int layer = 0; layer < 16; ++layer) map(256, [](int x, int y) { return x >= 100 && x < 104 && y >= 60 && y < 64; });
  map(64, [](int x, int) { return x >= 100 && x < 104; });
  for (const float number : {density, weight}) {
    std::uint8_t four[4];
    std::memcpy(four, &number, 4);
    bytes.insert(bytes.end(), four, four + 4);
  }
  return bytes;
}

TEST(FurGleFile, ATypeSetIsItsMapsItsDensityAndItsWeight) {
  const auto bytes = typeSetByHand(0.25f, 0.75f);
  ASSERT_EQ(bytes.size(), 3u * 256 * (16 * 256 + 64) + 8);
  const auto set = readTypeSet(bytes, "hand.fts");
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_EQ(set.value().density, 0.25f);
  EXPECT_EQ(set.value().weight, 0.75f);
  EXPECT_EQ(set.value().strandCount, 1);
  const std::size_t inside = (std::size_t{7} * 256 + 61) * 256 + 101;
  EXPECT_EQ(set.value().coverage[inside], 255);
  EXPECT_EQ(set.value().variance[inside], 200);
  EXPECT_EQ(set.value().dominance[inside], 150);
  EXPECT_EQ(set.value().coverage[inside + 10], 0);
  EXPECT_EQ(*writeTypeSet(set.value()), bytes);
}

}  // namespace
}  // namespace fur::scene
