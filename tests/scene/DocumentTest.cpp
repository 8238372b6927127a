// A glTF document that is saved with fur on it comes back whole, and so does the fur.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geometry/Surface.h"
#include "scene/Model.h"
#include "tests/scene/Tentacle.h"

namespace fur::scene {
namespace {

using Document = nlohmann::json;

[[maybe_unused]] const bool documentReadsHair = (readLongHair(), true);

std::size_t word(const FileBytes& bytes, std::size_t at) {
  return bytes[at] | std::size_t{bytes[at + 1]} << 8 | std::size_t{bytes[at + 2]} << 16 | std::size_t{bytes[at + 3]} << 24;
}
std::string jsonOf(const FileBytes& glb) { return {glb.begin() + 20, glb.begin() + 20 + static_cast<std::ptrdiff_t>(word(glb, 12))}; }
FileBytes binaryOf(const FileBytes& glb) {
  const auto first = glb.begin() + 28 + static_cast<std::ptrdiff_t>(word(glb, 12));
  return {first, first + static_cast<std::ptrdiff_t>(word(glb, 20 + word(glb, 12)))};
}

// Where what came before is not there any more as it was: paths. What has been added is not told.
void compare(const Document& before, const Document& after, const std::string& path, Warnings& out) {
  if (before.type() != after.type() || (!before.is_structured() && before != after)) return out.push_back(path);
  if (!before.is_structured()) return;
  if (before.is_array() && after.size() < before.size()) return out.push_back(path);
  for (const auto& [key, value] : before.items()) {
    const std::string below = path + "/" + key;
    if (before.is_object() && !after.contains(key)) out.push_back(below);
    else compare(value, before.is_object() ? after[key] : after[std::stoul(key)], below, out);
  }
}
Warnings lost(const FileBytes& before, const FileBytes& after) {
  Warnings out;
  compare(Document::parse(jsonOf(before)), Document::parse(jsonOf(after)), "", out);
  const FileBytes from = binaryOf(before), to = binaryOf(after);
  if (to.size() < from.size() || !std::equal(from.begin(), from.end(), to.begin())) out.push_back("the binary chunk");
  return out;
}

// A model that moves, with every kind of thing in its document, some of which nobody has heard of.
FileBytes furnished() {
  Tentacle tentacle;
  tentacle.attributes = R"("POSITION":0,"NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3,"_HEAT":6,"COLOR_0":3)";
  std::string json = jsonOf(tentacle.build());
  const auto replace = [&](const std::string& what, const std::string& with) {
    const std::size_t at = json.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    json.replace(at, what.size(), with);
  };
  replace(R"({"asset":{"version":"2.0"})", R"({"asset":{"version":"2.0","generator":"another","copyright":"2026 \u00e4 \ud83d\ude00","extras":{"a":1,"b":1.0,"big":9007199254740993,"tiny":1e-300,"negative":-0.0}},
    "extras":{"":null,"a \"b\" \\ \/ \n":[true,{},[]],"name":"x"},
    "extensionsUsed":["KHR_lights_punctual","EXT_unheard_of","KHR_materials_variants"],
    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","name":"sun","intensity":2,"extras":{}}]},
                  "EXT_unheard_of":{"deep":{"deeper":[1,2.5,"three",{"bufferView":1}]}},"KHR_materials_variants":{"variants":[{"name":"midnight"}]},"EXT_empty":{}},
    "unknownKey":{"at":"the root"},
    "cameras":[{"type":"perspective","name":"front","perspective":{"yfov":1,"znear":0.1,"extras":7},"extensions":{"EXT_unheard_of":{}}}],
    "images":[{"uri":"data:image/png;base64,iVBORw0KGgo=","name":"inside","extras":{"of":"an image"}}],
    "samplers":[{"magFilter":9728,"wrapS":33071,"extras":{"s":1}}],"textures":[{"sampler":0,"source":0,"extensions":{"KHR_texture_basisu":{"source":0}}}],
    "materials":[{"name":"Fur","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.1,1],"metallicFactor":0,"roughnessFactor":0.3,"extras":{"p":1}},"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true,
                  "emissiveFactor":[0,0,1]},{"name":"eye","extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1}}}])");
  replace(R"("scenes":[{"nodes":[0,1]}])", R"("scenes":[{"nodes":[0,1],"name":"first","extras":{"s":[]}},{"nodes":[1],"name":"second"}])");
  replace(R"("nodes":[{"mesh":0,"skin":0})", R"("nodes":[{"mesh":0,"skin":0,"name":"\u540d\u524d \/","camera":0,"weights":[0.0,0.25],"extensions":{"KHR_lights_punctual":{"light":0}},"extras":{"n":0}})");
  replace(R"("primitives":[)", R"("name":"tube","weights":[0,0],"extras":{"targetNames":["a","b"]},"primitives":[)");
  replace(R"(]}],"skins":[)", R"(,{"attributes":{"POSITION":0},"mode":0,"material":1,"targets":[{"POSITION":9},{"POSITION":9}]}]}],"skins":[)");
  // One accessor is another with some of its values replaced.
  const std::size_t end = json.find(R"(],"bufferViews":)");
  json.insert(end, R"(,{"componentType":5126,"type":"VEC3","count":4,"bufferView":0,"sparse":{"count":1,"extras":1,"indices":{"bufferView":4,"componentType":5123},"values":{"bufferView":1,"extras":{}}}})");
  return glb(json, binaryOf(tentacle.build()));
}

FurSurface surfaceOf(const Model& model) { return furSurface(geometry::buildSurface(model.mesh).value(), model.mesh); }

// All that fur has, on a model in its own space.
FurData furOn(const Model& model) {
  FurData fur;
  fur.state = R"({"version":1,"settings":{"furLength":0.2}})";
  fur.mapSize = 32;
  for (int i = 0; i < 32 * 32; ++i) fur.map.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i % 50), 3, 7});
  fur.paint = fur.mask = fur.shape = fur.map;
  for (const Vec3& n : model.mesh.normals) fur.comb.push_back(0.3f * glm::cross(n, Vec3(0.6f, 0.8f, 0)));
  fur.whiskers.resize(1);
  fur.whiskers[0].root = model.mesh.positions[2];
  fur.wetnessSize = 16;
  fur.wetness.assign(16 * 16, Vec4(0.5f, 0.25f, 0.1f, 0.75f));
  for (int i = 0; i < 1001; ++i) fur.water.push_back(static_cast<std::uint8_t>(i < 500 ? 0 : i));
  fur.coats[0].typeSet = {1, 2, 3, 4, 5};
  fur.hair.scalps.resize(1);
  fur.hair.scalps[0].map = groom::GroomMap(32, groom::GroomMap::kBlank);
  fur.hair.bodies = {{Vec3(0.1f, 0.2f, 0.3f), Vec3(0.3f), 0.25f, model.rig.moves() ? 2 : -1}, {Vec3(0), Vec3(0), 0.5f, -1}};
  return fur;
}

