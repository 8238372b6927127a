// Writes a glTF document back with other fur: the text of its JSON is copied as it stands, but for what has to change.
#include <algorithm>
#include <optional>
#include <utility>

#include "core/Json.h"
#include "core/NumberText.h"
#include "scene/Base64.h"
#include "scene/Model.h"
#include "scene/export/FurExtension.h"
#include "scene/export/GlbWriter.h"
#include "scene/import/GltfFile.h"
#include "scene/import/ImageHeader.h"

namespace fur::scene {

namespace {

constexpr std::string_view kOwn = "WETFUR_fur";  // also the name of our views and buffer
const std::string kNamedOwn = R"(,"name":"WETFUR_fur")";

// Keys and their new values, as JSON; "" removes the key.
using Changes = std::vector<std::pair<std::string_view, std::string>>;

// The object with those changes, which come last. `object` may be null.
std::string changed(const Json* object, const Changes& changes) {
  std::string out;
  const auto add = [&](std::string_view key, std::string_view value) {
    out.append(out.empty() ? "{" : ",").append(key).append(":").append(value);
  };
  if (object && object->isObject())
    for (const Json& key : *object) {
      const std::string name = key.text();
      if (std::none_of(changes.begin(), changes.end(), [&](const auto& change) { return change.first == name; })) add(key.source(), key.value().source());
    }
  for (const auto& [key, value] : changes)
    if (!value.empty()) add(jsonString(key), value);
  return out.empty() ? "{}" : out + "}";
}

std::string jsonArray(const std::vector<std::string>& elements) {
  std::string out;
  for (const std::string& element : elements) out.append(out.empty() ? "[" : ",").append(element);
  return out.empty() ? "[]" : out + "]";
}

std::vector<const Json*> elementsOf(const Json* array) {
  std::vector<const Json*> out;
  if (array && array->isArray())
    for (const Json& element : *array) out.push_back(&element);
  return out;
}

std::string textOf(const Json& object, const char* key) {
  const Json* found = object.find(key);
  return found ? found->text() : "";
}

double numberOf(const Json& object, const char* key, double absent) {
  const Json* found = object.find(key);
  return found && found->isNumber() ? found->number() : absent;
}

bool isExternal(const std::string& uri) { return !uri.empty() && uri.rfind("data:", 0) != 0; }

std::string dataUri(Bytes bytes) { return "data:application/octet-stream;base64," + base64Encoded(bytes); }

std::optional<Bytes> bytesOfBuffer(const GltfFile& file, std::size_t index) {
  try {
    return file.buffer(index);
  } catch (const ImportError&) {
    return {};
  }
}

// An image of a file beside the model's, if it is there and of a kind that a .glb can hold.
std::optional<std::pair<Bytes, std::string>> imageBeside(const GltfFile& file, const std::string& uri) {
  std::vector<std::uint8_t> decoded;
  Bytes bytes;
  if (!file.resolve(uri, decoded, bytes)) return {};
  const auto header = readImageHeader(bytes);
  if (!header) return {};
  return std::pair(bytes, header->mimeType);
}

// All chunks of a .glb but the JSON and the first binary one.
std::vector<std::uint8_t> furtherChunks(Bytes glb) {
  std::vector<std::uint8_t> out;
  if (glb.size() < 20 || std::string_view(reinterpret_cast<const char*>(glb.data()), 4) != "glTF") return out;
  const auto word = [&](std::size_t at) { return glb[at] | std::size_t{glb[at + 1]} << 8 | std::size_t{glb[at + 2]} << 16 | std::size_t{glb[at + 3]} << 24; };
  glb = glb.first(std::min(word(8), glb.size()));
  bool json = true, binary = true;
  for (std::size_t at = 12; at + 8 <= glb.size();) {
    const std::size_t end = at + 8 + word(at), type = word(at + 4);
    if (end > glb.size()) break;
    const bool known = std::exchange(json, false) || (type == 0x004e4942 && std::exchange(binary, false));
    if (!known) out.insert(out.end(), glb.begin() + static_cast<std::ptrdiff_t>(at), glb.begin() + static_cast<std::ptrdiff_t>(end));
    at = end;
  }
  padTo4(out, 0);
  return out;
}

class DocumentWriter {
 public:
  explicit DocumentWriter(const SourceFile& source) : source_(source), file_(source.bytes, source.name, source.others) {}

