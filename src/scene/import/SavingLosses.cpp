#include <algorithm>
#include <map>
#include <set>

#include "scene/Model.h"
#include "scene/import/GltfAccessors.h"
#include "scene/import/GltfFile.h"
#include "scene/import/GltfFur.h"
#include "scene/import/GltfMaterials.h"
#include "scene/import/GltfNodes.h"

namespace fur::scene {

namespace {

// A name of the file as it can stand in a line.
std::string shown(std::string name) {
  constexpr std::size_t kMost = 40;
  if (name.size() > kMost) {
    std::size_t end = kMost;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;  // whole characters of UTF-8
    name.resize(end);
    name += "...";
  }
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return "\"" + name + "\"";
}

// "the camera "front"", "1 camera", "3 cameras ("front", "side" and 1 more)".
std::string counted(std::size_t count, const std::string& what, const std::vector<std::string>& names) {
  if (count == 1 && names.size() == 1) return "the " + what + " " + shown(names[0]);
  std::string out = std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  constexpr std::size_t kMost = 2;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) out += (i ? ", " : " (") + shown(names[i]);
  if (names.size() > kMost) out += " and " + std::to_string(names.size() - kMost) + " more";
  return names.empty() ? out : out + ")";
}

std::string kept(std::size_t lost, std::size_t of, const std::string& what) {
  const std::string plural = what + (of == 1 ? "" : "s");
  return std::to_string(lost) + (lost == of ? " " : " of " + std::to_string(of) + " ") + plural;
}

// By what exportScene() writes: one node with one primitive, positions, normals, the texture coordinates and the base
// colour of one material, and WETFUR_fur. What makes no difference to somebody who wants the furry model back is not
// among them: names, the tree of nodes, tangents, samplers, how the material shines.
class Losses {
 public:
  explicit Losses(const GltfFile& file) : file_(file), materials_(file) {}

  Warnings find() {
    fur_ = readFur(file_, furData_);
    structure();
    materials();
    for (const std::string& data : vertexData_) out_.push_back(data);
    named("skins", "skin");
    named("animations", "animation");
    if (morphTargets_ > 0) out_.push_back(counted(morphTargets_, "morph target", {}));
    named("cameras", "camera");
    lights();
    others();
    return std::move(out_);
  }

 private:
  void lose(std::size_t lost, std::size_t of, const char* what) {
    if (lost > 0) out_.push_back(kept(lost, of, what));
  }

  std::vector<std::string> namesOf(const Json& list) const {
    std::vector<std::string> names;
    for (const Json& one : list)
      if (const Json* name = one.find("name"); name && name->isString()) names.push_back(name->text());
    return names;
  }
  void named(const Json* list, const char* what) {
    const std::size_t count = list && list->isArray() ? list->count() : 0;
    if (count > 0) out_.push_back(counted(count, what, namesOf(*list)));
  }
  void named(const char* key, const char* what) { named(file_.json().find(key), what); }

  void structure() {
    const std::size_t scenes = file_.count("scenes");
    if (scenes > 1) lose(scenes - 1, scenes, "scene");
    std::size_t lines = 0;
    std::set<Whole> meshes;
    for (const PlacedMesh& placed : placedMeshes(file_)) {
      const bool isNew = meshes.insert(placed.mesh).second;
      std::size_t targets = 0;
      for (const Json& primitive : *file_.element("meshes", placed.mesh).find("primitives")) {
        const bool surface = readPrimitive(primitive);
        lines += !surface;
        if (const Json* list = primitive.find("targets"); surface && list && list->isArray()) targets = std::max(targets, list->count());
      }
      if (isNew) morphTargets_ += targets;
    }
    lose(lines, lines, "primitive of points or lines");
  }

