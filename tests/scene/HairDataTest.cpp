// Long hair in a .glb: there and back, and what strangers put there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "AllocatedBytes.h"
#include "core/Random.h"
#include "geometry/Primitives.h"
#include "scene/Model.h"
#include "scene/PackBits.h"
#include "scene/import/GltfHair.h"
#include "tests/scene/GltfBuilder.h"

namespace fur::scene {
namespace {

[[maybe_unused]] const bool readsAll = (readLongHair(), readAllFormats(), true);

// A plane with an atlas and two scalps, one of them still without guides.
struct HairScene {
  HairScene() {
    geometry::fitToUnitSphere(mesh);
    mesh.atlas = std::move(mesh.uv);
    mesh.uv.clear();
    hair::Scalp mane;
    mane.name = "the \"mane\"";
    mane.values.wisps = 77, mane.values.curve = 1, mane.values.guideLength = 0.25f, mane.values.rootColor = 0x123456;
    mane.map = groom::GroomMap(32, groom::GroomMap::kBlank);
    for (std::uint32_t i = 0; i < 32 * 32; ++i) mane.map.set(i, {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 32), 200, 7});
    mane.guides.nodes = 5;
    mane.guides.flags = {0, hair::kStatic, hair::kHidden};
    for (int i = 0; i < 15; ++i) mane.guides.positions.emplace_back(0.1f * static_cast<float>(i / 5), 0.05f * static_cast<float>(i % 5), 0.3f);
    for (int i = 0; i < 15; ++i) mane.wetness.push_back(static_cast<std::uint8_t>(17 * i));
    fur.hair.scalps = {mane, {}};
    fur.hair.bodies = {{Vec3(0.1f, 0.2f, 0.3f), Vec3(0.1f, 0.2f, 0.3f), 0.5f}, {Vec3(0), Vec3(1, 0, 0), 0.25f}};
  }
  Result<Model> throughAFile() const { return importModel(exportScene(mesh, "plane", fur, {picture, Vec4(1)}), "plane.glb"); }

  geometry::Mesh mesh = geometry::makePlane(2);
  FurData fur{};
  EncodedImage picture;
};

void expectSame(const hair::Hairstyle& read, const hair::Hairstyle& written, float off) {
  ASSERT_EQ(read.scalps.size(), written.scalps.size());
  for (std::size_t i = 0; i < read.scalps.size(); ++i) {
    EXPECT_EQ(read.scalps[i].name, written.scalps[i].name);
    EXPECT_EQ(read.scalps[i].values, written.scalps[i].values);
    EXPECT_EQ(read.scalps[i].map.texels(), written.scalps[i].map.texels());
    EXPECT_EQ(read.scalps[i].guides.nodes, written.scalps[i].guides.nodes);
    EXPECT_EQ(read.scalps[i].guides.flags, written.scalps[i].guides.flags);
    EXPECT_EQ(read.scalps[i].wetness, written.scalps[i].wetness);
    ASSERT_EQ(read.scalps[i].guides.positions.size(), written.scalps[i].guides.positions.size());
    for (std::size_t k = 0; k < read.scalps[i].guides.positions.size(); ++k)
      EXPECT_LT(glm::distance(read.scalps[i].guides.positions[k], written.scalps[i].guides.positions[k]), off);
  }
  ASSERT_EQ(read.bodies.size(), written.bodies.size());
  for (std::size_t i = 0; i < read.bodies.size(); ++i) {
    EXPECT_LT(glm::distance(read.bodies[i].a, written.bodies[i].a) + glm::distance(read.bodies[i].b, written.bodies[i].b), 2 * off);
    EXPECT_NEAR(read.bodies[i].radius, written.bodies[i].radius, off);
  }
}

// The model is fitted once more: a rounding.
constexpr float kRounding = 1e-6f;

TEST(HairData, GoesThroughAFile) {
  HairScene scene;
  auto model = scene.throughAFile();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->warnings.empty());
  expectSame(model->fur.hair, scene.fur.hair, kRounding);
  EXPECT_EQ(model->mesh.atlas, scene.mesh.atlas);
  // Beside coordinates of the model's own it has the second set.
  scene.mesh.uv.assign(scene.mesh.positions.size(), Vec2(0.5f));
  auto beside = scene.throughAFile();
  ASSERT_TRUE(beside) << beside.error().message;
  expectSame(beside->fur.hair, scene.fur.hair, kRounding);
}

