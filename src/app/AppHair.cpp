// What programs do with long hair.
#include <cmath>

#include "app/AppState.h"
#include "core/NumberText.h"

namespace fur::app {

void App::State::beginHairStroke() {
  endStroke();
  hair->beginStroke();
}

HairStage::Look App::State::hairLook(const std::optional<Vec2>& pixel) const {
  HairStage::Look look{.settings = settings, .tool = hand.tool, .saved = saved, .pixelRatio = view.pixelRatio, .mapSize = groom.groom().paint.size(),
                       .worldFromModel = worldFromModel()};
  if (!worksOnHair(hand.tool)) return look;
  look.pixel = view.unitsPerPixel(1);
  look.points = pixel.has_value();
  const Ray ray = rayThrough(pixel.value_or(Vec2(0)));
  look.eye = look.origin = ray.origin;
  look.direction = glm::normalize(ray.direction);
  return look;
}

void App::hover(std::optional<Vec2> pixel) {
  State& s = *state_;
  s.hand.hover = pixel;
  if (worksOnHair(s.hand.tool)) s.changed += s.hair->pointsElsewhere(s.hairLook(pixel));
}

void App::setBody(std::size_t body, const hair::Body& to) {
  State& s = *state_;
  const bool alone = !s.changeBefore;
  if (alone || !s.hair->stroking()) s.beginHairStroke();
  s.hair->setBody(body, to);
  if (alone) s.endStroke();
}

int App::selectedBody() const { return state_->hair->selectedBody(); }
bool App::hasBones() const { return state_->shape.pose() != nullptr; }

void App::editHair(HairEdit edit, float value, const Vec3& direction) {
  State& s = *state_;
  if (!std::isfinite(value) || !std::isfinite(direction.x + direction.y + direction.z)) return;
  s.beginHairStroke();
  groom::GroomSurface skin = s.groom.groomSurface(s.shape);
  const std::vector<Vec3> comb = s.groom.upright() ? std::vector<Vec3>() : groom::restBends(s.groom.groom(), s.shape.surface(), s.shape.points());
  s.hair->edit(s.shape, skin, comb, {edit, value, direction, s.coatLength(), s.groom.groom().bare}, s.warnings);
  s.endStroke();
}

Status App::setHairValue(int scalp, std::string_view name, std::string_view text) {
  State& s = *state_;
  s.beginHairStroke();
  const Status status = s.hair->setValue(static_cast<std::size_t>(std::max(scalp, 0)), name, text, s.warnings);
  s.endStroke();
  return status;
}

Status App::loadHair(std::span<const std::uint8_t> bytes, const std::string& name) {
  State& s = *state_;
  s.beginHairStroke();
  const Status status = s.hair->readFile(s.shape, s.groom.groomSurface(s.shape), bytes, name);
  s.endStroke();
  return status;
}

Result<std::vector<std::uint8_t>> App::saveHairFile() {
  state_->hair->update(state_->hairInputs(0));  // no time may have gone by since it came
  return state_->hair->writeFile();
}

void App::setHairValues(std::size_t scalp, const hair::HairValues& values) {
  State& s = *state_;
  const bool alone = !s.changeBefore;
  if (alone || !s.hair->stroking()) s.beginHairStroke();
  s.hair->setValues(scalp, values);
  if (alone) s.endStroke();
}

std::size_t App::wispCount(std::size_t scalp) const { return scalp < state_->hair->scalpCount() ? state_->hair->growth(scalp).wisps.size() : 0; }

std::string App::scalps() const {
  state_->changed += state_->hair->update(state_->hairInputs(0));  // no time may have gone by since an edit
  return state_->hair->describe();
}

const hair::Hairstyle& App::hairstyle() const { return state_->hair->style(); }
bool App::haired() const { return state_->haired(); }
std::size_t App::selectedScalp() const { return state_->hair->selected(); }
std::vector<std::uint8_t> App::saveHair() const { return state_->hair->save(); }

Status App::restoreHair(std::span<const std::uint8_t> bytes, bool undoable) {
  State& s = *state_;
  s.endStroke();
  if (undoable) s.hair->beginStroke();
  const bool restored = s.hair->restore(bytes);
  s.endStroke();
  if (restored) return Done{};
  return Error{ErrorId::BadFile, "hair of " + decimal(bytes.size()) + " bytes is not of this program"};
}

}  // namespace fur::app
