// What programs do with the coat.
#include "app/AppState.h"
#include "core/Bytes.h"
#include "core/NumberText.h"
#include "scene/CoatFile.h"
#include "scene/TypeSet.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

std::vector<std::uint8_t> written(const furgen::FurVolume& volume) {
  auto bytes = scene::writeTypeSet(volume);
  FUR_ASSERT(bytes, "App::saveTypeSet()", "a volume of the format's shape", bytes.error().message);
  return std::move(*bytes);
}

}  // namespace

float App::coatProgress() const { return state_->coat.progress(state_->coatInputs()); }
std::uint64_t App::coatRevision() const { return state_->coat.revision(); }
int App::coatLayers() const { return state_->coat.coat().layers(); }
std::span<const float> App::coverageByHeight() const { return state_->coat.coat().coverage(); }

furgen::TilePicture App::tilePicture(int layer, furgen::TileChannel channel) const {
  return state_->coat.coat().tilePicture(layer, channel);
}

furgen::TilePicture App::finPicture(furgen::TileChannel channel) const { return state_->coat.coat().finPicture(channel); }

Status App::loadTypeSet(std::span<const std::uint8_t> bytes, const std::string& name, int type) {
  State& s = *state_;
  if (scene::isCoatFile(bytes)) return wearCoat(bytes, name, type);
  auto volume = scene::readTypeSet(bytes, name);
  if (!volume) return volume.error();
  settings::Settings next = s.settings;
  // Another type than the first becomes a coat of its own that grows.
  settings::Settings coat = settings::typeCoat(next, type);
  if (type > 0 && coat.density <= 0) coat.density = settings::Settings{}.density;
  if (type > 0) settings::setTypeCoat(next, type, coat);
  next.typeSets[static_cast<std::size_t>(type)] = s.shelf.add(std::make_shared<const furgen::FurVolume>(std::move(*volume)), {bytes.begin(), bytes.end()});
  changeSettings(next);
  s.finishCoat();
  return Done{};
}

// A saved coat is all of a type's: its files take the place of those that there are, or there are none.
Status App::wearCoat(std::span<const std::uint8_t> bytes, const std::string& name, int type) {
  auto coat = scene::readCoat(bytes, name);
  if (!coat) return coat.error();
  State& s = *state_;
  auto files = s.shelf.addFiles({&coat->files, 1}, name);
  if (!files) return files.error();
  for (const std::string& warning : coat->warnings) addWarning(name + ": " + warning);
  settings::Settings next = s.settings;
  const auto index = static_cast<std::size_t>(type);
  settings::setTypeCoat(next, type, coat->values);
  settings::setTypeName(next, type, coat->name);
  next.typePictures[index] = files->pictures[0];
  next.typeSets[index] = files->typeSets[0];
  changeSettings(next);
  if (files->typeSets[0]) s.finishCoat();
  return Done{};
}

std::vector<std::uint8_t> App::saveCoat(std::string_view name, int type) const {
  const settings::Settings& settings = state_->settings;
  if (name.empty()) name = settings::typeName(settings, type);
  return scene::writeCoat({std::string(name.empty() ? "Coat" : name), settings::typeCoat(settings, type), state_->shelf.filesOf(settings)[static_cast<std::size_t>(type)]});
}

bool App::coatGiven(int type) const { return state_->shelf.coat(state_->settings.typeSets[static_cast<std::size_t>(type)]) != nullptr; }

Status App::setTypePicture(int type, std::vector<std::uint8_t> file, int width, int height, std::vector<std::uint8_t> rgba) {
  FUR_ASSERT(rgba.size() == static_cast<std::size_t>(width) * height * 4, "App::setTypePicture()", "4 bytes for each of width * height texels", rgba.size());
  auto image = scene::encodedImage(std::move(file), "a colour map");
  if (!image) return image.error();
  if (type > 0 && type < settings::kFurTypes && !(state_->groom.types() >> type & 1))
    addWarning("fur type " + decimal(type + 1) + " grows nowhere yet: its colour map shows where the brush Type paints it");
  settings::Settings next = state_->settings;
  next.typePictures[static_cast<std::size_t>(type)] = state_->shelf.add(ColorMap{std::move(*image), width, height, std::move(rgba)});
  changeSettings(next);
  return Done{};
}

std::vector<std::uint32_t> App::pendingPictures() const { return state_->shelf.pending(); }

const scene::EncodedImage& App::typePicture(std::uint32_t number) const {
  static const scene::EncodedImage none;
  const ColorMap* map = state_->shelf.picture(number);
  return map ? map->file : none;
}

void App::provideTypePicture(std::uint32_t number, int width, int height, std::vector<std::uint8_t> rgba) {
  state_->shelf.provide(number, width, height, std::move(rgba));
  ++state_->changed;
}

std::vector<std::uint8_t> App::saveTypeFiles() const {
  ByteWriter to;
  for (const scene::TypeFiles& type : state_->shelf.filesOf(state_->settings)) to(type.typeSet, type.picture.bytes);
  return std::move(to.bytes);
}

Status App::restoreTypeFiles(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Done{};
  ByteReader from(bytes);
  std::array<scene::TypeFiles, settings::kFurTypes + 1> files;
  for (scene::TypeFiles& type : files) {
    // Browsers have kept some from before the skin had any.
    if (&type == &files.back() && from.atEnd()) break;
    from(type.typeSet, type.picture.bytes);
    if (type.picture.bytes.empty()) continue;
    auto picture = scene::encodedImage(std::move(type.picture.bytes), "a colour map");
    if (!picture) return picture.error();
    type.picture = std::move(*picture);
  }
  if (!from.sound() || !from.atEnd()) return Error{ErrorId::BadFile, "files of fur types of " + decimal(bytes.size()) + " bytes are not sound"};
  auto numbers = state_->shelf.addFiles(files, "coat.fts");
  if (!numbers) return numbers.error();
  ++state_->changed;
  return Done{};
}

std::vector<std::uint8_t> App::saveTypeSet(int type) const {
  const State& s = *state_;
  if (const auto given = s.shelf.coat(s.settings.typeSets[static_cast<std::size_t>(type)])) return written(*given);
  furgen::FurParameters wanted = coatParametersOf(s.settings, type);
  wanted.size = scene::kTypeSetSize;
  wanted.layers = scene::kTypeSetLayers;
  return written(furgen::generateFur(wanted));
}

bool App::applyPreset(std::string_view name, int type) {
  settings::Settings next = state_->settings;
  if (!settings::loadType(next, type, name)) {
    addWarning(settings::unknownPreset(name));
    return false;
  }
  changeSettings(next);
  return true;
}

void App::changeSettings(const settings::Settings& next) {
  beginChange();
  setSettings(next);
  endChange();
}

}  // namespace fur::app
