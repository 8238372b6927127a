#include "render/passes/hair/HairPass.h"

namespace fur::render {

namespace {

std::unique_ptr<HairPass> (*made)() = nullptr;

}  // namespace

void HairPass::drawWith(std::unique_ptr<HairPass> (*maker)()) { made = maker; }
std::unique_ptr<HairPass> HairPass::make() { return made ? made() : std::make_unique<HairPass>(); }

}  // namespace fur::render
