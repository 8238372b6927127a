// How far the fur leans at every vertex, and the forces that make it (Sheppard 2004, 3.4).
//
// A bend is a vector in model space, perpendicular to the direction in which the strand leaves the skin (the
// normal); its length is the angle theta (radians) by which the tip's direction has turned. A strand is an arc
// of constant length: along = sin(theta t) / theta, across = (1 - cos(theta t)) / theta.
//
// Combed fur is bent at rest (setRest). Forces then act across the combed strand's chord, the direction from root to tip,
// which is turned by half the rest bend's angle.
//
// Fur that was touched keeps that bend and returns slowly, the slower the softer and the wetter it is.
//
// The same input gives the same bits on every platform.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"
#include "dynamics/Contact.h"
#include "dynamics/Lanes.h"
#include "dynamics/Wind.h"

namespace fur::dynamics {

// How one fur type answers to forces.
struct TypeForces {
  float gravity = 1;       // strength, 0..1
  float stiffness = 0.5f;  // 0..1
  float weight = 0.5f;     // of the coat, FurVolume::weight
  bool operator==(const TypeForces&) const = default;
};

struct BendForces {
  Vec3 gravity{0, -1, 0};   // world space, strength included (0..1)
  Wind wind;
  float stiffness = 0.5f;   // 0..1
  float inertia = 0.5f;     // 0..1
  float weight = 0.5f;      // of the coat, FurVolume::weight
  float furLength = 0.12f;  // of the longest strand, model units: where a contact meets it
  // Of the types 1, 2.. of setTypes(); gravity, stiffness and weight above are those of type 0. Its direction is that of `gravity`,
  // which is not 0 then.
  std::array<TypeForces, 3> others{};
  bool operator==(const BendForces&) const = default;
};

class BendField {
 public:
  // Rest positions and rest directions (unit) in model space, one for each vertex; nothing moves at first. Tangents (unit,
  // perpendicular to the directions) are needed for an animated model only.
  void reset(const std::vector<Vec3>& positions, const std::vector<Vec3>& directions,
             const std::vector<Vec3>& tangents = {});
  // The comb: for each vertex its bend without forces, perpendicular to its direction and at most kMaxBend; empty: upright.
  // And its fur length as a share of the longest, which bends() passes on in w; empty: 1. For the shape given to reset().
  // Bends change with the next step() or settle().
  void setRest(const std::vector<Vec3>& rests, const std::vector<float>& lengths);
  // The fur type that most grows at each vertex, 0 to 3; empty: 0 everywhere. Likewise.
  void setTypes(std::vector<std::uint8_t> types);
  // The current shape of an animated model, finite values for each vertex: bends turn with the skin, and the next step takes
  // the vertices' motion into account. reset() must have had tangents.
  void setPose(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<const Vec3> tangents);

  // Advances by dt seconds. Strands are damped springs that are integrated exactly, so that the frame rate does not matter.
  // dt <= 0 and NaN do nothing; more than half a second settles; a jump of over 1.5 model radii is not treated as motion; a
  // transform that is not finite counts as the last one. `modelToWorld`: the model's rigid transform now. `wetness`: 0..1
  // for each vertex, or empty; wet fur is heavier and slower. Blocks of vertices at rest are skipped.
  void step(float dt, const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness,
            std::span<const Contact> contacts = {});
  // Goes to the equilibrium of the forces at once: on load, so that nothing swings.
  void settle(const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness);

  // xyz = bend (model space, radians), w = length. One a vertex.
  const std::vector<Vec4>& bends() const { return out_; }
  // For the view of forces: xyz = the sum of weight, wind, drag and inertia (model space, in units of the settings), w =
  // length. Filled from the next step on while showForces(true), else empty.
  void showForces(bool show);
  const std::vector<Vec4>& forces() const { return shownForces_; }
  // True when nothing moves: no need to step, upload or draw.
  bool atRest() const { return atRest_; }
  // How far from its rest what swings was at most in the last step, rad.
  float left() const { return std::sqrt(left_); }

 private:
  // The velocity of the rest position p in the world is linear * p + constant.
  struct RigidVelocity {
    Mat3 linear{0.0f};
    Vec3 constant{0};
    bool any() const { return linear != Mat3(0.0f) || constant != Vec3(0); }
  };
  // Columns::kBlock consecutive vertices, usually near each other; they are skipped together when all are at rest.
  struct Block {
    Vec3 centre{0};
    float radius = 0;
    bool awake = true, touched = false;
  };
  struct StepForces;
  enum class Advance { Swing, Jump };

  // Updates the model's velocity and returns its change.
  RigidVelocity follow(const Mat4& modelToWorld, float dt);
  void boundBlocks();
  void placeRests();
  void wake();
  bool reached(const Block& block) const;
  void findLevels();
  bool takeWetness(const std::vector<float>& wetness);
  void jump(const Mat4& modelToWorld, const BendForces& forces, float seconds);
  struct FourStrands;
  void findForces(FourStrands& four, const StepForces& common, bool swings);
  void findTarget(FourStrands& four, const StepForces& common);
  void swing(FourStrands& four, const StepForces& common);
  bool press(FourStrands& four);
  void advanceBlock(const StepForces& common, std::size_t block, Advance how);
  void advance(const StepForces& common, Advance how);

  std::size_t count_ = 0;
  std::vector<Block> blocks_;
  Columns positions_, directions_, bends_;
  Columns velocities_;                // of the bends, rad/s
  Columns rests_, chords_;            // unit chords; both empty when nothing is combed
  Columns sets_;                      // what touch has added to the rests; empty: nothing
  std::vector<float> lengths_;
  std::vector<float> wetness_;        // as it was given; empty: dry
  std::vector<std::uint8_t> types_;   // as they were given
  std::vector<std::uint16_t> levels_;  // rows of StepForces::wet, where any vertex is wet or of another type than 0
  std::vector<Vec4> out_;
  std::vector<Vec4> shownForces_;

  // For an animated model: the shape of reset() and setRest(), and the positions and moves of the last step.
  Columns tangents_, firstDirections_, firstTangents_, firstRests_, firstChords_;
  Columns lastPositions_, lastMoves_;
  bool posed_ = false;
  bool boundsStale_ = false;  // of the blocks
  int poseFelt_ = 0;  // steps in which the motion of the pose still acts

  Mat4 lastTransform_{1.0f};
  RigidVelocity lastVelocity_;
  BendForces lastForces_;
  std::vector<Press> presses_, lastPresses_;
  bool atRest_ = true;
  float left_ = 0;  // squared
  bool hasLast_ = false;
};

// In the order of the setting `bendCurve`.
enum class BendCurve { Arc, Polynomial };

// (along, across) of a strand of length 1 at t in [0, 1], theta = the tip's turn. Both are exact limits at theta = 0.
Vec2 arcBend(float theta, float t);
// The point at height h of a strand rooted at `root`: the twin of the shaders' strandPoint().
Vec3 strandPoint(const Vec3& root, const Vec3& normal, const Vec3& bend, float length, float h, BendCurve curve = BendCurve::Arc);
// Sheppard's polynomial stand-in (Eq. 3.14-3.16), force in 0..1: kept for comparison.
Vec2 windBend(float force, float t);

}  // namespace fur::dynamics
