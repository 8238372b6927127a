// Which meshes the default scene shows, and where.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/import/GltfFile.h"

namespace fur::scene {

inline constexpr Whole kNoSkin = ~0ull;

struct PlacedMesh {
  Whole mesh;
  glm::dmat4 transform;  // to the scene
  Whole node = 0, skin = kNoSkin;
};

// In the order of the node tree. Without scenes every root node is shown, without nodes every mesh.
// A node that is reached twice (a cycle, two parents) is bad-file. A skinned mesh stands where its skin
// puts it, so its node's own transform does not count (glTF 2.0, 3.7.3.3).
std::vector<PlacedMesh> placedMeshes(const GltfFile& file);
// The numbers of a node's children, which exist.
std::vector<Whole> childrenOf(const GltfFile& file, Whole node);

}  // namespace fur::scene
