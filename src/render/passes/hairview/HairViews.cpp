#include "render/passes/hairview/HairViews.h"

namespace fur::render {

namespace {

std::unique_ptr<HairViews> (*makerOfViews)() = nullptr;

}  // namespace

void HairViews::showWith(std::unique_ptr<HairViews> (*maker)()) { makerOfViews = maker; }

std::unique_ptr<HairViews> HairViews::make() { return makerOfViews ? makerOfViews() : nullptr; }

}  // namespace fur::render
