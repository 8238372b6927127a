// How far the fur leans at every vertex, and the forces that make it (Sheppard 2004, 3.4).
//
// A bend is a vector in model space, perpendicular to the direction in which the strand leaves the skin (the
// normal); its length is the angle theta (radians) by which the tip's direction has turned. A strand is an arc
// of constant length: along = sin(theta t) / theta, across = (1 - cos(theta t)) / theta.
//
// Fur that is combed rests bent (setRest). Forces then act on the combed strand: across its chord, the direction
// from root to tip, which the rest bend has turned by half its angle.
#pragma once

#include <vector>

#include "core/Math.h"

namespace fur::dynamics {

inline constexpr float kMaxBend = 1.35f;  // radians: fur never lies through the skin

struct BendForces {
  Vec3 gravity{0, -1, 0};   // world space, strength included (0..1)
  Vec3 wind{0};             // world space, 0..1
  float stiffness = 0.5f;   // 0..1
  float inertia = 0.5f;     // 0..1
  float weight = 0.5f;      // of the coat, FurVolume::weight
};

class BendField {
 public:
  // Rest positions and rest directions (unit) in model space, one a vertex; starts at rest, still.
  void reset(const std::vector<Vec3>& positions, const std::vector<Vec3>& directions);
  // How the fur is combed: the bend of every vertex without forces, across its direction and at most kMaxBend, and
  // what bends() has in w, for the shaders: the length of the fur there as a share of the longest. One of each
  // a vertex; without rests the fur stands up, without lengths w is 1. What moves goes on from where it is: step or settle.
  void setRest(std::vector<Vec3> rests, const std::vector<float>& lengths);

  // Advances by dt seconds, with the same result at any frame rate: every strand is a damped spring
  // that is integrated exactly. dt <= 0 and NaN do nothing, more than half a second settles, a
  // jump of over 1.5 model radii is no motion, a transform that is not finite counts as the last one.
  // `modelToWorld` is the model's rigid transform now; the last call's is remembered. `wetness`
  // (may be empty) is 0..1 a vertex: wet fur is heavier and slower.
  void step(float dt, const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness);
  // Where the forces, held steady, lead: used on load, so that nothing swings in.
  void settle(const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness);

  // xyz = bend (model space, radians), w = length. One a vertex.
  const std::vector<Vec4>& bends() const { return bends_; }
  // True once nothing moves any more: stop stepping, drawing, uploading.
  bool atRest() const { return atRest_; }

 private:
  // World velocity of the rest position p: linear * p + constant.
  struct RigidVelocity {
    Mat3 linear{0.0f};
    Vec3 constant{0};
    bool any() const { return linear != Mat3(0.0f) || constant != Vec3(0); }
  };
  // Takes the transform over and returns how much the velocity has changed.
  RigidVelocity follow(const Mat4& modelToWorld, float dt);

  // What a force of `climate` at vertex i leads to.
  template <class Climate>
  Vec3 targetAt(const Climate& climate, std::size_t i, float wet) const;
  // A force as it acts on the strand of vertex i: turned with the strand's chord to where that would stand upright.
  Vec3 uprighted(const Vec3& force, std::size_t i) const;

  std::vector<Vec3> positions_, directions_;
  std::vector<Vec3> rests_, chords_;  // unit chords; both empty when nothing is combed
  std::vector<Vec3> velocities_;  // of the bends, rad/s
  std::vector<Vec4> bends_;
  Mat4 lastTransform_{1.0f};
  RigidVelocity lastVelocity_;
  bool atRest_ = true;
  bool hasLast_ = false;
};

// (along, across) of a strand of length 1 at t in [0, 1], theta = the tip's turn. Both are exact limits at theta = 0.
Vec2 arcBend(float theta, float t);
// strandPoint() of the shaders: where a strand rooted at `root` is at height h.
Vec3 strandPoint(const Vec3& root, const Vec3& normal, const Vec3& bend, float length, float h);
// Sheppard's polynomial stand-in (Eq. 3.14-3.16), force in 0..1: kept for comparison.
Vec2 windBend(float force, float t);

}  // namespace fur::dynamics
