#include <gtest/gtest.h>

#include <string>

#include "geometry/Surface.h"
#include "scene/Model.h"
#include "scene/TextFile.h"

namespace fur::scene {
namespace {

Model read(const std::string& text) {
  auto model = importObj(textFile(text), "fox.obj");
  EXPECT_TRUE(model) << model.error().message;
  return model ? *model : Model{};
}

const std::string kSquare = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

TEST(ImportObj, ReadsCornersInEverySpelling) {
  const std::string lists = kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 0 2\n";
  for (const char* faces : {"f 1 2 3\nf 1 3 4", "f 1/1 2/2 3/3\nf 1/1 3/3 4/4", "f 1//1 2//1 3//1\nf 1//1 3//1 4//1",
                            "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1", "f -4 -3 -2\nf -4 -2 -1",
                            "f -4/-4/-2 -3/-3/-2 -2/-2/-2\nf -4/-4/-2 -2/-2/-2 -1/-1/-2"}) {
    const Model model = read(lists + faces);
    EXPECT_EQ(model.mesh.positions.size(), 4u) << faces;
    EXPECT_EQ(model.mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3})) << faces;
    for (const Vec3& normal : model.mesh.normals) EXPECT_EQ(normal, Vec3(0, 0, 1)) << faces;
    const bool withTexcoords = std::string(faces).find("1/1") != std::string::npos ||
                               std::string(faces).find("4/-4") != std::string::npos;
    EXPECT_EQ(model.hasTexcoords, withTexcoords) << faces;
    EXPECT_EQ(model.mesh.uv.size(), withTexcoords ? 4u : 0u) << faces;
  }
}

TEST(ImportObj, TurnsTextureCoordinatesOverSoThatTheTopOfTheImageIsZero) {
  const Model model = read(kSquare + "vt 0.25 0.75\nf 1/1 2/1 3/1");
  EXPECT_EQ(model.mesh.uv[0], Vec2(0.25f, 0.25f));
}

TEST(ImportObj, FitsTheMeshAndKeepsTheBoundsOfTheFile) {
  const Model model = read("v 10 0 0\nv 14 0 0\nv 12 4 0\nf 1 2 3\n");
  EXPECT_EQ(model.bounds.low, Vec3(10, 0, 0));
  EXPECT_EQ(model.bounds.high, Vec3(14, 4, 0));
  float farthest = 0;
  for (const Vec3& p : model.mesh.positions) farthest = std::max(farthest, glm::length(p));
  EXPECT_NEAR(farthest, 1.0f, 1e-6f);  // rounding of three squares
}

