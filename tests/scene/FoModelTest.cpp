#include "scene/FoModel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/Random.h"
#include "geometry/Primitives.h"
#include "scene/Model.h"
#include "scene/TextFile.h"

namespace fur::scene {
namespace {

const std::string kTriangle =
    "v 0 0 0 0 0 1 1 0\nv 1 0 0 0 0 1 1 0\nv 0 1 0 0 0 1 1 0\n"
    "t 0 0 0 0\nt 1 0 2 0\nt 0 1 0 2\np 1/1 2/2 3/3\n";

// Every bit pattern of a finite number in the range of positions.
float anyFloat(Random& random) {
  for (;;) {
    const std::uint32_t bits = random.next();
    float value;
    std::memcpy(&value, &bits, sizeof value);
    if (std::abs(value) < 1e38f) return value;
  }
}

FoModel anyModel(std::uint64_t seed) {
  Random random(seed);
  FoModel fo;
  for (int i = 0; i < 200; ++i) {
    fo.positions.emplace_back(anyFloat(random), anyFloat(random), anyFloat(random));
    fo.normals.emplace_back(anyFloat(random), anyFloat(random), anyFloat(random));
    fo.length.push_back(std::abs(anyFloat(random)));
    fo.furType.push_back(static_cast<int>(random.next()));
    fo.texcoords.push_back({{anyFloat(random), anyFloat(random)}, {anyFloat(random), anyFloat(random)}});
  }
  for (int i = 0; i < 100; ++i) {
    std::array<FoModel::Corner, 3> face;
    for (auto& corner : face) corner = {random.next() % 200, random.next() % 200};
    fo.faces.push_back(face);
  }
  return fo;
}

TEST(FoModel, ComesBackBitForBitFromItsFile) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const FoModel fo = anyModel(seed);
    const auto bytes = writeFo(fo);
    const auto again = readFo(bytes, "fox.fo");
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again.value(), fo) << seed;
    // == takes -0 for 0; the text does not.
    EXPECT_EQ(writeFo(again.value()), bytes) << seed;
  }
}

TEST(FoModel, ReadsTheEndsOfTheRangeOfFloats) {
  using Limits = std::numeric_limits<float>;
  FoModel fo = anyModel(1);
  fo.normals[0] = {Limits::max(), -Limits::min(), Limits::denorm_min()};
  fo.length[0] = -0.0f;
  fo.furType[0] = std::numeric_limits<int>::min();
  const auto again = readFo(writeFo(fo), "fox.fo");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again.value(), fo);
  EXPECT_TRUE(std::signbit(again.value().length[0]));
}

TEST(FoModel, IsWrittenInTheLayoutOfThePaper) {
  FoModel fo;
  fo.positions = {{1, 2, 3}, {0.1f, 0, 0}, {0, -1e-9f, 0}};
  fo.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  fo.length = {0.5f, 1, 0};
  fo.furType = {0, 3, 0};
  fo.texcoords = {{{0, 1}, {2, 3}}};
  fo.faces = {{{{0, 0}, {1, 0}, {2, 0}}}};
  EXPECT_EQ(writeFo(fo), textFile("v 1 2 3 0 0 1 0.5 0\n"
                                  "v 0.100000001 0 0 0 1 0 1 3\n"
                                  "v 0 -9.99999972e-10 0 1 0 0 0 0\n"
                                  "t 0 1 2 3\n"
                                  "p 1/1 2/1 3/1\n"));
}

TEST(FoModel, BecomesAMeshWithFurCoordinates) {
  const auto model = importFo(textFile(kTriangle), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().mesh.furUv, (std::vector<Vec2>{{0, 0}, {2, 0}, {0, 2}}));
  EXPECT_EQ(model.value().mesh.uv, (std::vector<Vec2>{{0, 1}, {1, 1}, {0, 0}}));
  EXPECT_EQ(model.value().mesh.normals, std::vector<Vec3>(3, {0, 0, 1}));
  EXPECT_TRUE(model.value().hasTexcoords);
  EXPECT_TRUE(model.value().warnings.empty());
}