  bool readPrimitive(const Json& primitive) {
    const Json* attributes = primitive.find("attributes");
    const Whole mode = file_.whole(primitive, "mode", 4, "a primitive");
    if (mode < 4 || !attributes || !attributes->find("POSITION")) return false;
    const bool indexed = primitive.find("indices") != nullptr;
    const std::size_t corners = elementCount(file_, indexed ? file_.whole(primitive, "indices", "a primitive")
                                                            : file_.whole(*attributes, "POSITION", "a primitive"));
    const Whole material = materials_.of(primitive, "a primitive");
    showsPaint_ |= material != file_.whole(primitive, "material", kNoMaterial, "a primitive");
    materials_.count(material, mode == 4 ? corners / 3 : corners < 3 ? 0 : corners - 2);
    for (const Json& attribute : *attributes) readAttribute(attribute.text(), materials_.texcoordUse(material).set);
    return true;
  }

  void readAttribute(const std::string& name, Whole texcoords) {
    const auto begins = [&](const char* with) { return name.rfind(with, 0) == 0; };
    if (name == "POSITION" || name == "NORMAL" || name == formatted("TEXCOORD_%llu", texcoords)) return;
    if (fur_.present && (begins("_WETFUR_") || (fur_.hasMap && name == formatted("TEXCOORD_%llu", fur_.atlasSet)))) return;
    if ((begins("JOINTS_") || begins("WEIGHTS_")) && file_.count("skins") > 0) return;  // told with the skin
    if (name == "TANGENT" || begins("TEXCOORD_")) return;
    vertexData_.insert(begins("COLOR_") ? "vertex colours" : "the vertex data " + shown(name));
  }

  void materials() {
    const Whole chosen = materials_.chosen();
    // Those of the paint are made anew.
    const auto ours = [&](const char* what) { return file_.count(what) - std::min<std::size_t>(file_.count(what), showsPaint_); };
    const std::size_t count = ours("materials"), images = ours("images");
    const bool keepsOne = chosen != kNoMaterial, keepsTexture = keepsOne && materials_.part(chosen, "baseColorTexture");
    lose(count - keepsOne, count, "material");
    lose(images - std::min<std::size_t>(images, keepsTexture), images, "image");
  }

  void lights() {
    const Json* extensions = file_.json().find("extensions");
    const Json* punctual = extensions ? extensions->find("KHR_lights_punctual") : nullptr;
    named(punctual ? punctual->find("lights") : nullptr, "light");
  }

  // The copyright, extras and extensions, wherever in the file they stand.
  void others() {
    const Json* asset = file_.json().find("asset");
    if (const Json* copyright = asset->find("copyright")) out_.push_back("the copyright notice " + shown(copyright->text()));
    std::size_t extras = 0;
    std::set<std::string> extensions;
    if (const Json* used = file_.json().find("extensionsUsed"); used && used->isArray())
      for (const Json& name : *used) extensions.insert(name.text());
    std::vector<const Json*> open{&file_.json()};
    while (!open.empty()) {
      const Json& json = *open.back();
      open.pop_back();
      if (json.isArray())
        for (const Json& one : json) open.push_back(&one);
      if (!json.isObject()) continue;
      for (const Json& key : json) {
        const std::string name = key.text();
        if (name == "extras") ++extras;
        else if (name != "extensions") open.push_back(&key.value());
        else if (key.value().isObject())
          for (const Json& one : key.value()) extensions.insert(one.text());
      }
    }
    if (extras > 0) out_.push_back(extras == 1 ? "extras of one object" : "extras of " + std::to_string(extras) + " objects");
    for (const char* read : {"WETFUR_fur", "KHR_mesh_quantization", "KHR_texture_transform", "EXT_texture_webp", "KHR_lights_punctual"})
      extensions.erase(read);
    for (const std::string& name : extensions) out_.push_back("the extension " + shown(name));
  }

  const GltfFile& file_;
  GltfMaterials materials_;
  bool showsPaint_ = false;
  FurData furData_;
  GltfFur fur_;
  std::set<std::string> vertexData_;
  std::size_t morphTargets_ = 0;
  Warnings out_;
};

}  // namespace

Warnings lostBySaving(const Model& model, std::span<const std::uint8_t> bytes, const FileSet& others) {
  if (!model.isGltf) return {};
  auto found = guardedImport<Warnings>(model.name, [&] { return Losses(GltfFile(bytes, model.name, others)).find(); });
  return found ? std::move(*found) : Warnings{found.error().message};
}

}  // namespace fur::scene
