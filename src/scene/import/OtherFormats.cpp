// Formats beside glTF, which a viewer of models on pages seldom meets.
#include "scene/TypeSet.h"
#include "scene/import/Readers.h"
#include "scene/import/StatementReader.h"

namespace fur::scene {

namespace {

// Both text formats begin with v; the first other statement of a mesh tells them apart.
std::optional<Format> formatOfStatements(Bytes bytes, const std::string& name) {
  for (StatementReader reader(bytes, name); reader.next();) {
    const std::string_view keyword = reader.keyword();
    if (keyword == "vt" || keyword == "vn" || keyword == "f") return Format::Obj;
    if (keyword == "t" || keyword == "p") return Format::Fo;
  }
  return std::nullopt;
}

}  // namespace

void readAllFormats() {
  static constexpr OtherReaders kReaders{formatOfStatements, readObjFile, readFoFile, readTypeSetFile, readCoatFile};
  readOthersWith(&kReaders);
}

}  // namespace fur::scene
