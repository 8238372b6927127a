// Groom and state of a scene in a .glb: there and back, and what strangers put there.
#include "scene/FurData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "geometry/Primitives.h"
#include "geometry/Surface.h"
#include "scene/Model.h"
#include "scene/PackBits.h"
#include "tests/scene/GltfBuilder.h"

namespace fur::scene {
namespace {

// A torus with an atlas, a map in which every channel differs, and a comb.
struct FurScene {
  geometry::Mesh mesh;
  FurData fur;
  FurScene() {
    geometry::Mesh torus = geometry::makeTorus();
    geometry::fitToUnitSphere(torus);
    const geometry::Surface surface = geometry::buildSurface(torus).value();
    mesh.indices = surface.indices;
    for (std::size_t i = 0; i < surface.trueVertexCount; ++i) {
      const auto& v = surface.vertices[i];
      mesh.positions.push_back(v.position);
      mesh.normals.push_back(v.normal);
      mesh.atlas.push_back(v.atlas);
      fur.comb.push_back(glm::cross(v.normal, Vec3(0, 1, 0)));
    }
    fur.mapSize = 32;
    for (int i = 0; i < 32 * 32; ++i)
      fur.map.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i % 50), static_cast<std::uint8_t>(i / 32), 7});
    fur.state = R"({"version":1,"settings":{"furLength":0.2}})";
  }
  std::vector<std::uint8_t> file() const { return exportScene(mesh, "torus", fur, {picture, factor}); }
  EncodedImage picture;
  Vec4 factor{1.0f};
};

TEST(FurData, GoesThroughAFile) {
  const FurScene scene;
  const auto model = importGltf(scene.file(), "torus.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model.value().warnings.empty());
  EXPECT_EQ(model.value().fur.map, scene.fur.map);
  EXPECT_EQ(model.value().fur.mapSize, 32);
  EXPECT_EQ(model.value().mesh.atlas, scene.mesh.atlas);
  EXPECT_EQ(model.value().fur.state, scene.fur.state);
  ASSERT_EQ(model.value().fur.comb.size(), scene.fur.comb.size());
  // A direction and a length instead of three numbers: rounding.
  for (std::size_t i = 0; i < scene.fur.comb.size(); ++i)
    ASSERT_LT(glm::length(model.value().fur.comb[i] - scene.fur.comb[i]), 1e-6f);
}

TEST(FurData, PaintMaskAndShapeGoThroughAFileWithAndWithoutAMap) {
  for (const bool hasMap : {true, false}) {
    FurScene scene;
    if (!hasMap) scene.fur.map.clear();
    for (int i = 0; i < 32 * 32; ++i) {
      scene.fur.paint.push_back({static_cast<std::uint8_t>(i), 200, 7, static_cast<std::uint8_t>(i / 5)});
      scene.fur.mask.push_back({0, 0, 0, static_cast<std::uint8_t>(i % 91)});
      scene.fur.shape.push_back({static_cast<std::uint8_t>(i % 7), 0, static_cast<std::uint8_t>(i), 255});
    }
    const auto model = importGltf(scene.file(), "torus.glb");
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(model.value().fur.paint, scene.fur.paint);
    EXPECT_EQ(model.value().fur.mask, scene.fur.mask);
    EXPECT_EQ(model.value().fur.shape, scene.fur.shape);
    if (hasMap) EXPECT_EQ(model.value().fur.map, scene.fur.map);
    else EXPECT_EQ(model.value().fur.map, std::vector<groom::GroomMap::Texel>(32 * 32, groom::GroomMap::kPlain));
    EXPECT_EQ(model.value().mesh.atlas, scene.mesh.atlas);
  }
}

TEST(FurData, KeepsItsAtlasBesideTheModelsOwnCoordinatesAndItsTile) {
  FurScene scene;
  for (const Vec3& p : scene.mesh.positions) scene.mesh.uv.emplace_back(p.x, p.y), scene.mesh.furUv.emplace_back(p.z, 2 * p.x);
  const auto model = importGltf(scene.file(), "torus.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().mesh.uv, scene.mesh.uv);
  EXPECT_EQ(model.value().mesh.furUv, scene.mesh.furUv);
  EXPECT_EQ(model.value().mesh.atlas, scene.mesh.atlas);
  // And the surface takes it.
  const auto surface = geometry::buildSurface(model.value().mesh);
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface.value().vertices[surface.value().indices[0]].atlas, scene.mesh.atlas[scene.mesh.indices[0]]);
}

TEST(FurData, BringsThePictureAndItsFactor) {
  FurScene scene;
  for (const Vec3& p : scene.mesh.positions) scene.mesh.uv.emplace_back(p.x, p.y);
  scene.factor = Vec4(0.5f, 0.25f, 1, 1);
  // The header of a PNG of 3 x 2 pixels, all that the importer looks at.
  const std::vector<std::uint8_t> png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0, 0, 0, 3, 0, 0, 0, 2, 8, 6, 0, 0, 0};
  scene.picture = {"image/png", png, 3, 2};
  const auto model = importGltf(scene.file(), "torus.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().baseColor().bytes, png);
  EXPECT_EQ(model.value().baseColor().width, 3);
  EXPECT_EQ(model.value().main().baseColor, scene.factor);
}

TEST(FurData, WhiskersStandWhereTheirModelIsFittedTo) {
  FurScene scene;
  groom::Whisker whisker;
  whisker.root = scene.mesh.positions[7];
  whisker.direction = Vec3(0, 0.6f, -0.8f);
  whisker.hairs = 5;
  whisker.seed = 0xfedcba98u;
  whisker.color = 0x336699;
  scene.fur.whiskers = {whisker, {}};
  const auto model = importGltf(scene.file(), "torus.glb");
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model.value().fur.whiskers.size(), 2u);
  groom::Whisker read = model.value().fur.whiskers[0];
  EXPECT_LT(glm::length(read.root - whisker.root), 1e-6f);
  read.root = whisker.root;
  EXPECT_EQ(read, whisker);
  // In a file of another size they stand at the same place of the model, and are as long as it is large.
  for (Vec3& p : scene.mesh.positions) p = 20.0f * p + Vec3(3, 0, -5);
  scene.fur.whiskers[0].root = scene.mesh.positions[7];
  const auto large = importGltf(scene.file(), "torus.glb");
  ASSERT_TRUE(large);
  EXPECT_LT(glm::length(large.value().fur.whiskers[0].root - large.value().mesh.positions[7]), 1e-5f);
  EXPECT_EQ(large.value().fur.whiskers[0].length, whisker.length);
}

