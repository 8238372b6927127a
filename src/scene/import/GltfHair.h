// The long hair of WETFUR_fur.
#pragma once

#include "geometry/Mesh.h"
#include "hair/Scalp.h"
#include "scene/import/GltfFile.h"

namespace fur::scene {

// `hair` of the extension; what is not sound is an error that names it.
struct HairReader {
  // Positions are as they stand in the file.
  hair::Hairstyle (*read)(const GltfFile& file, const Json& hair, Warnings& warnings);
  // Takes them to the space of the model.
  void (*fit)(const GltfFile& file, hair::Hairstyle& hair, const geometry::Fit& fit);
};
// nullptr until scene::readLongHair().
const HairReader* hairReader();
void readHairWith(const HairReader* reader);

}  // namespace fur::scene