TEST(HairData, IsAsLargeAsTheModelThatItGrowsOn) {
  const HairScene unit;
  for (const float scale : {20.0f, 3e4f, 1e-5f}) {
    HairScene scene;
    const Vec3 aside = scale * Vec3(3, 0, -5);
    const auto moved = [&](Vec3& p) { p = scale * p + aside; };
    for (Vec3& p : scene.mesh.positions) moved(p);
    for (Vec3& p : scene.fur.hair.scalps[0].guides.positions) moved(p);
    for (hair::Body& body : scene.fur.hair.bodies) moved(body.a), moved(body.b), body.radius *= scale;
    auto model = scene.throughAFile();
    ASSERT_TRUE(model) << model.error().message;
    // Places six radii from the origin are rounded for those.
    expectSame(model->fur.hair, unit.fur.hair, 6 * kRounding);
  }
}

TEST(HairData, AModelWithoutAnySaysNothingOfIt) {
  HairScene scene;
  scene.fur.hair = {};
  const std::vector<std::uint8_t> file = exportScene(scene.mesh, "plane", scene.fur, {scene.picture, Vec4(1)});
  EXPECT_EQ(std::string(file.begin(), file.end()).find("hair"), std::string::npos);
  EXPECT_TRUE(importModel(file, "plane.glb")->fur.hair.scalps.empty());
}

// --- hostile files ---

// A triangle with the hair of a text, and with bytes as bufferViews: 2 is a map of 16 x 16 texels, 3 and on are `views`.
struct HairyFile {
  std::string scalp = R"({"map":{"size":16,"bufferView":2}})", hair, groom;
  std::vector<FileBytes> views;

  FileBytes build() const {
    TriangleFile file;
    const std::string said = hair.empty() ? R"({"scalps":[)" + scalp + R"(],"texCoord":0})" : hair;
    file.top = R"("extensionsUsed":["WETFUR_fur"],"extensions":{"WETFUR_fur":{"version":1)" + groom + R"(,"hair":)" + said + "}},";
    std::vector<FileBytes> all = views;
    all.insert(all.begin(), packBits(FileBytes(4 * 256, 3)));
    for (const FileBytes& view : all) {
      while (file.more.size() % 4) file.more.push_back(0);
      file.moreViews += R"(,{"buffer":0,"byteOffset":)" + std::to_string(44 + file.more.size()) + R"(,"byteLength":)" + std::to_string(view.size()) + "}";
      file.more.insert(file.more.end(), view.begin(), view.end());
    }
    // Coordinates of its own for the map.
    while (file.more.size() % 4) file.more.push_back(0);
    const std::size_t at = 44 + file.more.size();
    appendValues<float>(file.more, {0, 0, 1, 0, 0, 1});
    file.moreViews += R"(,{"buffer":0,"byteOffset":)" + std::to_string(at) + R"(,"byteLength":24})";
    file.moreAccessors = R"(,{"bufferView":)" + std::to_string(2 + all.size()) + R"(,"componentType":5126,"count":3,"type":"VEC2"})";
    file.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1})";
    return file.build();
  }
  Result<Model> read() const { return importGltf(build(), "hostile.glb"); }
};

void expectHairError(const HairyFile& file, ErrorId id, const std::string& message) {
  const FileBytes bytes = file.build();
  const std::size_t before = allocatedBytes();
  auto model = importGltf(bytes, "hostile.glb");
  ASSERT_FALSE(model) << "imported; expected " << message;
  EXPECT_EQ(model.error().id, id);
  EXPECT_EQ(model.error().message, "hostile.glb: " + message);
  // Of any map that is too large nothing is made.
  EXPECT_LT(allocatedBytes() - before, (std::size_t{1} << 20) + 100 * bytes.size());
}
void expectBadHair(const HairyFile& file, const std::string& message) { expectHairError(file, ErrorId::BadFile, message); }

