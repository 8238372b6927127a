// A rig at one time: positions, normals and tangents of the mesh's vertices.
#pragma once

#include <span>
#include <vector>

#include "scene/Rig.h"

namespace fur::scene {

// The value of a channel at a time: `width` numbers; rotations are normalised. Constant before the first and after the last
// key.
void sample(const Rig::Channel& channel, float seconds, float* out);

class Pose {
 public:
  // The rest pose. The rig must outlive the pose.
  explicit Pose(const Rig& rig);
  // `animation` -1: none.
  void set(int animation, float seconds);

  // Model space, one for each vertex of the mesh; normals and tangents are unit and perpendicular.
  std::span<const Vec3> positions() const { return positions_; }
  std::span<const Vec3> normals() const { return normals_; }
  std::span<const Vec3> tangents() const { return tangents_; }
  // From a node's space to model space.
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
