#include "native/window/OwnCoats.h"

#include <cctype>

#include "native/Files.h"
#include "scene/CoatFile.h"
#include "scene/Formats.h"

namespace fur::native {

namespace fs = std::filesystem;

namespace {

// "Winter fox!" is kept as "Winter-fox.coat": names may hold what no file's may.
std::string coatFileName(const std::string& name) {
  std::string out;
  for (const char c : name.substr(0, 64)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte)) out += c;
    else if (!out.empty() && out.back() != '-') out += '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return (out.empty() ? "coat" : out).append(scene::endingOf(scene::Format::Coat));
}

Result<scene::CoatFile> coatIn(const fs::path& path) {
  const auto bytes = readFile(path.string());
  if (!bytes) return bytes.error();
  return scene::readCoat(bytes.value(), path.filename().string());
}

}  // namespace

std::vector<app::EditorHost::OwnCoat> OwnCoats::list() const {
  std::vector<app::EditorHost::OwnCoat> coats;
  std::error_code ignored;
  if (folder_.empty()) return coats;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const std::string id = entry.path().filename().string();
    if (scene::formatNamed(id) != scene::Format::Coat) continue;
    if (const auto coat = coatIn(entry.path())) coats.push_back({id, coat.value().name.empty() ? id : coat.value().name});
  }
  return coats;
}

Status OwnCoats::keep(const std::string& name, std::span<const std::uint8_t> coat) const {
  if (folder_.empty()) return Error{ErrorId::Network, "\"" + name + "\" was not kept: this system names no folder for it (HOME is not set)"};
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) return refused(folder_, failure);
  const Status status = replaceFile(freePath((folder_ / coatFileName(name)).string()), coat);
  return status ? status : Status(Error{status.error().id, "\"" + name + "\" was not kept: " + status.error().message});
}

Status OwnCoats::rename(const std::string& id, const std::string& name) const {
  auto coat = coatIn(folder_ / id);
  if (!coat) return coat.error();
  coat->name = name;
  return replaceFile((folder_ / id).string(), scene::writeCoat(*coat));
}

Status OwnCoats::remove(const std::string& id) const {
  std::error_code failure;
  fs::remove(folder_ / id, failure);
  return failure ? Status(refused(folder_ / id, failure)) : Status(Done{});
}

}  // namespace fur::native
