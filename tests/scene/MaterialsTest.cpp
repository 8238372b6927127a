// Several materials of a glTF file: what is read of them, and which are bare.
#include <gtest/gtest.h>

#include "core/Random.h"
#include "scene/Model.h"
#include "tests/scene/GltfBuilder.h"

namespace fur::scene {
namespace {

Material named(const char* name, AlphaMode alpha = AlphaMode::Opaque) {
  Material material;
  material.name = name;
  material.alpha = alpha;
  return material;
}

// Of two materials, the first of which is furry by its name.
bool guessedBare(const char* name, AlphaMode alpha = AlphaMode::Opaque) {
  std::vector<Material> materials{named("Body"), named(name, alpha)};
  guessBare(materials);
  EXPECT_FALSE(materials[0].bare);
  return materials[1].bare;
}

TEST(GuessBare, EyesClawsAndClothesAreBareByTheirNames) {
  for (const char* name : {"Eyes", "eye_L", "LeftEye", "MAT_eyeball.001", "Claws", "toenails", "Teeth", "Nose", "collar", "ClothShirt", "Hooves", "Tag"})
    EXPECT_TRUE(guessedBare(name)) << name;
}

TEST(GuessBare, OtherNamesAndThoseThatSpeakOfFurAreFurry) {
  for (const char* name : {"", "Material.001", "Paws", "Ears", "Head", "EyebrowFur", "fur_collar", "Coat", "Stage", "Heyes", "\xff\xfe"})
    EXPECT_FALSE(guessedBare(name)) << name;
}

TEST(GuessBare, WhatOneSeesThroughIsBareUnlessItsNameSpeaksOfFur) {
  EXPECT_TRUE(guessedBare("Material.002", AlphaMode::Blend));
  EXPECT_FALSE(guessedBare("Material.002", AlphaMode::Mask));
  EXPECT_FALSE(guessedBare("Mane", AlphaMode::Blend));
}

TEST(GuessBare, NoModelIsBareAllOver) {
  std::vector<Material> materials{named("Eyes"), named("Claws")};
  guessBare(materials);
  EXPECT_FALSE(materials[0].bare || materials[1].bare);
}

// Two triangles, the second of material 1.
TriangleFile two(const std::string& materials) {
  TriangleFile file;
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0},{"attributes":{"POSITION":0},"indices":1,"material":1})";
  file.top = R"("materials":[)" + materials + "],";
  return file;
}

TEST(GltfMaterials, EachVertexKnowsItsMaterialInTheOrderInWhichTheyAreUsed) {
  TriangleFile file = two(R"({"name":"Eyes"},{"name":"Body"})");
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":1},{"attributes":{"POSITION":0},"indices":1,"material":0},{"attributes":{"POSITION":0},"indices":1})";
  auto model = importGltf(file.build(), "two.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->materialOf, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1, 2, 2, 2}));
  ASSERT_EQ(model->materials.size(), 3u);
  EXPECT_EQ(model->materials[0].name, "Body");
  EXPECT_EQ(model->materials[0].source, 1);
  EXPECT_TRUE(model->materials[1].bare);
  EXPECT_EQ(model->materials[2].source, -1);
  EXPECT_FALSE(model->materials[2].bare);
}

TEST(GltfMaterials, AreReadWithAllThatTheirLookNeeds) {
  TriangleFile file = two(R"({},{"name":"Eyes","pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.25,"roughnessFactor":0.5},
    "emissiveFactor":[1,0.5,0],"alphaMode":"MASK","alphaCutoff":0.3,"doubleSided":true})");
  auto model = importGltf(file.build(), "two.glb");
  ASSERT_TRUE(model) << model.error().message;
  const Material &plain = model->materials[0], &eyes = model->materials[1];
  EXPECT_EQ(plain.metallic, 1);
  EXPECT_EQ(plain.roughness, 1);
  EXPECT_EQ(plain.alpha, AlphaMode::Opaque);
  EXPECT_EQ(eyes.baseColor, Vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(eyes.metallic, 0.25f);
  EXPECT_EQ(eyes.roughness, 0.5f);
  EXPECT_EQ(eyes.emissive, Vec3(1, 0.5f, 0));
  EXPECT_EQ(eyes.alpha, AlphaMode::Mask);
  EXPECT_EQ(eyes.alphaCutoff, 0.3f);
  EXPECT_TRUE(eyes.doubleSided);
  EXPECT_EQ(eyes.baseColorTexture.image, -1);
}

