// Dialogs for files, with scripts in the place of zenity and kdialog.
#include "native/window/FileDialog.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#ifndef _WIN32
namespace fur::native {
namespace {

namespace fs = std::filesystem;

// A desktop whose only dialog is this script.
struct Desktop {
  Desktop(const char* name, const char* script) : folder(fs::temp_directory_path() / ("wet-fur-dialog-" + std::string(name))) {
    fs::create_directories(folder);
    const fs::path program = folder / name;
    std::ofstream(program) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(program, fs::perms::owner_all);
    setenv("FUR_FILE_DIALOG", program.c_str(), 1);
  }
  ~Desktop() {
    unsetenv("FUR_FILE_DIALOG");
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  std::string answer(FileDialog::Kind kind, const std::string& suggested) {
    FileDialog dialog;
    EXPECT_TRUE(dialog.show(kind, "A title", suggested));
    EXPECT_FALSE(dialog.show(kind, "A title", suggested)) << "one at a time";
    for (int i = 0; i < 3000; ++i) {
      if (const auto path = dialog.poll()) return *path;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return "it never closed";
  }
  fs::path folder;
};

TEST(FileDialog, AsksZenityAndGivesTheChosenPath) {
  Desktop desktop("zenity", "for a in \"$@\"; do case $a in --filename=*) echo \"${a#--filename=} $*\";; esac; done");
  const std::string answer = desktop.answer(FileDialog::Kind::Save, "it's a $(name).glb");
  EXPECT_EQ(answer.rfind("it's a $(name).glb ", 0), 0u) << answer;
  EXPECT_NE(answer.find("--save"), std::string::npos);
  EXPECT_EQ(desktop.answer(FileDialog::Kind::Open, "x").find("--save"), std::string::npos);
  EXPECT_NE(desktop.answer(FileDialog::Kind::Folder, "x").find("--directory"), std::string::npos);
}

TEST(FileDialog, AsksKdialogInItsOwnWords) {
  Desktop desktop("kdialog", "echo \"$3 $4\"");
  EXPECT_EQ(desktop.answer(FileDialog::Kind::Open, "a.glb"), "--getopenfilename a.glb");
  EXPECT_EQ(desktop.answer(FileDialog::Kind::Save, "a.glb"), "--getsavefilename a.glb");
}

TEST(FileDialog, APersonWhoGivesUpHasChosenNothing) {
  EXPECT_EQ(Desktop("zenity", "echo half a path; exit 1").answer(FileDialog::Kind::Open, ""), "");
}

TEST(FileDialog, WithoutAProgramThereIsNoDialog) {
  setenv("FUR_FILE_DIALOG", "none", 1);
  EXPECT_FALSE(FileDialog::available());
  EXPECT_FALSE(FileDialog().show(FileDialog::Kind::Open, "A title", ""));
  unsetenv("FUR_FILE_DIALOG");
}

}  // namespace
}  // namespace fur::native
#endif
