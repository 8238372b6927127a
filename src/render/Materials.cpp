#include "render/Materials.h"

#include <algorithm>
#include <array>

#include "shared/Material.h"

namespace fur::render {

namespace {

gl::Texture onePixel(const std::array<std::uint8_t, 4>& rgba) { return gl::Texture({gl::TexelFormat::RGBA8, 1, 1, 0}, gl::bytesOf(rgba)); }

void fillRows(const scene::MaterialTexture& texture, Vec4 (&rows)[2]) {
  for (int k = 0; k < 2; ++k) rows[k] = Vec4(texture.transform[0][k], texture.transform[1][k], texture.transform[2][k], texture.other);
}

shared::MaterialBlock blockOf(const scene::Material& from) {
  shared::MaterialBlock block{};
  block.baseColorFactor = from.baseColor;
  block.emissiveFactor = Vec4(from.emissive, 1);
  fillRows(from.normalTexture, block.normalRows);
  fillRows(from.metallicRoughnessTexture, block.roughnessRows);
  fillRows(from.occlusionTexture, block.occlusionRows);
  fillRows(from.emissiveTexture, block.emissiveRows);
  block.metallicFactor = from.metallic;
  block.roughnessFactor = from.roughness;
  block.normalScale = from.normalScale;
  block.occlusionStrength = from.occlusionStrength;
  block.alphaMode = static_cast<float>(from.alpha);
  block.alphaCutoff = from.alphaCutoff;
  return block;
}

}  // namespace

std::size_t Materials::create() {
  white_ = onePixel({255, 255, 255, 255});
  flat_ = onePixel({128, 128, 255, 255});
  return set(std::array<scene::Material, 1>{}, 0);
}

std::size_t Materials::set(std::span<const scene::Material> materials, std::size_t main) {
  parts_.clear();
  images_.clear();
  main_ = main;
  const shared::FurBlock coat{};
  for (const scene::Material& material : materials)
    parts_.push_back({material, gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(coat), true),
                      gl::Buffer(gl::BufferKind::Uniform, gl::bytesOf(blockOf(material)), false)});
  setBare({});
  return parts_.size() * (sizeof coat + sizeof(shared::MaterialBlock));
}

void Materials::setBare(std::span<const std::uint8_t> bare) {
  anyBare_ = false;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].bare = i < bare.size() && bare[i];
    anyBare_ |= parts_[i].bare;
  }
  findPictures();
}

std::size_t Materials::setImage(std::size_t image, int width, int height, const Pixels& rgba, SharedThings& shared) {
  if (images_.size() <= image) images_.resize(image + 1);
  // One that parts use in different ways repeats.
  int wrapU = 0, wrapV = 0;
  const auto note = [](int& wrap, int wanted) { wrap = wrap == 0 || wrap == wanted ? wanted : scene::kWrapRepeat; };
  for (const Part& part : parts_)
    for (const auto texture : {&scene::Material::baseColorTexture, &scene::Material::metallicRoughnessTexture, &scene::Material::normalTexture,
                               &scene::Material::occlusionTexture, &scene::Material::emissiveTexture})
      if (const scene::MaterialTexture& of = part.material.*texture; of.image == static_cast<int>(image)) note(wrapU, of.wrapS), note(wrapV, of.wrapT);
  const std::uint64_t number = reinterpret_cast<std::uintptr_t>(rgba.get()) ^ std::uint64_t(wrapU) << 32 ^ std::uint64_t(wrapV) << 48;
  auto& kept = images_[image] = std::static_pointer_cast<SharedPicture>(shared.find(number));
  const bool isNew = !kept;
  if (isNew) {
    kept = std::make_shared<SharedPicture>(SharedPicture{rgba, {}});
    kept->texture = gl::Texture({gl::TexelFormat::RGBA8, width, height, 0, gl::Filter::Trilinear, true, 0, wrapU, wrapV}, gl::bytesOf(*rgba));
    shared.add(number, kept);
  }
  findPictures();
  return isNew ? kept->texture.bytes() : 0;
}

void Materials::findPictures() {
  hasPicture_ = std::any_of(parts_.begin(), parts_.end(),
                            [this](const Part& part) { return !part.bare && &pictureOf(part.material.baseColorTexture, white_) != &white_; });
}

const gl::Texture& Materials::pictureOf(const scene::MaterialTexture& texture, const gl::Texture& without) const {
  const auto image = static_cast<std::size_t>(texture.image);
  return texture.image >= 0 && image < images_.size() && images_[image] ? images_[image]->texture : without;
}

void Materials::bind(std::size_t i) const {
  pictureOf(parts_[i].material.baseColorTexture, white_).bind(FUR_UNIT_BASE_COLOR);
  parts_[i].coat.bindAsBlock(FUR_COAT_BINDING);
}

void Materials::bindBare(std::size_t i) const {
  const scene::Material& material = parts_[i].material;
  pictureOf(material.baseColorTexture, white_).bind(FUR_UNIT_BASE_COLOR);
  pictureOf(material.normalTexture, flat_).bind(FUR_UNIT_NORMALS);
  pictureOf(material.metallicRoughnessTexture, white_).bind(FUR_UNIT_ROUGHNESS);
  pictureOf(material.occlusionTexture, white_).bind(FUR_UNIT_OCCLUSION);
  pictureOf(material.emissiveTexture, white_).bind(FUR_UNIT_EMISSIVE);
  parts_[i].block.bindAsBlock(FUR_MATERIAL_BINDING);
}

std::size_t Materials::bytes() const {
  std::size_t sum = white_.bytes() + flat_.bytes();
  for (const auto& image : images_)
    if (image) sum += image->texture.bytes() / static_cast<std::size_t>(image.use_count());
  for (const Part& part : parts_) sum += part.coat.bytes() + part.block.bytes();
  return sum;
}

}  // namespace fur::render