// `count` guides with these positions and as many flags.
HairyFile withGuides(std::size_t count, const std::vector<float>& positions, const char* nodes = "4") {
  HairyFile file;
  file.scalp = R"({"map":{"size":16,"bufferView":2},"guides":{"nodes":)" + std::string(nodes) + R"(,"positions":3,"flags":4}})";
  file.views.resize(2);
  appendValues(file.views[0], positions);
  file.views[1].assign(count, 0);
  return file;
}

HairyFile withBodies(const std::vector<float>& numbers, const std::string& view = "3") {
  HairyFile file;
  file.hair = R"({"scalps":[],"bodies":)" + view + R"(,"texCoord":0})";
  file.views.resize(1);
  appendValues(file.views[0], numbers);
  return file;
}

TEST(HairData, ATriangleOfHairIsReadWhereNothingIsWrong) {
  auto model = withGuides(1, {0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3}).read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->warnings.empty());
  ASSERT_EQ(model->fur.hair.scalps.size(), 1u);
  EXPECT_EQ(model->fur.hair.scalps[0].guides.count(), 1u);
  EXPECT_EQ(model->fur.hair.scalps[0].values, hair::HairValues{});
  EXPECT_EQ(withBodies({0, 0, 0, 0, 0, 1, 0.5f}).read()->fur.hair.bodies.size(), 1u);
}

TEST(HairData, ScalpsThatAreNoneAreNamed) {
  HairyFile file;
  const auto says = [&](const char* hair, const std::string& message) {
    file.hair = hair;
    expectBadHair(file, message);
  };
  says("7", "WETFUR_fur.hair is not an object");
  says("[]", "WETFUR_fur.hair is not an object");
  says("{}", "WETFUR_fur.hair.scalps is not an array");
  says(R"({"scalps":{},"texCoord":0})", "WETFUR_fur.hair.scalps is not an array");
  says(R"({"scalps":[3],"texCoord":0})", "WETFUR_fur.hair.scalps[0] is not an object");
  says(R"({"scalps":[{}],"texCoord":0})", "WETFUR_fur.hair.scalps[0].map is not an object");
  says(R"({"scalps":[{"values":[]}],"texCoord":0})", "WETFUR_fur.hair.scalps[0].values is not an object");
  says(R"({"scalps":[]})", "WETFUR_fur.hair.texCoord is missing");
  says(R"({"scalps":[],"texCoord":-1})", "WETFUR_fur.hair.texCoord is not a whole number");
  const std::string scalp = HairyFile().scalp;
  std::string nine = scalp;
  for (int i = 0; i < 8; ++i) nine += "," + scalp;
  file = {};
  file.scalp = nine;
  expectHairError(file, ErrorId::TooLarge, "WETFUR_fur.hair has 9 scalps; the limit is 8");
  file.scalp = nine.substr(scalp.size() + 1);
  EXPECT_EQ(file.read()->fur.hair.scalps.size(), 8u);
  file.scalp = scalp + R"(,{"map":7})";
  expectBadHair(file, "WETFUR_fur.hair.scalps[1].map is not an object");
}

TEST(HairData, MapsOfAnotherSizeAreNamed) {
  HairyFile file;
  const auto says = [&](const std::string& map, const std::string& message) {
    file.scalp = R"({"map":)" + map + "}";
    expectBadHair(file, "WETFUR_fur.hair.scalps[0].map" + message);
  };
  says(R"({"size":17,"bufferView":2})", " does not hold a map of 17 x 17 texels");
  says(R"({"size":15,"bufferView":2})", ".size is 15; a map has 16 to 1024");
  says(R"({"size":1025,"bufferView":2})", ".size is 1025; a map has 16 to 1024");
  says(R"({"size":4294967312,"bufferView":2})", ".size is 4294967312; a map has 16 to 1024");
  says(R"({"bufferView":2})", ".size is missing");
  says(R"({"size":16})", ".bufferView is missing");
  says(R"({"size":16,"bufferView":0})", " does not hold a map of 16 x 16 texels");
}

