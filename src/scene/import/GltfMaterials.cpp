#include "scene/import/GltfMaterials.h"

#include <algorithm>
#include <cmath>

#include "scene/import/ImageHeader.h"

namespace fur::scene {

namespace {

// What a file could cause any number of.
constexpr std::size_t kMostImageWarnings = 20;

const Json* child(const Json* object, const char* key) {
  return object ? object->find(key) : nullptr;
}

void warn(Model& model, std::string text) {
  if (model.warnings.size() < kMostImageWarnings) model.warnings.push_back(std::move(text));
}

// In the order in which the first that is there gives its texture coordinates to the mesh.
constexpr struct {
  const char* key;
  bool ofRoughness;  // in pbrMetallicRoughness
  MaterialTexture Material::*texture;
} kTextures[] = {
    {"baseColorTexture", true, &Material::baseColorTexture},
    {"normalTexture", false, &Material::normalTexture},
    {"metallicRoughnessTexture", true, &Material::metallicRoughnessTexture},
    {"emissiveTexture", false, &Material::emissiveTexture},
    {"occlusionTexture", false, &Material::occlusionTexture},
};

}  // namespace

const Json* GltfMaterials::materialOf(Whole material) const {
  return material == kNoMaterial ? nullptr : &file_.element("materials", material);
}

Whole GltfMaterials::of(const Json& primitive, const std::string& where) const {
  const Json* below = child(child(&primitive, "extensions"), "WETFUR_fur");
  return file_.whole(child(below, "material") ? *below : primitive, "material", kNoMaterial, where);
}

const TexcoordUse& GltfMaterials::texcoordUse(Whole material) {
  const auto [at, isNew] = uses_.try_emplace(material);
  if (!isNew) return at->second;
  const Json* json = materialOf(material);
  for (const auto& [key, ofRoughness, member] : kTextures) {
    const Json* texture = child(ofRoughness ? child(json, "pbrMetallicRoughness") : json, key);
    if (!texture || !texture->isObject()) continue;
    at->second = readTexcoordUse(*texture, formatted("materials[%llu].%s", material, key));
    break;
  }
  return at->second;
}

std::optional<Whole> GltfMaterials::otherSet(Whole material) {
  const Whole first = texcoordUse(material).set;
  const Json* json = materialOf(material);
  for (const auto& [key, ofRoughness, member] : kTextures) {
    const Json* texture = child(ofRoughness ? child(json, "pbrMetallicRoughness") : json, key);
    if (!texture || !texture->isObject()) continue;
    if (const Whole set = readTexcoordUse(*texture, formatted("materials[%llu].%s", material, key)).set; set != first) return set;
  }
  return {};
}

TexcoordUse GltfMaterials::readTexcoordUse(const Json& texture, const std::string& where) const {
  TexcoordUse use;
  use.set = file_.whole(texture, "texCoord", 0, where);
  const Json* moved = child(child(&texture, "extensions"), "KHR_texture_transform");
  if (!moved || !moved->isObject()) return use;
  use.set = file_.whole(*moved, "texCoord", use.set, where);
  float offset[2] = {0, 0}, scale[2] = {1, 1};
  file_.numbers(*moved, "offset", offset, 2, where);
  file_.numbers(*moved, "scale", scale, 2, where);
  const Json* rotation = child(moved, "rotation");
  const float angle = rotation && rotation->isNumber() ? static_cast<float>(rotation->number()) : 0.0f;
  const float c = std::cos(angle), s = std::sin(angle);
  // translation * rotation * scale, as the extension's text has it.
  const Mat3 transform(Vec3(c * scale[0], -s * scale[0], 0), Vec3(s * scale[1], c * scale[1], 0), Vec3(offset[0], offset[1], 1));
  if (std::isfinite(angle)) use.transform = transform;
  return use;
}

std::uint8_t GltfMaterials::count(Whole material, std::size_t triangles) {
  const auto [at, isNew] = numbers_.try_emplace(material, static_cast<std::uint8_t>(std::min(order_.size(), kMostMaterials - 1)));
  if (isNew && order_.size() < kMostMaterials) {
    order_.push_back(material);
    triangles_.push_back(0);
  }
  triangles_[at->second] += triangles;
  return at->second;
}

void GltfMaterials::describe(Model& model) {
  if (numbers_.size() > kMostMaterials)
    warn(model, formatted("of %zu materials %zu are kept apart, which is the limit", numbers_.size(), kMostMaterials));
  model.materials.resize(order_.size());
  std::size_t most = 0;
  bool textured = false;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    Material& material = model.materials[i];
    material.triangles = triangles_[i];
    if (order_[i] != kNoMaterial) readMaterial(material, order_[i], model);
    // The main one: of those with a picture, else of all, the largest.
    const bool hasTexture = material.baseColorTexture.image >= 0;
    if (hasTexture < textured || (hasTexture == textured && material.triangles <= most)) continue;
    most = material.triangles;
    textured = hasTexture;
    model.mainMaterial = static_cast<int>(i);
  }
}

