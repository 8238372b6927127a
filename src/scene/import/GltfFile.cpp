#include "scene/import/GltfFile.h"

#include <cmath>
#include <cstring>
#include <optional>

#include "core/NumberText.h"
#include "scene/Base64.h"

namespace fur::scene {

namespace {

// A value takes some dozens of bytes in memory where it may take two in the file.
constexpr std::size_t kMaxJsonValues = 1'000'000;
// Each vector moves when the list grows, its bytes stay; views keep pointing at them.
constexpr std::size_t kMaxDecodedBuffers = 1024;
constexpr std::size_t kMaxKeys = 256;

std::uint32_t word(Bytes bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

std::string percentDecoded(const std::string& uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 && hexDigit(uri[i + 2]) >= 0;
    if (escape) {
      out += static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2]));
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

// Extensions that change only how a surface looks, or that we read.
bool canIgnore(const std::string& extension) {
  for (const char* known : {"KHR_mesh_quantization", "KHR_texture_transform", "KHR_lights_punctual",
                            "EXT_texture_webp", "WETFUR_fur"}) {
    if (extension == known) return true;
  }
  return extension.rfind("KHR_materials_", 0) == 0;
}

}  // namespace

GltfFile::GltfFile(Bytes bytes, const std::string& name, const FileSet& others) : name_(name), others_(others) {
  if (bytes.size() > kMaxFileBytes) {
    fail(ErrorId::TooLarge, "the file has %zu bytes; the limit is %zu", bytes.size(), kMaxFileBytes);
  }
  Bytes text = splitContainer(bytes);
  while (!text.empty() && text.back() == 0) text = text.first(text.size() - 1);  // some writers pad with zeros
  checkShape(text);
  nodes_ = parseJson({reinterpret_cast<const char*>(text.data()), text.size()});
  if (nodes_.empty() || !json().isObject()) bad("the JSON cannot be parsed");
  checkVersion();
}

// Leaves the binary chunk in binary_ and returns the JSON.
Bytes GltfFile::splitContainer(Bytes bytes) {
  if (bytes.empty()) bad("the file is empty");
  std::size_t start = 0;
  if (bytes.size() >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf) start = 3;  // byte order mark
  while (start < bytes.size() && std::isspace(bytes[start])) ++start;
  if (start < bytes.size() && bytes[start] == '{') return bytes.subspan(start);

  if (bytes.size() < 4 || word(bytes, 0) != 0x46546c67) bad("this is neither a .glb nor a .gltf");
  if (bytes.size() < 20) bad("the .glb is truncated: its header is not whole");
  const std::uint32_t version = word(bytes, 4), length = word(bytes, 8);
  if (version != 2) fail(ErrorId::UnsupportedVersion, "the .glb has version %u; 2 is read", version);
  if (length > bytes.size()) {
    bad("the .glb is truncated: %zu bytes of %u", bytes.size(), length);
  }
  if (length < 20) bad("the .glb claims a length of %u", length);
  Bytes rest = bytes.subspan(12, length - 12);
  const std::uint32_t jsonLength = word(rest, 0);
  if (word(rest, 4) != 0x4e4f534a) bad("the first chunk is not JSON");
  if (jsonLength > rest.size() - 8) {
    bad("the JSON chunk claims %u bytes; %zu are left", jsonLength, rest.size() - 8);
  }
  const Bytes text = rest.subspan(8, jsonLength);
  rest = rest.subspan(8 + static_cast<std::size_t>(jsonLength));
  while (rest.size() >= 8) {
    const std::uint32_t chunkLength = word(rest, 0);
    if (chunkLength > rest.size() - 8) {
      bad("a chunk claims %u bytes; %zu are left", chunkLength, rest.size() - 8);
    }
    if (word(rest, 4) == 0x004e4942 && !hasBinary_) {
      binary_ = rest.subspan(8, chunkLength);
      hasBinary_ = true;
    }
    rest = rest.subspan(8 + static_cast<std::size_t>(chunkLength));
  }
  return text;
}

// Counts the values before they are given memory.
void GltfFile::checkShape(Bytes text) const {
  std::size_t values = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint8_t c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      else if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == ',' || c == '[' || c == '{' || c == ':') {
      ++values;
    }
  }
  if (values > kMaxJsonValues) {
    fail(ErrorId::TooLarge, "the JSON has over %zu values, which is the limit", kMaxJsonValues);
  }
}

void GltfFile::checkVersion() const {
  const Json* asset = json().find("asset");
  if (!asset || !asset->isObject()) bad("there is no \"asset\"");
  const Json* version = asset->find("version");
  if (!version || !version->isString()) bad("asset.version is missing");
  const std::string text = version->text();
  if (text.rfind("2.", 0) != 0) fail(ErrorId::UnsupportedVersion, "glTF version %.20s; 2.x is read", text.c_str());
  const Json* required = json().find("extensionsRequired");
  if (!required) return;
  if (!required->isArray()) bad("extensionsRequired is not an array");
  for (const Json& extension : *required) {
    if (!extension.isString()) bad("extensionsRequired holds something that is not a name");
    const std::string wanted = extension.text();
    if (!canIgnore(wanted)) {
      fail(ErrorId::UnsupportedVersion, "the file needs the extension %.80s, which is not read", wanted.c_str());
    }
  }
}

const std::vector<const Json*>& GltfFile::list(const char* key) const {
  const auto [at, isNew] = lists_.try_emplace(key);
  const Json* array = isNew ? json().find(key) : nullptr;
  if (!array) return at->second;
  if (!array->isArray()) bad("%s is not an array", key);
  for (const Json& one : *array) {
    if (one.isObject()) expectFewKeys(one, key);
    at->second.push_back(&one);
  }
  return at->second;
}

