#include "app/LongHair.h"

#include "app/stages/GrownHair.h"
#include "scene/Model.h"

namespace fur::app {

void growLongHair() {
  HairStage::growWith([]() -> std::unique_ptr<HairStage> { return std::make_unique<GrownHair>(); });
  scene::readLongHair();
}

}  // namespace fur::app
