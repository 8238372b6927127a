// WETFUR_fur.surface: how fur lies on a document whose primitives stay as they are.
#pragma once

#include "scene/Model.h"
#include "scene/import/GltfFile.h"

namespace fur::scene {

// Gives the mesh its layout and the comb, one a vertex. False, and nothing is changed: the model has other vertices or triangles
// than when it was saved, or the layout is no atlas. bad-file for views that do not hold what they should.
bool readSurface(const GltfFile& file, const Json& surface, Model& model);

}  // namespace fur::scene
