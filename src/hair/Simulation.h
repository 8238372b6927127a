// The motion of guides over time (Halen & Wester 2007, 4 and 5.9). Three models:
//   Spring   each node is tied to where the rest shape has it, which goes with the root
//   Cascade  reference nodes in tangent spaces built from root to tip, upward and downward ones of unequal stiffness
//   Forest   angular joints, torque handed down from tip to root (DCF01), linear in nodes
// In all of them reference nodes are raised by m g / k, for what the strand's own tension does not hold; stiffness falls as
// k / (L c)^a, and with the tilt of the head. They are integrated in fixed steps (kStep) in world space, keep lengths, and collide.
//
// What is shown lies between the last two steps as seen from the roots, put where the roots are now: hair stands on the skin at
// every frame, and its swing is shown a step (8 ms) late. So colliders, too, are met where they were a step ago.
//
// Steps come every kStep whatever the frame rate. Between two calls the roots, the colliders and `up` go straight from what was
// given to what is given, and each step has what that is at its time. The path is therefore the same at any frame rate: bit for
// bit where the inputs do not change (or change at once: values, wind, wetness count from the call on), and else as far as
// straight pieces between frames follow the same motion.
//
// The same input gives the same bits on every platform. Knows neither the skin nor wisps. Nothing is ever NaN or leaves its
// length, whatever comes in.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/Math.h"
#include "dynamics/Wind.h"
#include "hair/AdaptiveDetail.h"
#include "hair/Colliders.h"
#include "hair/Crowding.h"
#include "hair/GuideBlocks.h"
#include "hair/Guides.h"
#include "hair/MotionModels.h"

namespace fur::hair {

enum class Model { Spring, Cascade, Forest };  // in the order of the setting `hairModel`

// Numbers of one scalp's motion. All 0..1 but where a unit stands.
struct MotionValues {
  Model model = Model::Cascade;
  float stiffness = 0.35f;   // at the root
  int softening = 2;         // a of k / (L c)^a: 1, 2 or 3
  float damping = 0.3f;
  float weight = 0.5f;       // how little wind moves it
  float gravity = 0.25f;     // as the setting `gravity`
  float volume = 0.5f;       // how strongly guides that crowd push each other apart; 0: not at all
  bool adaptive = true;      // calm hair is simulated with fewer guides (after Bertails et al. 2003, Halen 4.1)
  bool operator==(const MotionValues&) const = default;
};

// What acts on the hair until the next call.
struct Surroundings {
  std::span<const RootFrame> roots;     // of each guide, world space, now
  Vec3 up{0, 1, 0};                     // of the model, world space: the tilt term's z_h
  const dynamics::Wind* wind = nullptr; // world space; none
  std::span<const float> wetness;       // of each node, 0..1; empty: dry. Wet hair is heavier and slower
  std::span<const Collider> colliders;
};

class Simulation {
 public:
  // Other guides: their rest shape, with the roots for which they were made (the same space as guides.positions). At rest.
  void reset(const Guides& guides, std::span<const RootFrame> rootsAsMade);
  // Advances by `seconds`, of which what does not fill a step is kept. More than a quarter of a second, and roots that jump by
  // more than a model unit in one call, take the hair along as it is. <= 0 and NaN do nothing. Whether anything that is shown has
  // changed.
  bool advance(float seconds, const MotionValues& values, const Surroundings& around);
  // Goes to rest under gravity and mean wind at once, as on load.
  void settle(const MotionValues& values, const Surroundings& around);
  // True when nothing moves: no need to step, upload or draw.
  bool atRest() const { return asleep_; }
  // Guide after guide, world space.
  std::span<const GuideNode> nodes() const { return shown_; }
  // Where springs pull the nodes, likewise: to the rest shape as it stands (Spring), or on from the segments before them as
  // they are (Cascade, Forest); without what is raised against gravity, which takes it back. Where nothing pulls it is the node's place.
  std::vector<Vec3> references() const;
  // Of each guide, 1: it moves by forces of its own; 0: it is static, or follows its neighbours (AdaptiveDetail.h).
  std::vector<std::uint8_t> simulated() const;
  // Nodes that were moved by forces since reset(), with what fills up blocks: what the work grows with.
  std::size_t nodeSteps() const { return nodeSteps_; }

 private:
  // What was given to the last call.
  struct Inputs {
    MotionValues values;
    Vec3 up{0, 1, 0};
    dynamics::Wind wind;
    std::vector<FrameLanes> roots;
    std::vector<Collider> colliders;
  };
  enum class Roots { Held, Moved, Jumped };
  Roots takeRoots(std::span<const RootFrame> roots);
  bool takeWetness(std::span<const float> wetness);
  void takeValues(const MotionValues& values);
  bool meets(std::span<const Collider> colliders);
  void carry();
  void feel(float share);
  void blow(const dynamics::Wind& wind);
  void step(float share, float stepShare);
  void stepCluster(std::size_t cluster, const StepValues& values, float share);
  float stepBlock(std::size_t block, const StepValues& values, float share, bool follows);
  FourGuides fourGuides(std::size_t block, const FrameLanes& root, const Lanes3* goals) const;
  void settleChain(std::size_t block, const FrameLanes& root, Lanes3* next, Contacts& contacts);
  float takeStep(std::size_t block, const FrameLanes& root, const Lanes3* goals, const Lanes3* next);
  void fallAsleep();
  void lieStill();
  void show();

  GuideBlocks guides_;
  CascadeRests cascade_;
  Crowding crowding_;
  AdaptiveDetail detail_;
  Inputs now_, last_;
  std::vector<Obstacle> obstacles_, reached_;  // in this step; of them those that a block may meet
  std::optional<MotionValues> stiffnessFor_;   // values for which guides_.stiffness is
  std::vector<GuideNode> shown_;
  std::size_t nodeSteps_ = 0;
  double pending_ = 0;                  // steps that are due, less than one
  std::uint32_t steps_ = 0;             // since it woke
  std::uint32_t undisturbed_ = 0;       // steps since anything but itself has moved it
  std::vector<Lanes3> lookedAt_;        // positions when it was last asked whether anything moves
  bool asleep_ = true, hasRoots_ = false, stale_ = false;
};

}  // namespace fur::hair