struct Saved {
  SourceFile source;
  FurData fur;
  FileBytes bytes;
};
Saved saved(SourceFile source) {
  auto model = importGltf(source.bytes, source.name, source.others);
  EXPECT_TRUE(model) << model.error().message;
  Saved out{std::move(source), furOn(*model), {}};
  out.bytes = kDocumentKeeping.write(out.source, surfaceOf(*model), out.fur);
  return out;
}

TEST(Document, ComesBackWithEverythingThatWasInIt) {
  const Saved file = saved({"fox.glb", furnished(), {}});
  EXPECT_TRUE(kDocumentKeeping.keep(file.source.bytes, "fox.glb", {}));
  EXPECT_EQ(kDocumentKeeping.beside(file.source), Warnings{});
  EXPECT_EQ(lost(file.source.bytes, file.bytes), Warnings{"/buffers/0/byteLength"});
  // To the digit.
  for (const char* text : {R"("b":1.0)", "9007199254740993", "1e-300", "-0.0", R"(\ud83d\ude00)", R"("\u540d\u524d \/")", R"("":null)"})
    EXPECT_NE(jsonOf(file.bytes).find(text), std::string::npos) << text;
}

TEST(Document, ChunksOfAGlbThatNobodyKnowsStay) {
  FileBytes bytes = furnished(), chunk;
  append32(chunk, 8);
  append32(chunk, 0x52545845);  // "EXTR"
  for (int i = 1; i <= 8; ++i) chunk.push_back(static_cast<std::uint8_t>(i));
  bytes.insert(bytes.end(), chunk.begin(), chunk.end());
  for (unsigned k = 0; k < 4; ++k) bytes[8 + k] = static_cast<std::uint8_t>(bytes.size() >> 8 * k);
  const Saved file = saved({"fox.glb", bytes, {}});
  EXPECT_TRUE(std::equal(chunk.begin(), chunk.end(), file.bytes.end() - static_cast<std::ptrdiff_t>(chunk.size())));
  EXPECT_EQ(word(file.bytes, 8), file.bytes.size());
}

