// What a file may say of the files of fur types, of the skin and of bare materials, and must not.
#include <gtest/gtest.h>

#include "scene/Model.h"
#include "scene/Png.h"
#include "scene/TypeSet.h"
#include "tests/scene/GltfBuilder.h"

namespace fur::scene {
namespace {

// One triangle whose root says `extension`; `more` lies in the bufferView 2.
Result<Model> withFur(const std::string& extension, const FileBytes& more = FileBytes(4), const std::string& top = "") {
  TriangleFile file;
  file.top = top + "\"extensionsUsed\":[\"WETFUR_fur\"],\"extensions\":{\"WETFUR_fur\":{\"version\":2," + extension + "}},";
  file.moreViews = ",{\"buffer\":0,\"byteOffset\":44,\"byteLength\":" + std::to_string(more.size()) + "}";
  file.more = more;
  return importGltf(file.build(), "hostile.glb");
}

FileBytes pngOf(std::uint32_t width, std::uint32_t height) {
  FileBytes png = writePng(1, 1, 4, std::vector<std::uint8_t>(4));
  for (std::size_t k = 0; k < 4; ++k) {
    png[16 + k] = static_cast<std::uint8_t>(width >> (24 - 8 * k));
    png[20 + k] = static_cast<std::uint8_t>(height >> (24 - 8 * k));
  }
  return png;
}

// The error, its file, and words of it.
void expectError(const Result<Model>& model, ErrorId id, const char* words, const std::string& what) {
  ASSERT_FALSE(model) << what;
  EXPECT_EQ(model.error().id, id) << what << ": " << model.error().message;
  for (const char* part : {"hostile.glb", words}) EXPECT_NE(model.error().message.find(part), std::string::npos) << what << ": " << model.error().message;
}

TEST(FurTypesBadInput, TypesOfAnotherShapeAreTypedErrors) {
  for (const auto& [types, words] : {std::pair("7", "types is not an array"), std::pair("{}", "types is not an array"), std::pair("[7]", "types[0] is not an object"), std::pair("[{},[]]", "types[1] is not an object"),
                                     std::pair(R"([{"typeSet":"2"}])", "types[0]"), std::pair(R"([{},{"typeSet":-1}])", "types[1]"), std::pair(R"([{},{"typeSet":1e30}])", "types[1]"),
                                     std::pair(R"([{"picture":2}])", "types[0].picture is not an object"), std::pair(R"([{"picture":{}}])", "types[0].picture"),
                                     std::pair(R"([{},{},{},{"picture":{"bufferView":"x"}}])", "types[3].picture")})
    expectError(withFur(std::string("\"types\":") + types), ErrorId::BadFile, words, types);
  expectError(withFur(R"("types":[{},{},{},{},{}])"), ErrorId::TooLarge, "the limit is 4", "five types");
}

TEST(FurTypesBadInput, ViewsThatAreNotThereAreTypedErrors) {
  for (const char* part : {R"("types":[{"typeSet":3}])", R"("typeSet":9)", R"("types":[{},{"picture":{"bufferView":3,"mimeType":"image/png"}}])", R"("skinPicture":{"bufferView":3})"})
    expectError(withFur(part), ErrorId::BadFile, "bufferViews", part);
}

TEST(FurTypesBadInput, PicturesAreLookedAtBeforeAnybodyDecodesThem) {
  const FileBytes png = writePng(2, 2, 4, std::vector<std::uint8_t>(16, 9));
  for (const auto& [key, where] : {std::pair(R"("types":[{},{"picture":{"bufferView":2,"mimeType":"image/png"}}])", "WETFUR_fur.types[1].picture"), std::pair(R"("skinPicture":{"bufferView":2,"mimeType":"image/png"})", "WETFUR_fur.skinPicture")}) {
    EXPECT_TRUE(withFur(key, png)) << key;
    expectError(withFur(key, textBytes("GIF89a__________")), ErrorId::BadFile, where, "another kind");
    expectError(withFur(key, FileBytes(png.begin(), png.begin() + 20)), ErrorId::BadFile, where, "its first bytes");
    expectError(withFur(key, pngOf(0, 5)), ErrorId::BadFile, where, "no pixels");
    expectError(withFur(key, pngOf(8193, 1)), ErrorId::TooLarge, "8192", "8193 pixels");
    expectError(withFur(key, pngOf(1, 0xffffffffu)), ErrorId::TooLarge, "8192", "4 thousand million pixels");
  }
}

TEST(FurTypesBadInput, BareMaterialsThatAreNotThereAreTypedErrors) {
  const std::string two = R"("materials":[{"name":"Body"},{"name":"Eyes"}],)";
  for (const char* bare : {"[2]", "[-2]", "[0.5]", "[\"0\"]", "[null]", "[1e30]", "[[0]]", "[0,1,99]"})
    expectError(withFur(std::string("\"bare\":") + bare, FileBytes(4), two), ErrorId::BadFile, "of which there are 2", bare);
  for (const char* bare : {"7", "{}", "\"all\""}) expectError(withFur(std::string("\"bare\":") + bare, FileBytes(4), two), ErrorId::BadFile, "bare is not an array", bare);
  expectError(withFur("\"bare\":[0,0,0,0,0,0]", FileBytes(4), two), ErrorId::TooLarge, "2 materials", "the same again and again");
  EXPECT_TRUE(withFur("\"bare\":[-1,0,1]", FileBytes(4), two)) << "each once, and primitives without one";
}

// Of one material with that text; more members before it.
Result<Model> withMaterial(const std::string& material, const std::string& more) {
  TriangleFile file;
  file.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
  file.top = "\"materials\":[" + material + "]," + more;
  return importGltf(file.build(), "hostile.glb");
}

TEST(FurTypesBadInput, MaterialsThatLeadNowhereAreTypedErrors) {
  const auto expect = [](const std::string& material, const std::string& more, const char* words) { expectError(withMaterial(material, more), ErrorId::BadFile, words, material + more); };
  const std::string textured = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  expect(textured, "", "textures");
  expect(textured, R"("textures":[{"source":0}],)", "images");
  expect(textured, R"("textures":[{"source":0,"sampler":3}],"images":[{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJ"}],"samplers":[{}],)", "samplers");
  expect(textured, R"("textures":[{"source":0,"extensions":{"EXT_texture_webp":{"source":7}}}],"images":[{}],)", "images");
  expect(R"({"normalTexture":7})", "", "normalTexture");
  expect(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":-1}}})", "", "texCoord");
}

TEST(FurTypesBadInput, TexturesThatNameThemselvesEndAtOnce) {
  // Nothing of a texture is followed further than to its image.
  const auto model = withMaterial(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})",
                                  R"("textures":[{"source":0,"sampler":0,"extensions":{"EXT_texture_webp":{"source":0,"textures":[0]}}}],"images":[{"uri":"hostile.glb"}],"samplers":[{"wrapS":0}],)");
  ASSERT_TRUE(model) << model.error().message;
  ASSERT_EQ(model.value().warnings.size(), 1u);
  EXPECT_NE(model.value().warnings[0].find("hostile.glb"), std::string::npos) << "the file of the image did not come along";
  EXPECT_TRUE(model.value().images.empty());
}

}  // namespace
}  // namespace fur::scene