  std::vector<std::uint8_t> write(const FurSurface& surface, const FurData& fur) {
    takeBuffers();
    takeViews();
    embedImages();
    writer_.viewExtra = kNamedOwn;
    const std::string own = furExtension(writer_, fur, {.hasAtlas = true, .ofMaps = "", .ofRoot = surfaceJson(surface, fur), .version = 2});
    const Json& root = file_.json();
    std::vector<std::string> used;
    for (const Json* name : elementsOf(root.find("extensionsUsed")))
      if (name->text() != kOwn) used.emplace_back(name->source());
    used.push_back(jsonString(kOwn));
    std::string views = jsonArray(views_);
    views.insert(views.size() - 1, (views_.empty() ? "" : ",") + writer_.views);
    Changes changes = {{"buffers", jsonArray(buffers())}, {"bufferViews", std::move(views)}, {"extensionsUsed", jsonArray(used)},
                       {"extensions", changed(root.find("extensions"), {{kOwn, own}})}};
    if (!images_.empty()) changes.emplace_back("images", jsonArray(images_));
    const std::string json = changed(&root, changes);
    return glbContainer(json, isBinary_ ? Bytes(writer_.binary) : Bytes(), furtherChunks(source_.bytes));
  }

 private:
  // The first buffer becomes the binary chunk, to which ours is added; others are kept as they are. Where the first has no bytes
  // (its file did not come along, or an extension says how it is filled), ours is one more.
  void takeBuffers() {
    for (const Json* buffer : elementsOf(file_.json().find("buffers"))) {
      const std::size_t index = buffers_.size();
      const std::string uri = textOf(*buffer, "uri");
      const auto bytes = index == 0 || isExternal(uri) ? bytesOfBuffer(file_, index) : std::nullopt;
      if (index == 0 && bytes) writer_.binary.assign(bytes->begin(), bytes->end());
      if (index == 0) isBinary_ = bytes.has_value(), first_ = buffer;
      const bool own = index > 0 && textOf(*buffer, "name") == kOwn;
      if (!own) buffers_.push_back(index > 0 && bytes ? changed(buffer, {{"uri", jsonString(dataUri(*bytes))}}) : std::string(buffer->source()));
    }
    isBinary_ |= buffers_.empty();
    writer_.buffer = isBinary_ ? 0 : static_cast<int>(buffers_.size());
  }

  // The buffers with the length that the binary has by now.
  std::vector<std::string> buffers() const {
    std::vector<std::string> out = buffers_;
    Changes changes = {{"uri", ""}, {"byteLength", decimal(writer_.binary.size())}};
    if (out.empty()) out.emplace_back();
    if (isBinary_) {
      out[0] = changed(first_, changes);
    } else {
      changes[0].second = jsonString(dataUri(writer_.binary));
      changes.emplace_back("name", jsonString(kOwn));
      out.push_back(changed(nullptr, changes));
    }
    return out;
  }

  // 1 + the greatest bufferView that anything but our extension uses.
  double viewsUsed() const {
    double used = 0;
    std::vector<const Json*> open{&file_.json()};
    while (!open.empty()) {
      const Json& json = *open.back();
      open.pop_back();
      if (json.isArray())
        for (const Json& element : json) open.push_back(&element);
      if (!json.isObject()) continue;
      for (const Json& key : json) {
        const std::string name = key.text();
        if (name == "bufferView" && key.value().isNumber()) used = std::max(used, key.value().number() + 1);
        if (name != kOwn) open.push_back(&key.value());
      }
    }
    return used;
  }

  // Those of the fur that was read go, with their bytes, where they are the last.
  void takeViews() {
    const std::vector<const Json*> all = elementsOf(file_.json().find("bufferViews"));
    std::size_t kept = all.size();
    const double used = viewsUsed();
    while (kept > 0 && static_cast<double>(kept) > used && textOf(*all[kept - 1], "name") == kOwn) --kept;
    double end = 0, cut = static_cast<double>(writer_.binary.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool mine = isBinary_ && numberOf(*all[i], "buffer", -1) == 0;
      const double offset = numberOf(*all[i], "byteOffset", 0);
      if (i < kept) views_.emplace_back(all[i]->source());
      if (mine && i < kept) end = std::max(end, offset + numberOf(*all[i], "byteLength", 0));
      if (mine && i >= kept) cut = std::min(cut, offset);
    }
    if (end <= cut && cut >= 0) writer_.binary.resize(static_cast<std::size_t>(cut));
    writer_.viewCount = static_cast<int>(kept);
  }

