// The meshes of the default scene and their transforms.
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

// In the order of the node tree. Without scenes all root nodes are used, without nodes all meshes. A node that is reached twice
// (a cycle, two parents) is bad-file. The transform of a skinned mesh's node is ignored (glTF 2.0, 3.7.3.3).
std::vector<PlacedMesh> placedMeshes(const GltfFile& file);
// The indices of a node's children; checked.
std::vector<Whole> childrenOf(const GltfFile& file, Whole node);

}  // namespace fur::scene
