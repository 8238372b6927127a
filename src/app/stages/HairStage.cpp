#include "app/stages/HairStage.h"

namespace fur::app {

namespace {

std::unique_ptr<HairStage> (*makerOfHair)() = nullptr;

}  // namespace

void HairStage::growWith(std::unique_ptr<HairStage> (*maker)()) { makerOfHair = maker; }

std::unique_ptr<HairStage> HairStage::make() { return makerOfHair ? makerOfHair() : std::make_unique<HairStage>(); }

Status HairStage::setValue(std::size_t scalp, std::string_view, std::string_view, Warnings&) {
  return Error{ErrorId::BadFile, "there is no scalp " + std::to_string(scalp)};
}

const HairStage::Growth& HairStage::growth(std::size_t) const {
  static const Growth none;
  return none;
}

}  // namespace fur::app