void GltfMaterials::readMaterial(Material& out, Whole material, Model& model) {
  const Json& json = *materialOf(material);
  const std::string where = formatted("materials[%llu]", material);
  out.source = static_cast<int>(material);
  if (const Json* name = child(&json, "name")) out.name = name->text().substr(0, 200);
  const auto share = [&](const Json* object, const char* key, float& value, float most = 1) {
    const Json* found = child(object, key);
    if (found && found->isNumber()) value = glm::clamp(static_cast<float>(found->number()), 0.0f, most);
  };
  const Json* look = child(&json, "pbrMetallicRoughness");
  if (float rgba[4]; look && file_.numbers(*look, "baseColorFactor", rgba, 4, where))
    out.baseColor = glm::clamp(Vec4(rgba[0], rgba[1], rgba[2], rgba[3]), 0.0f, 1.0f);
  share(look, "metallicFactor", out.metallic);
  share(look, "roughnessFactor", out.roughness);
  if (float rgb[3]; file_.numbers(json, "emissiveFactor", rgb, 3, where)) out.emissive = glm::clamp(Vec3(rgb[0], rgb[1], rgb[2]), 0.0f, 1.0f);
  share(child(&json, "normalTexture"), "scale", out.normalScale, 100);
  share(child(&json, "occlusionTexture"), "strength", out.occlusionStrength);
  share(&json, "alphaCutoff", out.alphaCutoff, 100);
  const Json* mode = child(&json, "alphaMode");
  const std::string alpha = mode ? mode->text() : "";
  out.alpha = alpha == "MASK" ? AlphaMode::Mask : alpha == "BLEND" ? AlphaMode::Blend : AlphaMode::Opaque;
  const Json* sides = child(&json, "doubleSided");
  out.doubleSided = sides && sides->source() == "true";
  for (const auto& [key, ofRoughness, member] : kTextures) readTexture(out.*member, ofRoughness ? look : &json, key, material, model);
}

void GltfMaterials::readTexture(MaterialTexture& out, const Json* holder, const char* key, Whole material, Model& model) {
  const Json* texture = child(holder, key);
  if (!texture) return;
  const std::string where = formatted("materials[%llu].%s", material, key);
  if (!texture->isObject()) file_.bad("%s is not an object", where.c_str());
  const TexcoordUse use = readTexcoordUse(*texture, where);
  const TexcoordUse& ofMesh = texcoordUse(material);
  out.other = use.set != ofMesh.set;
  if (out.other && use.set != otherSet(material)) return warn(model, where + " has a third set of texture coordinates: it is left out");
  const Whole index = file_.whole(*texture, "index", where);
  out.image = imageOf(index, key, model);
  if (out.image < 0) return;
  if (out.other) out.transform = use.transform;
  else if (std::abs(glm::determinant(ofMesh.transform)) > 1e-12f) out.transform = use.transform * glm::inverse(ofMesh.transform);
  const Json& json = file_.element("textures", index);
  if (!child(&json, "sampler")) return;
  const Json& sampler = file_.element("samplers", file_.whole(json, "sampler", where));
  for (const auto& [key, wrap] : {std::pair("wrapS", &out.wrapS), std::pair("wrapT", &out.wrapT)})
    if (const Whole wanted = file_.whole(sampler, key, Whole{kWrapRepeat}, where); wanted == Whole{kWrapClamp} || wanted == Whole{kWrapMirror}) *wrap = static_cast<int>(wanted);
}

int GltfMaterials::imageOf(Whole texture, const char* what, Model& model) {
  const Json& json = file_.element("textures", texture);
  const Json* webp = child(child(&json, "extensions"), "EXT_texture_webp");
  const Json* holder = child(webp, "source") ? webp : &json;
  if (!holder->find("source")) {
    warn(model, formatted("textures[%llu] (%s) has no image of a kind that is read (PNG, JPEG, WebP)", texture, what));
    return -1;
  }
  const Whole index = file_.whole(*holder, "source", formatted("textures[%llu]", texture));
  const auto [at, isNew] = images_.try_emplace(index, -1);
  if (isNew) at->second = readImage(index, model);
  return at->second;
}

int GltfMaterials::readImage(Whole index, Model& model) const {
  const Json& image = file_.element("images", index);
  const std::string where = formatted("images[%llu]", index);
  std::vector<std::uint8_t> decoded;
  Bytes bytes;
  std::string label = where;
  if (const Json* uri = child(&image, "uri"); uri && uri->isString()) {
    const std::string text = uri->text();
    if (text.rfind("data:", 0) != 0) label = "\"" + text.substr(0, 200) + "\"";
    if (!file_.resolve(text, decoded, bytes)) {
      warn(model, "the image file " + label + " did not come along");
      return -1;
    }
  } else {
    bytes = file_.bufferView(file_.whole(image, "bufferView", where)).bytes;
  }
  const auto header = readImageHeader(bytes);
  if (!header || header->width == 0 || header->height == 0) {
    warn(model, "the image " + label + " is no PNG, JPEG or WebP");
    return -1;
  }
  constexpr std::uint32_t kMost = kMaxImageSide;
  if (header->width > kMost || header->height > kMost) {
    file_.fail(ErrorId::TooLarge, "the image %s has %u x %u pixels; the limit is %u a side", label.c_str(), header->width,
               header->height, kMost);
  }
  const std::size_t texels = std::size_t{header->width} * header->height;
  std::size_t before = 0;
  for (const EncodedImage& other : model.images) before += static_cast<std::size_t>(other.width) * static_cast<std::size_t>(other.height);
  if (before + texels > kMostImageTexels) {
    warn(model, formatted("the image %s is left out: the limit is %zu pixels together", label.c_str(), kMostImageTexels));
    return -1;
  }
  model.images.push_back({header->mimeType, {bytes.begin(), bytes.end()}, static_cast<int>(header->width), static_cast<int>(header->height)});
  return static_cast<int>(model.images.size()) - 1;
}

}  // namespace fur::scene
