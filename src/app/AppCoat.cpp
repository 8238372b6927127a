// The half of App that keeps the coat what the settings ask for.
#include <ctime>

#include "app/AppState.h"
#include "scene/TypeSet.h"
#include "settings/Presets.h"

namespace fur::app {

namespace {

// A coat on its way is finished first when settings change again, so that a slider that is dragged shows
// coat after coat, unless it has taken this many seconds: then the newest settings win.
constexpr double kPatience = 0.4;

std::vector<std::uint8_t> written(const furgen::FurVolume& volume) {
  auto bytes = scene::writeTypeSet(volume);
  FUR_ASSERT(bytes, "App::saveTypeSet()", "a volume of the format's shape", bytes.error().message);
  return std::move(*bytes);
}

}  // namespace

// Not std::chrono: its clocks can throw, and the texts of what they throw bring all of printf to the download.
double secondsNow() {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// `budget` in seconds of this machine's time; what is drawn in the end does not depend on it.
void App::State::workOnCoat(double budget) {
  if (!renderer) return;
  const double begun = secondsNow();
  do {
    if (furChanged && (!coatWork || coatSeconds + secondsNow() - begun > kPatience)) {
      if (!coatUploaded) renderer->warmUp(frame());
      coatWork.emplace(coatParameters(settings, furTypes, &warnings), given);
      workTypes = furTypes;
      coatSeconds = 0;
      furChanged = false;
    }
    if (!coatWork) break;
    if (!coatWork->step(*renderer)) continue;
    showCoat(coatWork->take());
    coatWork.reset();
    coatSeconds = 0;
  } while (secondsNow() - begun < budget);
  if (coatWork) coatSeconds += secondsNow() - begun;
}

void App::State::showCoat(DrawnCoat next) {
  coat = std::move(next);
  coatUploaded = true;
  shownTypes = workTypes;
  ++coatRevision;
  governor.forget();
  forcesChanged = pictureChanged = true;
}

void App::State::finishCoat() {
  refreshGroom();  // it says which types there are
  if (furChanged) coatWork.reset();
  workOnCoat(1e9);
}

// After a context was lost, or found: what was drawn has to be uploaded anew.
void App::State::uploadCoat() {
  coatWork.reset();
  coatUploaded = false;
  furChanged = true;
}

void App::finishCoat() { state_->finishCoat(); }

float App::coatProgress() const {
  const State& s = *state_;
  return s.coatWork ? s.coatWork->progress() : s.furChanged ? 0.0f : 1.0f;
}

bool App::coatGiven() const { return state_->given != nullptr; }
std::uint64_t App::coatRevision() const { return state_->coatRevision; }
int App::coatLayers() const { return state_->coat.layers(); }
std::span<const float> App::coverageByHeight() const { return state_->coat.coverage(); }

furgen::TilePicture App::tilePicture(int layer, furgen::TileChannel channel) const {
  return state_->coat.tilePicture(layer, channel);
}

furgen::TilePicture App::finPicture(furgen::TileChannel channel) const { return state_->coat.finPicture(channel); }

Status App::loadTypeSet(std::span<const std::uint8_t> bytes, const std::string& name) {
  auto volume = scene::readTypeSet(bytes, name);
  if (!volume) return volume.error();
  State& s = *state_;
  s.given = std::make_shared<const furgen::FurVolume>(std::move(*volume));
  s.furChanged = true;
  s.finishCoat();
  return Done{};
}

std::vector<std::uint8_t> App::saveTypeSet() const {
  const State& s = *state_;
  if (s.given) return written(*s.given);
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
