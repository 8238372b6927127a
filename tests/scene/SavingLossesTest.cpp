// What a saved scene will be without is told in words.
#include <gtest/gtest.h>

#include "geometry/Primitives.h"
#include "scene/GltfBuilder.h"
#include "scene/Model.h"

namespace fur::scene {
namespace {

Warnings lost(const FileBytes& bytes) {
  auto model = importGltf(bytes, "fox.glb");
  EXPECT_TRUE(model) << model.error().message;
  return model ? lostBySaving(*model, bytes, {}) : Warnings{};
}

TEST(SavingLosses, APlainFileHasNone) { EXPECT_EQ(lost(TriangleFile().build()), Warnings{}); }

// Nobody who wants the furry model back would miss any of it.
TEST(SavingLosses, AnOrdinaryModelOfAnotherProgramHasNone) {
  TriangleFile file;
  file.asset = R"({"version":"2.0","generator":"another"})";
  file.top = R"("materials":[{"name":"Fur","doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"roughnessFactor":0.5}}],
    "textures":[{"sampler":0}],"samplers":[{}],)";
  file.scene = R"("scene":0,"scenes":[{"name":"Scene","nodes":[0]}],)";
  file.nodes = R"([{"name":"root","children":[1]},{"name":"fox","mesh":0}])";
  file.primitive = R"({"attributes":{"POSITION":0,"TANGENT":0,"TEXCOORD_0":2,"TEXCOORD_1":2},"indices":1,"material":0})";
  file.moreAccessors = R"(,{"componentType":5126,"count":3,"type":"VEC2"})";
  EXPECT_EQ(lost(file.build()), Warnings{});
}

TEST(SavingLosses, WhatThisProgramSavedHasNone) {
  geometry::Mesh plane = geometry::makePlane(2);
  plane.atlas = plane.uv;
  FurData fur;
  fur.state = R"({"version":1})";
  fur.mapSize = 16;
  fur.map = fur.paint = fur.mask = fur.shape = std::vector<groom::GroomMap::Texel>(16 * 16, {9, 8, 7, 6});
  fur.whiskers.resize(2);
  fur.comb.assign(plane.positions.size(), Vec3(0.5f, 0, 0));
  EXPECT_EQ(lost(exportScene(plane, "another name", fur, {{}, Vec4(0.5f, 0.5f, 0.5f, 1)})), Warnings{});
}

// Two materials, a skin, animations, morph targets, cameras, a light, extras, extensions.
TriangleFile everything() {
  TriangleFile file;
  file.asset = R"({"version":"2.0","generator":"another","copyright":"2026 somebody","extras":{"a":1}})";
  file.top = R"("extensionsUsed":["KHR_lights_punctual","EXT_unheard_of"],
    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","name":"sun"}]},"EXT_other":{"extras":{}}},
    "materials":[{"name":"Fur","doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"metallicFactor":0,"roughnessFactor":0.5}},
                 {"extensions":{"KHR_materials_clearcoat":{}}}],
    "skins":[{"joints":[1]}],
    "animations":[{"name":"walk\nwith a very long name that nobody would ever want to read","channels":[],"samplers":[]},{"name":"run","channels":[],"samplers":[]},{"name":"sit","channels":[],"samplers":[]}],
    "cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1}},{"type":"perspective","perspective":{"yfov":1,"znear":1}}],
    "textures":[{"sampler":0}],"samplers":[{}],)";
  file.scene = R"("scene":0,"scenes":[{"nodes":[0,1]},{"nodes":[1]}],)";
  file.nodes = R"([{"mesh":0,"extras":{}},{"camera":0,"name":"bone"}])";
  file.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":0,"TANGENT":0,"TEXCOORD_0":2,"TEXCOORD_1":2,"_HEAT":0},"indices":1,"material":0,
    "targets":[{"POSITION":0},{"POSITION":0}]},{"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"indices":1,"material":0})";
  file.moreAccessors = R"(,{"componentType":5126,"count":3,"type":"VEC2"})";
  return file;
}

TEST(SavingLosses, AreToldWithCountsAndNames) {
  const Warnings expected = {
      "1 of 2 scenes", "1 primitive of points or lines", "1 of 2 materials", "the vertex data \"_HEAT\"", "vertex colours", "1 skin",
      "3 animations (\"walk with a very long name that nobody w...\", \"run\" and 1 more)", "2 morph targets", "2 cameras", "the light \"sun\"",
      "the copyright notice \"2026 somebody\"",
      "extras of 2 objects", "the extension \"EXT_other\"", "the extension \"EXT_unheard_of\"", "the extension \"KHR_materials_clearcoat\""};
  EXPECT_EQ(lost(everything().build()), expected);
}

// Each of them is gone when the scene has been saved: nothing is told that is kept.
TEST(SavingLosses, AreNoneOnceTheFileHasBeenSaved) {
  auto model = importGltf(everything().build(), "fox.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(lost(exportScene(model->mesh, "fox", model->fur, {model->baseColor, model->baseColorFactor})), Warnings{});
}

TEST(SavingLosses, AreNotAskedOfOtherFormats) {
  const FileBytes text = textBytes("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  auto model = importModel(text, "fox.obj");
  ASSERT_TRUE(model);
  EXPECT_EQ(lostBySaving(*model, text, {}), Warnings{});
}

}  // namespace
}  // namespace fur::scene
