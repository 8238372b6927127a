// How far the fur leans at every vertex, and the forces that make it (Sheppard 2004, 3.4).
//
// A bend is a vector in model space, perpendicular to the strand's rest direction; its length is
// the angle theta (radians) by which the tip's direction has turned. A strand is an arc of constant
// length: along = sin(theta t) / theta, across = (1 - cos(theta t)) / theta.
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

  // Advances by dt seconds, with the same result at any frame rate: every strand is a damped spring
  // that is integrated exactly. dt <= 0 and NaN do nothing, more than half a second settles, a
  // jump of over 1.5 model radii is no motion, a transform that is not finite counts as the last one.
  // `modelToWorld` is the model's rigid transform now; the last call's is remembered. `wetness`
  // (may be empty) is 0..1 a vertex: wet fur is heavier and slower.
  void step(float dt, const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness);
  // Where the forces, held steady, lead: used on load, so that nothing swings in.
  void settle(const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness);

  // xyz = bend (model space, radians), w = 0. One a vertex.
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

  std::vector<Vec3> positions_, directions_;
  std::vector<Vec3> velocities_;  // of the bends, rad/s
  std::vector<Vec4> bends_;
  Mat4 lastTransform_{1.0f};
  RigidVelocity lastVelocity_;
  bool atRest_ = true;
  bool hasLast_ = false;
};

// (along, across) of a strand of length 1 at t in [0, 1], theta = the tip's turn. Both are exact limits at theta = 0.
Vec2 arcBend(float theta, float t);
// Sheppard's polynomial stand-in (Eq. 3.14-3.16), force in 0..1: kept for comparison.
Vec2 windBend(float force, float t);

}  // namespace fur::dynamics
