// What programs do with the coat.
#include "app/AppState.h"
#include "core/Bytes.h"
#include "scene/TypeSet.h"
#include "scene/import/ImageHeader.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

std::vector<std::uint8_t> written(const furgen::FurVolume& volume) {
  auto bytes = scene::writeTypeSet(volume);
  FUR_ASSERT(bytes, "App::saveTypeSet()", "a volume of the format's shape", bytes.error().message);
  return std::move(*bytes);
}

// Without a type where it is none that is read.
scene::EncodedImage encodedImage(std::vector<std::uint8_t> bytes) {
  const auto header = scene::readImageHeader(bytes);
  if (!header) return {{}, std::move(bytes)};
  return {header->mimeType, std::move(bytes), static_cast<int>(header->width), static_cast<int>(header->height)};
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
  auto volume = scene::readTypeSet(bytes, name);
  if (!volume) return volume.error();
  State& s = *state_;
  settings::Settings next = s.settings;
  // Another type than the first becomes a coat of its own that grows.
  settings::Settings coat = settings::typeCoat(next, type);
  if (type > 0 && coat.density <= 0) coat.density = settings::Settings{}.density;
  if (type > 0) settings::setTypeCoat(next, type, coat);
  next.typeSets[static_cast<std::size_t>(type)] = s.shelf.add(std::make_shared<const furgen::FurVolume>(std::move(*volume)), {bytes.begin(), bytes.end()});
  beginChange();
  setSettings(next);
  endChange();
  s.finishCoat();
  return Done{};
}

bool App::coatGiven(int type) const { return state_->shelf.coat(state_->settings.typeSets[static_cast<std::size_t>(type)]) != nullptr; }

Status App::setTypePicture(int type, std::vector<std::uint8_t> file, int width, int height, std::vector<std::uint8_t> rgba) {
  FUR_ASSERT(rgba.size() == static_cast<std::size_t>(width) * height * 4, "App::setTypePicture()", "4 bytes for each of width * height texels", rgba.size());
  scene::EncodedImage image = encodedImage(std::move(file));
  if (image.mimeType.empty()) return Error{ErrorId::BadFile, "a colour map is a PNG, JPEG or WebP"};
  settings::Settings next = state_->settings;
  next.typePictures[static_cast<std::size_t>(type)] = state_->shelf.add(ColorMap{std::move(image), width, height, std::move(rgba)});
  beginChange();
  setSettings(next);
  endChange();
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
  std::array<scene::TypeFiles, settings::kFurTypes> files;
  for (scene::TypeFiles& type : files) {
    from(type.typeSet, type.picture.bytes);
    if (type.picture.bytes.empty()) continue;
    type.picture = encodedImage(std::move(type.picture.bytes));
    if (type.picture.mimeType.empty()) from.fail();
  }
  if (!from.sound() || !from.atEnd()) return Error{ErrorId::BadFile, "files of fur types of " + std::to_string(bytes.size()) + " bytes are not sound"};
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
  beginChange();
  setSettings(next);
  endChange();
  return true;
}

}  // namespace fur::app