TEST(HairData, GuidesThatDoNotAddUpAreNamed) {
  const std::vector<float> two(2 * 4 * 3, 1);
  const std::string where = "WETFUR_fur.hair.scalps[0].guides";
  expectBadHair(withGuides(2, two, "1"), where + ".nodes is 1; a guide has 4 to 32");
  expectBadHair(withGuides(2, two, "33"), where + ".nodes is 33; a guide has 4 to 32");
  expectBadHair(withGuides(2, two, "1.5"), where + ".nodes is not a whole number");
  expectBadHair(withGuides(2, two, "5"), where + ".positions does not hold 2 guides of 5 nodes");
  expectBadHair(withGuides(3, two), where + ".positions does not hold 3 guides of 4 nodes");
  expectBadHair(withGuides(2, std::vector<float>(two.begin(), two.end() - 1)), where + ".positions does not hold 2 guides of 4 nodes");
  expectBadHair(withGuides(1, two), where + ".positions does not hold 1 guides of 4 nodes");
  expectHairError(withGuides(1025, std::vector<float>(1025 * 12, 0)), ErrorId::TooLarge, where + " has 1025 guides; the limit is 1024");
  EXPECT_TRUE(withGuides(1024, std::vector<float>(1024 * 12, 0)).read());
  HairyFile file;
  file.scalp = R"({"map":{"size":16,"bufferView":2},"guides":[]})";
  expectBadHair(file, where + " is not an object");
  file.scalp = R"({"map":{"size":16,"bufferView":2},"guides":{"nodes":4,"positions":2}})";
  expectBadHair(file, where + ".flags is missing");
  file = withGuides(2, two);
  const std::size_t end = file.scalp.rfind("}}");
  ASSERT_NE(end, std::string::npos);
  file.scalp.insert(end, ",\"wetness\":2");
  expectBadHair(file, where + ".wetness does not hold a byte for each of 8 nodes");
}

TEST(HairData, GuidesLeadToPlacesAroundTheModel) {
  const std::string where = "WETFUR_fur.hair.scalps[0].guides.positions";
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    std::vector<float> guide(12, 0);
    guide[7] = bad;
    expectBadHair(withGuides(1, guide), where + " has a number that is not finite");
  }
  std::vector<float> far{0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3e38f};
  expectBadHair(withGuides(1, far), where + " leads farther from the model than 1000000 times its radius");
}

TEST(HairData, GuidesOfNoLengthGetSome) {
  auto model = withGuides(2, std::vector<float>(24, 0.25f)).read();
  ASSERT_TRUE(model) << model.error().message;
  const hair::Guides& guides = model->fur.hair.scalps[0].guides;
  ASSERT_EQ(guides.count(), 2u);
  for (std::size_t g = 0; g < 2; ++g)
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(glm::distance(guides.of(g)[i], guides.of(g)[i - 1]), 0.0f);
}

TEST(HairData, BodiesThatAreNotSoundAreNamed) {
  const std::string where = "WETFUR_fur.hair.bodies";
  const std::vector<float> good{0, 0, 0, 0, 0, 1, 0.5f};
  for (const char* view : {"\"3\"", "-1", "1.5", "1e300", "[]"}) expectBadHair(withBodies(good, view), where + " is not a whole number");
  expectBadHair(withBodies({0, 0, 0, 0, 0, 1}), where + " does not hold up to 64 bodies of 28 bytes");
  expectHairError(withBodies(std::vector<float>(65 * 7, 1)), ErrorId::TooLarge, where + " does not hold up to 64 bodies of 28 bytes");
  EXPECT_EQ(withBodies(std::vector<float>(64 * 7, 1)).read()->fur.hair.bodies.size(), 64u);
  for (std::size_t at = 0; at < 7; ++at)
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
      std::vector<float> two = good;
      two.insert(two.end(), good.begin(), good.end());
      two[7 + at] = bad;
      expectBadHair(withBodies(two), where + "[1] has a number that is not finite, or no radius");
    }
  for (const float radius : {0.0f, -1.0f}) {
    std::vector<float> none = good;
    none[6] = radius;
    expectBadHair(withBodies(none), where + "[0] has a number that is not finite, or no radius");
  }
  for (const std::size_t at : {1, 6}) {
    std::vector<float> large = good;
    large[at] = 1e9f;
    expectBadHair(withBodies(large), where + "[0] is larger or farther from the model than 1000 times its radius");
  }
}