void GltfFile::expectFewKeys(const Json& object, const std::string& where) const {
  const std::size_t keys = object.count();
  if (keys > kMaxKeys) fail(ErrorId::TooLarge, "%s: an object has %zu keys; the limit is %zu", where.c_str(), keys, kMaxKeys);
}

std::size_t GltfFile::count(const char* key) const { return list(key).size(); }

const Json& GltfFile::element(const char* key, Whole index) const {
  const std::vector<const Json*>& all = list(key);
  if (index >= all.size()) bad("%s[%llu] is used, but there are %zu", key, index, all.size());
  const Json& found = *all[static_cast<std::size_t>(index)];
  if (!found.isObject()) bad("%s[%llu] is not an object", key, index);
  return found;
}

Whole GltfFile::whole(const Json& object, const char* key, const std::string& where) const {
  constexpr Whole kAbsent = ~0ull;
  const Whole value = whole(object, key, kAbsent, where);
  if (value == kAbsent) bad("%s.%s is missing", where.c_str(), key);
  return value;
}

Whole GltfFile::whole(const Json& object, const char* key, Whole absent, const std::string& where) const {
  const Json* found = object.find(key);
  if (!found) return absent;
  // Up to 2^53, what every JSON writer agrees on: sums of two cannot overflow.
  constexpr double kLimit = 9007199254740992.0;
  const double value = found->number();
  if (value >= 0.0 && value <= kLimit && value == std::floor(value)) return static_cast<Whole>(value);
  bad("%s.%s is not a whole number", where.c_str(), key);
}

bool GltfFile::numbers(const Json& object, const char* key, float* out, std::size_t count, const std::string& where) const {
  const Json* found = object.find(key);
  if (!found) return false;
  if (!found->isArray() || found->count() != count) bad("%s.%s does not have %zu numbers", where.c_str(), key, count);
  for (const Json& value : *found) {
    const double number = value.number();
    if (!(std::abs(number) <= 3e38)) bad("%s.%s holds something that is not a finite number", where.c_str(), key);
    *out++ = static_cast<float>(number);
  }
  return true;
}

GltfFile::View GltfFile::bufferView(Whole index) const {
  const Json& view = element("bufferViews", index);
  const std::string where = formatted("bufferViews[%llu]", index);
  const Bytes bytes = buffer(whole(view, "buffer", where));
  const Whole offset = whole(view, "byteOffset", 0, where), length = whole(view, "byteLength", where);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    bad("%s reaches byte %llu of a buffer of %zu", where.c_str(), offset + length, bytes.size());
  }
  const Whole stride = whole(view, "byteStride", 0, where);
  if (stride > 252) bad("%s.byteStride is %llu; 252 is the limit", where.c_str(), stride);
  return {bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)), static_cast<std::size_t>(stride)};
}

Bytes GltfFile::buffer(Whole index) const {
  if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
  const Json& json = element("buffers", index);
  const std::string where = formatted("buffers[%llu]", index);
  const Whole length = whole(json, "byteLength", where);
  Bytes bytes;
  if (const Json* uri = json.find("uri"); !uri) {
    if (index != 0 || !hasBinary_) bad("%s has no uri and the file no binary chunk for it", where.c_str());
    bytes = binary_;
  } else {
    if (!uri->isString()) bad("%s.uri is not a text", where.c_str());
    if (decoded_.size() >= kMaxDecodedBuffers) bad("more than %zu buffers", kMaxDecodedBuffers);
    decoded_.emplace_back();
    const std::string text = uri->text();
    if (!resolve(text, decoded_.back(), bytes)) {
      bad("the buffer file \"%.200s\" did not come along", percentDecoded(text).c_str());
    }
  }
  if (length > bytes.size()) bad("%s claims %llu bytes and has %zu", where.c_str(), length, bytes.size());
  bytes = bytes.first(static_cast<std::size_t>(length));
  buffers_[index] = bytes;
  return bytes;
}

bool GltfFile::resolve(const std::string& uri, std::vector<std::uint8_t>& decoded, Bytes& bytes) const {
  if (uri.rfind("data:", 0) == 0) {
    const std::size_t comma = uri.find(',');
    const bool base64 = comma != std::string::npos && comma >= 12 && uri.compare(comma - 7, 7, ";base64") == 0;
    auto data = base64 ? base64Decoded(std::string_view(uri).substr(comma + 1)) : std::nullopt;
    if (!data) bad("a data: URI is not whole base64");
    decoded = std::move(*data);
    bytes = decoded;
    return true;
  }
  std::string wanted = percentDecoded(uri);
  if (wanted.rfind("./", 0) == 0) wanted.erase(0, 2);
  auto found = others_.find(wanted);
  // Files that were picked or dropped one by one have lost their folder.
  if (found == others_.end()) found = others_.find(wanted.substr(wanted.find_last_of('/') + 1));
  if (found == others_.end()) return false;
  bytes = found->second;
  return true;
}

void GltfFile::failWith(ErrorId id, const std::string& what) const { throw ImportError({id, name_ + ": " + what}); }

void GltfFile::fail(ErrorId id, const char* format, ...) const {
  std::va_list arguments;
  va_start(arguments, format);
  const std::string what = formatted(format, arguments);
  va_end(arguments);
  failWith(id, what);
}

void GltfFile::bad(const char* format, ...) const {
  std::va_list arguments;
  va_start(arguments, format);
  const std::string what = formatted(format, arguments);
  va_end(arguments);
  failWith(ErrorId::BadFile, what);
}

}  // namespace fur::scene
