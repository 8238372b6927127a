#include <optional>
#include <string_view>

#include "scene/Formats.h"
#include "scene/Model.h"
#include "scene/TypeSet.h"
#include "scene/import/Readers.h"

namespace fur::scene {

const Material& Model::main() const {
  static const Material plain;
  return mainMaterial < 0 ? plain : materials[static_cast<std::size_t>(mainMaterial)];
}

const EncodedImage& Model::baseColor() const {
  static const EncodedImage none;
  const int image = main().baseColorTexture.image;
  return image < 0 ? none : images[static_cast<std::size_t>(image)];
}

namespace {

const OtherReaders* otherReaders = nullptr;

Error larger(const std::string& name) { return {ErrorId::LargerProgram, name + ": this program does not read such files"}; }

const OtherReaders& othersFor(const std::string& name) {
  if (!otherReaders) throw ImportError(larger(name));
  return *otherReaders;
}

// Nullptr where the format is none of models.
ModelReader readerOf(Format format) {
  switch (format) {
#define FUR_MODEL_FORMAT(id, endings, mime, savedAs, reader) case Format::id: return reader;
#define FUR_FORMAT(id, ...) case Format::id: return nullptr;
#include "scene/Formats.inc"
#undef FUR_MODEL_FORMAT
#undef FUR_FORMAT
  }
  return nullptr;
}

// A .glb begins with "glTF", a .gltf with a brace.
bool isGltf(Bytes bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return text.substr(0, 4) == "glTF" || (start != std::string_view::npos && text[start] == '{');
}

std::optional<Format> formatOf(Bytes bytes, const std::string& name) {
  if (isGltf(bytes)) return Format::Glb;
  const auto named = formatNamed(name);
  return named && readerOf(*named) ? named : othersFor(name).formatOf(bytes, name);
}

Result<Model> importAs(std::optional<Format> format, Bytes bytes, const std::string& name, const FileSet& others) {
  return guardedImport<Model>(name, [&] {
    Model model;
    model.name = name;
    if (!format) format = formatOf(bytes, name);
    if (!format) throw ImportError({ErrorId::BadFile, name + ": this is no model; " + endingsOf(FileKind::Model) + " files are read"});
    readerOf(*format)(bytes, others, model);
    return model;
  });
}

}  // namespace

void readOthersWith(const OtherReaders* readers) { otherReaders = readers; }

void readObj(Bytes bytes, const FileSet& others, Model& model) { othersFor(model.name).obj(bytes, others, model); }
void readFo(Bytes bytes, const FileSet& others, Model& model) { othersFor(model.name).fo(bytes, others, model); }

Result<furgen::FurVolume> readTypeSet(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (!otherReaders) return larger(name);
  return otherReaders->typeSet(bytes, name);
}

Result<CoatFile> readCoat(std::span<const std::uint8_t> bytes, const std::string& file) {
  if (!otherReaders) return larger(file);
  return otherReaders->coat(bytes, file);
}

Result<Model> importModel(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others) {
  return importAs(std::nullopt, bytes, name, others);
}

Result<Model> importGltf(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others) {
  return importAs(Format::Glb, bytes, name, others);
}

Result<Model> importObj(std::span<const std::uint8_t> bytes, const std::string& name) {
  return importAs(Format::Obj, bytes, name, {});
}

Result<Model> importFo(std::span<const std::uint8_t> bytes, const std::string& name) {
  return importAs(Format::Fo, bytes, name, {});
}

}  // namespace fur::scene
