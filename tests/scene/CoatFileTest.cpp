// Saved coats as files, good and bad.
#include "scene/CoatFile.h"

#include <gtest/gtest.h>

#include <string>

#include "scene/Base64.h"
#include "scene/Formats.h"
#include "scene/Model.h"
#include "scene/Png.h"
#include "scene/TypeSet.h"
#include "settings/Presets.h"

namespace fur::scene {
namespace {

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }
Result<CoatFile> read(const std::string& text) { return readCoat(bytesOf(text), "mine.coat"); }

CoatFile fox() {
  CoatFile coat{"Winter fox \"2\" \xc3\xa4", *settings::applyPreset({}, "persian")};
  coat.files.typeSet = {1, 2, 3, 4, 5};
  coat.files.picture = {"image/png", writePng(2, 1, 4, std::vector<std::uint8_t>(8, 77)), 2, 1};
  return coat;
}

TEST(CoatFile, ComesBackAsItWasWritten) {
  const CoatFile coat = fox();
  const auto read = readCoat(writeCoat(coat), "fox.coat");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read.value().name, coat.name);
  settings::Values expected;
  settings::copyCoat(coat.values, expected);
  EXPECT_EQ(read.value().values, expected);
  EXPECT_EQ(read.value().files.typeSet, coat.files.typeSet);
  EXPECT_EQ(read.value().files.picture.bytes, coat.files.picture.bytes);
  EXPECT_EQ(read.value().files.picture.mimeType, "image/png");
  EXPECT_EQ(read.value().files.picture.width, 2);
  EXPECT_TRUE(read.value().warnings.empty());
}

TEST(CoatFile, HoldsWhatIsOfACoatAndNothingElse) {
  settings::Settings settings;
  settings.lightYaw = 2;
  settings.layers = 8;
  settings.curl = 0.75f;
  const auto bytes = writeCoat({"", settings});
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "{\"wetFurCoat\":1,\"name\":\"\",\"settings\":{\"curl\":0.75}}\n");
}

TEST(CoatFile, IsKnownByItsEndingAndItsFirstByte) {
  EXPECT_EQ(formatNamed("Fox.COAT"), Format::Coat);
  EXPECT_EQ(kindOf(Format::Coat), FileKind::Coat);
  EXPECT_TRUE(isCoatFile(writeCoat(fox())));
  EXPECT_TRUE(isCoatFile(bytesOf(" \n\t{")));
  std::vector<std::uint8_t> typeSet(kTypeSetBytes, '{');
  EXPECT_FALSE(isCoatFile(typeSet)) << "a .fts may begin with any byte";
  EXPECT_FALSE(isCoatFile({}));
}

TEST(CoatFile, ValuesOutOfRangeAreClampedAndUnknownOnesLeftOutWithAWarning) {
  const auto coat = read(R"({"wetFurCoat":1,"settings":{"curl":7,"rootColor":"#102030","lightYaw":1,"nonsense":true,"tipColor":[1]},"mood":"good"})");
  ASSERT_TRUE(coat) << coat.error().message;
  EXPECT_EQ(coat.value().values.curl, 1);
  EXPECT_EQ(coat.value().values.rootColor, 0x102030u);
  EXPECT_EQ(coat.value().values.lightYaw, settings::Values{}.lightYaw);
  EXPECT_EQ(coat.value().warnings.size(), 5u);
}

// What is wrong, the file, the error and words of it.
struct Bad {
  const char* what;
  std::string text;
  ErrorId id;
  const char* words;
};

std::string withPicture(const std::vector<std::uint8_t>& picture) { return R"({"wetFurCoat":1,"picture":")" + base64Encoded(picture) + "\"}"; }

std::vector<std::uint8_t> pngOfSide(std::uint32_t side) {
  std::vector<std::uint8_t> png = writePng(1, 1, 4, std::vector<std::uint8_t>(4));
  for (std::size_t k = 0; k < 4; ++k) png[16 + k] = png[20 + k] = static_cast<std::uint8_t>(side >> (24 - 8 * k));
  return png;
}

std::vector<Bad> hostileCoats() {
  const std::vector<std::uint8_t> png = writePng(1, 1, 4, std::vector<std::uint8_t>(4));
  return {
      {"nothing", "", ErrorId::BadFile, "no JSON"},
      {"no JSON", "{\"wetFurCoat\":1,", ErrorId::BadFile, "no JSON"},
      {"an array", "[1]", ErrorId::BadFile, "no JSON object"},
      {"a state", R"({"version":1,"settings":{}})", ErrorId::BadFile, "no coat"},
      {"a version that is text", R"({"wetFurCoat":"1"})", ErrorId::BadFile, "no coat"},
      {"a version of a half", R"({"wetFurCoat":1.5})", ErrorId::BadFile, "no coat"},
      {"a version below the first", R"({"wetFurCoat":0})", ErrorId::BadFile, "no coat"},
      {"a version beyond doubles", R"({"wetFurCoat":1e999})", ErrorId::UnsupportedVersion, "up to 1"},
      {"a newer version", R"({"wetFurCoat":2,"settings":{}})", ErrorId::UnsupportedVersion, "up to 1"},
      {"a name that is none", R"({"wetFurCoat":1,"name":{}})", ErrorId::BadFile, "name"},
      {"a name without end", R"({"wetFurCoat":1,"name":")" + std::string(400, 'x') + "\"}", ErrorId::TooLarge, "320"},
      {"settings that are text", R"({"wetFurCoat":1,"settings":"curl"})", ErrorId::BadFile, "settings"},
      {"a type set of numbers", R"({"wetFurCoat":1,"typeSet":[1,2]})", ErrorId::BadFile, "typeSet"},
      {"a type set of other letters", R"({"wetFurCoat":1,"typeSet":"?"})", ErrorId::BadFile, "typeSet"},
      {"a picture that is none", R"({"wetFurCoat":1,"picture":"AAAA"})", ErrorId::BadFile, "picture"},
      {"a picture of nothing", R"({"wetFurCoat":1,"picture":""})", ErrorId::BadFile, "picture"},
      {"a picture that ends early", withPicture({png.begin(), png.begin() + 20}), ErrorId::BadFile, "picture"},
      {"a picture without pixels", withPicture(pngOfSide(0)), ErrorId::BadFile, "picture"},
      {"a picture of a million pixels a side", withPicture(pngOfSide(1000000)), ErrorId::TooLarge, "8192"},
      {"a coat of 33 MiB", "{" + std::string(33u << 20, ' ') + "}", ErrorId::TooLarge, "33554432"},
  };
}

TEST(CoatFile, WhatIsNoneIsATypedErrorThatNamesFileAndLimit) {
  for (const Bad& bad : hostileCoats()) {
    const auto coat = read(bad.text);
    ASSERT_FALSE(coat) << bad.what;
    EXPECT_EQ(coat.error().id, bad.id) << bad.what << ": " << coat.error().message;
    EXPECT_NE(coat.error().message.find("mine.coat: "), std::string::npos) << coat.error().message;
    EXPECT_NE(coat.error().message.find(bad.words), std::string::npos) << coat.error().message;
  }
}

TEST(CoatFile, AnyPartOfOneIsReadOrRefused) {
  const auto whole = writeCoat(fox());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(readCoat(std::span(whole).first(size), "part.coat") && size + 1 < whole.size()) << size;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::vector<std::uint8_t> other = whole;
    other[at] ^= 0x15;
    const auto read = readCoat(other, "other.coat");
    if (!read) EXPECT_NE(read.error().message.find("other.coat"), std::string::npos) << read.error().message;
  }
}

}  // namespace
}  // namespace fur::scene
