// What a good file becomes. Bad ones: ImportGltfBadInputTest.cpp.
#include <gtest/gtest.h>

#include "geometry/Primitives.h"
#include "scene/GltfBuilder.h"
#include "scene/Model.h"

namespace fur::scene {
namespace {

Model imported(const FileBytes& bytes, const FileSet& others = {}) {
  Result<Model> model = importGltf(bytes, "test.glb", others);
  if (!model) {
    ADD_FAILURE() << model.error().message;
    return {};
  }
  return model.value();
}

Vec3 faceNormal(const Model& model, std::size_t triangle) {
  const auto p = [&](std::size_t k) { return model.mesh.positions[model.mesh.indices[3 * triangle + k]]; };
  return glm::normalize(glm::cross(p(1) - p(0), p(2) - p(0)));
}

void expectNear(const Vec3& a, const Vec3& b, float tolerance = 1e-5f) {  // a few roundings of values near 1
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(ImportGltf, FitsTheModelToTheUnitSphere) {
  TriangleFile file;
  file.positions = {100, 0, 0, 103, 0, 0, 100, 4, 0};
  const Model model = imported(file.build());
  expectNear(model.bounds.low, Vec3(100, 0, 0));
  expectNear(model.bounds.high, Vec3(103, 4, 0));
  float farthest = 0.0f;
  for (const Vec3& p : model.mesh.positions) farthest = std::max(farthest, glm::length(p));
  EXPECT_NEAR(farthest, 1.0f, 1e-6f);
}

TEST(ImportGltf, ComputesMissingNormals) {
  const Model model = imported(TriangleFile().build());
  ASSERT_EQ(model.mesh.normals.size(), 3u);
  for (const Vec3& normal : model.mesh.normals) expectNear(normal, Vec3(0, 0, 1));
  EXPECT_FALSE(model.hasTexcoords);
  EXPECT_TRUE(model.mesh.uv.empty());
}

TEST(ImportGltf, AppliesTransformsOfParentAndChild) {
  TriangleFile file;
  file.nodes = R"([{"children":[1],"translation":[10,0,0]},{"mesh":0,"scale":[2,3,1]}])";
  const Model model = imported(file.build());
  expectNear(model.bounds.low, Vec3(10, 0, 0));
  expectNear(model.bounds.high, Vec3(12, 3, 0));
}

TEST(ImportGltf, ReadsMatricesByColumns) {
  TriangleFile file;
  file.nodes = R"([{"mesh":0,"matrix":[0,0,-1,0, 0,1,0,0, 1,0,0,0, 5,6,7,1]}])";
  const Model model = imported(file.build());
  expectNear(model.bounds.low, Vec3(5, 6, 6));
  expectNear(model.bounds.high, Vec3(5, 7, 7));
  expectNear(faceNormal(model, 0), Vec3(1, 0, 0));
}

TEST(ImportGltf, TurnsWithQuaternions) {
  TriangleFile file;
  file.nodes = R"([{"mesh":0,"rotation":[0,0,0.70710678,0.70710678]}])";
  const Model model = imported(file.build());
  expectNear(model.bounds.low, Vec3(-1, 0, 0));
  expectNear(model.bounds.high, Vec3(0, 1, 0));
}

TEST(ImportGltf, KeepsMirroredNodesOutsideOut) {
  // The mirror image of a triangle that faces +z still faces +z when only x is mirrored.
  TriangleFile file;
  file.nodes = R"([{"mesh":0,"scale":[-1,1,1]}])";
  const Model model = imported(file.build());
  expectNear(faceNormal(model, 0), Vec3(0, 0, 1));
  expectNear(model.mesh.normals[0], Vec3(0, 0, 1));
}

TEST(ImportGltf, MirrorsGivenNormalsWithTheirTriangles) {
  TriangleFile file;
  appendValues<float>(file.more, {0, 0, 1, 0, 0, 1, 0, 0, 1});
  file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":36})";
  file.moreAccessors = R"(,{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"})";
  file.primitive = R"({"attributes":{"POSITION":0,"NORMAL":2},"indices":1})";
  for (const char* scale : {"[1,1,-1]", "[-1,1,1]", "[2,0.5,-3]", "[-1,-1,-1]"}) {
    file.nodes = std::string(R"([{"mesh":0,"scale":)") + scale + "}]";
    const Model model = imported(file.build());
    EXPECT_GT(glm::dot(model.mesh.normals[0], faceNormal(model, 0)), 0.999f) << scale;
  }
}

TEST(ImportGltf, ShowsEveryInstanceOfAMesh) {
  TriangleFile file;
  file.scene = R"("scenes":[{"nodes":[0,1]}],)";
  file.nodes = R"([{"mesh":0},{"mesh":0,"translation":[5,0,0]}])";
  const Model model = imported(file.build());
  EXPECT_EQ(model.mesh.triangleCount(), 2u);
  EXPECT_EQ(model.mesh.positions.size(), 6u);
  expectNear(model.bounds.high, Vec3(6, 1, 0));
}

TEST(ImportGltf, JoinsPrimitivesOfOneMesh) {
  TriangleFile file;
  file.primitive += R"(,{"attributes":{"POSITION":0}})";
  const Model model = imported(file.build());
  EXPECT_EQ(model.mesh.triangleCount(), 2u);
  EXPECT_EQ(model.mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
}

TEST(ImportGltf, ShowsAllRootNodesWithoutAScene) {
  TriangleFile file;
  file.scene = "";
  file.nodes = R"([{"mesh":0,"translation":[1,0,0]},{"children":[0]}])";
  EXPECT_EQ(imported(file.build()).mesh.triangleCount(), 1u);
  file.nodes = "[]";
  EXPECT_EQ(imported(file.build()).mesh.triangleCount(), 1u);
}

TEST(ImportGltf, ReadsStripsWithEveryOtherTriangleTurned) {
  TriangleFile file;
  file.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  file.position = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";
  file.primitive = R"({"attributes":{"POSITION":0},"mode":5})";
  const Model model = imported(file.build());
  ASSERT_EQ(model.mesh.triangleCount(), 2u);
  expectNear(faceNormal(model, 0), Vec3(0, 0, 1));
  expectNear(faceNormal(model, 1), Vec3(0, 0, 1));
}

TEST(ImportGltf, ReadsFans) {
  TriangleFile file;
  file.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  file.position = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";
  file.primitive = R"({"attributes":{"POSITION":0},"mode":6})";
  const Model model = imported(file.build());
  EXPECT_EQ(model.mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(ImportGltf, ReadsIndicesOfEveryWidth) {
  for (const int component : {5121, 5123, 5125}) {
    TriangleFile file;
    if (component == 5121) file.more = {2, 0, 1};
    if (component == 5123) file.more = {2, 0, 0, 0, 1, 0};
    if (component == 5125) file.more = {2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
    file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":)" + std::to_string(file.more.size()) + "}";
    file.index = R"({"bufferView":2,"count":3,"type":"SCALAR","componentType":)" + std::to_string(component) + "}";
    EXPECT_EQ(imported(file.build()).mesh.indices, (std::vector<std::uint32_t>{2, 0, 1})) << component;
  }
}

TEST(ImportGltf, ReadsInterleavedAndOffsetVertices) {
  TriangleFile file;
  file.positions = {9, 9, 0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0};
  file.position = R"({"bufferView":2,"byteOffset":8,"componentType":5126,"count":3,"type":"VEC3"})";
  file.moreViews = R"(,{"buffer":0,"byteLength":60,"byteStride":20})";
  expectNear(imported(file.build()).bounds.high, Vec3(1, 1, 0));
}

TEST(ImportGltf, ReadsQuantizedPositionsAndTexcoords) {
  TriangleFile file;
  const std::vector<std::int16_t> positions{0, 0, 0, 32767, 0, 0, 0, -32767, 0, 0};  // and two bytes to align
  const std::vector<std::uint16_t> uv{0, 0, 65535, 0, 0, 13107};
  appendValues(file.more, positions);
  appendValues(file.more, uv);
  file.top = R"("extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":["KHR_mesh_quantization"],)";
  file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":18},{"buffer":0,"byteOffset":64,"byteLength":12})";
  file.moreAccessors = R"(,{"bufferView":2,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"}
                          ,{"bufferView":3,"componentType":5123,"normalized":true,"count":3,"type":"VEC2"})";
  file.primitive = R"({"attributes":{"POSITION":2,"TEXCOORD_0":3},"indices":1})";
  const Model model = imported(file.build());
  expectNear(model.bounds.low, Vec3(0, -1, 0));
  expectNear(model.bounds.high, Vec3(1, 0, 0));
  EXPECT_TRUE(model.hasTexcoords);
  EXPECT_FLOAT_EQ(model.mesh.uv[1].x, 1.0f);
  EXPECT_FLOAT_EQ(model.mesh.uv[2].y, 0.2f);
}

TEST(ImportGltf, PutsSparseValuesInPlace) {
  TriangleFile file;
  file.more = {1, 0, 0, 0};
  appendValues<float>(file.more, {7, 0, 0});
  file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":1},{"buffer":0,"byteOffset":48,"byteLength":12})";
  file.position = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
    "indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}})";
  expectNear(imported(file.build()).bounds.high, Vec3(7, 1, 0));
}

TEST(ImportGltf, ReadsBuffersFromDataUrisAndFiles) {
  TriangleFile file;
  const std::string size = std::to_string(file.binary().size());
  file.buffer = R"({"byteLength":)" + size + R"(,"uri":"my%20mesh.bin"})";
  const FileSet others{{"my mesh.bin", file.binary()}};
  EXPECT_EQ(imported(textBytes(file.json()), others).mesh.triangleCount(), 1u);

  // Three floats 0, 0, 0; 1, 0, 0; 0, 1, 0 and the indices 0 1 2 0 in base64.
  file.buffer = R"({"byteLength":44,"uri":"data:application/octet-stream;base64,)"
                R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIAAAA="})";
  EXPECT_EQ(imported(textBytes(file.json())).mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

FileBytes pngHeader(std::uint32_t width, std::uint32_t height) {
  FileBytes bytes{0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  for (const std::uint32_t side : {width, height}) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(side >> shift));
  }
  return bytes;
}

TriangleFile texturedTriangle(const FileBytes& image) {
  TriangleFile file;
  file.more = image;
  file.moreViews = R"(,{"buffer":0,"byteOffset":44,"byteLength":)" + std::to_string(image.size()) + "}";
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
  file.top = R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[1,0.5,0.25,1]}}],
    "textures":[{"source":0}],"images":[{"bufferView":2,"mimeType":"image/png"}],)";
  return file;
}

