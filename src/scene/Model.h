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
  geometry::Mesh mesh;         // all meshes of the default scene, transformed by their nodes, fitted to the unit sphere
  EncodedImage baseColor;
  Vec4 baseColorFactor{1.0f};  // linear
  bool isGltf = false;
  bool hasTexcoords = false;   // the file has texture coordinates for all meshes
  FurData fur;
  Rig rig;                     // its vertices are the mesh's; empty when nothing moves
  geometry::Bounds bounds;     // before fitting, in the file's units
  Warnings warnings;
};

// Limits; beyond them is the error too-large, whose text names the limit.
inline constexpr std::size_t kMaxFileBytes = 256u << 20;
inline constexpr std::size_t kMaxVertices = 4'000'000;
inline constexpr std::size_t kMaxTriangles = kMaxVertices;
inline constexpr int kMaxImageSide = 8192;

// Files beside the model's, by name relative to it: buffers and images of a .gltf.
using FileSet = std::map<std::string, std::vector<std::uint8_t>>;

// Importers never throw. Invalid files give an error that names the file and the place in it, within about a second.

// Reads any of the formats below. glTF is recognised by its content, the others by the ending of `name`, or by their first
// statements if the ending is unknown.
Result<Model> importModel(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others = {});

// From then on models have their long hair; before, such a model is an error, long-hair.
void readLongHair();

// .glb or .gltf; `others` holds external buffers and images.
Result<Model> importGltf(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others = {});

// Wavefront .obj: v, vt, vn and f with absolute or relative indices. Polygons become fans round their first corner, which is
// correct for convex ones. Missing normals are computed. v of texture coordinates is flipped: .obj counts from the bottom of
// the image, glTF from the top. Materials, groups, points, lines and curves are left out, some with a warning.
Result<Model> importObj(std::span<const std::uint8_t> bytes, const std::string& name);

// Sheppard's .fo, see FoModel.h. Its types become 1, 2, .. in ascending order. If there are more than groom::kTypes, the others
// become the last one, with a warning.
Result<Model> importFo(std::span<const std::uint8_t> bytes, const std::string& name);

// Parts of a glTF file that exportScene() does not write, each as a phrase with counts and names ("2 of 3 materials"); `bytes`
// and `others` are the files the model was read from. Empty for other formats.
using FindLosses = Warnings(const Model& model, std::span<const std::uint8_t> bytes, const FileSet& others);
FindLosses lostBySaving;

// A .glb with positions, normals, uv and indices only.
std::vector<std::uint8_t> exportGlb(const geometry::Mesh& mesh, const std::string& name);

// The same with all that importGltf() reads: the picture and the extension WETFUR_fur. Empty parts are left out. Maps need
// mesh.atlas. The state is JSON and is copied.
struct ScenePicture {
  const EncodedImage& image;
  Vec4 factor;
  // A PNG over mesh.atlas with the paint, which other programs show instead; may be empty.
  std::vector<std::uint8_t> painted{};
};
std::vector<std::uint8_t> exportScene(const geometry::Mesh& mesh, const std::string& name, const FurData& fur,
                                      const ScenePicture& picture);

}  // namespace fur::scene
