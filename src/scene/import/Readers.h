// The formats behind importModel(): each fills a model that has only its name, or throws.
#pragma once

#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

void readGltf(Bytes bytes, const FileSet& others, Model& model);
void readObj(Bytes bytes, Model& model);
void readFo(Bytes bytes, Model& model);

}  // namespace fur::scene