TEST(ImportGltf, KeepsTheBaseColourImageEncoded) {
  const FileBytes image = pngHeader(640, 480);
  const Model model = imported(texturedTriangle(image).build());
  EXPECT_EQ(model.baseColor().mimeType, "image/png");
  EXPECT_EQ(model.baseColor().width, 640);
  EXPECT_EQ(model.baseColor().height, 480);
  EXPECT_EQ(model.baseColor().bytes, image);
  EXPECT_EQ(model.main().baseColor, Vec4(1, 0.5f, 0.25f, 1));
}

TEST(ImportGltf, RefusesAnImageOfTwentyThousandPixelsBeforeDecodingIt) {
  for (const auto& [width, height] : {std::pair(20000u, 16u), {16u, 20000u}, {0xffffffffu, 1u}}) {
    const auto model = importGltf(texturedTriangle(pngHeader(width, height)).build(), "big.glb");
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().id, ErrorId::TooLarge);
    EXPECT_NE(model.error().message.find(std::to_string(std::max(width, height))), std::string::npos);
    EXPECT_NE(model.error().message.find("8192"), std::string::npos);
    EXPECT_NE(model.error().message.find("big.glb"), std::string::npos);
  }
}

TEST(ImportGltf, GoesOnWithoutAnImageThatIsNone) {
  const Model model = imported(texturedTriangle(textBytes("not an image at all")).build());
  EXPECT_TRUE(model.baseColor().mimeType.empty());
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("images[0]"), std::string::npos);
}

