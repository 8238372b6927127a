#include "app/TypeShelf.h"

#include <algorithm>

#include "core/Fnv1a.h"
#include "scene/TypeSet.h"

namespace fur::app {

namespace {

std::uint32_t numberOf(std::span<const std::uint8_t> bytes) {
  Fnv1a hash;
  hash.addAll(bytes);
  const auto number = static_cast<std::uint32_t>(hash.value() ^ hash.value() >> 32);
  return number ? number : 1;
}

template <class Held>
void keepOnly(std::map<std::uint32_t, Held>& all, std::span<const std::uint32_t> numbers) {
  std::erase_if(all, [&](const auto& one) { return std::find(numbers.begin(), numbers.end(), one.first) == numbers.end(); });
}

}  // namespace

std::uint32_t TypeShelf::add(GivenCoat coat, std::vector<std::uint8_t> file) {
  const std::uint32_t number = numberOf(file);
  coats_.emplace(number, Coat{std::move(coat), std::move(file)});
  return number;
}

std::uint32_t TypeShelf::add(ColorMap map) {
  const std::uint32_t number = numberOf(map.file.bytes);
  const auto [at, isNew] = pictures_.try_emplace(number);
  if (isNew || at->second.rgba.empty()) at->second = std::move(map);
  ++revision_;
  return number;
}

GivenCoat TypeShelf::coat(std::uint32_t number) const {
  const auto found = coats_.find(number);
  return found == coats_.end() ? nullptr : found->second.volume;
}

const ColorMap* TypeShelf::picture(std::uint32_t number) const {
  const auto found = pictures_.find(number);
  return found == pictures_.end() ? nullptr : &found->second;
}

std::vector<std::uint32_t> TypeShelf::pending() const {
  std::vector<std::uint32_t> numbers;
  for (const auto& [number, map] : pictures_)
    if (map.rgba.empty()) numbers.push_back(number);
  return numbers;
}

void TypeShelf::provide(std::uint32_t number, int width, int height, std::vector<std::uint8_t> rgba) {
  const auto found = pictures_.find(number);
  if (found == pictures_.end()) return;
  found->second.width = width;
  found->second.height = height;
  found->second.rgba = std::move(rgba);
  ++revision_;
}

GivenCoats TypeShelf::coatsOf(const settings::Settings& settings) const {
  GivenCoats coats;
  for (std::size_t type = 0; type < coats.size(); ++type) coats[type] = coat(settings.typeSets[type]);
  return coats;
}

std::array<scene::TypeFiles, settings::kFurTypes + 1> TypeShelf::filesOf(const settings::Settings& settings) const {
  std::array<scene::TypeFiles, settings::kFurTypes + 1> files;
  for (std::size_t type = 0; type < files.size(); ++type) {
    if (const auto found = coats_.find(settings.typeSets[type]); found != coats_.end()) files[type].typeSet = found->second.file;
    if (const ColorMap* map = picture(settings.typePictures[type])) files[type].picture = map->file;
  }
  return files;
}

Result<TypeShelf::Numbers> TypeShelf::addFiles(std::span<const scene::TypeFiles> files, const std::string& name) {
  Numbers numbers;
  for (std::size_t type = 0; type < std::min(files.size(), numbers.pictures.size()); ++type) {
    const scene::TypeFiles& from = files[type];
    if (!from.typeSet.empty()) {
      auto volume = scene::readTypeSet(from.typeSet, name);
      if (!volume) return volume.error();
      numbers.typeSets[type] = add(std::make_shared<const furgen::FurVolume>(std::move(*volume)), from.typeSet);
    }
    if (!from.picture.bytes.empty()) numbers.pictures[type] = add(ColorMap{from.picture});
  }
  return numbers;
}

void TypeShelf::keepOnlyThoseOf(std::initializer_list<const settings::Settings*> all) {
  std::vector<std::uint32_t> sets, pictures;
  for (const settings::Settings* settings : all) {
    sets.insert(sets.end(), settings->typeSets.begin(), settings->typeSets.end());
    pictures.insert(pictures.end(), settings->typePictures.begin(), settings->typePictures.end());
  }
  keepOnly(coats_, sets);
  keepOnly(pictures_, pictures);
  ++revision_;
}

}  // namespace fur::app
