#include "app/stages/CoatStage.h"

#include <algorithm>

#include "core/Clock.h"

namespace fur::app {

namespace {

// A coat on its way is finished first when settings change again, so that a slider that is dragged shows
// coat after coat, unless it has taken this many seconds: then the newest settings win.
constexpr double kPatience = 0.4;

}  // namespace

bool CoatStage::asksForAnother(const Inputs& inputs) const {
  return changed_ || inputs.given != givenFor_ || coatParameters(inputs.settings, inputs.types) != grownFor_;
}

void CoatStage::begin(const Inputs& inputs, Warnings& warnings) {
  if (!shown_) inputs.receiver->prepare();
  CoatParameters wanted = coatParameters(inputs.settings, inputs.types, &warnings);
  givenFor_ = inputs.given;
  grownFor_ = wanted;
  types_ = inputs.types;
  seconds_ = 0;
  changed_ = false;
  growth_.emplace(std::move(wanted), inputs.given);
}

void CoatStage::take() {
  coat_ = growth_->take();
  weights_ = growth_->weights();
  growth_.reset();
  seconds_ = 0;
  shown_ = true;
  shownTypes_ = types_;
  ++revision_;
}

bool CoatStage::update(const Inputs& inputs, Warnings& warnings) {
  if (!inputs.receiver) return false;
  const std::uint64_t before = revision_;
  const double begun = secondsNow();
  do {
    if ((!growth_ || seconds_ + secondsNow() - begun > kPatience) && asksForAnother(inputs)) begin(inputs, warnings);
    if (!growth_) break;
    if (growth_->step(*inputs.receiver)) take();
  } while (secondsNow() - begun < inputs.budget);
  if (growth_) seconds_ += secondsNow() - begun;
  return revision_ != before;
}

void CoatStage::dropUnlessFor(const Inputs& inputs) {
  if (asksForAnother(inputs)) growth_.reset();
}

std::array<float, settings::kFurTypes> CoatStage::weights() const {
  std::array<float, settings::kFurTypes> weights{};
  std::copy(weights_.begin(), weights_.end(), weights.begin());
  return weights;
}

void CoatStage::forgetLayers() {
  growth_.reset();
  shown_ = false;
  changed_ = true;
}

float CoatStage::progress(const Inputs& inputs) const {
  return growth_ ? growth_->progress() : asksForAnother(inputs) ? 0.0f : 1.0f;
}

}  // namespace fur::app
