#include "scene/import/GltfHair.h"
#include "scene/Model.h"

namespace fur::scene {

namespace {

const HairReader* reader = nullptr;

}  // namespace

const HairReader* hairReader() { return reader; }
void readHairWith(const HairReader* one) { reader = one; }

}  // namespace fur::scene
