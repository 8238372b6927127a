#include <algorithm>
#include <cctype>
#include <string_view>

#include "scene/Model.h"
#include "scene/import/Readers.h"
#include "scene/import/StatementReader.h"

namespace fur::scene {

namespace {

enum class Format { Gltf, Obj, Fo, Unknown };

// A .glb begins with "glTF", a .gltf with a brace.
bool isGltf(Bytes bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return text.substr(0, 4) == "glTF" || (start != std::string_view::npos && text[start] == '{');
}

std::string endingOf(const std::string& name) {
  std::string ending = name.substr(std::min(name.rfind('.'), name.size()));
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

// Both text formats begin with v; the first other statement of a mesh tells them apart.
Format formatOfStatements(Bytes bytes, const std::string& name) {
  for (StatementReader reader(bytes, name); reader.next();) {
    const std::string_view keyword = reader.keyword();
    if (keyword == "vt" || keyword == "vn" || keyword == "f") return Format::Obj;
    if (keyword == "t" || keyword == "p") return Format::Fo;
  }
  return Format::Unknown;
}

Format formatOf(Bytes bytes, const std::string& name) {
  const std::string ending = endingOf(name);
  if (isGltf(bytes) || ending == ".glb" || ending == ".gltf") return Format::Gltf;
  if (ending == ".obj") return Format::Obj;
  if (ending == ".fo") return Format::Fo;
  return formatOfStatements(bytes, name);
}

Result<Model> importAs(Format format, Bytes bytes, const std::string& name, const FileSet& others) {
  return guardedImport<Model>(name, [&] {
    Model model;
    model.name = name;
    switch (format == Format::Unknown ? formatOf(bytes, name) : format) {
      case Format::Gltf: readGltf(bytes, others, model), model.isGltf = true; break;
      case Format::Obj: readObj(bytes, model); break;
      case Format::Fo: readFo(bytes, model); break;
      case Format::Unknown:
        throw ImportError({ErrorId::BadFile, name + ": this is no model; .glb, .gltf, .obj and .fo files are read"});
    }
    return model;
  });
}

}  // namespace

Result<Model> importModel(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others) {
  return importAs(Format::Unknown, bytes, name, others);
}

Result<Model> importGltf(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others) {
  return importAs(Format::Gltf, bytes, name, others);
}

Result<Model> importObj(std::span<const std::uint8_t> bytes, const std::string& name) {
  return importAs(Format::Obj, bytes, name, {});
}

Result<Model> importFo(std::span<const std::uint8_t> bytes, const std::string& name) {
  return importAs(Format::Fo, bytes, name, {});
}

}  // namespace fur::scene
