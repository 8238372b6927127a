// The materials of a glTF file (glTF 2.0, 3.9), as bare parts are drawn. Furry ones use base colour alone.
#pragma once

#include <string>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

enum class AlphaMode { Opaque, Mask, Blend };

// How pictures go on beyond their edges, as glTF and OpenGL number it.
inline constexpr int kWrapClamp = 33071, kWrapMirror = 33648, kWrapRepeat = 10497;

struct MaterialTexture {
  int image = -1;        // of Model::images; -1: none
  int wrapS = kWrapRepeat, wrapT = kWrapRepeat;
  Mat3 transform{1.0f};  // (u, v, 1) of the mesh to (u, v, 1) of the image
  bool other = false;    // of the mesh's otherUv
};

struct Material {
  std::string name;
  int source = -1;       // its index in the file; -1: of primitives without one
  std::size_t triangles = 0;
  bool bare = false;     // no fur grows on it: as the file says, or guessed
  Vec4 baseColor{1.0f};  // factors; linear
  Vec3 emissive{0.0f};
  float metallic = 1, roughness = 1, normalScale = 1, occlusionStrength = 1;
  AlphaMode alpha = AlphaMode::Opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  MaterialTexture baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture, emissiveTexture;
};

// More of a file count as the last of these.
inline constexpr std::size_t kMostMaterials = 255;
// Texels of all images of a model together.
inline constexpr std::size_t kMostImageTexels = std::size_t{8192} * 8192;

// Which are bare, by their names (eyes, claws, collars, clothes) and whether one sees through them; not all of them.
void guessBare(std::vector<Material>& materials);

}  // namespace fur::scene
