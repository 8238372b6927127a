#include "app/stages/CoatStage.h"

#include <algorithm>

#include "core/Clock.h"

namespace fur::app {

namespace {

// A coat on its way is finished first when settings change again, so that a slider that is dragged shows
// coat after coat, unless it has taken this many seconds: then the newest settings win.
constexpr double kPatience = 0.4;
// Of the first coat: fewer show steps between them.
constexpr int kCoarseLayers = 8;

}  // namespace

bool CoatStage::asksForAnother(const Inputs& inputs) const {
  return changed_ || inputs.given != givenFor_ || coatParameters(inputs.settings, inputs.types) != grownFor_;
}

void CoatStage::begin(const Inputs& inputs, Warnings& warnings) {
  CoatParameters wanted = coatParameters(inputs.settings, inputs.types, &warnings);
  givenFor_ = inputs.given;
  grownFor_ = wanted;
  types_ = inputs.types;
  seconds_ = 0;
  changed_ = coarse_ = showsCoarse_ = false;
  growth_.reset();
  if (auto had = inputs.receiver->showShared(grownFor_, givenFor_)) return take(std::move(had));
  coarse_ = inputs.coarseFirst && !shown_ && wanted[0].layers > kCoarseLayers && inputs.given == GivenCoats{};
  if (!shown_) inputs.receiver->prepare();
  if (coarse_)
    for (furgen::FurParameters& p : wanted) p.layers = kCoarseLayers;
  growth_.emplace(std::move(wanted), inputs.given);
  if (coarse_) growth_->leaveFins();
}

// The strands go on into the whole one.
void CoatStage::takeCoarse() {
  coat_ = std::make_shared<const WholeCoat>(WholeCoat{grownFor_, givenFor_, growth_->take(), growth_->weights()});
  growth_.emplace(grownFor_, givenFor_, growth_->takeStrands());
  coarse_ = false;
  shown_ = showsCoarse_ = true;
  shownTypes_ = types_;
  ++revision_;
}

void CoatStage::take(std::shared_ptr<const WholeCoat> coat) {
  coat_ = std::move(coat);
  growth_.reset();
  coarse_ = showsCoarse_ = false;
  seconds_ = 0;
  shown_ = true;
  shownTypes_ = types_;
  ++revision_;
}

bool CoatStage::update(const Inputs& inputs, Warnings& warnings) {
  if (!inputs.receiver) return false;
  const std::uint64_t before = revision_;
  const double begun = secondsNow();
  // Another may have been faster.
  if (growth_)
    if (auto had = inputs.receiver->showShared(grownFor_, givenFor_)) take(std::move(had));
  do {
    if ((!growth_ || seconds_ + secondsNow() - begun > kPatience) && asksForAnother(inputs)) begin(inputs, warnings);
    if (!growth_) break;
    if (!growth_->step(*inputs.receiver)) continue;
    if (coarse_) {
      takeCoarse();
      if (inputs.coarseFirst) break;
      continue;
    }
    const auto whole = std::make_shared<const WholeCoat>(WholeCoat{grownFor_, givenFor_, growth_->take(), growth_->weights()});
    inputs.receiver->share(whole);
    take(whole);
  } while (secondsNow() - begun < inputs.budget);
  if (growth_) seconds_ += secondsNow() - begun;
  return revision_ != before;
}

void CoatStage::dropUnlessFor(const Inputs& inputs) {
  if (asksForAnother(inputs)) growth_.reset();
}

std::array<float, settings::kFurTypes> CoatStage::weights() const {
  std::array<float, settings::kFurTypes> weights{};
  std::copy(coat_->weights.begin(), coat_->weights.end(), weights.begin());
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
