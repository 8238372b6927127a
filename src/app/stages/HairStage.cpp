#include "app/stages/HairStage.h"
#include "core/NumberText.h"

namespace fur::app {

namespace {

std::unique_ptr<HairStage> (*makerOfHair)() = nullptr;

}  // namespace

void HairStage::growWith(std::unique_ptr<HairStage> (*maker)()) { makerOfHair = maker; }

std::unique_ptr<HairStage> HairStage::make() { return makerOfHair ? makerOfHair() : std::make_unique<HairStage>(); }

Status HairStage::setValue(std::size_t scalp, std::string_view, std::string_view, Warnings&) {
  return Error{ErrorId::BadFile, "there is no scalp " + decimal(scalp)};
}

Status HairStage::readFile(const ShapeStage&, const groom::GroomSurface&, std::span<const std::uint8_t>, const std::string& name) {
  return Error{ErrorId::LargerProgram, name + ": this program does not grow long hair"};
}

Result<std::vector<std::uint8_t>> HairStage::writeFile() const { return Error{ErrorId::BadFile, "there is no hair to save"}; }

const HairStage::Growth& HairStage::growth(std::size_t) const {
  static const Growth none;
  return none;
}

}  // namespace fur::app
