// The extension WETFUR_fur of a glTF file (scene/FurData.h). Throws ImportError as GltfFile does: unsupported-version
// for a newer one, too-large for maps or whiskers over their limit, bad-file for the rest.
#pragma once

#include <optional>
#include <vector>

#include "scene/Model.h"
#include "scene/import/GltfFile.h"

namespace fur::scene {

// What the extension at the root has; values of vertices are read with the meshes.
struct GltfFur {
  bool present = false;
  const Json* surface = nullptr;  // where the maps lie, for readSurface(); null: in texture coordinates
  bool hasMap = false;
  Whole atlasSet = 0;  // of the maps, if they lie in texture coordinates
  std::optional<std::vector<int>> bare;  // materials of the file; -1: primitives without one
  Warnings warnings;
};

// Fills `fur` but for the comb; without a surface whiskers and hair are in the file's units.
GltfFur readFur(const GltfFile& file, FurData& fur);

}  // namespace fur::scene