TEST(FoModel, LengthsBecomeSharesOfTheLongestAndTypesSmallNumbers) {
  const auto model = importFo(textFile("v 9 9 9 0 0 1 0.5 7\nv 5 5 9 0 0 1 2 0\nv 5 9 9 0 0 1 0 3\nt 0 0 0 0\np 1/1 2/1 3/1\n"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().fur.lengths, (std::vector<float>{0.25f, 1, 0}));
  EXPECT_EQ(model.value().fur.types, (std::vector<int>{3, 1, 2}));
  EXPECT_TRUE(model.value().warnings.empty());
}

TEST(FoModel, OneLengthAndOneTypeSayNothing) {
  const auto model = importFo(textFile(kTriangle), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model.value().fur.lengths.empty());
  EXPECT_TRUE(model.value().fur.types.empty());
}

TEST(FoModel, SaysOnceThatItTellsOnlyFourTypesApart) {
  std::string text;
  for (int i = 0; i < 6; ++i) text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0 0 0 1 1 " + std::to_string(i) + "\n";
  const auto model = importFo(textFile(text + "t 0 0 0 0\np 1/1 2/1 3/1\np 4/1 5/1 6/1\n"), "fox.fo");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().fur.types, (std::vector<int>{1, 2, 3, 4, 4, 4}));
  ASSERT_EQ(model.value().warnings.size(), 1u);
  EXPECT_NE(model.value().warnings[0].find("6 types"), std::string::npos);
}

TEST(FoModel, OfASurfaceHoldsItsTrianglesAndItsFurCoordinatesTimesTheRepeat) {
  const auto surface = geometry::buildSurface(geometry::makeTorus());
  ASSERT_TRUE(surface);
  const std::size_t count = surface.value().vertices.size();
  const FoModel fo = foFromSurface(surface.value(), 4.0f, {std::vector<float>(count, 0.25f), std::vector<int>(count, 2)});
  ASSERT_EQ(fo.faces.size(), surface.value().triangleCount());
  EXPECT_LT(fo.positions.size(), surface.value().vertices.size());  // its seams are closed again
  for (std::size_t t = 0; t < fo.faces.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& vertex = surface.value().vertices[surface.value().indices[3 * t + k]];
      const auto [v, texcoord] = fo.faces[t][k];
      ASSERT_EQ(fo.positions[v], vertex.position);
      ASSERT_EQ(fo.normals[v], vertex.normal);
      ASSERT_EQ(fo.texcoords[texcoord].fur, vertex.fur * 4.0f);
      ASSERT_EQ(fo.length[v], 0.25f);
      ASSERT_EQ(fo.furType[v], 2);
    }
}

TEST(FoModel, OfASurfaceOpensAsTheSameSurface) {
  const auto surface = geometry::buildSurface(geometry::makeTorus());
  ASSERT_TRUE(surface);
  const std::size_t count = surface.value().vertices.size();
  const auto model = importFo(writeFo(foFromSurface(surface.value(), 1.0f, {std::vector<float>(count, 0.25f), std::vector<int>(count, 1)})), "torus.fo");
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model.value().mesh.triangleCount(), surface.value().triangleCount());
  for (std::size_t i = 0; i < surface.value().indices.size(); ++i) {
    const auto& then = surface.value().vertices[surface.value().indices[i]];
    const std::uint32_t now = model.value().mesh.indices[i];
    // It was in the unit sphere before, so fitting moves it by rounding only.
    EXPECT_LT(glm::distance(model.value().mesh.positions[now], then.position), 1e-5f);
    EXPECT_EQ(model.value().mesh.furUv[now], then.fur);
  }
}

}  // namespace
}  // namespace fur::scene
