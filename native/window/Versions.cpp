#include "native/window/Versions.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "native/Files.h"
#include "scene/ImageDecode.h"

namespace fur::native {

namespace fs = std::filesystem;

namespace {

constexpr const char *kName = "name.txt", *kPicture = "picture.png", *kUnfinished = ".part";

std::string textOf(const fs::path& path) {
  const auto bytes = readFile(path.string());
  return bytes ? std::string(bytes.value().begin(), bytes.value().end()) : "";
}

Status writeText(const fs::path& path, const std::string& text) {
  return writeFile(path.string(), std::vector<std::uint8_t>(text.begin(), text.end()));
}

// "20261123-053556": folders in the order of their names are in that of time.
std::string nowAsId() {
  const std::time_t now = std::time(nullptr);
  char text[32] = "";
  if (const std::tm* local = std::localtime(&now)) std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", local);
  return text;
}

// "2026-11-23 05:35" of it.
std::string whenOf(const std::string& id) {
  if (id.size() < 15) return "";
  return id.substr(0, 4) + '-' + id.substr(4, 2) + '-' + id.substr(6, 2) + ' ' + id.substr(9, 2) + ':' + id.substr(11, 2);
}

fs::path sceneIn(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".glb") return entry.path();
  return {};
}

// "wooly.obj" is kept as "wooly.glb".
std::string fileNameOf(const std::string& model) {
  const std::string stem = fs::path(model).filename().stem().string();
  return (stem.empty() ? "scene" : stem) + ".glb";
}

}  // namespace

fs::path userFolder(const char* variable, const char* belowHome) {
  for (const char* name : {variable, "APPDATA"})
    if (const char* value = std::getenv(name); value && *value) return fs::path(value) / "wet-fur";
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) / belowHome / "wet-fur" : fs::path();
}

Versions::~Versions() {
  std::error_code ignored;
  for (const std::string& id : removed_) fs::remove_all(folder_ / id, ignored);
}

std::vector<app::EditorHost::Version> Versions::list() const {
  std::vector<app::EditorHost::Version> versions;
  std::error_code ignored;
  if (folder_.empty()) return versions;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const std::string id = entry.path().filename().string();
    if (entry.path().extension() == kUnfinished || sceneIn(entry.path()).empty()) continue;
    if (std::find(removed_.begin(), removed_.end(), id) != removed_.end()) continue;
    app::EditorHost::Version version{id, textOf(entry.path() / kName), whenOf(id), {}};
    if (version.name.empty()) version.name = id;
    if (const auto png = readFile((entry.path() / kPicture).string()))
      if (auto image = scene::decodeImage(png.value())) version.rgba = std::move(image->rgba);
    versions.push_back(std::move(version));
  }
  std::sort(versions.begin(), versions.end(), [](const auto& a, const auto& b) { return a.id > b.id; });
  return versions;
}

Status Versions::keep(const std::string& name, const std::string& model, std::span<const std::uint8_t> scene,
                      const std::vector<std::uint8_t>& rgba) {
  if (folder_.empty()) return Error{ErrorId::Network, "\"" + name + "\" was not kept: this system names no folder for it (HOME is not set)"};
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) return refused(folder_, failure);
  const fs::path place = freePath((folder_ / nowAsId()).string());
  const fs::path part = place.string() + kUnfinished;
  fs::create_directories(part, failure);
  if (failure) return refused(part, failure);
  Status status = writeFile((part / fileNameOf(model)).string(), scene);
  if (status) status = writePng((part / kPicture).string(), editor::kVersionPictureWidth, editor::kVersionPictureHeight, rgba);
  if (status) status = writeText(part / kName, name);
  if (status) {
    fs::rename(part, place, failure);
    if (failure) status = refused(place, failure);
  }
  if (!status) {
    fs::remove_all(part, failure);
    return Error{status.error().id, "\"" + name + "\" was not kept: " + status.error().message};
  }
  return Done{};
}

Status Versions::rename(const std::string& id, const std::string& name) {
  return replaceFile((folder_ / id / kName).string(), std::vector<std::uint8_t>(name.begin(), name.end()));
}

Result<std::string> Versions::path(const std::string& id) const {
  const fs::path scene = sceneIn(folder_ / id);
  if (scene.empty()) return Error{ErrorId::Network, (folder_ / id).string() + ": there is no scene in it"};
  return scene.string();
}

}  // namespace fur::native
