// .obj and .fo as the world may send them: each a typed error that names file, line and thing, in memory
// by the file's size, and no crash.
#include <gtest/gtest.h>

#include "AllocatedBytes.h"
#include "core/Random.h"
#include "geometry/Surface.h"
#include "scene/FoModel.h"
#include "scene/Model.h"
#include "scene/TextFile.h"

namespace fur::scene {
namespace {

const std::string kObj =
    "# a fox\nmtllib fox.mtl\no fox\nv -1 -1 0\nv 1 -1 0.5\nv 1 1e0 0\nv -1 1 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
    "vn 0 0 1\ng all\nusemtl red\ns off\nf 1/1/1 2/2/1 3/3/1\nf 1//1 3//1 4//1\nf -4 \\\n -3 -2 -1\n";
const std::string kFo =
    "v 0 0 0 0 0 1 1 0\nv 1 0 0 0 0 1 0.5 0\nv 0 1e0 0 0 0 1 1 2\nt 0 0 0 0\nt 1 0 2 0\nt 0 1 0 2\np 1/1 2/2 3/3\n";

void expectTextError(const std::string& text, ErrorId id, const std::string& message, const char* name) {
  const auto bytes = textFile(text);
  const std::size_t before = allocatedBytes();
  const auto model = importModel(bytes, name);
  ASSERT_FALSE(model) << "imported; expected " << message;
  EXPECT_EQ(model.error().id, id) << model.error().message;
  EXPECT_EQ(model.error().message.rfind(std::string(name) + message, 0), 0u) << model.error().message;
  EXPECT_LT(model.error().message.size(), 200u);
  // A corner of two bytes makes a triangle's three in a list that grows by doubling.
  EXPECT_LT(allocatedBytes() - before, (1u << 20) + 100 * bytes.size());
}

void expectBadObj(const std::string& text, const std::string& message) {
  expectTextError(text, ErrorId::BadFile, message, "fox.obj");
}
void expectBadFo(const std::string& text, const std::string& message) {
  expectTextError(text, ErrorId::BadFile, message, "fox.fo");
}

std::string vertices(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "v " + std::to_string(i) + " 0 1\n";
  return text;
}

TEST(ImportObj, NamesFileLineAndReasonOfANumberThatNoVertexHas) {
  expectBadObj(vertices(8) + "\n\n\nf 1 2 9\n", ", line 12: a face refers to vertex 9, but only 8 are defined so far");
  expectBadObj(vertices(3) + "f 1 2 0", ", line 4: a face refers to vertex 0; they are counted from 1");
  expectBadObj(vertices(3) + "f 1 2 -4", ", line 4: a face refers to vertex -4, but only 3");
  expectBadObj(vertices(3) + "f 1/1 2 3", ", line 4: a face refers to texture coordinate 1, but only 0");
  expectBadObj(vertices(3) + "f 1//2 2 3", ", line 4: a face refers to normal 2, but only 0");
  for (const char* huge : {"4294967297", "99999999999999999999999", "-99999999999999999999999", "-9223372036854775808"})
    expectBadObj(vertices(3) + "f 1 2 " + huge, ", line 4: a face refers to vertex ");
}

TEST(ImportObj, RejectsCornersThatAreNone) {
  for (const char* corner : {"1.5", "a", "/1", "1/2/3/4", "1/a", "--1", "1\\1", "+"})
    expectBadObj(vertices(3) + "vt 0 0\nvt 0 0\nvn 0 0 1\nf 2 3 " + corner + "\n", ", line 7: a face");
}

TEST(ImportObj, RejectsComponentsThatAreMissingOrNoNumbers) {
  expectBadObj("v 1 2\nv 1 2 3\n", ", line 1: the z of a vertex is missing");
  expectBadObj("v", ", line 1: the x of a vertex is missing");
  expectBadObj("vt 1\n", ", line 1: the v of a texture coordinate is missing");
  expectBadObj("vn 1 0\n", ", line 1: the z of a normal is missing");
  for (const char* number : {"nan", "NaN", "inf", "-infinity", "1,5", "0x10", ".", "-", "e5", "1e", "1e+", "1.2.3", "1-2"})
    expectBadObj(std::string("v 0 ") + number + " 0\n", ", line 1: the y of a vertex is \"");
  for (const char* number : {"1e39", "-1e39", "1e999999999999999999999", "2e38"})
    expectBadObj(std::string("v 0 ") + number + " 0\n", ", line 1: the y of a vertex is");
  expectBadObj("v 0 " + std::string(100'000, '9') + " 0\n", ", line 1: the y of a vertex is \"9999");
}

TEST(ImportObj, RejectsFacesOfFewerThanThreeCorners) {
  expectBadObj(vertices(3) + "f 1 2\n", ", line 4: a face has 2 corners; it needs 3");
  expectBadObj(vertices(3) + "f\n", ", line 4: a face has 0 corners; it needs 3");
}

TEST(ImportObj, RejectsFilesWithoutFaces) {
  expectBadObj("", ", line 1: the file ends without a face");
  expectBadObj("\n\n# nothing\n", ", line 4: the file ends without a face");
  expectBadObj(vertices(3), ", line 4: the file ends without a face");
  expectBadObj("hello world", ", line 1: the file ends without a face");
  expectBadObj("\\", ", line 1: the file ends without a face");
}

TEST(ImportObj, RejectsBinaryFiles) {
  expectBadObj(std::string("PK\x03\x04\0\0\0", 7), ", line 1: there is a zero byte");
  expectBadObj(std::string("\xff\xfev\0 \0" "1\0", 8), ", line 1: there is a zero byte");
  Random random(7);
  std::string rubbish;
  for (int i = 0; i < 100'000; ++i) rubbish += static_cast<char>(random.next());
  expectBadObj(rubbish, ", line ");
}

TEST(ImportObj, RefusesMoreThanItsLimits) {
  std::string faces = vertices(3);
  while (faces.size() < 40'000'000) faces += "f 1 2 3\n";
  expectTextError(faces, ErrorId::TooLarge, ", line 4000004: there are over 4000000 triangles", "fox.obj");
  std::string points;
  while (points.size() < 33'000'000) points += "v 1 2 3\n";
  expectTextError(points, ErrorId::TooLarge, ", line 4000001: there are over 4000000 vertices", "fox.obj");
  std::string polygon = vertices(3) + "f";
  while (polygon.size() < 10'000'000) polygon += " 1 2";
  expectTextError(polygon, ErrorId::TooLarge, ", line 4: there are over 4000000 triangles", "fox.obj");
}

TEST(ImportObj, TakesNoMemoryForWhatItDoesNotUse) {
  for (const char* piece : {"f\n", "#", " ", "\n", "\\\n", "o", "v 1 2 3 4 5 6 7 8\\\n", "x\n", "x "}) {
    std::string text;
    while (text.size() < 1'000'000) text += piece;
    const auto bytes = textFile(text);
    const std::size_t before = allocatedBytes();
    EXPECT_FALSE(importObj(bytes, "fox.obj"));
    EXPECT_LT(allocatedBytes() - before, 100'000u) << piece;
  }
}

TEST(ImportObj, KeepsCornersApartThatShareAPositionOrANormal) {
  // So many that a table by either alone would have to look at each for each.
  std::string onePosition = "v 0 0 0\n", oneNormal = "vn 0 0 1\n";
  constexpr int kCount = 200'000;
  for (int i = 0; i < kCount; ++i) onePosition += "vn 0 0 1\n", oneNormal += "v 0 0 0\n";
  onePosition += "f", oneNormal += "f";
  for (int i = 1; i <= kCount; ++i) {
    onePosition += " 1//" + std::to_string(i);
    oneNormal += " " + std::to_string(i) + "//1";
  }
  for (const std::string& text : {onePosition, oneNormal}) {
    const auto model = importObj(textFile(text), "fox.obj");
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model.value().mesh.positions.size(), std::size_t{kCount});
  }
}

TEST(ImportFo, RejectsWhatIsNotItsLayout) {
  expectBadFo("v 0 0 0 0 0 1 1\n", ", line 1: a fur type is missing");
  expectBadFo("v 0 0 0 0 0 1\n", ", line 1: a fur length is missing");
  expectBadFo("v 0 0 0 0 0 1 -0.5 0\n", ", line 1: a fur length is below 0");
  expectBadFo("v 0 0 0 0 0 1 nan 0\n", ", line 1: a fur length is \"nan\", which is not a number");
  expectBadFo("v 0 0 0 0 0 1 1 0.5\n", ", line 1: a fur type is \"0.5\", which is not a whole number");
  expectBadFo("v 0 0 0 0 0 1 1 2147483648\n", ", line 1: a fur type is \"2147483648\"");
  expectBadFo("v 0 0 0 0 0 1 1 0 7\n", ", line 1: the last word is \"7\", which is one too many");
  expectBadFo("t 0 0 0\n", ", line 1: a texture coordinate is missing");
  expectBadFo("\nf 1 2 3\n", ", line 2: the statement is \"f\", which is none of a .fo file");
  expectBadFo("", ", line 1: the file ends without a face");
  const std::string lists = kFo.substr(0, kFo.find("p "));
  expectBadFo(lists, ", line 7: the file ends without a face");
  expectBadFo(lists + "p 1/1 2/2\n", ", line 7: a face has fewer than 3 corners");
  expectBadFo(lists + "p 1/1 2/2 3/3 1/1\n", ", line 7: the last word is \"1/1\", which is one too many");
  expectBadFo(lists + "p 1/1 2/2 4/3\n", ", line 7: a face refers to vertex 4, but only 3 are defined so far");
  expectBadFo(lists + "p 1/1 2/2 3/4\n", ", line 7: a face refers to texture coordinate 4, but only 3");
  expectBadFo(lists + "p 1/1 2/2 -1/1\n", ", line 7: a face refers to vertex -1");
  for (const char* corner : {"1", "1/", "/1", "1//1", "1/1/1", "a/b"})
    expectBadFo(lists + "p 1/1 2/2 " + corner + "\n", ", line 7: a face's corner is \"");
}

// Changes, cuts and doubles pieces of a good file.
std::string spoilt(std::string text, Random& random) {
  static const char* const pieces[] = {"-", "/", "//", "\n", " ", "\\\n", "\r", "1e99", "0", "f", "v", "p", "#", "nan", "99999999999"};
  for (std::uint32_t i = 0, changes = 1 + random.next() % 8; i < changes && !text.empty(); ++i) {
    const std::size_t at = random.next() % text.size();
    switch (random.next() % 5) {
      case 0: text[at] = static_cast<char>(random.next()); break;
      case 1: text.erase(at, random.next() % 16); break;
      case 2: text.insert(at, pieces[random.next() % std::size(pieces)]); break;
      case 3: text.insert(at, text.substr(random.next() % text.size(), random.next() % 64)); break;
      default: text.resize(at); break;
    }
  }
  return text;
}

TEST(ImportText, SurvivesFilesThatAreSpoiltAtRandom) {
  Random random(20);
  int read = 0;
  for (int i = 0; i < 20'000; ++i) {
    const bool isObj = i % 2 == 0;
    const auto bytes = textFile(spoilt(isObj ? kObj : kFo, random));
    const auto model = importModel(bytes, isObj ? "fox.obj" : "fox.fo");
    if (!model) {
      ASSERT_EQ(model.error().message.rfind(isObj ? "fox.obj, line " : "fox.fo, line ", 0), 0u) << model.error().message;
      continue;
    }
    ++read;
    const geometry::Mesh& mesh = model.value().mesh;
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    for (const Vec3& p : mesh.positions) ASSERT_LE(glm::length(p), 1.001f);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  }
  EXPECT_GT(read, 500);  // the test is of the reader, not only of its first refusal
}

}  // namespace
}  // namespace fur::scene