TEST(Document, TheFurOnItComesBackToTheBit) {
  const Saved file = saved({"fox.glb", furnished(), {}});
  const auto before = importGltf(file.source.bytes, "fox.glb");
  const auto after = importGltf(file.bytes, "saved.glb");
  ASSERT_TRUE(after) << after.error().message;
  const Model &a = before.value(), &b = after.value();
  EXPECT_EQ(b.warnings, a.warnings);
  EXPECT_EQ(b.mesh.positions, a.mesh.positions);
  EXPECT_EQ(b.mesh.normals, a.mesh.normals);
  EXPECT_EQ(b.rig.animations.size(), 2u);
  EXPECT_EQ(b.rig.deltas, a.rig.deltas);
  EXPECT_EQ(b.fur.state, file.fur.state);
  for (const auto map : {&FurData::map, &FurData::paint, &FurData::mask, &FurData::shape}) EXPECT_EQ(b.fur.*map, file.fur.*map);
  EXPECT_EQ(b.fur.comb, file.fur.comb);
  EXPECT_EQ(b.fur.whiskers[0].root, file.fur.whiskers[0].root);
  EXPECT_EQ(b.fur.water, file.fur.water);
  EXPECT_EQ(b.fur.coats[0].typeSet, file.fur.coats[0].typeSet);
  ASSERT_EQ(b.fur.hair.bodies.size(), 2u);
  EXPECT_EQ(b.fur.hair.bodies[0].a, file.fur.hair.bodies[0].a);
  EXPECT_EQ(b.rig.nodes[static_cast<std::size_t>(b.fur.hair.bodies[0].bone)].source, 2u) << "it goes with the same node";
  EXPECT_EQ(b.fur.hair.bodies[1].bone, -1);
  const geometry::Surface of = geometry::buildSurface(a.mesh).value(), then = geometry::buildSurface(b.mesh).value();
  EXPECT_EQ(then.indices, of.indices);
  ASSERT_EQ(then.vertices.size(), of.vertices.size());
  for (std::size_t i = 0; i < of.vertices.size(); ++i) {
    ASSERT_EQ(then.vertices[i].atlas, of.vertices[i].atlas);
    ASSERT_EQ(then.vertices[i].chart, of.vertices[i].chart);
    ASSERT_EQ(then.vertices[i].fur, of.vertices[i].fur);
  }
}

TEST(Document, DoesNotGrowWhenItIsSavedAgain) {
  const Saved once = saved({"fox.glb", furnished(), {}});
  EXPECT_EQ(saved({"fox.glb", once.bytes, {}}).bytes, once.bytes);
  FurData nothing;
  auto model = importGltf(once.bytes, "fox.glb");
  const FileBytes bare = kDocumentKeeping.write({"fox.glb", once.bytes, {}}, surfaceOf(*model), nothing);
  EXPECT_EQ(lost(once.source.bytes, bare), Warnings{"/buffers/0/byteLength"});
  EXPECT_LT(bare.size(), once.bytes.size());
}

