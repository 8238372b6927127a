// The extension WETFUR_fur of a glTF file (scene/FurData.h). Throws ImportError as GltfFile does: unsupported-version
// for a newer one, too-large for maps or whiskers over their limit, bad-file for the rest.
#pragma once

#include "scene/Model.h"
#include "scene/import/GltfFile.h"

namespace fur::scene {

// What the extension at the root has; values of vertices are read with the meshes.
struct GltfFur {
  bool present = false;
  bool hasMap = false;
  Whole atlasSet = 0;  // of the maps
  Warnings warnings;
};

// Fills state, maps and whiskers of `fur`; whiskers are in the file's units.
GltfFur readFur(const GltfFile& file, FurData& fur);

}  // namespace fur::scene
