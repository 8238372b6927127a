#include "app/LongHair.h"

#include "app/stages/GrownHair.h"
#include "render/passes/hair/DrawnHair.h"
#include "render/passes/hair/HairShaders.h"
#include "render/passes/hairview/HairViews.h"
#include "scene/Model.h"

namespace fur::app {

void growLongHair() {
  HairStage::growWith([]() -> std::unique_ptr<HairStage> { return std::make_unique<GrownHair>(); });
  render::provideHairShaders();
  render::HairPass::drawWith(render::makeDrawnHair);
  render::HairViews::showWith(render::makeHairViews);
  scene::readLongHair();
}

}  // namespace fur::app
