#include "scene/import/GltfFile.h"

#include <cmath>
#include <cstring>
#include <optional>

namespace fur::scene {

namespace {

// A value takes some dozens of bytes in memory where it may take two in the file.
constexpr std::size_t kMaxJsonValues = 1'000'000;
// Each vector moves when the list grows, its bytes stay; views keep pointing at them.
constexpr std::size_t kMaxDecodedBuffers = 1024;

std::uint32_t word(Bytes bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
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

// RFC 4648 base64; nothing when a character is none of its.
std::optional<std::vector<std::uint8_t>> base64Decoded(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::vector<std::uint8_t> out;
  out.reserve(text.size() * 3 / 4);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    std::uint32_t value;
    if (c >= 'A' && c <= 'Z') value = static_cast<std::uint32_t>(c - 'A');
    else if (c >= 'a' && c <= 'z') value = static_cast<std::uint32_t>(c - 'a' + 26);
    else if (c >= '0' && c <= '9') value = static_cast<std::uint32_t>(c - '0' + 52);
    else if (c == '+' || c == '-') value = 62;
    else if (c == '/' || c == '_') value = 63;
    else return {};
    bits = bits << 6 | value;
    held += 6;
    if (held < 8) continue;
    held -= 8;
    out.push_back(static_cast<std::uint8_t>(bits >> held));
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
    fail(ErrorId::TooLarge, "the file has " + std::to_string(bytes.size()) + " bytes; the limit is " +
                                std::to_string(kMaxFileBytes));
  }
  const Bytes text = splitContainer(bytes);
  checkShape(text);
  json_ = Json::parse(std::string_view(reinterpret_cast<const char*>(text.data()), text.size()), nullptr, false);
  if (!json_.is_object()) bad("the JSON cannot be parsed");
  checkVersion();
}

// Leaves the binary chunk in binary_ and returns the JSON.
Bytes GltfFile::splitContainer(Bytes bytes) {
  std::size_t start = 0;
  if (bytes.size() >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf) start = 3;  // byte order mark
  while (start < bytes.size() && std::isspace(bytes[start])) ++start;
  if (start < bytes.size() && bytes[start] == '{') return bytes.subspan(start);

  if (bytes.size() < 4 || word(bytes, 0) != 0x46546c67) bad("this is neither a .glb (wrong magic) nor a .gltf");
  if (bytes.size() < 20) bad("the .glb is truncated: its header is not whole");
  const std::uint32_t version = word(bytes, 4), length = word(bytes, 8);
  if (version != 2) fail(ErrorId::UnsupportedVersion, "the .glb has version " + std::to_string(version) + "; 2 is read");
  if (length > bytes.size()) {
    bad("the .glb is truncated: " + std::to_string(bytes.size()) + " bytes of " + std::to_string(length));
  }
  if (length < 20) bad("the .glb claims a length of " + std::to_string(length));
  Bytes rest = bytes.subspan(12, length - 12);
  const std::uint32_t jsonLength = word(rest, 0);
  if (word(rest, 4) != 0x4e4f534a) bad("the first chunk is not JSON");
  if (jsonLength > rest.size() - 8) {
    bad("the JSON chunk claims " + std::to_string(jsonLength) + " bytes; " + std::to_string(rest.size() - 8) + " are left");
  }
  const Bytes text = rest.subspan(8, jsonLength);
  rest = rest.subspan(8 + static_cast<std::size_t>(jsonLength));
  while (rest.size() >= 8) {
    const std::uint32_t chunkLength = word(rest, 0);
    if (chunkLength > rest.size() - 8) {
      bad("a chunk claims " + std::to_string(chunkLength) + " bytes; " + std::to_string(rest.size() - 8) + " are left");
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
    fail(ErrorId::TooLarge, "the JSON has over " + std::to_string(kMaxJsonValues) + " values, which is the limit");
  }
}

void GltfFile::checkVersion() const {
  const auto asset = json_.find("asset");
  if (asset == json_.end() || !asset->is_object()) bad("there is no \"asset\"");
  const auto version = asset->find("version");
  if (version == asset->end() || !version->is_string()) bad("asset.version is missing");
  const std::string& text = version->get_ref<const std::string&>();
  if (text.rfind("2.", 0) != 0) fail(ErrorId::UnsupportedVersion, "glTF version " + text.substr(0, 20) + "; 2.x is read");
  const auto required = json_.find("extensionsRequired");
  if (required == json_.end()) return;
  if (!required->is_array()) bad("extensionsRequired is not an array");
  for (const Json& extension : *required) {
    if (!extension.is_string()) bad("extensionsRequired holds something that is not a name");
    const std::string& wanted = extension.get_ref<const std::string&>();
    if (!canIgnore(wanted)) {
      fail(ErrorId::UnsupportedVersion, "the file needs the extension " + wanted.substr(0, 80) + ", which is not read");
    }
  }
}

std::size_t GltfFile::count(const char* key) const {
  const auto array = json_.find(key);
  if (array == json_.end()) return 0;
  if (!array->is_array()) bad(std::string(key) + " is not an array");
  return array->size();
}

const Json& GltfFile::element(const char* key, std::uint64_t index) const {
  const std::size_t size = count(key);
  const std::string where = std::string(key) + "[" + std::to_string(index) + "]";
  if (index >= size) bad(where + " is used, but there are " + std::to_string(size));
  const Json& found = json_[key][static_cast<std::size_t>(index)];
  if (!found.is_object()) bad(where + " is not an object");
  return found;
}

std::uint64_t GltfFile::whole(const Json& object, const char* key, const std::string& where) const {
  constexpr std::uint64_t kAbsent = ~0ull;
  const std::uint64_t value = whole(object, key, kAbsent, where);
  if (value == kAbsent) bad(where + "." + key + " is missing");
  return value;
}

std::uint64_t GltfFile::whole(const Json& object, const char* key, std::uint64_t absent, const std::string& where) const {
  const auto found = object.find(key);
  if (found == object.end()) return absent;
  // Up to 2^53, what every JSON writer agrees on: sums of two cannot overflow.
  constexpr double kLimit = 9007199254740992.0;
  if (found->is_number()) {
    const double value = found->get<double>();
    if (value >= 0.0 && value <= kLimit && value == std::floor(value)) return static_cast<std::uint64_t>(value);
  }
  bad(where + "." + key + " is not a whole number");
}

bool GltfFile::numbers(const Json& object, const char* key, float* out, std::size_t count, const std::string& where) const {
  const auto found = object.find(key);
  if (found == object.end()) return false;
  if (!found->is_array() || found->size() != count) bad(where + "." + key + " does not have " + std::to_string(count) + " numbers");
  for (std::size_t i = 0; i < count; ++i) {
    const Json& value = (*found)[i];
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (!(std::abs(number) <= 3e38)) bad(where + "." + key + " holds something that is not a finite number");
    out[i] = static_cast<float>(number);
  }
  return true;
}

GltfFile::View GltfFile::bufferView(std::uint64_t index) const {
  const Json& view = element("bufferViews", index);
  const std::string where = "bufferViews[" + std::to_string(index) + "]";
  const Bytes bytes = buffer(whole(view, "buffer", where));
  const std::uint64_t offset = whole(view, "byteOffset", 0, where), length = whole(view, "byteLength", where);
  if (offset > bytes.size() || length > bytes.size() - offset) {
    bad(where + " reaches byte " + std::to_string(offset + length) + " of a buffer of " + std::to_string(bytes.size()));
  }
  const std::uint64_t stride = whole(view, "byteStride", 0, where);
  if (stride > 252) bad(where + ".byteStride is " + std::to_string(stride) + "; 252 is the limit");
  return {bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)), static_cast<std::size_t>(stride)};
}

Bytes GltfFile::buffer(std::uint64_t index) const {
  if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
  const Json& json = element("buffers", index);
  const std::string where = "buffers[" + std::to_string(index) + "]";
  const std::uint64_t length = whole(json, "byteLength", where);
  Bytes bytes;
  const auto uri = json.find("uri");
  if (uri == json.end()) {
    if (index != 0 || !hasBinary_) bad(where + " has no uri and the file no binary chunk for it");
    bytes = binary_;
  } else {
    if (!uri->is_string()) bad(where + ".uri is not a text");
    if (decoded_.size() >= kMaxDecodedBuffers) bad("more than " + std::to_string(kMaxDecodedBuffers) + " buffers");
    decoded_.emplace_back();
    const std::string& text = uri->get_ref<const std::string&>();
    if (!resolve(text, decoded_.back(), bytes)) {
      bad("the buffer file \"" + percentDecoded(text).substr(0, 200) + "\" did not come along");
    }
  }
  if (length > bytes.size()) {
    bad(where + " claims " + std::to_string(length) + " bytes and has " + std::to_string(bytes.size()));
  }
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

void GltfFile::fail(ErrorId id, const std::string& what) const { throw ImportError({id, name_ + ": " + what}); }

}  // namespace fur::scene
