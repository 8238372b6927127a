// Scenes that are kept under names: a folder each, with the scene as .glb, its name and a small picture, below the user's
// data ($XDG_DATA_HOME or ~/.local/share, %APPDATA% on Windows).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/editor/EditorHost.h"

namespace fur::native {

class Versions {
 public:
  // Empty: where the system names none.
  explicit Versions(std::filesystem::path folder) : folder_(std::move(folder)) {}
  // What was removed goes for good: until then undo may lead to it.
  ~Versions();
  Versions(const Versions&) = delete;
  Versions& operator=(const Versions&) = delete;

  // Newest first; what cannot be read is left out.
  std::vector<app::EditorHost::Version> list() const;
  // All of it is written or nothing. `model` names the scene's file.
  Status keep(const std::string& name, const std::string& model, std::span<const std::uint8_t> scene, const std::vector<std::uint8_t>& rgba);
  Status rename(const std::string& id, const std::string& name);
  void remove(const std::string& id) { removed_.push_back(id); }
  // The scene's file.
  Result<std::string> path(const std::string& id) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::string> removed_;
};

// Of this system and user, below which programs keep what is theirs.
std::filesystem::path userFolder(const char* variable, const char* belowHome);

}  // namespace fur::native