TEST(FurData, WaterGoesThroughAFileAndIsRoundedOnce) {
  FurScene scene;
  scene.fur.wetnessSize = 64;
  scene.fur.wetness.assign(64 * 64, Vec4(0));
  for (std::size_t i = 1000; i < 3000; ++i)
    scene.fur.wetness[i] = Vec4(1.2f - 0.0007f * static_cast<float>(i), 0.3f, 0.04f, 0.0005f * static_cast<float>(i));
  const auto model = importGltf(scene.file(), "torus.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().fur.wetnessSize, 64);
  const std::vector<Vec4>& read = model.value().fur.wetness;
  ASSERT_EQ(read.size(), 64u * 64u);
  for (std::size_t i = 0; i < read.size(); ++i)
    for (int k = 0; k < 4; ++k)
      // Half a step of the number: an eighty-fifth of a texel of 512, and 1/32768 of what a coat holds.
      ASSERT_LT(std::abs(read[i][k] - scene.fur.wetness[i][k]), k < 2 ? 2.31e-5f : k < 3 ? 7.7e-6f : 3.1e-5f) << i;
  EXPECT_EQ(read[0], Vec4(0));
  const std::vector<Vec4> once = read;
  scene.fur.wetness = once;
  EXPECT_EQ(importGltf(scene.file(), "torus.glb").value().fur.wetness, once);
  // Saturated fur, and what lies on it.
  EXPECT_EQ(once[2000].w, 1.0f);
  EXPECT_GT(once[2999].w, 1.49f);
}

TEST(FurData, ADryOneSaysNothingOfWater) {
  const FurScene scene;
  const std::vector<std::uint8_t> file = scene.file();
  EXPECT_EQ(std::string(file.begin(), file.end()).find("wetness"), std::string::npos);
}

TEST(FurData, AFileWithoutItHasNone) {
  const auto model = importGltf(exportGlb(geometry::makeTorus(), "torus"), "torus.glb");
  ASSERT_TRUE(model);
  EXPECT_TRUE(model.value().fur.map.empty() && model.value().fur.comb.empty() && model.value().fur.state.empty());
  EXPECT_TRUE(model.value().fur.whiskers.empty());
  EXPECT_TRUE(model.value().mesh.atlas.empty());
}

// One triangle whose root says `extension`.
Result<Model> withExtension(const std::string& extension, const std::string& views = "", FileBytes more = {}) {
  TriangleFile file;
  file.top = "\"extensionsUsed\":[\"WETFUR_fur\"],\"extensions\":{\"WETFUR_fur\":" + extension + "},";
  file.moreViews = views;
  file.more = std::move(more);
  return importGltf(file.build(), "hostile.glb");
}

TEST(FurData, HostileOnesAreTypedErrors) {
  const auto idOf = [](const Result<Model>& model) {
    EXPECT_FALSE(model);
    return model ? ErrorId::Network : model.error().id;
  };
  EXPECT_EQ(idOf(withExtension("7")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension("{}")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":"1"})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":3})")), ErrorId::UnsupportedVersion);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"state":[]})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"state":{"version":9}})")), ErrorId::UnsupportedVersion);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"groom":3})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"groom":{"size":1025,"bufferView":0,"texCoord":0}})")), ErrorId::TooLarge);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"groom":{"size":4e9,"bufferView":0,"texCoord":0}})")), ErrorId::TooLarge);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"groom":{"size":2,"bufferView":0,"texCoord":0}})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"groom":{"size":16,"bufferView":0,"texCoord":0}})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"groom":{"size":16,"bufferView":9,"texCoord":0}})")), ErrorId::BadFile);
  const FileBytes plain = packBits(FileBytes(4 * 256, 0));
  const std::string plainView = ",{\"buffer\":0,\"byteOffset\":44,\"byteLength\":" + std::to_string(plain.size()) + "}";
  for (const char* paint : {"0", "9", "-1", "\"2\""}) {
    const std::string groom = R"({"version":1,"groom":{"size":16,"bufferView":2,"texCoord":0,"paint":)" + std::string(paint) + "}}";
    EXPECT_EQ(idOf(withExtension(groom.c_str(), plainView, plain)), ErrorId::BadFile) << paint;
  }
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"wetness":3})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"wetness":{"size":2049,"bufferView":0,"texCoord":0}})")), ErrorId::TooLarge);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"wetness":{"size":1e30,"bufferView":0,"texCoord":0}})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"wetness":{"size":15,"bufferView":0,"texCoord":0}})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"wetness":{"size":16,"bufferView":0,"texCoord":0}})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"wetness":{"size":16,"bufferView":9,"texCoord":0}})")), ErrorId::BadFile);
  const auto waterOf = [](std::size_t bytes, const char* more) {
    const FileBytes packed = packBits(FileBytes(bytes, 0xff));
    const std::string view = ",{\"buffer\":0,\"byteOffset\":44,\"byteLength\":" + std::to_string(packed.size()) + "}";
    return withExtension(R"({"version":1,"wetness":{"size":16,"bufferView":2)" + std::string(more) + "}", view, packed);
  };
  EXPECT_EQ(idOf(waterOf(8 * 256 - 1, R"(,"texCoord":0})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(waterOf(8 * 256 + 1, R"(,"texCoord":0})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(waterOf(8 * 256, "}")), ErrorId::BadFile);
  EXPECT_EQ(idOf(waterOf(8 * 256, R"(,"texCoord":0},"groom":{"size":16,"bufferView":2,"texCoord":1})")), ErrorId::BadFile);
  const auto unplaced = waterOf(8 * 256, R"(,"texCoord":0})");
  ASSERT_TRUE(unplaced) << "a triangle without coordinates: left out with a warning";
  EXPECT_TRUE(unplaced.value().fur.wetness.empty());
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"whiskers":[]})")), ErrorId::BadFile);
  EXPECT_EQ(idOf(withExtension(R"({"version":1,"whiskers":{"bufferView":9}})")), ErrorId::BadFile);
  const auto whiskersOf = [](std::size_t bytes) {
    const std::string view = ",{\"buffer\":0,\"byteOffset\":44,\"byteLength\":" + std::to_string(bytes) + "}";
    return withExtension(R"({"version":1,"whiskers":{"bufferView":2}})", view, FileBytes(bytes, 0xff));
  };
  EXPECT_EQ(idOf(whiskersOf(51)), ErrorId::BadFile);
  EXPECT_EQ(idOf(whiskersOf(513 * 52)), ErrorId::TooLarge);
  EXPECT_TRUE(whiskersOf(512 * 52)) << "what is in them is judged where the surface is known";
}

TEST(FurData, AMapWithoutCoordinatesOfItsOwnIsLeftOutWithAWarning) {
  const FileBytes packed = packBits(FileBytes(4 * 16 * 16, 3));
  const std::string view = ",{\"buffer\":0,\"byteOffset\":44,\"byteLength\":" + std::to_string(packed.size()) + "}";
  const auto model = withExtension(R"({"version":1,"groom":{"size":16,"bufferView":2,"texCoord":3}})", view, packed);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model.value().fur.map.empty());
  ASSERT_EQ(model.value().warnings.size(), 1u);
  EXPECT_NE(model.value().warnings[0].find("groom"), std::string::npos);
}

}  // namespace
}  // namespace fur::scene
