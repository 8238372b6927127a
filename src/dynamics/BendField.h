// How far the fur leans at every vertex, and the forces that make it (Sheppard 2004, 3.4).
//
// A bend is a vector in model space, perpendicular to the direction in which the strand leaves the skin (the
// normal); its length is the angle theta (radians) by which the tip's direction has turned. A strand is an arc
// of constant length: along = sin(theta t) / theta, across = (1 - cos(theta t)) / theta.
//
// Fur that is combed rests bent (setRest). Forces then act on the combed strand: across its chord, the direction
// from root to tip, which the rest bend has turned by half its angle.
//
// Fur that was touched stays where it was put and forgets that slowly, the slower the softer and the wetter it is.
//
// The same input gives the same bits on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"
#include "dynamics/Contact.h"
#include "dynamics/Lanes.h"
#include "dynamics/Wind.h"

namespace fur::dynamics {

struct BendForces {
  Vec3 gravity{0, -1, 0};   // world space, strength included (0..1)
  Wind wind;
  float stiffness = 0.5f;   // 0..1
  float inertia = 0.5f;     // 0..1
  float weight = 0.5f;      // of the coat, FurVolume::weight
  float furLength = 0.12f;  // of the longest strand, model units: where a contact meets it
  bool operator==(const BendForces&) const = default;
};

class BendField {
 public:
  // Rest positions and rest directions (unit) in model space, one a vertex; starts at rest, still. Tangents (unit, across
  // the directions) are for a model that changes its shape.
  void reset(const std::vector<Vec3>& positions, const std::vector<Vec3>& directions,
             const std::vector<Vec3>& tangents = {});
  // How the fur is combed: the bend of every vertex without forces, across its direction and at most kMaxBend, and
  // what bends() has in w, for the shaders: the length of the fur there as a share of the longest. One of each
  // a vertex, for the shape of reset(); without rests the fur stands up, without lengths w is 1. What moves goes on from
  // where it is: step or settle.
  void setRest(const std::vector<Vec3>& rests, const std::vector<float>& lengths);
  // The model has changed its shape since reset(), which had tangents: what leans turns with the skin, and how the
  // vertices have moved is felt by the next step. One of each a vertex, finite.
  void setPose(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<const Vec3> tangents);

  // Advances by dt seconds, with the same result at any frame rate: every strand is a damped spring
  // that is integrated exactly. dt <= 0 and NaN do nothing, more than half a second settles, a
  // jump of over 1.5 model radii is no motion, a transform that is not finite counts as the last one.
  // `modelToWorld` is the model's rigid transform now; the last call's is remembered. `wetness`
  // (may be empty) is 0..1 a vertex: wet fur is heavier and slower. Vertices that are still cost nothing.
  void step(float dt, const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness,
            std::span<const Contact> contacts = {});
  // Where the forces, held steady, lead: used on load, so that nothing swings in.
  void settle(const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness);

  // xyz = bend (model space, radians), w = length. One a vertex.
  const std::vector<Vec4>& bends() const { return out_; }
  // For those who ask: xyz = weight, wind, air resistance and momentum (model space, their strength in the settings),
  // w = length; from the next step on. Empty for others.
  void showForces(bool show);
  const std::vector<Vec4>& forces() const { return shownForces_; }
  // True once nothing moves any more: stop stepping, drawing, uploading.
  bool atRest() const { return atRest_; }

 private:
  // World velocity of the rest position p: linear * p + constant.
  struct RigidVelocity {
    Mat3 linear{0.0f};
    Vec3 constant{0};
    bool any() const { return linear != Mat3(0.0f) || constant != Vec3(0); }
  };
  // Vertices that lie near each other, mostly: they fall asleep together.
  struct Block {
    Vec3 centre{0};
    float radius = 0;
    bool awake = true, touched = false;
  };
  struct StepForces;
  enum class Advance { Swing, Jump };

  // Takes the transform over and returns how much the velocity has changed.
  RigidVelocity follow(const Mat4& modelToWorld, float dt);
  void boundBlocks();
  void placeRests();
  void wake();
  bool reached(const Block& block) const;
  bool takeWetness(const std::vector<float>& wetness);
  void jump(const Mat4& modelToWorld, const BendForces& forces, float seconds);
  void advanceBlock(const StepForces& common, std::size_t block, Advance how);
  void advance(const StepForces& common, Advance how);

  std::size_t count_ = 0;
  std::vector<Block> blocks_;
  Columns positions_, directions_, bends_;
  Columns velocities_;                // of the bends, rad/s
  Columns rests_, chords_;            // unit chords; both empty when nothing is combed
  Columns sets_;                      // what touch has added to the rests; empty when it has not
  std::vector<float> lengths_;
  std::vector<float> wetness_;        // as it was given; empty: dry
  std::vector<std::uint8_t> levels_;  // of wetness, where there is any
  std::vector<Vec4> out_;
  std::vector<Vec4> shownForces_;

  // A model that changes its shape: as reset() and setRest() had it, where it was at the last step and how it moved there.
  Columns tangents_, firstDirections_, firstTangents_, firstRests_, firstChords_;
  Columns lastPositions_, lastMoves_;
  bool posed_ = false;
  bool boundsStale_ = false;  // of the blocks
  int poseFelt_ = 0;  // steps that have its motion still to feel

  Mat4 lastTransform_{1.0f};
  RigidVelocity lastVelocity_;
  BendForces lastForces_;
  std::vector<Press> presses_, lastPresses_;
  bool atRest_ = true;
  bool hasLast_ = false;
};

// In the order of the setting `bendCurve`.
enum class BendCurve { Arc, Polynomial };

// (along, across) of a strand of length 1 at t in [0, 1], theta = the tip's turn. Both are exact limits at theta = 0.
Vec2 arcBend(float theta, float t);
// strandPoint() of the shaders: where a strand rooted at `root` is at height h.
Vec3 strandPoint(const Vec3& root, const Vec3& normal, const Vec3& bend, float length, float h, BendCurve curve = BendCurve::Arc);
// Sheppard's polynomial stand-in (Eq. 3.14-3.16), force in 0..1: kept for comparison.
Vec2 windBend(float force, float t);

}  // namespace fur::dynamics
