// A second opinion: tinygltf reads what we write, and our importer sees what tinygltf sees.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <gtest/gtest.h>

#include <fstream>  // tinygltf forgets it

#include <tiny_gltf.h>

#include "geometry/Primitives.h"
#include "scene/Model.h"

namespace fur::scene {
namespace {

const float* floatsOf(const tinygltf::Model& model, int accessorIndex) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessorIndex)];
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  const auto& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  return reinterpret_cast<const float*>(bytes.data() + view.byteOffset + accessor.byteOffset);
}

TEST(ExportGlb, TinygltfReadsTheSameVertices) {
  for (geometry::Mesh mesh : {geometry::makeSphere(), geometry::makeTorus(), geometry::makePlane()}) {
    const auto glb = exportGlb(mesh, "shape");
    tinygltf::Model model;
    std::string errors, warnings;
    ASSERT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromMemory(&model, &errors, &warnings, glb.data(),
                                                          static_cast<unsigned>(glb.size())))
        << errors;
    EXPECT_EQ(warnings, "");
    const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
    const int positions = primitive.attributes.at("POSITION");
    ASSERT_EQ(model.accessors[static_cast<std::size_t>(positions)].count, mesh.positions.size());
    ASSERT_EQ(model.accessors[static_cast<std::size_t>(primitive.indices)].count, mesh.indices.size());
    const float* written = floatsOf(model, positions);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      for (int k = 0; k < 3; ++k) ASSERT_EQ(written[3 * i + static_cast<std::size_t>(k)], mesh.positions[i][k]);
  }
}

TEST(GltfImport, SeesTheTrianglesThatTinygltfSees) {
  geometry::Mesh mesh = geometry::makeTorus();
  geometry::fitToUnitSphere(mesh);
  const auto glb = exportGlb(mesh, "torus");
  const auto ours = importGltf(glb, "torus.glb");
  ASSERT_TRUE(ours) << ours.error().message;
  tinygltf::Model theirs;
  std::string errors, warnings;
  ASSERT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromMemory(&theirs, &errors, &warnings, glb.data(),
                                                        static_cast<unsigned>(glb.size())));
  const auto& indices = theirs.accessors[static_cast<std::size_t>(theirs.meshes[0].primitives[0].indices)];
  EXPECT_EQ(ours.value().mesh.indices.size(), indices.count);
  const float* positions = floatsOf(theirs, theirs.meshes[0].primitives[0].attributes.at("POSITION"));
  // The importer fits again what already fits: only rounding may differ.
  for (std::size_t i = 0; i < ours.value().mesh.positions.size(); ++i)
    EXPECT_NEAR(ours.value().mesh.positions[i].x, positions[3 * i], 1e-5f);
}

}  // namespace
}  // namespace fur::scene