TEST(HairData, HasTheCoordinatesOfTheGroom) {
  HairyFile file;
  file.groom = R"(,"groom":{"size":16,"bufferView":2,"texCoord":1})";
  expectBadHair(file, "WETFUR_fur.hair has another texCoord than the maps before it");
  file.groom = R"(,"groom":{"size":16,"bufferView":2,"texCoord":0})";
  EXPECT_TRUE(file.read());
}

TEST(HairData, WithoutCoordinatesForItsMapsItIsLeftOutWithAWarning) {
  HairyFile file;
  file.hair = R"({"scalps":[)" + file.scalp + R"(],"texCoord":3})";
  auto model = file.read();
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->fur.hair.scalps.empty());
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("hair"), std::string::npos);
}

TEST(HairData, ValuesOutOfRangeAreClampedAndUnknownOnesSkippedWithAWarning) {
  HairyFile file;
  file.scalp = R"({"map":{"size":16,"bufferView":2},"values":{"wisps":1e9,"curl":-4,"nodes":"many","combed":1,"rootColor":"#102030"}})";
  auto model = file.read();
  ASSERT_TRUE(model) << model.error().message;
  const hair::HairValues& values = model->fur.hair.scalps[0].values;
  EXPECT_EQ(values.wisps, 4000);
  EXPECT_EQ(values.curl, 0.0f);
  EXPECT_EQ(values.nodes, hair::HairValues{}.nodes);
  EXPECT_EQ(values.rootColor, 0x102030u);
  std::string all;
  for (const std::string& warning : model->warnings) all += warning + "\n";
  for (const char* named : {"nodes", "combed"}) EXPECT_NE(all.find(named), std::string::npos) << all;
}

TEST(HairData, AProgramThatGrowsNoneSaysSoByTheErrorsId) {
  const HairReader* reader = hairReader();
  readHairWith(nullptr);
  const HairScene scene;
  auto model = scene.throughAFile();
  HairScene bald;
  bald.fur.hair = {};
  auto without = bald.throughAFile();
  readHairWith(reader);
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().id, ErrorId::LargerProgram);
  EXPECT_EQ(model.error().message, "plane.glb: it has long hair, which this program does not grow");
  EXPECT_TRUE(without);
}

TEST(HairData, MutatedFilesAreReadOrRefused) {
  const HairScene scene;
  const FileBytes good = exportScene(scene.mesh, "plane", scene.fur, {scene.picture, Vec4(1)});
  const std::uint32_t jsonEnd = 20 + (good[12] | static_cast<std::uint32_t>(good[13]) << 8);
  Random random(11);
  int read = 0;
  for (int round = 0; round < 1500; ++round) {
    FileBytes bytes = good;
    for (std::uint32_t n = 1 + random.next() % 3; n > 0; --n) {
      const std::uint32_t at = random.next() % (random.next() % 2 ? jsonEnd : static_cast<std::uint32_t>(bytes.size()));
      bytes[at] = static_cast<std::uint8_t>(random.next() % 2 ? "0123456789-\"[]{},:.e"[random.next() % 20] : static_cast<char>(random.next()));
    }
    auto model = importGltf(bytes, "mutant.glb");
    if (!model) continue;
    ++read;
    for (const hair::Scalp& scalp : model->fur.hair.scalps) {
      hair::Guides again = scalp.guides;
      EXPECT_TRUE(hair::makeSound(again));
      EXPECT_EQ(again, scalp.guides);
    }
  }
  EXPECT_GT(read, 50);  // some mutations hit only names or values
}

}  // namespace
}  // namespace fur::scene
