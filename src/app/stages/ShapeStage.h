// The model's shape: the surface that was made of a mesh, the animation that it plays, where its vertices are shown
// now, and what finds points on it. Comes from a file or primitive, its rig and time; the other stages read it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/stages/ShownSurface.h"
#include "scene/Pose.h"

namespace fur::app {

// Two directions along the skin, across each other.
std::pair<Vec3, Vec3> axesOn(const Vec3& normal);

class ShapeStage {
 public:
  struct Inputs {
    float seconds = 0;    // that have passed
    int animation = -1;   // of the rig; -1: none
    float speed = 0;      // of the animation, a factor; 0: it stands still
    // In place of that, what it plays now; another number whenever that changes; and the animations in it, of which the first stands
    // on the ground.
    const scene::PoseMix* mix = nullptr;
    std::uint64_t mixRevision = 0;
    std::span<const int> played{};
  };
  // A sphere that holds the skin, whatever the animations that it plays do with it. Model units.
  struct Extent {
    Vec3 centre{0};
    float radius = 1;
  };
  // The skin of a posed model, one of each a vertex of the surface, model space.
  struct Skin {
    std::vector<Vec3> positions, normals, tangents;
  };

  // Another model; the rig may have no animations. `materialOf`: one a vertex of the mesh; empty: there is one.
  void setModel(geometry::Mesh mesh, ShownSurface surface, scene::Rig rig, std::vector<std::uint8_t> materialOf = {});
  // The same mesh with other fur coordinates.
  void setSurface(ShownSurface surface);
  // Plays the animation. Whether the shape has changed.
  bool update(const Inputs& inputs);
  bool active(const Inputs& inputs) const { return inputs.mix ? inputs.mixRevision != mixShown_ : inputs.animation >= 0 && inputs.speed > 0; }
  // The animation of a setting that counts from 1; -1: the rig has none of that number.
  int animationOf(int setting) const;

  std::uint64_t revision() const { return surfaceRevision_ + poseRevision_; }
  std::uint64_t surfaceRevision() const { return surfaceRevision_; }
  std::uint64_t poseRevision() const { return poseRevision_; }

  const geometry::Mesh& mesh() const { return mesh_; }
  const geometry::Surface& surface() const { return *shown_; }
  const scene::Rig& rig() const { return rig_; }
  // The material of each vertex of the surface; empty: there is one.
  const std::vector<std::uint8_t>& materialOf() const { return materialOf_; }
  std::size_t materialAt(std::uint32_t triangle) const { return materialOf_.empty() ? 0 : materialOf_[surface().indices[std::size_t{3} * triangle]]; }
  const Extent& extent() const { return extent_; }
  float groundHeight() const { return groundHeight_; }  // of the floor below all that it plays, y
  float top() const { return top_; }                    // the highest that it comes there
  const geometry::SurfaceQuery& query() const { return shown_.query(); }
  const groom::SurfacePoints& points() const { return shown_.points(); }
  const std::vector<Vec3>& naturalLie() const { return shown_.naturalLie(); }  // groom/Lie.h

  // nullptr for a model without animations: it is shown as it was made.
  const Skin* skin() const { return pose_ ? &skin_ : nullptr; }
  // Positions as they were `seconds` before; 0 seconds: not known.
  struct Before {
    std::span<const Vec3> positions;
    float seconds = 0;
  };
  Before before() const { return {lastPositions_, lastSeconds_}; }
  // nullptr likewise.
  const scene::Pose* pose() const { return pose_ ? &*pose_ : nullptr; }
  // Of each vertex, as it was made; empty for a model without animations.
  std::span<const Vec3> firstTangents() const { return firstTangents_; }
  // As shown.
  const geometry::SurfaceQuery& shownQuery() const;
  Vec3 shownPosition(const geometry::SurfacePoint& at) const;
  Vec3 shownNormal(const geometry::SurfacePoint& at) const;
  // The point of the surface nearest to a place in model space.
  std::optional<geometry::SurfacePoint> nearest(const Vec3& place) const;

 private:
  // How fur stands in the frame of the pose; vertices of one point share a direction.
  struct Lean {
    Vec3 normal, tangent;
    std::uint32_t point;
  };
  void bindRig();
  void readSkin();
  void followSkin();
  // How far an animation goes, and how far down.
  struct Reach {
    int animation;
    Extent extent;
    float ground, top;
  };
  void measure(std::span<const int> animations);
  const Reach& reachOf(int animation);
  bool play(const Inputs& inputs);
  void spreadMaterials();

  geometry::Mesh mesh_;
  ShownSurface shown_;
  std::vector<std::uint8_t> ofMesh_, materialOf_;  // materials
  scene::Rig rig_;
  std::optional<scene::Pose> pose_;
  Skin skin_;
  std::vector<Vec3> lastPositions_;
  float lastSeconds_ = 0;
  std::vector<std::uint32_t> sources_;  // of each vertex: one of the mesh's vertices or of those inserted between them
  std::vector<Lean> leans_;             // one a vertex, while there is a rig
  std::vector<Vec3> firstTangents_;
  int animation_ = -1;       // that is shown; below -1: several
  double seconds_ = 0;       // of it
  std::uint64_t mixShown_ = 0;
  std::vector<int> measuredFor_;  // the animations that extent and ground are for
  std::vector<Reach> reaches_;    // of animations that have been played
  Extent extent_;
  float groundHeight_ = -1, top_ = 1;
  mutable geometry::SurfaceQuery posedQuery_;
  mutable std::uint64_t posedQueryFor_ = 0, posedQueryOf_ = 0;  // revisions of shape and surface that it is of
  std::uint64_t surfaceRevision_ = 0, poseRevision_ = 0;
};

}  // namespace fur::app
