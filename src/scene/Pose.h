// A rig at one time: positions, normals and tangents of the mesh's vertices.
#pragma once

#include <span>
#include <vector>

#include "scene/PoseMix.h"
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
  // Several at once. Changes as steadily as weights, times and turns do. Allocates nothing from the second call on.
  void set(const PoseMix& mix);

  // Model space, one for each vertex of the mesh; normals and tangents are unit and perpendicular.
  std::span<const Vec3> positions() const { return positions_; }
  std::span<const Vec3> normals() const { return normals_; }
  std::span<const Vec3> tangents() const { return tangents_; }
  // From a node's space to model space, which may be scaled.
  const Mat4& transform(std::size_t node) const { return transforms_[node]; }

 private:
  // Of all nodes, in the space of their parents, and the morph weights.
  struct Local {
    struct Place {
      Vec3 translation{0};
      Quat rotation{1, 0, 0, 0};
      Vec3 scale{1};
    };
    std::vector<Place> nodes;
    std::vector<float> weights;
  };
  void rest(Local& out) const;
  void play(const PlayedClip& clip, Local& out);
  static void blend(Local& sum, const Local& other, float share);
  void add(const PlayedClip& layer, Local& to);
  void placeNodes();
  void placeParts();
  void placePart(const Rig::Part& part);

  const Rig* rig_;
  Local now_, other_;
  std::vector<float> value_;
  std::vector<Mat4> transforms_, joints_;
  std::vector<Vec3> firstTangents_;
  std::vector<Vec3> positions_, normals_, tangents_;
};

}  // namespace fur::scene
