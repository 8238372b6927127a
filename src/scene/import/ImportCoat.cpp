#include "core/NumberText.h"
#include "scene/CoatFile.h"

#include <algorithm>
#include <cmath>

#include "core/Json.h"
#include "scene/Base64.h"
#include "scene/TypeSet.h"
#include "scene/import/ImportError.h"

namespace fur::scene {

namespace {

// Reads one; what is wrong with it is thrown.
class CoatReader {
 public:
  CoatReader(Bytes bytes, const std::string& file) : file_(file), nodes_(parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) {}

  CoatFile read() {
    if (nodes_.empty() || !nodes_[0].isObject()) fail(ErrorId::BadFile, "it is no JSON object");
    const Json& json = nodes_[0];
    checkVersion(json.find(kCoatVersionKey));
    for (const Json& own : json) {
      const std::string key = own.text();
      const Json& value = own.value();
      if (key == "name") readName(value);
      else if (key == "settings") readValues(value);
      else if (key == "typeSet") out_.files.typeSet = bytesOf(value, "typeSet");
      else if (key == "picture") readPicture(value);
      else if (key != kCoatVersionKey) out_.warnings.push_back("a coat has no \"" + key.substr(0, 64) + '"');
    }
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(ErrorId id, const std::string& text) const { throw ImportError({id, file_ + ": " + text}); }

  void checkVersion(const Json* version) const {
    const double number = version && version->isNumber() ? version->number() : 0;
    if (!(number >= 1) || number != std::floor(number)) fail(ErrorId::BadFile, "it is no coat of this program");
    if (number > kCoatVersion)
      fail(ErrorId::UnsupportedVersion, "version " + std::string(version->source().substr(0, 64)) + ", this program reads up to " + decimal(kCoatVersion));
  }

  void readName(const Json& name) {
    if (!name.isString()) fail(ErrorId::BadFile, "name is not a text");
    out_.name = name.text();
    if (out_.name.size() > kMostCoatNameBytes) fail(ErrorId::TooLarge, formatted("name has %zu bytes; the limit is %zu", out_.name.size(), kMostCoatNameBytes));
  }

  void readValues(const Json& values) {
    if (!values.isObject()) fail(ErrorId::BadFile, "settings is not an object");
    for (const Json& key : values) {
      const std::string name = key.text();
      const Json& value = key.value();
      const settings::Field* field = settings::findField(name);
      if (!field || !field->has(settings::kOfCoat)) out_.warnings.push_back("a coat has no setting \"" + name.substr(0, 64) + '"');
      else if (value.isNumber()) settings::setField(out_.values, *field, value.number(), out_.warnings);
      else settings::setFieldText(out_.values, *field, value.isString() ? value.text() : std::string(value.source()), out_.warnings);
    }
  }

  std::vector<std::uint8_t> bytesOf(const Json& json, const char* key) const {
    auto bytes = json.isString() ? base64Decoded(json.text()) : std::nullopt;
    if (!bytes) fail(ErrorId::BadFile, std::string(key) + " is not base64");
    return std::move(*bytes);
  }

  void readPicture(const Json& json) {
    auto picture = encodedImage(bytesOf(json, "picture"), "picture");
    if (!picture) fail(picture.error().id, picture.error().message);
    out_.files.picture = std::move(*picture);
  }

  const std::string& file_;
  std::vector<Json> nodes_;
  CoatFile out_;
};

}  // namespace

bool isCoatFile(std::span<const std::uint8_t> bytes) {
  const auto first = std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte != ' ' && byte != '\t' && byte != '\r' && byte != '\n'; });
  return first != bytes.end() && *first == '{' && bytes.size() != kTypeSetBytes;
}

Result<CoatFile> readCoatFile(Bytes bytes, const std::string& file) {
  if (bytes.size() > kMostCoatBytes)
    return Error{ErrorId::TooLarge, file + formatted(": a coat of %zu bytes; the limit is %zu", bytes.size(), kMostCoatBytes)};
  return guardedImport<CoatFile>(file, [&] { return CoatReader(bytes, file).read(); });
}

}  // namespace fur::scene
