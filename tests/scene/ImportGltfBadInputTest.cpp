// What the world may send: each a typed error that names the file and the thing, in memory by the file's size, and no crash.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "AllocatedBytes.h"
#include "core/Random.h"
#include "geometry/Primitives.h"
#include "geometry/Surface.h"
#include "scene/GltfBuilder.h"
#include "scene/Model.h"

namespace fur::scene {
namespace {

// A value of the JSON takes some dozens of bytes where it may take two in the file.
constexpr std::size_t kAlways = 1 << 20, kAByte = 100;

void expectError(const FileBytes& bytes, ErrorId id, const std::string& named, const FileSet& others = {},
                 std::size_t most = kAlways) {
  const std::size_t before = allocatedBytes();
  const auto model = importGltf(bytes, "wolf.glb", others);
  ASSERT_FALSE(model) << "imported; expected an error about " << named;
  EXPECT_EQ(model.error().id, id) << model.error().message;
  EXPECT_EQ(model.error().message.rfind("wolf.glb: ", 0), 0u) << model.error().message;
  EXPECT_NE(model.error().message.find(named), std::string::npos) << model.error().message;
  EXPECT_LT(allocatedBytes() - before, most + kAByte * bytes.size());
}

void expectBad(const TriangleFile& file, const std::string& named) { expectError(file.build(), ErrorId::BadFile, named); }

TEST(ImportGltf, RejectsATruncatedGlbAtEveryLength) {
  const FileBytes whole = TriangleFile().build();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto model = importGltf(std::span(whole).first(length), "wolf.glb");
    ASSERT_FALSE(model) << length;
    EXPECT_EQ(model.error().id, ErrorId::BadFile) << length;
  }
  expectError({whole.begin(), whole.end() - 4}, ErrorId::BadFile, "truncated");
}

TEST(ImportGltf, RejectsAWrongMagic) {
  expectError(textBytes("PK\x03\x04 this is a zip file, is it not?"), ErrorId::BadFile, "neither a .glb nor");
  expectError({}, ErrorId::BadFile, "empty");
}

TEST(ImportGltf, RejectsAJsonChunkThatClaimsAHundredMegabytes) {
  FileBytes file = TriangleFile().build();
  const std::uint32_t claimed = 100u << 20;
  std::memcpy(&file[12], &claimed, 4);
  expectError(file, ErrorId::BadFile, "104857600");
}

TEST(ImportGltf, RejectsAnAccessorPastItsBuffer) {
  TriangleFile file;
  file.position = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";
  expectBad(file, "accessors[0]");
  file.position = R"({"bufferView":0,"byteOffset":4,"componentType":5126,"count":3,"type":"VEC3"})";
  expectBad(file, "accessors[0]");
  file.position = R"({"bufferView":0,"byteOffset":9007199254740992,"componentType":5126,"count":3,"type":"VEC3"})";
  expectBad(file, "accessors[0]");
}

TEST(ImportGltf, RejectsAViewPastItsBuffer) {
  TriangleFile file;
  for (const char* view : {R"({"buffer":0,"byteOffset":40,"byteLength":36})", R"({"buffer":0,"byteLength":45})",
                           R"({"buffer":0,"byteOffset":9007199254740992,"byteLength":9007199254740992})",
                           R"({"buffer":0,"byteOffset":4294967296,"byteLength":36})"}) {
    file.moreViews = std::string(",") + view;
    file.position = R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"})";
    expectBad(file, "bufferViews[2]");
  }
}

TEST(ImportGltf, RejectsCountsThatNothingBacks) {
  TriangleFile file;
  file.position = R"({"bufferView":0,"componentType":5126,"count":3999999,"type":"VEC3"})";
  expectBad(file, "accessors[0]");
  file.position = R"({"componentType":5126,"count":4000000000,"type":"VEC3"})";
  expectError(file.build(), ErrorId::TooLarge, "4000000");
  file.position = R"({"bufferView":0,"componentType":5126,"count":18446744073709551615,"type":"VEC3"})";
  expectBad(file, "count");
  file.position = R"({"bufferView":0,"componentType":5126,"count":-3,"type":"VEC3"})";
  expectBad(file, "count");
  file.position = R"({"bufferView":0,"componentType":5126,"count":1e400,"type":"VEC3"})";
  expectBad(file, "count");
}

TEST(ImportGltf, RejectsAnIndexPastTheVertexCount) {
  TriangleFile file;
  file.indices = {0, 1, 3, 0};
  expectBad(file, "index 3 is past the 3 vertices");
}

TEST(ImportGltf, RejectsFilesWithoutTriangles) {
  TriangleFile file;
  for (const char* primitive : {R"({"attributes":{"POSITION":0},"mode":1})", R"({"attributes":{}})",
                                R"({"attributes":{"POSITION":0},"mode":0})"}) {
    file.primitive = primitive;
    expectBad(file, "no triangles");
  }
  file = {};
  file.index = R"({"bufferView":1,"componentType":5123,"count":2,"type":"SCALAR"})";
  expectBad(file, "no triangles");
  file = {};
  file.nodes = "[{}]";
  expectBad(file, "no triangles");
  expectError(textBytes(R"({"asset":{"version":"2.0"}})"), ErrorId::BadFile, "no triangles");
}

TEST(ImportGltf, RejectsPositionsThatAreNotFinite) {
  for (const float value : {NAN, INFINITY, -INFINITY, 3e38f}) {
    TriangleFile file;
    file.positions[4] = value;
    expectBad(file, "position 1");
  }
  TriangleFile file;
  file.nodes = R"([{"mesh":0,"scale":[1e38,1e38,1e38],"children":[]}])";
  expectBad(file, "position");
}

TEST(ImportGltf, NamesAMissingExternalBuffer) {
  TriangleFile file;
  file.buffer = R"({"byteLength":44,"uri":"the%20mesh.bin"})";
  expectError(file.build(), ErrorId::BadFile, "the mesh.bin");
  expectError(file.build(), ErrorId::BadFile, "claims 44", {{"the mesh.bin", FileBytes(43)}});
}

TEST(ImportGltf, NamesAnExtensionThatItCannotRead) {
  for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu"}) {
    TriangleFile file;
    file.top = std::string(R"("extensionsRequired":[")") + extension + R"("],)";
    expectError(file.build(), ErrorId::UnsupportedVersion, extension);
  }
}

TEST(ImportGltf, RefusesOtherVersions) {
  TriangleFile file;
  for (const char* version : {"1.0", "1.1", "3.0", "20"}) {
    file.asset = std::string(R"({"version":")") + version + "\"}";
    expectError(file.build(), ErrorId::UnsupportedVersion, version);
  }
  FileBytes first = TriangleFile().build();
  first[4] = 1;
  expectError(first, ErrorId::UnsupportedVersion, "version 1");
  file.asset = "{}";
  expectBad(file, "asset.version");
}

TEST(ImportGltf, RejectsCyclesAndSharedNodes) {
  TriangleFile file;
  file.nodes = R"([{"children":[1]},{"children":[0],"mesh":0}])";
  expectBad(file, "nodes[0] is reached twice");
  file.nodes = R"([{"children":[1,1]},{"mesh":0}])";
  expectBad(file, "nodes[1] is reached twice");
  file.nodes = R"([{"children":[0]}])";
  expectBad(file, "nodes[0] is reached twice");
}

TEST(ImportGltf, ReadsAChainOfFiftyThousandNodesWithoutRecursion) {
  TriangleFile file;
  file.nodes = "[";
  for (int i = 1; i < 50000; ++i) file.nodes += R"({"children":[)" + std::to_string(i) + "]},";
  file.nodes += R"({"mesh":0}])";
  EXPECT_TRUE(importGltf(file.build(), "chain.glb"));
}

TEST(ImportGltf, RejectsReferencesToWhatIsNotThere) {
  TriangleFile file;
  file.scene = R"("scene":7,"scenes":[{"nodes":[0]}],)";
  expectBad(file, "scenes[7]");
  file = {};
  file.nodes = R"([{"mesh":5}])";
  expectBad(file, "meshes[5]");
  file = {};
  file.primitive = R"({"attributes":{"POSITION":9}})";
  expectBad(file, "accessors[9]");
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":3})";
  expectBad(file, "materials[3]");
  file = {};
  file.position = R"({"bufferView":9,"componentType":5126,"count":3,"type":"VEC3"})";
  expectBad(file, "bufferViews[9]");
  file = {};
  file.scene = R"("scenes":[{"nodes":[1e18]}],)";
  expectBad(file, "scenes[0].nodes");
}

TEST(ImportGltf, RejectsWrongTypes) {
  TriangleFile file;
  for (const char* position : {R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})",
                               R"({"bufferView":0,"componentType":5130,"count":3,"type":"VEC3"})",
                               R"({"bufferView":0,"componentType":"x","count":3,"type":"VEC3"})", "[]", "7", "null"}) {
    file.position = position;
    expectBad(file, "accessors[0]");
  }
  file = {};
  file.index = R"({"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR"})";
  expectBad(file, "accessors[1]");
  file = {};
  file.nodes = R"([{"mesh":0,"matrix":[1,2,3]}])";
  expectBad(file, "nodes[0].matrix");
  file.nodes = R"([{"mesh":0,"scale":[1,"2",3]}])";
  expectBad(file, "nodes[0].scale");
  for (const char* json : {"{", "{]", "{\"asset\":7}", "{\"asset\":{\"version\":\"2.0\"},\"nodes\":3}"}) {
    expectError(textBytes(json), ErrorId::BadFile, "");
  }
}

