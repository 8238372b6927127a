// What happens within a step (Simulation.h).
#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "hair/Lengths.h"
#include "hair/Simulation.h"

namespace fur::hair {

namespace {

// Hair whose nodes all stay within this for so long is at rest: nobody sees it move.
constexpr float kStill = 2e-4f;  // model units
constexpr std::uint32_t kStillSteps = 60;
// Heavy hair that is pressed on a collider may fold one way and the other for ever: so long after anything has moved it, it begins to
// move as in syrup, and then lies, s.
constexpr float kLongSwing = 5, kLongestUnrest = 15;
constexpr std::uint32_t kFeltSteps = 4;  // from one look at wind and crowding to the next: they change slowly

// Chosen by eye for a mane of half the model's radius.
constexpr float kGravity = 40;         // model units / s^2 at gravity 1
constexpr float kWind = 25;            // model units / s^2 at wind 1, of hair of middling weight
constexpr float kUpsideDown = 0.35f;   // alpha / k of the tilt term

// `undisturbed`: seconds since anything has moved the hair.
StepValues stepValues(const MotionValues& values, const Vec3& up, float undisturbed) {
  // From a floating swing to one that ends at once; water swings less still.
  const float syrup = 20.0f * std::max(undisturbed - kLongSwing, 0.0f);
  const float dry = 1.5f + 20.0f * values.damping * values.damping + syrup, wet = 3.0f * dry + 6.0f;
  StepValues out;
  out.keepDry = portableExp(-dry * kStep);
  out.keepWet = portableExp(-wet * kStep);
  out.gravity = kGravity * values.gravity;
  out.tilt = tiltStiffness(1.0f, kUpsideDown, up.y);
  return out;
}

}  // namespace

void Simulation::blow(const dynamics::Wind& wind) {
  const float strength = kWind / (0.4f + 1.2f * now_.values.weight);
  const dynamics::WindField field(wind, Mat4(1));
  const bool any = wind.force != Vec3(0);
  const auto middle = static_cast<std::size_t>(guides_.nodes / 2), tip = static_cast<std::size_t>(guides_.nodes - 1);
  for (std::size_t block = 0; block < guides_.blocks; ++block) {
    if (!any) {
      guides_.windMiddle[block] = guides_.windTip[block] = Lanes3{};
      continue;
    }
    const Lanes caught = field.exposure(guides_.roots[block].y) * strength;
    const Lanes3* nodes = &guides_.positions[guides_.first(block)];
    guides_.windMiddle[block] = field.at(nodes[middle]) * caught;
    guides_.windTip[block] = field.at(nodes[tip]) * caught;
  }
}

// Lengths and colliders, for where the nodes have been taken.
void Simulation::settleChain(std::size_t block, const FrameLanes& root, Lanes3* next, Contacts& contacts) {
  const std::size_t first = guides_.first(block);
  findReached(obstacles_, root.origin, guides_.reach[block], reached_);
  pushOut(reached_, guides_.nodes, next);
  // A forest keeps its lengths, but for what was pushed; springs have pulled since they were kept.
  if (now_.values.model == Model::Cascade || !reached_.empty()) relaxLengths(&guides_.lengths[first], guides_.nodes, next, next);
  placeSegments(reached_, guides_, first, root, next, contacts);
}

// The step's end is the next one's beginning. Returns the largest acceleration of a node.
float Simulation::takeStep(std::size_t block, const FrameLanes& root, const Lanes3* goals, const Lanes3* next) {
  const std::size_t first = guides_.first(block);
  const LaneMask still = guides_.still[block];
  Lanes most{};
  for (int i = 0; i < guides_.nodes; ++i) {
    const std::size_t at = first + static_cast<std::size_t>(i);
    const Lanes3 change = next[i] - guides_.positions[at] - (guides_.positions[at] - guides_.before[at]);
    most = max(most, dot(change, change));
    guides_.before[at] = guides_.earlier[at] = guides_.positions[at];
    guides_.positions[at] = select(still, goals[i], next[i]);
    guides_.goals[at] = goals[i];
  }
  guides_.rootsBefore[block] = guides_.roots[block];
  guides_.roots[block] = root;
  return std::sqrt(largest(most)) / (kStep * kStep);
}

// What the models are told of a block.
FourGuides Simulation::fourGuides(std::size_t block, const FrameLanes& root, const Lanes3* goals) const {
  const std::size_t first = guides_.first(block);
  FourGuides four;
  four.nodes = guides_.nodes;
  four.root = &root;
  four.rootBefore = &guides_.roots[block];
  four.positions = &guides_.positions[first];
  four.before = &guides_.before[first];
  four.goals = goals;
  four.goalsBefore = &guides_.goals[first];
  four.raises = now_.values.model == Model::Forest ? &guides_.raisesAlone[first] : &guides_.raises[first];
  four.pushes = &guides_.pushes[first];
  four.lengths = &guides_.lengths[first];
  four.lengthInverses = &guides_.lengthInverses[first];
  four.fromRoot = &guides_.fromRoot[first];
  four.stiffness = &guides_.stiffness[first];
  four.wetness = &guides_.wetness[first];
  four.windMiddle = guides_.windMiddle[block];
  four.windTip = guides_.windTip[block];
  return four;
}

// Returns the largest acceleration of a node.
float Simulation::stepBlock(std::size_t block, const StepValues& values, float share, bool follows) {
  const std::size_t first = guides_.first(block);
  const FrameLanes root = mix(last_.roots[block], now_.roots[block], share);
  Lanes3 goals[kMostNodes], next[kMostNodes];
  for (int i = 0; i < guides_.nodes; ++i) goals[i] = root.placed(guides_.rests[first + static_cast<std::size_t>(i)]);
  const LaneMask still = guides_.still[block];
  if ((still[0] & still[1] & still[2] & still[3]) != 0) return takeStep(block, root, goals, goals);
  next[0] = goals[0];
  next[1] = goals[1];
  if (follows) {
    detail_.follow(guides_, block, root, next);
  } else {
    nodeSteps_ += kLanes * static_cast<std::size_t>(guides_.nodes);
    const FourGuides four = fourGuides(block, root, goals);
    switch (now_.values.model) {
      case Model::Spring: springModel(four, values, next); break;
      case Model::Cascade: cascadeModel(four, values, cascade_, first, next); break;
      case Model::Forest: forestModel(four, values, cascade_, first, next); break;
    }
  }
  Contacts contacts;
  settleChain(block, root, next, contacts);
  const float acceleration = takeStep(block, root, goals, next);
  if (!reached_.empty()) rub(contacts, guides_.nodes, &guides_.positions[first], &guides_.before[first]);
  return acceleration;
}

void Simulation::stepCluster(std::size_t cluster, const StepValues& values, float share) {
  const std::size_t first = cluster * AdaptiveDetail::kBlocks;
  bool free = now_.values.adaptive;
  for (std::size_t b = 0; b < AdaptiveDetail::kBlocks && free && !obstacles_.empty(); ++b) {
    findReached(obstacles_, guides_.roots[first + b].origin, guides_.reach[first + b], reached_);
    free = reached_.empty();
  }
  const std::size_t simulated = detail_.choose(guides_, cluster, free);
  float most = 0;
  for (std::size_t b = 0; b < AdaptiveDetail::kBlocks; ++b) {
    const float acceleration = stepBlock(first + b, values, share, b >= simulated);
    if (b < simulated) most = std::max(most, acceleration);
  }
  detail_.note(cluster, most);
}

// What acts on the steps until it is looked at again.
void Simulation::feel(float share) {
  stale_ = false;
  dynamics::Wind wind = now_.wind;
  wind.time = last_.wind.time + (now_.wind.time - last_.wind.time) * static_cast<double>(share);
  blow(wind);
  crowding_.push(guides_, now_.values.volume, detail_);
}

// `share`: how far between what was given to the last call and what is given to this; `stepShare`: of that, a step.
void Simulation::step(float share, float stepShare) {
  const StepValues values = stepValues(now_.values, last_.up + (now_.up - last_.up) * share, static_cast<float>(undisturbed_) * kStep);
  if (stale_ || steps_ % kFeltSteps == 0) feel(share);
  obstacles_ = obstaclesBetween(last_.colliders, now_.colliders, share, stepShare);
  for (std::size_t cluster = 0; cluster < detail_.clusters(); ++cluster) stepCluster(cluster, values, share);
  for (std::size_t block = detail_.clusters() * AdaptiveDetail::kBlocks; block < guides_.blocks; ++block) stepBlock(block, values, share, false);
  ++steps_;
}

// Looks every now and then whether anything has moved.
void Simulation::fallAsleep() {
  if (steps_ % kStillSteps != 0) return;
  Lanes farthest{};
  if (!lookedAt_.empty())
    for (std::size_t i = 0; i < lookedAt_.size(); ++i) {
      const Lanes3 move = guides_.positions[i] - lookedAt_[i];
      farthest = max(farthest, dot(move, move));
    }
  undisturbed_ += kStillSteps;
  const bool still = !lookedAt_.empty() && largest(farthest) < kStill * kStill;
  asleep_ = (still || static_cast<float>(undisturbed_) * kStep > kLongestUnrest) && !now_.wind.varies();
  lookedAt_ = guides_.positions;
  if (asleep_) lieStill();
}

void Simulation::lieStill() {
  guides_.before = guides_.earlier = guides_.positions;
  guides_.rootsBefore = guides_.roots;
  lookedAt_.clear();
  steps_ = 0;
  pending_ = 0;
}

}  // namespace fur::hair
