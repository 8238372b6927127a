// What programs do with the coat.
#include "app/AppState.h"
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

Status App::loadTypeSet(std::span<const std::uint8_t> bytes, const std::string& name) {
  auto volume = scene::readTypeSet(bytes, name);
  if (!volume) return volume.error();
  state_->giveCoat(std::make_shared<const furgen::FurVolume>(std::move(*volume)));
  return Done{};
}

void App::State::giveCoat(GivenCoat volume) {
  coat.give(std::move(volume), coatInputs());
  finishCoat();
}

const std::vector<std::uint8_t>& App::ownTypeSet() const { return state_->document.typeSet; }

bool App::coatGiven() const { return state_->coat.given(state_->coatInputs()) != nullptr; }

std::vector<std::uint8_t> App::saveTypeSet() const {
  const State& s = *state_;
  if (const auto given = s.coat.given(s.coatInputs())) return written(*given);
  furgen::FurParameters wanted = coatParameters(s.settings, 1u)[0];
  wanted.size = scene::kTypeSetSize;
  wanted.layers = scene::kTypeSetLayers;
  return written(furgen::generateFur(wanted));
}

bool App::applyPreset(std::string_view name) {
  const auto next = settings::applyPreset(state_->settings, name);
  if (!next) {
    addWarning(settings::unknownPreset(name));
    return false;
  }
  beginChange();
  setSettings(*next);
  endChange();
  return true;
}

}  // namespace fur::app