TEST(ImportObj, CutsPolygonsIntoAFan) {
  const Model model = read("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
  EXPECT_EQ(model.mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(ImportObj, SplitsAVertexOnlyWhereItsCornersDiffer) {
  const Model model = read(kSquare + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/1 4/1\n");
  EXPECT_EQ(model.mesh.positions.size(), 5u);
  EXPECT_EQ(model.mesh.positions[0], model.mesh.positions[3]);
  EXPECT_EQ(model.mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 4}));
}

TEST(ImportObj, LeavesOutVerticesThatNoFaceUses) {
  EXPECT_EQ(read("v 9 9 9\n" + kSquare + "f 2 3 4\n").mesh.positions.size(), 3u);
}

TEST(ImportObj, ComputesTheNormalsThatAreMissing) {
  const Model model = read(kSquare + "vn 1 0 0\nvn 0 0 0\nf 1//1 2//2 3\n");
  EXPECT_EQ(model.mesh.normals[0], Vec3(1, 0, 0));
  EXPECT_EQ(model.mesh.normals[1], Vec3(0, 0, 1));  // a vector without a direction says nothing
  EXPECT_EQ(model.mesh.normals[2], Vec3(0, 0, 1));
}

TEST(ImportObj, ReadsEveryWayOfEndingLinesAndOfWritingNumbers) {
  const Model plain = read("v 0 0 0\nv 1.5 0 0\nv 0 25 0\nf 1 2 3\n");
  for (const char* text :
       {"v 0 0 0\r\nv 1.5 0 0\r\nv 0 25 0\r\nf 1 2 3", "v 0 0 0\rv 1.5 0 0\rv 0 25 0\rf 1 2 3\r",
        "\xef\xbb\xbf# a fox\nv 0 0 0 # the nose\n\n\tv\t1.5  0 0 \nv 0 25 0\nf \\\n1 2\\\r\n 3\n",
        "v -0 +0 .0\nv 15E-1 0. 0e9\nv 0 +2.5e+01 0\nf 1 2 3", "v 0 0 0 1\nv 1.5 0 0 0.5 0.5 0.5\nv 0 25 0 what\nf 1 2 3",
        "v 0 0 0\nv 0.000000000000000000000015e23 0 0\nv 0 25000000000000000000000e-21 0\nf 1 2 3"}) {
    const Model model = read(text);
    EXPECT_EQ(model.mesh.indices, plain.mesh.indices) << text;
    EXPECT_EQ(model.bounds.high, plain.bounds.high) << text;
  }
}

TEST(ImportObj, WarnsOnceOfEachKindOfThingThatItLeavesOut) {
  const Model model = read("mtllib a.mtl\no fox\ng tail\ns off\n" + kSquare +
                           "usemtl red\nf 1 2 3\nusemtl blue\nl 1 2\np 1\ncurv 1 2\nsurf 1\n");
  ASSERT_EQ(model.warnings.size(), 3u);
  EXPECT_EQ(model.warnings[0].rfind("fox.obj: its materials", 0), 0u);
  EXPECT_NE(model.warnings[1].find("points and lines"), std::string::npos);
  EXPECT_NE(model.warnings[2].find("no part of a mesh"), std::string::npos);
  EXPECT_TRUE(read("o fox\ng tail\ns 1\n" + kSquare + "f 1 2 3").warnings.empty());
}

TEST(ImportModel, KnowsTheFormatByContentThenByEndingThenByStatements) {
  const auto obj = textFile(kSquare + "f 1 2 3");
  const auto fo = textFile("v 0 0 0 0 0 1 1 0\nv 1 0 0 0 0 1 1 0\nv 0 1 0 0 0 1 1 0\nt 0 0 0 0\np 1/1 2/1 3/1\n");
  for (const char* name : {"fox.obj", "FOX.OBJ", "model", "a.b/fox"}) EXPECT_TRUE(importModel(obj, name)) << name;
  for (const char* name : {"fox.fo", "Fox.Fo", "model"}) EXPECT_TRUE(importModel(fo, name)) << name;
  const auto gltf = importModel(textFile(" {\"asset\":{}}"), "fox.obj");
  ASSERT_FALSE(gltf);
  EXPECT_NE(gltf.error().message.find("asset"), std::string::npos);
  const auto neither = importModel(textFile("hello"), "holiday.txt");
  ASSERT_FALSE(neither);
  EXPECT_EQ(neither.error().id, ErrorId::BadFile);
  EXPECT_EQ(neither.error().message.rfind("holiday.txt: ", 0), 0u);
}

TEST(ImportModel, GivesASurfaceThatCanCarryFur) {
  const Model model = read(kSquare + "f 1 2 3 4\nf 4 3 2 1\n");
  EXPECT_TRUE(geometry::buildSurface(model.mesh));
}

std::string box(float height) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += "v " + std::to_string(i & 1) + " " + std::to_string(height * static_cast<float>(i >> 1 & 1)) + " " + std::to_string(i >> 2) + "\n";
  for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) text += std::string("f ") + face + "\n";
  return text;
}

TEST(ImportObj, WithoutNormalsABoxHasThoseOfItsFacesAndNoOthers) {
  const Model model = read(box(1));
  EXPECT_EQ(model.mesh.positions.size(), 24u);
  for (std::size_t i = 0; i < model.mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return model.mesh.positions[model.mesh.indices[i + k]]; };
    const Vec3 face = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(glm::dot(model.mesh.normals[model.mesh.indices[i + k]], face), 0.9999f);
  }
}

TEST(ImportObj, WithoutNormalsWhatIsRoundStaysSmoothAndAPlaneAppearsOnce) {
  // A roof of 50 degrees between its sides is round.
  const Model roof = read("v -1 0 0\nv -1 0 1\nv 0 0.4663 0\nv 0 0.4663 1\nv 1 0 0\nv 1 0 1\nf 1 2 4 3\nf 3 4 6 5\n");
  EXPECT_EQ(roof.mesh.positions.size(), 6u);
  const Model steep = read("v -1 0 0\nv -1 0 1\nv 0 0.7 0\nv 0 0.7 1\nv 1 0 0\nv 1 0 1\nf 1 2 4 3\nf 3 4 6 5\n");
  EXPECT_EQ(steep.mesh.positions.size(), 8u);
}

}  // namespace
}  // namespace fur::scene
