// The formats behind importModel(): each fills a model that has only its name, or throws. `others`: what came along.
#pragma once

#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

void readGltf(Bytes bytes, const FileSet& others, Model& model);
void readObj(Bytes bytes, const FileSet& others, Model& model);
void readFo(Bytes bytes, const FileSet& others, Model& model);

}  // namespace fur::scene
