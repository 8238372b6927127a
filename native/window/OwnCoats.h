// Coats that a person has kept under names: a .coat file each, below the user's data beside the versions.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/editor/EditorHost.h"
#include "core/Result.h"

namespace fur::native {

class OwnCoats {
 public:
  // Empty: where the system names none.
  explicit OwnCoats(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // What cannot be read is left out. Ids are names of files.
  std::vector<app::EditorHost::OwnCoat> list() const;
  // App::saveCoat() under that name.
  Status keep(const std::string& name, std::span<const std::uint8_t> coat) const;
  std::string path(const std::string& id) const { return (folder_ / id).string(); }
  Status rename(const std::string& id, const std::string& name) const;
  Status remove(const std::string& id) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace fur::native
