// Reads nodes, skins, morph targets and animations of a glTF file; everything is checked.
#pragma once

#include "scene/Rig.h"
#include "scene/import/GltfFile.h"
#include "scene/import/GltfNodes.h"

namespace fur::scene {

class GltfRig {
 public:
  GltfRig(const GltfFile& file, Rig& rig);

  // Reads nodes and animations; false when nothing is animated or skinned: then there is no rig.
  bool begin();
  // Adds a primitive; `positions` and `normals` are in the space of its node.
  void addPart(const PlacedMesh& placed, const Json& primitive, std::vector<Vec3> positions, std::vector<Vec3> normals,
               const std::string& where);

 private:
  void readNodes();
  void readSkins();
  void readAnimations();
  void readChannel(const std::vector<const Json*>& samplers, const Json& channel, Rig::Animation& out, const std::string& where);
  void readJoints(const Json& attributes, std::size_t joints, std::size_t vertices, const std::string& where);
  void readTargets(const Json& primitive, Rig::Part& part, const std::string& where);
  std::vector<float> floats(Whole accessor, int components);
  void atMost(std::size_t limit, std::size_t count, const char* what) const;

  const GltfFile& file_;
  Rig& rig_;
  std::vector<std::uint32_t> nodeOf_;  // by the number in the file
  std::size_t floats_ = 0;             // read for the rig so far
};

}  // namespace fur::scene
