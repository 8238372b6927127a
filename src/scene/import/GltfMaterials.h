// The one base colour of a model: of its materials, the textured one that covers the most triangles.
#pragma once

#include <cstdint>
#include <map>

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

  // The material of a primitive; of one that shows paint (ScenePicture) the one below that.
  Whole of(const Json& primitive, const std::string& where) const;
  // Which texture coordinates the material's base colour reads (set 0 without a texture).
  const TexcoordUse& texcoordUse(Whole material);
  void count(Whole material, std::size_t triangles) { triangles_[material] += triangles; }
  // Of those that were counted the one whose base colour is the model's, or kNoMaterial.
  Whole chosen() const;
  // pbrMetallicRoughness.key of a material, or null.
  const Json* part(Whole material, const char* key) const;
  // Base colour factor and image of the chosen material. An image over kMaxImageSide is too-large; one
  // that is missing or unreadable is a warning, and the factor alone remains.
  void describe(Model& model) const;

 private:
  TexcoordUse readTexcoordUse(Whole material) const;
  void readImage(Model& model, const Json& texture) const;

  const GltfFile& file_;
  std::map<Whole, std::size_t> triangles_;
  std::map<Whole, TexcoordUse> uses_;
};

}  // namespace fur::scene
