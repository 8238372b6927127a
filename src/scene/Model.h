// A model as read from a file: one mesh, its base colour image still encoded (the platform decodes it).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/Result.h"
#include "geometry/Mesh.h"
#include "scene/FurData.h"
#include "scene/Rig.h"

namespace fur::scene {

struct EncodedImage {
  std::string mimeType;  // "image/png", "image/jpeg" or "image/webp"; empty: no image
  std::vector<std::uint8_t> bytes;
  int width = 0, height = 0;  // from its header
};

struct Model {
  std::string name;
  geometry::Mesh mesh;         // every mesh of the default scene, node transforms applied, fitted to the unit sphere
  EncodedImage baseColor;
  Vec4 baseColorFactor{1.0f};  // linear
  bool isGltf = false;
  bool hasTexcoords = false;   // the file had them for every mesh
  FurData fur;
  Rig rig;                     // its vertices are the mesh's; empty when nothing moves
  geometry::Bounds bounds;     // before fitting, in the file's units
  Warnings warnings;
};

// Limits: over them is too-large, and the text names the limit.
inline constexpr std::size_t kMaxFileBytes = 256u << 20;
inline constexpr std::size_t kMaxVertices = 4'000'000;
inline constexpr std::size_t kMaxTriangles = kMaxVertices;
inline constexpr int kMaxImageSide = 8192;

// Files that came along, by name (a .gltf names its buffers and images relative to itself).
using FileSet = std::map<std::string, std::vector<std::uint8_t>>;

// None of the importers throws. Bytes that are not what they claim to be give a typed error that names
// the file and the place in it, within about a second.

// Any of the formats below: a glTF file is known by its content, the others by the ending of `name`, and
// without a known ending by their first statements. `others` holds what a .gltf refers to.
Result<Model> importModel(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others = {});

// .glb or .gltf; `others` holds external buffers and images.
Result<Model> importGltf(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others = {});

// Wavefront .obj: v, vt, vn and f in any of their spellings, with absolute and relative numbers. Polygons
// become fans round their first corner, which is right for convex ones. Normals are computed where a
// corner has none. v of the texture coordinates is turned over: .obj counts from the bottom of the image,
// glTF from the top. Materials, groups, points, lines and curves are left out, some with a warning.
Result<Model> importObj(std::span<const std::uint8_t> bytes, const std::string& name);

// Sheppard's .fo, see FoModel.h. Its types become 1, 2, .. in ascending order; one warning when they are more than
// groom::kTypes, whose last one then stands for all the others.
Result<Model> importFo(std::span<const std::uint8_t> bytes, const std::string& name);

// What the file of a model has and exportScene() does not write, each in some words with counts and names, as
// "2 of 3 materials"; `bytes` and `others` are what the model was read from. Of glTF alone: what other formats have
// beside their mesh is left out when they are read. At most some dozens of bytes for each name in the file.
using FindLosses = Warnings(const Model& model, std::span<const std::uint8_t> bytes, const FileSet& others);
FindLosses lostBySaving;

// A bare .glb (positions, normals, uv, indices), as any glTF viewer shows it.
std::vector<std::uint8_t> exportGlb(const geometry::Mesh& mesh, const std::string& name);

// The same with everything that importGltf() reads back: the picture, and the extension WETFUR_fur. What is
// empty is left out. A map needs mesh.atlas. The state is JSON, put in as it is.
struct ScenePicture {
  const EncodedImage& image;
  Vec4 factor;
  // A PNG over mesh.atlas that other programs show instead, or nothing.
  std::vector<std::uint8_t> painted{};
};
std::vector<std::uint8_t> exportScene(const geometry::Mesh& mesh, const std::string& name, const FurData& fur,
                                      const ScenePicture& picture);

}  // namespace fur::scene
