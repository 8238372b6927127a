#include "scene/import/GltfMaterials.h"

#include <cmath>

#include "scene/import/ImageHeader.h"

namespace fur::scene {

namespace {

const Json* child(const Json* object, const char* key) {
  return object ? object->find(key) : nullptr;
}

}  // namespace

const Json* GltfMaterials::part(Whole material, const char* key) const {
  if (material == kNoMaterial) return nullptr;
  return child(child(&file_.element("materials", material), "pbrMetallicRoughness"), key);
}

Whole GltfMaterials::of(const Json& primitive, const std::string& where) const {
  const Json* below = child(child(&primitive, "extensions"), "WETFUR_fur");
  return file_.whole(child(below, "material") ? *below : primitive, "material", kNoMaterial, where);
}

const TexcoordUse& GltfMaterials::texcoordUse(Whole material) {
  const auto [at, isNew] = uses_.try_emplace(material);
  if (isNew) at->second = readTexcoordUse(material);
  return at->second;
}

TexcoordUse GltfMaterials::readTexcoordUse(Whole material) const {
  TexcoordUse use;
  const Json* texture = part(material, "baseColorTexture");
  if (!texture || !texture->isObject()) return use;
  const std::string where = formatted("materials[%llu].baseColorTexture", material);
  use.set = file_.whole(*texture, "texCoord", 0, where);
  const Json* moved = child(child(texture, "extensions"), "KHR_texture_transform");
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

Whole GltfMaterials::chosen() const {
  Whole chosen = kNoMaterial;
  std::size_t most = 0;
  bool chosenTextured = false;
  for (const auto& [material, triangles] : triangles_) {
    const bool hasTexture = part(material, "baseColorTexture") != nullptr;
    if (hasTexture < chosenTextured || (hasTexture == chosenTextured && triangles <= most)) continue;
    chosen = material;
    most = triangles;
    chosenTextured = hasTexture;
  }
  return chosen;
}

void GltfMaterials::describe(Model& model) const {
  const Whole chosen = this->chosen();
  if (chosen == kNoMaterial) return;
  std::size_t textured = 0;
  for (const auto& counted : triangles_) textured += part(counted.first, "baseColorTexture") != nullptr;
  if (textured > 1) model.warnings.push_back(formatted("of %zu textured materials the largest is used", textured));
  const std::string where = formatted("materials[%llu]", chosen);
  const Json* look = child(&file_.element("materials", chosen), "pbrMetallicRoughness");
  if (float rgba[4]; look && file_.numbers(*look, "baseColorFactor", rgba, 4, where)) {
    model.baseColorFactor = glm::clamp(Vec4(rgba[0], rgba[1], rgba[2], rgba[3]), 0.0f, 1.0f);
  }
  if (const Json* texture = part(chosen, "baseColorTexture")) {
    if (!texture->isObject()) file_.bad("%s.baseColorTexture is not an object", where.c_str());
    readImage(model, file_.element("textures", file_.whole(*texture, "index", where + ".baseColorTexture")));
  }
}

void GltfMaterials::readImage(Model& model, const Json& texture) const {
  const Json* webp = child(child(&texture, "extensions"), "EXT_texture_webp");
  const Json* holder = child(webp, "source") ? webp : &texture;
  if (!holder->find("source")) {
    model.warnings.push_back("the base colour texture has no image of a kind that is read (PNG, JPEG, WebP)");
    return;
  }
  const Whole index = file_.whole(*holder, "source", "the base colour texture");
  const Json& image = file_.element("images", index);
  const std::string where = formatted("images[%llu]", index);
  std::vector<std::uint8_t> decoded;
  Bytes bytes;
  std::string label = where;
  if (const Json* uri = child(&image, "uri"); uri && uri->isString()) {
    const std::string text = uri->text();
    if (text.rfind("data:", 0) != 0) label = "\"" + text.substr(0, 200) + "\"";
    if (!file_.resolve(text, decoded, bytes)) {
      model.warnings.push_back("the image file " + label + " did not come along");
      return;
    }
  } else {
    bytes = file_.bufferView(file_.whole(image, "bufferView", where)).bytes;
  }
  const auto header = readImageHeader(bytes);
  if (!header || header->width == 0 || header->height == 0) {
    model.warnings.push_back("the image " + label + " is no PNG, JPEG or WebP");
    return;
  }
  constexpr std::uint32_t kMost = kMaxImageSide;
  if (header->width > kMost || header->height > kMost) {
    file_.fail(ErrorId::TooLarge, "the image %s has %u x %u pixels; the limit is %u a side", label.c_str(), header->width,
               header->height, kMost);
  }
  model.baseColor = {header->mimeType, {bytes.begin(), bytes.end()}, static_cast<int>(header->width),
                     static_cast<int>(header->height)};
}

}  // namespace fur::scene
