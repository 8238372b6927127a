// The three models: where the forces of one step take the nodes of four guides. Nodes 0 and 1 are at their goals: hair leaves
// the skin as it was modelled. Lengths and colliders come after.
#pragma once

#include "hair/GuideBlocks.h"
#include "hair/Springs.h"

namespace fur::hair {

inline constexpr float kStep = 1.0f / 120;  // s

// What a step has of MotionValues and Surroundings, the same for all guides.
struct StepValues {
  float keepDry = 1, keepWet = 1;  // shares of its velocity that a node keeps
  float gravity = 0;               // model units / s^2
  float tilt = 1;                  // of the stiffness that is left as the head is held
};

// Water's part: soaked hair weighs this many dry hairs more, and catches less wind.
inline constexpr float kWaterMass = 1.5f, kWetWind = 0.5f;
// Of h^2 k / m: more is no stiffer to see, and too much for the precision of what is solved.
inline constexpr float kStiffest = 2000;
// Of damping, the share that is inner: against how the rest shape moves. The rest is the air's, which stands still.
inline constexpr float kInnerDamping = 0.85f;
// A node moves no further in a step: 30 model units a second.
inline constexpr float kMostMove = 0.25f;

// A block within a step, as arrays of `nodes`.
struct FourGuides {
  int nodes = 0;
  const FrameLanes *root = nullptr, *rootBefore = nullptr;
  const Lanes3 *positions = nullptr, *before = nullptr;
  const Lanes3 *goals = nullptr, *goalsBefore = nullptr;  // the rest shape now and at the last step, world space
  const Lanes3 *raises = nullptr, *pushes = nullptr;
  const Lanes *lengths = nullptr, *lengthInverses = nullptr, *fromRoot = nullptr, *stiffness = nullptr, *wetness = nullptr;
  Lanes3 windMiddle{}, windTip{};

  Lanes lightness(int i) const { return 1.0f / (1.0f + kWaterMass * wetness[i]); }
  Lanes keep(const StepValues& values, int i) const { return values.keepDry + (values.keepWet - values.keepDry) * wetness[i]; }
  // Acceleration by everything but springs, with what the raised reference nodes hold.
  Lanes3 acceleration(const StepValues& values, int i, const Lanes& light) const;
  // Where a node goes under an acceleration; it is damped against how the rest shape moves.
  Lanes3 stepped(const StepValues& values, int i, const Lanes3& acceleration) const;
};

inline Lanes3 FourGuides::acceleration(const StepValues& values, int i, const Lanes& light) const {
  const Lanes share = splat(static_cast<float>(i) / static_cast<float>(nodes - 1));
  const Lanes3 wind = windMiddle + (windTip - windMiddle) * share;
  Lanes3 sum = root->turned(raises[i]) * (light * (values.gravity * values.tilt)) + pushes[i];
  sum = sum + wind * (light * (1.0f - kWetWind * wetness[i]));
  sum.y -= values.gravity;
  return sum;
}

inline Lanes3 FourGuides::stepped(const StepValues& values, int i, const Lanes3& acceleration) const {
  const Lanes keep = this->keep(values, i);
  const Lanes3 from = positions[i] - clampLength(positions[i] - before[i], kMostMove);
  const Lanes3 along = (goals[i] - goalsBefore[i]) * ((1.0f - keep) * kInnerDamping);
  return verletStep(positions[i], from, acceleration, keep, splat(kStep)) + along;
}

// `next`: kMostNodes places.
void springModel(const FourGuides& four, const StepValues& values, Lanes3* next);
// The rest shape in the frames of segments: of each node from 2 on the segment up to it, in the frame of the segment before.
struct CascadeRests {
  std::vector<Lanes3> directions;  // of the segment, unit
  std::vector<Lanes> ratios;       // r: how many lengths of the segment before lie along that
  std::vector<Lanes3> bends;       // the segment less that
  std::vector<Lanes> stiffest;     // h^2 k / m that a cascade may have there: bends go with frames as they are predicted, which
                                   // shakes where stiff hair turns sharply
  void assign(const GuideBlocks& guides);
};
// `first`: of the block in `rests`.
void cascadeModel(const FourGuides& four, const StepValues& values, const CascadeRests& rests, std::size_t first, Lanes3* next);
void forestModel(const FourGuides& four, const StepValues& values, const CascadeRests& rests, std::size_t first, Lanes3* next);

// Frames of segments, by parallel transport: y along the segment, x as it has turned with it.
struct SegmentFrame {
  Lanes3 x{}, y{};
  Lanes3 turned(const Lanes3& v) const { return x * v.x + y * v.y + cross(x, y) * v.z; }
  Lanes3 turnedBack(const Lanes3& v) const { return {dot(x, v), dot(y, v), dot(cross(x, y), v)}; }
  // Without twist to a segment along the unit vector `to`.
  SegmentFrame onTo(const Lanes3& to) const {
    const Lanes3 sum = y + to;
    return {x - sum * (dot(x, to) / max(1.0f + dot(y, to), splat(0.01f))), to};
  }
};

}  // namespace fur::hair