// Buffers and images beside a .gltf.
TEST(Document, OfSeveralFilesBecomesOne) {
  TriangleFile triangle;
  triangle.top = R"("images":[{"uri":"a%20picture.png"},{"uri":"other.ktx2"},{"uri":"gone.png"}],)";
  triangle.buffer = R"({"byteLength":44,"uri":"first.bin","name":"one"},{"byteLength":4,"uri":"second.bin","extras":{"e":1}},{"byteLength":4,"uri":"data:;base64,AQIDBA=="},{"byteLength":9,"uri":"absent.bin"})";
  const FileBytes png = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0};
  const Saved file = saved({"fox.gltf", textBytes(triangle.json()), {{"first.bin", triangle.binary()}, {"second.bin", {9, 8, 7, 6}}, {"a picture.png", png}, {"other.ktx2", {1, 2}}}});
  const Document after = Document::parse(jsonOf(file.bytes));
  EXPECT_EQ(after["buffers"][0].value("uri", ""), "");
  EXPECT_EQ(after["buffers"][0]["name"], "one");
  EXPECT_EQ(after["buffers"][1]["uri"], "data:application/octet-stream;base64,CQgHBg==");
  EXPECT_EQ(after["buffers"][1]["extras"]["e"], 1);
  EXPECT_EQ(after["buffers"][2]["uri"], "data:;base64,AQIDBA==");
  EXPECT_EQ(after["buffers"][3]["uri"], "absent.bin");
  const Document& view = after["bufferViews"][after["images"][0]["bufferView"].get<std::size_t>()];
  const FileBytes binary = binaryOf(file.bytes);
  EXPECT_TRUE(std::equal(png.begin(), png.end(), binary.begin() + view["byteOffset"].get<std::ptrdiff_t>()));
  EXPECT_EQ(after["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(kDocumentKeeping.beside(file.source), (Warnings{"the buffer file \"absent.bin\", which stays beside it", "the image file \"other.ktx2\", which stays beside it",
                                                            "the image file \"gone.png\", which stays beside it"}));
  const auto opened = importGltf(file.bytes, "saved.glb");
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened.value().fur.water, file.fur.water);
}

TEST(Document, WhoseFirstBufferIsNotThereGetsFurAllTheSame) {
  TriangleFile triangle;
  std::string json = triangle.json();
  const std::string views = R"("bufferViews":[{"buffer":0)";
  for (std::size_t at; (at = json.find(R"({"buffer":0)")) != std::string::npos;) json.replace(at, 11, R"({"buffer":1)");
  json.replace(json.find(R"("buffers":[)"), 11, R"("buffers":[{"byteLength":400,"extensions":{"EXT_meshopt_compression":{"fallback":true}}},)");
  json.replace(json.rfind(R"({"byteLength":44})"), 17, R"({"byteLength":44,"uri":"second.bin"})");
  const Saved once = saved({"fox.gltf", textBytes(json), {{"second.bin", triangle.binary()}}});
  EXPECT_EQ(Document::parse(jsonOf(once.bytes))["buffers"].size(), 3u);
  const auto opened = importGltf(once.bytes, "saved.glb");
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened.value().fur.water, once.fur.water);
  EXPECT_EQ(saved({"fox.glb", once.bytes, {}}).bytes, once.bytes);
}

TEST(Document, ThatSomebodyHasChangedOpensWithoutTheFurAndWithAWarning) {
  const Saved file = saved({"fox.glb", furnished(), {}});
  Document after = Document::parse(jsonOf(file.bytes));
  after["meshes"][0]["primitives"].push_back(after["meshes"][0]["primitives"][0]);
  const auto model = importGltf(glb(after.dump(), binaryOf(file.bytes)), "changed.glb");
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(model.value().warnings.back(), "groom, wetness and hair are left out: the model is another than when they were saved");
  EXPECT_TRUE(model.value().fur.map.empty() && model.value().fur.water.empty() && model.value().fur.hair.empty());
  EXPECT_FALSE(model.value().fur.state.empty());
}

