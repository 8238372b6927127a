// The readers behind importModel(), which turns what they throw into errors: each fills a model that has only its name, or
// throws, also when the file is larger than kMaxFileBytes. `others`: what came along. Their sources must stand in this folder:
// as wasm it alone has exceptions.
#pragma once

#include <optional>
#include <string>

#include "furgen/FurVolume.h"
#include "scene/CoatFile.h"
#include "scene/Formats.h"
#include "scene/Model.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

using ModelReader = void (*)(Bytes bytes, const FileSet& others, Model& model);
void readGltf(Bytes bytes, const FileSet& others, Model& model);
void readObj(Bytes bytes, const FileSet& others, Model& model);
void readFo(Bytes bytes, const FileSet& others, Model& model);

// What is behind those two, readTypeSet() and readCoat(), once readAllFormats() has been called.
struct OtherReaders {
  std::optional<Format> (*formatOf)(Bytes bytes, const std::string& name);  // of a model by its statements; none: it is none
  ModelReader obj, fo;
  Result<furgen::FurVolume> (*typeSet)(Bytes bytes, const std::string& name);
  Result<CoatFile> (*coat)(Bytes bytes, const std::string& name);
};
void readObjFile(Bytes bytes, const FileSet& others, Model& model);
void readFoFile(Bytes bytes, const FileSet& others, Model& model);
Result<furgen::FurVolume> readTypeSetFile(Bytes bytes, const std::string& name);
Result<CoatFile> readCoatFile(Bytes bytes, const std::string& name);
void readOthersWith(const OtherReaders* readers);

}  // namespace fur::scene
