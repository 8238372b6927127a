#include "scene/Formats.h"

#include <gtest/gtest.h>

#include <set>

#include "scene/Model.h"

namespace fur::scene {
namespace {

Format formatAt(std::size_t i) { return static_cast<Format>(i); }

TEST(Formats, EachIsFoundByItsEndingInSmallLettersAndCapitals) {
  std::set<std::string_view> endings;
  for (std::size_t i = 0; i < kFormatCount; ++i) {
    const std::string ending(endingOf(formatAt(i)));
    EXPECT_EQ(formatNamed("a folder.d/bunny" + ending), formatAt(i));
    EXPECT_TRUE(endings.insert(endingOf(formatAt(i))).second) << ending;
  }
  EXPECT_EQ(formatNamed("BUNNY.GLB"), Format::Glb);
  EXPECT_EQ(formatNamed("fur.JPeg"), Format::Jpeg);
  EXPECT_EQ(formatNamed("bunny"), std::nullopt);
  EXPECT_EQ(formatNamed("bunny.glb.txt"), std::nullopt);
  EXPECT_EQ(formatNamed("glb"), std::nullopt);
  EXPECT_EQ(formatNamed(""), std::nullopt);
}

TEST(Formats, WhatTheyAreSaidToBeIsInWords) {
  EXPECT_EQ(endingsOf(FileKind::Coat), ".coat and .fts");
  EXPECT_EQ(endingsOf(FileKind::Model, " or ").substr(0, 12), ".glb, .gltf,");
  EXPECT_NE(endingsOf(FileKind::Model, " or ").find(" or ."), std::string::npos);
  EXPECT_EQ(saveLabel(Format::Glb), "Save scene (.glb)");
}

TEST(Formats, AModelOfNoFormatIsToldWhichThereAre) {
  const std::uint8_t nonsense[] = {'?', '?'};
  const auto model = importModel(nonsense, "bunny.doc");
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find(endingsOf(FileKind::Model)), std::string::npos) << model.error().message;
}

}  // namespace
}  // namespace fur::scene