// Materials whose textures are images that did not come along.
std::string textured(const char* more) {
  return R"({},{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0},{"source":7},{}],"images":[{"uri":"gone.png"}],"samplers":[)" + std::string(more);
}

TEST(GltfMaterials, ImagesThatDidNotComeAlongAreAWarningAndTheMaterialKeepsItsFactors) {
  auto model = importGltf(two(textured("")).build(), "two.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->warnings, Warnings{"the image file \"gone.png\" did not come along"});
  EXPECT_TRUE(model->images.empty());
}

TEST(GltfMaterials, WhatIsWrongIsAnErrorThatNamesTheMaterial) {
  const std::pair<const char*, const char*> wrong[] = {
      {R"({},{"normalTexture":{"index":1}}],"textures":[{"source":0}],"images":[{}],"samplers":[)", "textures[1]"},
      {R"({},{"normalTexture":7}],"samplers":[)", "materials[1].normalTexture"},
      {R"({},{"emissiveTexture":{}}],"samplers":[)", "materials[1].emissiveTexture"},
      {R"({},{"emissiveFactor":[1,"red",0]}],"samplers":[)", "materials[1]"},
      {R"({},7],"samplers":[)", "materials"},
  };
  for (const auto& [materials, names] : wrong) {
    auto model = importGltf(two(materials).build(), "two.glb");
    ASSERT_FALSE(model) << materials;
    EXPECT_EQ(model.error().id, ErrorId::BadFile) << materials;
    EXPECT_NE(model.error().message.find(names), std::string::npos) << model.error().message;
  }
}

TEST(GltfMaterials, NumbersOutOfBoundsAreBroughtIntoThem) {
  auto model = importGltf(two(R"({},{"pbrMetallicRoughness":{"metallicFactor":1e30,"roughnessFactor":-4},"alphaCutoff":-1,"alphaMode":"GLOW","emissiveFactor":[9,-9,0]})").build(), "two.glb");
  ASSERT_TRUE(model) << model.error().message;
  const Material& material = model->materials[1];
  EXPECT_EQ(material.metallic, 1);
  EXPECT_EQ(material.roughness, 0);
  EXPECT_EQ(material.alphaCutoff, 0);
  EXPECT_EQ(material.alpha, AlphaMode::Opaque);
  EXPECT_EQ(material.emissive, Vec3(1, 0, 0));
}

TEST(GltfMaterials, MoreThanTheLimitAreKeptTogetherAndNamed) {
  TriangleFile file;
  file.primitive.clear();
  std::string materials;
  constexpr int kCount = 300;
  for (int i = 0; i < kCount; ++i) {
    file.primitive += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0},"indices":1,"material":)" + std::to_string(i) + "}";
    materials += std::string(i ? "," : "") + "{}";
  }
  file.top = R"("materials":[)" + materials + "],";
  auto model = importGltf(file.build(), "many.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->materials.size(), kMostMaterials);
  EXPECT_EQ(model->materials.back().triangles, kCount - kMostMaterials + 1);
  EXPECT_EQ(model->mesh.triangleCount(), static_cast<std::size_t>(kCount));
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("255"), std::string::npos);
}

// A PNG as far as its size.
FileBytes sizedPng(std::uint32_t width, std::uint32_t height) {
  FileBytes bytes{137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  for (const std::uint32_t side : {width, height})
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(side >> shift));
  bytes.insert(bytes.end(), {8, 6, 0, 0, 0, 0, 0, 0, 0, 0});
  return bytes;
}

TEST(GltfMaterials, ImagesOverTheLimitTogetherAreLeftOutByName) {
  const FileSet others{{"a.png", sizedPng(8192, 4096)}, {"b.png", sizedPng(8192, 4096)}, {"c.png", sizedPng(8, 8)}};
  auto model = importGltf(two(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},{"pbrMetallicRoughness":{"baseColorTexture":{"index":1}},"normalTexture":{"index":2}}],
    "textures":[{"source":0},{"source":1},{"source":2}],"images":[{"uri":"a.png"},{"uri":"b.png"},{"uri":"c.png"}],"samplers":[)").build(), "big.glb", others);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->images.size(), 2u);
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("c.png"), std::string::npos);
  EXPECT_NE(model->warnings[0].find("67108864"), std::string::npos);
}