TEST(ImportGltf, RejectsBadStrides) {
  TriangleFile file;
  file.position = R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"})";
  for (const char* stride : {"4", "253", "4294967284", "-12"}) {
    file.moreViews = std::string(R"(,{"buffer":0,"byteLength":44,"byteStride":)") + stride + "}";
    expectBad(file, "tride");
  }
}

TEST(ImportGltf, RejectsSparseAccessorsThatReachOutside) {
  const auto sparse = [](const std::string& inside) {
    TriangleFile file;
    file.more = {1, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":12})";
    file.position = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":)" + inside + "}";
    return file;
  };
  const std::string values = R"(,"values":{"bufferView":2})";
  expectBad(sparse(R"({"count":4,"indices":{"bufferView":2,"componentType":5121})" + values + "}"), "4 of 3");
  expectBad(sparse(R"({"count":1,"indices":{"bufferView":2,"byteOffset":2,"componentType":5121})" + values + "}"),
            "element 9 of 3");
  expectBad(sparse(R"({"count":2,"indices":{"bufferView":2,"componentType":5121})" + values + "}"), "values");
  expectBad(sparse(R"({"count":1,"indices":{"bufferView":2,"componentType":5126})" + values + "}"), "sparse");
  expectBad(sparse(R"({"count":1})"), "sparse");
  expectBad(sparse("3"), "sparse");
}

TEST(ImportGltf, RefusesMoreVerticesThanTheLimitBeforeReadingThem) {
  TriangleFile file;
  file.position = R"({"componentType":5126,"count":3000000,"type":"VEC3"})";
  file.scene = R"("scenes":[{"nodes":[0,1]}],)";
  file.nodes = R"([{"mesh":0},{"mesh":0}])";
  file.primitive = R"({"attributes":{"POSITION":0},"mode":4,"indices":1})";
  // The first three millions are within the limit; each is a position, its normal and what they are read from.
  expectError(file.build(), ErrorId::TooLarge, "4000000", {}, 3'000'000 * 100);
}

TEST(ImportGltf, RefusesJsonOfTooManyValues) {
  std::string json = R"({"asset":{"version":"2.0"},"extras":[)";
  for (int i = 0; i < 1'100'000; ++i) json += "1,";
  expectError(textBytes(json + "1]}"), ErrorId::TooLarge, "1000000");
}

TEST(ImportGltf, RefusesAMeshThatIsPlacedTooOften) {
  TriangleFile file;
  file.nodes = "[";
  file.scene.clear();
  for (int i = 0; i < 400; ++i) file.nodes += R"({"mesh":0},)";
  file.nodes += R"({"mesh":0}])";
  for (int i = 1; i < 400; ++i) file.primitive += R"(,{"attributes":{},"mode":0})";
  // What each is called.
  expectError(file.build(), ErrorId::TooLarge, "100000 primitives", {}, 100'000 * 400);
}

TEST(ImportGltf, RefusesObjectsOfTooManyKeysWhereManyRefer) {
  std::string keys;
  for (int i = 0; i < 300; ++i) keys += ",\"k" + std::to_string(i) + "\":0";
  const auto with = [&](std::string json) { return json.insert(json.rfind('}'), keys); };
  TriangleFile file;
  file.position = with(file.position);
  expectError(file.build(), ErrorId::TooLarge, "accessors: an object has 304 keys; the limit is 256");
  file = {};
  file.primitive = with(file.primitive);
  expectError(file.build(), ErrorId::TooLarge, "meshes[0].primitives[0]");
  file = {};
  file.primitive = R"({"attributes":{"POSITION":0)" + keys + R"(},"indices":1})";
  expectError(file.build(), ErrorId::TooLarge, "attributes: an object has 301 keys");
  file = {};
  file.nodes = R"([{"mesh":0,"extras":{"a":0)" + keys + "}}]";  // nobody looks into those
  EXPECT_TRUE(importGltf(file.build(), "wolf.glb"));
}

TEST(ImportGltf, DoesNotReadAttributesThatCannotBelongToTheirPrimitive) {
  TriangleFile file;
  file.moreAccessors = R"(,{"componentType":5126,"count":3999999,"type":"VEC3"},{"componentType":5126,"count":3999999,"type":"VEC2"})";
  file.primitive = R"({"attributes":{"POSITION":0,"NORMAL":2,"TEXCOORD_0":3},"indices":1})";
  const std::string one = file.primitive;
  for (int i = 0; i < 1000; ++i) file.primitive += "," + one;
  const FileBytes bytes = file.build();
  const std::size_t before = allocatedBytes();
  EXPECT_TRUE(importGltf(bytes, "wolf.glb"));
  EXPECT_LT(allocatedBytes() - before, kAlways + kAByte * bytes.size());
}

TEST(ImportGltf, SurvivesDeepNesting) {
  const std::string deep(900'000, '[');
  expectError(textBytes(R"({"asset":{"version":"2.0"},"extras":)" + deep), ErrorId::BadFile, "JSON");
  const std::string closed = std::string(400'000, '[') + std::string(400'000, ']');
  expectError(textBytes(R"({"asset":{"version":"2.0"},"extras":)" + closed + "}"), ErrorId::BadFile, "no triangles");
}

TEST(ImportGltf, RejectsDataUrisThatAreNotBase64) {
  TriangleFile file;
  for (const char* uri : {"data:,plain", "data:application/octet-stream;base64,?!", "data:"}) {
    file.buffer = std::string(R"({"byteLength":44,"uri":")") + uri + "\"}";
    expectBad(file, "data: URI");
  }
}

TEST(ImportGltf, NeverCrashesOnMutatedFiles) {
  TriangleFile sparse;
  sparse.more = {1, 0, 0, 0};
  appendValues<float>(sparse.more, {7, 0, 0});
  sparse.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":1},{"buffer":0,"byteOffset":48,"byteLength":12})";
  sparse.position = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
    "indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}})";
  FurData fur{R"({"version":1})", std::vector<groom::GroomMap::Texel>(16 * 16, {9, 8, 7, 6}),
              std::vector<groom::GroomMap::Texel>(16 * 16, {1, 2, 3, 4}), {}, std::vector<groom::GroomMap::Texel>(16 * 16, {5, 6, 7, 8}), 16, {}, {}, {}, std::vector<groom::Whisker>(2)};
  geometry::Mesh plane = geometry::makePlane(2);
  plane.atlas = plane.uv;
  fur.comb.assign(plane.positions.size(), Vec3(0.5f, 0, 0));
  const FileBytes seeds[] = {exportGlb(geometry::makeSphere(6, 4), "seed"), sparse.build(),
                             exportScene(plane, "seed", fur, {{}, Vec4(1)})};
  Random random(20240607);
  const int rounds = std::getenv("WETFUR_MUTATIONS") ? std::atoi(std::getenv("WETFUR_MUTATIONS")) : 2000;
  int imported = 0;
  for (int round = 0; round < rounds; ++round) {
    FileBytes bytes = seeds[round % 3];
    const std::uint32_t jsonEnd = 20 + (bytes[12] | static_cast<std::uint32_t>(bytes[13]) << 8);
    for (std::uint32_t n = 1 + random.next() % 4; n > 0; --n) {
      // Half of the changes go into the JSON, where most of what can go wrong is said.
      const std::uint32_t range = random.next() % 2 ? jsonEnd : static_cast<std::uint32_t>(bytes.size());
      const std::uint32_t at = random.next() % range;
      const std::string digits = "0123456789-\"[]{},:.e";
      if (random.next() % 2) bytes[at] = static_cast<std::uint8_t>(digits[random.next() % digits.size()]);
      else bytes[at] = static_cast<std::uint8_t>(random.next());
    }
    auto model = importGltf(bytes, "mutant.glb");
    if (!model) continue;
    ++imported;
    // What passes the importer must be fit for the rest as well.
    for (const std::uint32_t index : model->mesh.indices) ASSERT_LT(index, model->mesh.positions.size());
    auto surface = geometry::buildSurface(model->mesh);
    if (surface) {
      ASSERT_GT(surface->triangleCount(), 0u);
    }
  }
  EXPECT_GT(imported, rounds / 50);  // some mutations hit only names or values
}

}  // namespace
}  // namespace fur::scene
