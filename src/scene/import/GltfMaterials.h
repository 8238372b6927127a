// Chooses the base colour of a model: that of the textured material with the most triangles.
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

  // The material of a primitive; if it shows paint (ScenePicture), the material under the paint.
  Whole of(const Json& primitive, const std::string& where) const;
  // The texture coordinates of the material's base colour (set 0 without a texture).
  const TexcoordUse& texcoordUse(Whole material);
  void count(Whole material, std::size_t triangles) { triangles_[material] += triangles; }
  // The material whose base colour is used, or kNoMaterial; after count() for all primitives.
  Whole chosen() const;
  // pbrMetallicRoughness.key of a material, or null.
  const Json* part(Whole material, const char* key) const;
  // Sets the base colour factor and image of the chosen material. An image over kMaxImageSide is too-large; for one that is
  // missing or unreadable there is a warning, and only the factor is used.
  void describe(Model& model) const;

 private:
  TexcoordUse readTexcoordUse(Whole material) const;
  void readImage(Model& model, const Json& texture) const;

  const GltfFile& file_;
  std::map<Whole, std::size_t> triangles_;
  std::map<Whole, TexcoordUse> uses_;
};

}  // namespace fur::scene
