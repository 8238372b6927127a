// Scenes that the window keeps under names.
#include "native/window/Versions.h"

#include <gtest/gtest.h>

#include <fstream>

#include "native/Files.h"

namespace fur::native {
namespace {

namespace fs = std::filesystem;

struct Shelf {
  fs::path folder = fs::temp_directory_path() / ("wet-fur-versions-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                                                 std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  std::vector<std::uint8_t> picture = std::vector<std::uint8_t>(std::size_t(4) * editor::kVersionPictureWidth * editor::kVersionPictureHeight, 200);
  std::vector<std::uint8_t> scene = {'g', 'l', 'T', 'F'};
  ~Shelf() { fs::remove_all(folder); }
};

TEST(Versions, AreKeptWithNameAndPictureNewestFirst) {
  Shelf shelf;
  const std::string name = "Ötter / \"50 %\" 乾 ..";
  {
    Versions versions(shelf.folder);
    EXPECT_TRUE(versions.list().empty());
    ASSERT_TRUE(versions.keep("first", "bunny", shelf.scene, shelf.picture));
    ASSERT_TRUE(versions.keep(name, "five-coats.obj", shelf.scene, shelf.picture));
  }
  Versions later(shelf.folder);
  const auto list = later.list();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].name, name);
  EXPECT_EQ(list[1].name, "first");
  EXPECT_EQ(list[0].rgba, shelf.picture);
  EXPECT_EQ(list[0].when.size(), 16u);
  const auto path = later.path(list[0].id);
  ASSERT_TRUE(static_cast<bool>(path));
  EXPECT_EQ(fs::path(path.value()).filename(), "five-coats.glb");
}

TEST(Versions, FiftyInOneSecondAreFifty) {
  Shelf shelf;
  Versions versions(shelf.folder);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(versions.keep("version " + std::to_string(i), "bunny", shelf.scene, shelf.picture));
  EXPECT_EQ(versions.list().size(), 50u);
}

TEST(Versions, AreRenamed) {
  Shelf shelf;
  Versions versions(shelf.folder);
  ASSERT_TRUE(versions.keep("a", "bunny", shelf.scene, shelf.picture));
  ASSERT_TRUE(versions.rename(versions.list()[0].id, "b"));
  EXPECT_EQ(versions.list()[0].name, "b");
}

TEST(Versions, WhatIsDeletedIsHiddenAndGoesAtTheEndSinceUndoMayLeadToIt) {
  Shelf shelf;
  {
    Versions versions(shelf.folder);
    ASSERT_TRUE(versions.keep("a", "bunny", shelf.scene, shelf.picture));
    const std::string id = versions.list()[0].id;
    versions.remove(id);
    EXPECT_TRUE(versions.list().empty());
    EXPECT_TRUE(static_cast<bool>(versions.path(id)));
  }
  EXPECT_TRUE(fs::is_empty(shelf.folder));
}

TEST(Versions, AFolderThatCannotBeWrittenLosesNothingAndIsNamed) {
  Shelf shelf;
  std::ofstream(shelf.folder) << "a file where the folder should be";
  Versions versions(shelf.folder);
  const Status status = versions.keep("a", "bunny", shelf.scene, shelf.picture);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find(shelf.folder.string()), std::string::npos) << status.error().message;
  EXPECT_TRUE(versions.list().empty());
}

TEST(Versions, AHalfWrittenOneIsNone) {
  Shelf shelf;
  fs::create_directories(shelf.folder / "20260101-000000.part");
  std::ofstream(shelf.folder / "20260101-000000.part" / "bunny.glb") << "glTF";
  fs::create_directories(shelf.folder / "20260102-000000");
  EXPECT_TRUE(Versions(shelf.folder).list().empty());
}

}  // namespace
}  // namespace fur::native
