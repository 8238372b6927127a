// Segments as branches on angular joints, torque handed down from tip to root (Halen & Wester 2007, 4.2, after Di Giacomo,
// Capo and Faure 2001).
//
// Angles about the joint's x and y are one vector here, across the segment: nothing locks where it lies along an axis (H 4.3,
// 5.9). A joint's torque turns its segment one way and the one before the other, which chains all joints to each other: they are
// solved together, a tridiagonal system, so that time is linear in nodes and any stiffness holds. All segments have the inertia
// of a rod as long as the strand, so that hanging hair swings as fast as a pendulum of its length.
#include "hair/Lengths.h"
#include "hair/MotionModels.h"

namespace fur::hair {

namespace {

constexpr float kMostTurn = 0.5f;        // rad in a step
constexpr float kMostJerk = 400;         // of the root, model units / s^2
constexpr float kJointDamping = 0.03f;  // v / k, s

// The rotation that takes unit vector `from` to `to`, as axis times an angle that grows on past a right one: 2 tan(angle / 2).
Lanes3 turnFrom(const Lanes3& from, const Lanes3& to) {
  return cross(from, to) * (2.0f / max(1.0f + dot(from, to), splat(0.1f)));
}

}  // namespace

void forestModel(const FourGuides& four, const StepValues& values, const CascadeRests& rests, std::size_t first, Lanes3* next) {
  const int n = four.nodes;
  Lanes3 along[kMostNodes], turn[kMostNodes + 1], velocity[kMostNodes];  // velocity: rad a step
  Lanes joint[kMostNodes + 1], spring[kMostNodes + 1];                    // h^2 k and h v of each, and their sum
  const auto direction = [&](const Lanes3* p, int s) { return (p[s] - p[s - 1]) * four.lengthInverses[s]; };
  SegmentFrame frame{four.root->x, four.root->y};
  along[1] = directionOr(four.goals[1] - four.goals[0], four.root->y);
  velocity[1] = turnFrom(directionOr(four.goalsBefore[1] - four.goalsBefore[0], along[1]), along[1]);
  frame = frame.onTo(along[1]);
  for (int s = 2; s < n; ++s) {
    const std::size_t at = first + static_cast<std::size_t>(s);
    along[s] = direction(four.positions, s);
    turn[s] = turnFrom(frame.turned(rests.directions[at]), along[s]);
    spring[s] = min(four.stiffness[s] * four.lightness(s) * (values.tilt * kStep * kStep), splat(kStiffest));
    joint[s] = spring[s] * (1.0f + kJointDamping / kStep);
    frame = frame.onTo(along[s]);
  }
  turn[n] = Lanes3{};
  spring[n] = joint[n] = Lanes{};
  // Joints know nothing of how the root is thrown: hair lags behind by a force against it.
  const Lanes3 thrown = clampLength(four.goals[1] - four.positions[1] - (four.positions[1] - four.before[1]), kMostJerk * kStep * kStep);
  const Lanes lever = 1.0f / max(0.6667f * four.fromRoot[n - 1], splat(1e-3f));
  Lanes pivots[kMostNodes];
  pivots[1] = Lanes{};
  for (int s = 2; s < n; ++s) {
    const Lanes light = four.lightness(s), keep = four.keep(values, s);
    const Lanes3 force = four.acceleration(values, s, light) * splat(kStep * kStep) - thrown;
    const Lanes3 was = clampLength(cross(direction(four.before, s), along[s]), kMostTurn) * keep;
    const Lanes3 carried = cross(direction(four.goalsBefore, s), direction(four.goals, s)) * ((1.0f - keep) * kInnerDamping);
    const Lanes3 right = was + carried + cross(along[s], force) * lever - turn[s] * spring[s] + turn[s + 1] * spring[s + 1];
    const Lanes pivot = 1.0f / (1.0f + joint[s] + joint[s + 1] - joint[s] * pivots[s - 1]);
    velocity[s] = (right + velocity[s - 1] * joint[s]) * pivot;
    pivots[s] = joint[s + 1] * pivot;
  }
  // What the joints hand down from the tip.
  for (int s = n - 2; s >= 2; --s) velocity[s] = velocity[s] + velocity[s + 1] * pivots[s];
  for (int s = 2; s < n; ++s) {
    const Lanes3 turned = along[s] + cross(clampLength(velocity[s], kMostTurn), along[s]);
    next[s] = next[s - 1] + directionOr(turned, along[s]) * four.lengths[s];
  }
}

}  // namespace fur::hair