TEST(ImportGltf, WarnsOfAMissingImageFile) {
  TriangleFile file = texturedTriangle({});
  file.top.replace(file.top.find(R"({"bufferView":2,"mimeType":"image/png"})"), 39, R"({"uri":"skin.png"})");
  const Model model = imported(file.build());
  ASSERT_EQ(model.warnings.size(), 1u);
  EXPECT_NE(model.warnings[0].find("skin.png"), std::string::npos);
}

TEST(ImportGltf, MovesTexcoordsAsKhrTextureTransformSays) {
  TriangleFile file = texturedTriangle(pngHeader(4, 4));
  while (file.more.size() % 4 != 0) file.more.push_back(0);
  const std::size_t offset = 44 + file.more.size();
  appendValues<float>(file.more, {0, 0, 1, 0, 0, 1});
  file.moreViews += R"(,{"buffer":0,"byteLength":24,"byteOffset":)" + std::to_string(offset) + "}";
  file.moreAccessors = R"(,{"bufferView":3,"componentType":5126,"count":3,"type":"VEC2"})";
  file.primitive = R"({"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0})";
  const std::string plain = R"("baseColorTexture":{"index":0})";
  file.top.replace(file.top.find(plain), plain.size(), R"("baseColorTexture":{"index":0,"extensions":{
    "KHR_texture_transform":{"offset":[0,1],"rotation":1.5707963267948966,"scale":[0.5,0.5]}}})");
  const Model model = imported(file.build());
  // The example of the extension's text: half size, turned a quarter, origin at (0, 1).
  EXPECT_NEAR(model.mesh.uv[0].x, 0.0f, 1e-6f);
  EXPECT_NEAR(model.mesh.uv[0].y, 1.0f, 1e-6f);
  EXPECT_NEAR(model.mesh.uv[1].x, 0.0f, 1e-6f);
  EXPECT_NEAR(model.mesh.uv[1].y, 0.5f, 1e-6f);
  EXPECT_NEAR(model.mesh.uv[2].x, 0.5f, 1e-6f);
}

TEST(ImportGltf, ReadsBackWhatExportGlbWrote) {
  geometry::Mesh torus = geometry::makeTorus(12, 8);
  geometry::fitToUnitSphere(torus);
  const Model model = imported(exportGlb(torus, "a \"torus\""));
  EXPECT_EQ(model.mesh.indices, torus.indices);
  EXPECT_EQ(model.mesh.uv, torus.uv);
  EXPECT_TRUE(model.hasTexcoords);
  EXPECT_TRUE(model.warnings.empty());
  ASSERT_EQ(model.mesh.positions.size(), torus.positions.size());
  for (std::size_t i = 0; i < torus.positions.size(); ++i) {
    expectNear(model.mesh.positions[i], torus.positions[i]);
    expectNear(model.mesh.normals[i], torus.normals[i]);
  }
}

}  // namespace
}  // namespace fur::scene
