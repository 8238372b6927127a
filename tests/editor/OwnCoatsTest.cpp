// Coats that the window keeps under names.
#include "native/window/OwnCoats.h"

#include <gtest/gtest.h>

#include <fstream>

#include "native/Files.h"
#include "scene/CoatFile.h"

namespace fur::native {
namespace {

namespace fs = std::filesystem;

struct CoatShelf {
  fs::path folder = fs::temp_directory_path() / ("wet-fur-coats-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                                                 std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  OwnCoats coats{folder};
  ~CoatShelf() { fs::remove_all(folder); }
  Status keep(const std::string& name, float curl = 0.5f) {
    settings::Settings settings;
    settings.curl = curl;
    return coats.keep(name, scene::writeCoat({name, settings}));
  }
  std::string idOf(const std::string& name) const {
    for (const auto& coat : coats.list())
      if (coat.name == name) return coat.id;
    return "";
  }
  float curlOf(const std::string& id) const { return scene::readCoat(*readFile(coats.path(id)), id).value().values.curl; }
};

TEST(OwnCoats, AreKeptUnderAnyNameAsFilesThatOpen) {
  CoatShelf shelf;
  EXPECT_TRUE(shelf.coats.list().empty());
  for (const char* name : {"Winter fox", "Ötter / \"50 %\" 乾 ..", "../../etc/passwd", "...", "Winter fox"}) ASSERT_TRUE(shelf.keep(name)) << name;
  EXPECT_EQ(shelf.coats.list().size(), 5u) << "two of one name are two coats";
  EXPECT_EQ(std::distance(fs::directory_iterator(shelf.folder), {}), 5) << "and none lies elsewhere";
  EXPECT_TRUE(fs::exists(shelf.folder / "Winter-fox.coat"));
  EXPECT_EQ(shelf.curlOf(shelf.idOf("../../etc/passwd")), 0.5f);
}

TEST(OwnCoats, ARenamedOneKeepsItsCoatAndADeletedOneIsGone) {
  CoatShelf shelf;
  ASSERT_TRUE(shelf.keep("First", 0.25f));
  const std::string id = shelf.idOf("First");
  ASSERT_TRUE(shelf.coats.rename(id, "Second \"one\""));
  EXPECT_EQ(shelf.idOf("Second \"one\""), id);
  EXPECT_EQ(shelf.curlOf(id), 0.25f);
  ASSERT_TRUE(shelf.coats.remove(id));
  EXPECT_TRUE(shelf.coats.list().empty());
}

TEST(OwnCoats, WhatIsNoneIsLeftOutAndWhatCannotBeIsAnErrorThatNamesIt) {
  CoatShelf shelf;
  ASSERT_TRUE(shelf.keep("Good"));
  std::ofstream(shelf.folder / "broken.coat") << "{\"wetFurCoat\":";
  std::ofstream(shelf.folder / "notes.txt") << "hello";
  EXPECT_EQ(shelf.coats.list().size(), 1u);
  const Status renamed = shelf.coats.rename("broken.coat", "Whole");
  ASSERT_FALSE(renamed);
  EXPECT_EQ(renamed.error().id, ErrorId::BadFile);
  EXPECT_NE(renamed.error().message.find("broken.coat"), std::string::npos);
  const Status homeless = OwnCoats({}).keep("Mine", {});
  ASSERT_FALSE(homeless);
  EXPECT_NE(homeless.error().message.find("Mine"), std::string::npos);
}

}  // namespace
}  // namespace fur::native