  void embedImages() {
    const std::vector<const Json*> all = elementsOf(file_.json().find("images"));
    bool any = false;
    for (const Json* image : all) {
      const std::string uri = textOf(*image, "uri");
      const auto found = isExternal(uri) ? imageBeside(file_, uri) : std::nullopt;
      any |= found.has_value();
      if (!found) {
        images_.emplace_back(image->source());
        continue;
      }
      Changes changes = {{"uri", ""}, {"bufferView", decimal(writer_.addView(found->first))}, {"mimeType", jsonString(found->second)}};
      if (!image->find("name")) changes.emplace_back("name", jsonString(uri));
      images_.push_back(changed(image, changes));
    }
    if (!any) images_.clear();
  }

  std::string surfaceJson(const FurSurface& surface, const FurData& fur) {
    std::string out = ",\"surface\":{\"vertices\":" + decimal(surface.vertices) + ",\"indices\":" + decimal(writer_.addBytes(surface.indices)) +
                      ",\"atlas\":" + decimal(writer_.addBytes(surface.atlas)) + ",\"charts\":" + decimal(writer_.addBytes(surface.charts));
    if (!fur.comb.empty()) out += ",\"comb\":" + decimal(writer_.addBytes(fur.comb));
    return out + "}";
  }

  const SourceFile& source_;
  GltfFile file_;
  GlbWriter writer_;
  std::vector<std::string> buffers_, views_, images_;  // JSON; no images: they stay as they are
  const Json* first_ = nullptr;  // buffer; null: there is none
  bool isBinary_ = false;        // ours is the binary chunk
};

// What exportScene() wrote and nobody has added to: one node, no extras, no other extensions.
bool isOurs(const GltfFile& file) {
  const Json& root = file.json();
  const Json* asset = root.find("asset");
  if (textOf(*asset, "generator") != "wet-fur" || file.count("nodes") != 1 || root.source().find("\"extras\"") != std::string_view::npos) return false;
  for (const char* key : {"skins", "animations", "cameras", "samplers", "extensionsRequired"})
    if (root.find(key)) return false;
  for (const Json* name : elementsOf(root.find("extensionsUsed")))
    if (name->text() != kOwn && name->text() != "EXT_texture_webp") return false;
  const Json* extensions = root.find("extensions");
  const Json* own = extensions ? extensions->find(kOwn) : nullptr;
  return !own || !own->find("surface");
}

std::shared_ptr<const SourceFile> keep(Bytes bytes, const std::string& name, const FileSet& others) {
  auto ours = guardedImport<bool>(name, [&] { return isOurs(GltfFile(bytes, name, others)); });
  if (!ours || *ours) return nullptr;
  return std::make_shared<const SourceFile>(SourceFile{name, {bytes.begin(), bytes.end()}, others});
}

Warnings besideDocument(const SourceFile& source) {
  auto found = guardedImport<Warnings>(source.name, [&] {
    const GltfFile file(source.bytes, source.name, source.others);
    Warnings out;
    std::size_t index = 0;
    const auto add = [&](const char* what, const std::string& uri) { out.push_back(formatted("the %s file \"%.200s\", which stays beside it", what, uri.c_str())); };
    for (const Json* buffer : elementsOf(file.json().find("buffers"))) {
      const std::string uri = textOf(*buffer, "uri");
      if (isExternal(uri) && !bytesOfBuffer(file, index)) add("buffer", uri);
      ++index;
    }
    for (const Json* image : elementsOf(file.json().find("images")))
      if (const std::string uri = textOf(*image, "uri"); isExternal(uri) && !imageBeside(file, uri)) add("image", uri);
    return out;
  });
  return found ? *found : Warnings{};
}

std::vector<std::uint8_t> exportDocument(const SourceFile& source, const FurSurface& surface, const FurData& fur) {
  return DocumentWriter(source).write(surface, fur);
}

}  // namespace

FurSurface furSurface(const geometry::Surface& surface, const geometry::Mesh& mesh) {
  const geometry::OwnSurface own = geometry::ownSurface(surface, mesh);
  FurSurface out;
  out.vertices = mesh.positions.size();
  for (const geometry::SurfaceVertex& v : own.surface.vertices) out.atlas.push_back(v.atlas), out.charts.push_back(v.chart);
  // The surface has left out triangles without an area.
  auto next = own.surface.indices.begin();
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) out.indices.push_back(geometry::hasArea(mesh, i / 3) ? *next++ : 0);
  return out;
}

const DocumentKeeping kDocumentKeeping{keep, besideDocument, exportDocument};

}  // namespace fur::scene