TEST(GltfMaterials, OneImageOfSeveralMaterialsIsKeptOnce) {
  const FileSet others{{"a.png", sizedPng(8, 8)}};
  auto model = importGltf(two(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},{"pbrMetallicRoughness":{"baseColorTexture":{"index":1}}}],
    "textures":[{"source":0},{"source":0,"sampler":0}],"images":[{"uri":"a.png"}],"samplers":[{"wrapS":33071,"wrapT":33071})").build(), "one.glb", others);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model->images.size(), 1u);
  EXPECT_EQ(model->materials[1].baseColorTexture.image, 0);
  EXPECT_EQ(model->materials[0].baseColorTexture.wrapS, kWrapRepeat);
  EXPECT_EQ(model->materials[1].baseColorTexture.wrapS, kWrapClamp);
}

TEST(GltfMaterials, PicturesMayLieByTwoSetsOfCoordinates) {
  const FileSet others{{"a.png", sizedPng(8, 8)}};
  TriangleFile file = two(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}},
    {"normalTexture":{"index":0},"emissiveTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":{"scale":[2,3]}}},"occlusionTexture":{"index":0,"texCoord":2}}],
    "textures":[{"source":0}],"images":[{"uri":"a.png"}],"samplers":[)");
  file.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":3},"indices":1,"material":0},{"attributes":{"POSITION":0,"TEXCOORD_0":2,"TEXCOORD_1":3},"indices":1,"material":1})";
  const std::size_t from = file.binary().size();
  appendValues(file.more, std::vector<float>{0, 0, 1, 0, 0, 1, 0.5f, 0.25f, 0.75f, 0.25f, 0.5f, 0.125f});
  for (std::size_t i = 0; i < 2; ++i) {
    file.moreViews += R"(,{"buffer":0,"byteOffset":)" + std::to_string(from + 24 * i) + R"(,"byteLength":24})";
    file.moreAccessors += R"(,{"bufferView":)" + std::to_string(2 + i) + R"(,"componentType":5126,"count":3,"type":"VEC2"})";
  }
  auto model = importGltf(file.build(), "sets.glb", others);
  ASSERT_TRUE(model) << model.error().message;
  // Of a furry part its picture counts, by whichever set that lies.
  EXPECT_EQ(model->mesh.uv[1], Vec2(0.75f, 0.25f));
  EXPECT_EQ(model->mesh.uv[4], Vec2(1, 0));
  EXPECT_EQ(model->mesh.otherUv[1], Vec2(0)) << "it has one";
  EXPECT_EQ(model->mesh.otherUv[4], Vec2(0.75f, 0.25f));
  const Material& second = model->materials[1];
  EXPECT_FALSE(second.normalTexture.other);
  EXPECT_TRUE(second.emissiveTexture.other);
  EXPECT_EQ(Vec2(second.emissiveTexture.transform * Vec3(1, 1, 1)), Vec2(2, 3));
  EXPECT_EQ(second.occlusionTexture.image, -1);
  ASSERT_EQ(model->warnings.size(), 1u);
  EXPECT_NE(model->warnings[0].find("third set"), std::string::npos) << model->warnings[0];
  const geometry::Surface surface = geometry::buildSurface(model->mesh).value();
  for (const geometry::SurfaceVertex& vertex : surface.vertices)
    if (vertex.source < model->mesh.otherUv.size()) EXPECT_EQ(vertex.otherUv, model->mesh.otherUv[vertex.source]);
}

