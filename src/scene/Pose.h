// A rig at a moment: where every vertex of the mesh is, how its skin faces, and a tangent that turns with the skin.
#pragma once

#include <span>
#include <vector>

#include "scene/Rig.h"

namespace fur::scene {

// The value of a channel at a time, `width` numbers; rotations are of length 1. Before its first and after its last time
// it is what it is there.
void sample(const Rig::Channel& channel, float seconds, float* out);

class Pose {
 public:
  // As the nodes stand without an animation. The rig must outlive the pose.
  explicit Pose(const Rig& rig);
  // `animation` -1: none.
  void set(int animation, float seconds);

  // Model space, one a vertex of the mesh; normals and tangents are unit and across each other.
  std::span<const Vec3> positions() const { return positions_; }
  std::span<const Vec3> normals() const { return normals_; }
  std::span<const Vec3> tangents() const { return tangents_; }
  // Of a node, to the model.
  const Mat4& transform(std::size_t node) const { return transforms_[node]; }

 private:
  void placeNodes(int animation, float seconds);
  void placePart(const Rig::Part& part);

  const Rig* rig_;
  std::vector<Mat4> transforms_, joints_;
  std::vector<float> weights_;
  std::vector<Vec3> firstTangents_;
  std::vector<Vec3> positions_, normals_, tangents_;
};

}  // namespace fur::scene