TEST(Document, HostileFurIsRefusedByNameAndLimit) {
  const Saved file = saved({"fox.glb", furnished(), {}});
  const Document good = Document::parse(jsonOf(file.bytes));
  const auto with = [&](const char* pointer, const Document& value) {
    Document bad = good;
    bad["extensions"]["WETFUR_fur"][Document::json_pointer(pointer)] = value;
    const auto model = importGltf(glb(bad.dump(), binaryOf(file.bytes)), "bad.glb");
    return model ? "read" : std::string(model.error().message);
  };
  EXPECT_EQ(with("/surface", 1), "bad.glb: WETFUR_fur.surface is not an object");
  EXPECT_EQ(with("/surface/indices", 9999), "bad.glb: bufferViews[9999] is used, but there are " + std::to_string(good["bufferViews"].size()));
  EXPECT_EQ(with("/surface/charts", good["extensions"]["WETFUR_fur"]["surface"]["indices"]).find("bad.glb: WETFUR_fur.surface.charts has "), 0u);
  EXPECT_EQ(with("/surface/atlas", 0).find("bad.glb: WETFUR_fur.surface.charts has "), 0u);
  EXPECT_EQ(with("/surface/comb", 4).find("bad.glb: WETFUR_fur.surface.comb has "), 0u);
  EXPECT_EQ(with("/water", 1), "bad.glb: WETFUR_fur.water is not an object");
  EXPECT_EQ(with("/water/bytes", 1e9), "bad.glb: WETFUR_fur.water.bytes is 1000000000; the limit is 16777216");
  EXPECT_EQ(with("/water/bytes", 77), "bad.glb: WETFUR_fur.water does not hold 77 bytes");
  EXPECT_EQ(with("/typeSet", -1).find("bad.glb: WETFUR_fur.typeSet"), 0u);
  EXPECT_EQ(with("/hair/bones", {1}), "bad.glb: WETFUR_fur.hair.bones does not have 2 numbers");
  EXPECT_EQ(with("/hair/bones", {1, 900}), "bad.glb: WETFUR_fur.hair.bones[1] is no node of the file");
  EXPECT_EQ(with("/version", 3), "bad.glb: WETFUR_fur has version 3; this program reads up to 2");
  // Any one byte of what says where the fur is.
  for (const char* key : {"indices", "charts", "atlas"}) {
    const Document& view = good["bufferViews"][good["extensions"]["WETFUR_fur"]["surface"][key].get<std::size_t>()];
    FileBytes binary = binaryOf(file.bytes);
    for (int k = 0; k < 8; ++k) binary[view["byteOffset"].get<std::size_t>() + static_cast<std::size_t>(k)] = 0xff;
    const auto model = importGltf(glb(good.dump(), binary), "bad.glb");
    EXPECT_TRUE(!model || model.value().warnings.back().find("left out") != std::string::npos) << key;
  }
}

TEST(Document, AViewThatSomethingElseUsesStays) {
  const Saved file = saved({"fox.glb", furnished(), {}});
  Document after = Document::parse(jsonOf(file.bytes));
  const std::size_t last = after["bufferViews"].size() - 1;
  after["extras"]["bufferView"] = last;
  const Document again = Document::parse(jsonOf(saved({"fox.glb", glb(after.dump(), binaryOf(file.bytes)), {}}).bytes));
  EXPECT_EQ(again["bufferViews"][last], after["bufferViews"][last]);
}

TEST(Document, WhatThisProgramWroteOfAMeshIsWrittenAnew) {
  auto model = importGltf(furnished(), "fox.glb");
  const FileBytes ours = exportScene(model->mesh, "fox", {}, {{}, Vec4(1)});
  EXPECT_FALSE(kDocumentKeeping.keep(ours, "fox.glb", {}));
  Document changed = Document::parse(jsonOf(ours));
  changed["animations"] = Document::array();
  EXPECT_TRUE(kDocumentKeeping.keep(glb(changed.dump(), binaryOf(ours)), "fox.glb", {}));
}

}  // namespace
}  // namespace fur::scene