TEST(GltfMaterials, PicturesGoOnBeyondEachEdgeAsTheirSamplerSays) {
  const FileSet others{{"a.png", sizedPng(8, 8)}};
  const auto wrapsOf = [&](const std::string& sampler) {
    auto model = importGltf(two(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},{}],"textures":[{"source":0,"sampler":0}],"images":[{"uri":"a.png"}],"samplers":[)" + sampler).build(), "one.glb", others);
    EXPECT_TRUE(model) << model.error().message;
    const MaterialTexture& texture = model->materials[0].baseColorTexture;
    return std::pair(texture.wrapS, texture.wrapT);
  };
  EXPECT_EQ(wrapsOf("{}"), std::pair(kWrapRepeat, kWrapRepeat));
  EXPECT_EQ(wrapsOf(R"({"wrapS":33648,"wrapT":33071})"), std::pair(kWrapMirror, kWrapClamp));
  EXPECT_EQ(wrapsOf(R"({"wrapS":1,"wrapT":4294967295})"), std::pair(kWrapRepeat, kWrapRepeat)) << "of no kind that glTF has";
}

TEST(GltfMaterials, AnyByteMayBeWrongWithoutMoreThanATypedError) {
  const FileSet others{{"a.png", sizedPng(8, 8)}};
  TriangleFile file = two(R"({"name":"Body","pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicFactor":0.5}},{"name":"Eyes","alphaMode":"BLEND","doubleSided":true,
    "normalTexture":{"index":1,"scale":2},"occlusionTexture":{"index":1,"strength":0.5},"emissiveTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.5,0],"scale":[2,2],"rotation":1}}}}],
    "textures":[{"source":0,"sampler":0},{"source":0}],"images":[{"uri":"a.png"}],"samplers":[{"wrapS":33071,"wrapT":33071})");
  file.top += R"("extensionsUsed":["WETFUR_fur"],"extensions":{"WETFUR_fur":{"version":2,"bare":[1]}},)";
  const FileBytes whole = file.build();
  ASSERT_TRUE(importGltf(whole, "whole.glb", others));
  const std::size_t from = 20, length = file.json().size();
  Random random(7);
  int opened = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    FileBytes bad = whole;
    // One byte or two of the JSON, mostly such as stand in it.
    for (std::uint32_t k = 0; k <= random.next() % 2; ++k) bad[from + random.next() % length] = random.next() % 4 ? bad[from + random.next() % length] : static_cast<std::uint8_t>(random.next());
    auto model = importGltf(bad, "bad.glb", others);
    if (!model) {
      EXPECT_FALSE(model.error().message.empty());
      ++refused;
      continue;
    }
    ++opened;
    for (const std::uint8_t material : model->materialOf) ASSERT_LT(material, model->materials.size());
    for (const Material& material : model->materials)
      for (const auto texture : {&Material::baseColorTexture, &Material::normalTexture, &Material::occlusionTexture, &Material::emissiveTexture})
        ASSERT_LT((material.*texture).image, static_cast<int>(model->images.size()));
  }
  EXPECT_GT(opened, 100);
  EXPECT_GT(refused, 100);
}

TriangleFile withBare(const std::string& bare) {
  TriangleFile file = two(R"({"name":"Body"},{"name":"Eyes"})");
  file.top += R"("extensionsUsed":["WETFUR_fur"],"extensions":{"WETFUR_fur":{"version":2,"bare":)" + bare + "}},";
  return file;
}

TEST(GltfMaterials, WhatTheFileSaysIsBareCountsMoreThanNames) {
  auto none = importGltf(withBare("[]").build(), "two.glb"), body = importGltf(withBare("[0,-1]").build(), "two.glb");
  ASSERT_TRUE(none && body);
  EXPECT_FALSE(none->materials[0].bare || none->materials[1].bare);
  EXPECT_TRUE(body->materials[0].bare);
  EXPECT_FALSE(body->materials[1].bare);
}

TEST(GltfMaterials, AWrongListOfBareOnesIsAnErrorThatNamesIt) {
  for (const char* bare : {"7", "[2]", "[-2]", "[0.5]", "[\"a\"]", "[null]", "[1e300]", "{}"}) {
    auto model = importGltf(withBare(bare).build(), "two.glb");
    ASSERT_FALSE(model) << bare;
    EXPECT_EQ(model.error().id, ErrorId::BadFile);
    EXPECT_NE(model.error().message.find("WETFUR_fur.bare"), std::string::npos) << model.error().message;
  }
  auto many = importGltf(withBare("[0,0,0,0,0]").build(), "two.glb");
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().id, ErrorId::TooLarge);
}

}  // namespace
}  // namespace fur::scene
