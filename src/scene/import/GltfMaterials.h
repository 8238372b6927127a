// The materials of the primitives that are read, and their images.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/import/GltfFile.h"

namespace fur::scene {

inline constexpr Whole kNoMaterial = ~0ull;

struct TexcoordUse {
  Whole set = 0;     // TEXCOORD_set
  Mat3 transform{1.0f};      // KHR_texture_transform; (u, v, 1) in, out
};

class GltfMaterials {
 public:
  explicit GltfMaterials(const GltfFile& file) : file_(file) {}

  // The material of a primitive; if it shows paint (ScenePicture), the material under the paint.
  Whole of(const Json& primitive, const std::string& where) const;
  // The texture coordinates that a mesh of the material has: those of its base colour, or of its first texture.
  const TexcoordUse& texcoordUse(Whole material);
  // Another set by which other textures of it lie, of those that are read; none: all lie by that one.
  std::optional<Whole> otherSet(Whole material);
  // Another primitive of so many triangles; returns the material's place in Model::materials.
  std::uint8_t count(Whole material, std::size_t triangles);
  // Model::materials, which of them is the main one, and images; after count() for all primitives. An image over kMaxImageSide is
  // too-large; for one that is missing or unreadable there is a warning, and only the factor is used.
  void describe(Model& model);

 private:
  const Json* materialOf(Whole material) const;
  TexcoordUse readTexcoordUse(const Json& texture, const std::string& where) const;
  void readMaterial(Material& out, Whole material, Model& model);
  void readTexture(MaterialTexture& out, const Json* holder, const char* key, Whole material, Model& model);
  int imageOf(Whole texture, const char* what, Model& model);
  int readImage(Whole index, Model& model) const;

  const GltfFile& file_;
  std::vector<Whole> order_;            // of Model::materials
  std::map<Whole, std::uint8_t> numbers_;
  std::vector<std::size_t> triangles_;  // of each
  std::map<Whole, TexcoordUse> uses_;
  std::map<Whole, int> images_;         // those of the file, by their place in Model::images; -1: unreadable
};

}  // namespace fur::scene
