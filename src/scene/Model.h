// A model as read from a file: one mesh, its images still encoded (the platform decodes them).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/Result.h"
#include "geometry/Mesh.h"
#include "geometry/Surface.h"
#include "scene/FurData.h"
#include "scene/Material.h"
#include "scene/Rig.h"

namespace fur::scene {

struct Model {
  std::string name;
  geometry::Mesh mesh;         // all meshes of the default scene, transformed by their nodes, fitted to the unit sphere
  std::vector<Material> materials;  // in the order in which meshes use them; none where the format has none
  std::vector<std::uint8_t> materialOf;  // one a vertex of the mesh; empty: there are less than two
  std::vector<EncodedImage> images;
  int mainMaterial = -1;       // what stands for all of them where there can be only one
  // Of that; plain and empty where there is none.
  const Material& main() const;
  const EncodedImage& baseColor() const;
  bool isGltf = false;
  float furLength = 0;         // that the file says of the longest strand, units of the mesh; 0: nothing
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

// From then on models have their long hair; before, such a model is an error, larger-program.
void readLongHair();
// The same of .obj and .fo, and of type sets and saved coats (TypeSet.h, CoatFile.h).
void readAllFormats();

// .glb or .gltf; `others` holds external buffers and images.
Result<Model> importGltf(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others = {});

// Wavefront .obj: v, vt, vn and f with absolute or relative indices. Polygons become fans round their first corner, which is
// correct for convex ones. Missing normals are computed. v of texture coordinates is flipped: .obj counts from the bottom of
// the image, glTF from the top. Materials, groups, points, lines and curves are left out, some with a warning.
Result<Model> importObj(std::span<const std::uint8_t> bytes, const std::string& name);

// Sheppard's .fo, see FoModel.h. Types that are none of 1 to 4 become 1, 2, .. in ascending order, all of them, and none is bald; if
// there are more than groom::kTypes, the others become the last one, with a warning.
Result<Model> importFo(std::span<const std::uint8_t> bytes, const std::string& name);

// A glTF document as it was read.
struct SourceFile {
  std::string name;
  std::vector<std::uint8_t> bytes;
  FileSet others;
};

// How fur lies on a document, whose primitives stay as they are: where the corners of its triangles are in the atlas.
struct FurSurface {
  std::size_t vertices = 0;            // of the model's mesh
  std::vector<std::uint32_t> indices;  // three a triangle of the model's mesh, into the two below
  std::vector<Vec2> atlas;
  std::vector<std::uint32_t> charts;
};

FurSurface furSurface(const geometry::Surface& surface, const geometry::Mesh& mesh);

// Documents are saved whole: nodes, skins, morph targets, animations, cameras, lights, materials, extras and unknown extensions as
// they were, with another WETFUR_fur. For programs that save; without, the viewer's download is spared it.
struct DocumentKeeping {
  // nullptr where there is no more in it than exportScene() writes.
  std::shared_ptr<const SourceFile> (*keep)(std::span<const std::uint8_t> bytes, const std::string& name, const FileSet& others);
  // Files beside it that the saved one still needs, each as a phrase.
  Warnings (*beside)(const SourceFile& source);
  // A .glb of a document that has been read before. Of `fur`, the comb is one a vertex of the model's mesh; positions are in model
  // space, and bodies have the file's nodes for bones.
  std::vector<std::uint8_t> (*write)(const SourceFile& source, const FurSurface& surface, const FurData& fur);
};
extern const DocumentKeeping kDocumentKeeping;

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
