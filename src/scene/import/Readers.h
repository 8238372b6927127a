// The readers behind importModel(), which turns what they throw into errors: each fills a model that has only its name, or
// throws, also when the file is larger than kMaxFileBytes. `others`: what came along. Their sources must stand in this folder:
// as wasm it alone has exceptions.
#pragma once

#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

void readGltf(Bytes bytes, const FileSet& others, Model& model);
void readObj(Bytes bytes, const FileSet& others, Model& model);
void readFo(Bytes bytes, const FileSet& others, Model& model);

}  // namespace fur::scene
