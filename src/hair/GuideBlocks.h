// Guides as the simulation has them: four side by side in a block, node after node. The last block is filled up with copies of
// its last guide.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/Lanes.h"
#include "hair/Guides.h"

namespace fur::hair {

using dynamics::kLanes;
using dynamics::LaneMask;
using dynamics::Lanes;
using dynamics::Lanes3;
using dynamics::any;
using dynamics::max;
using dynamics::min;
using dynamics::splat;
using dynamics::sqrtOf;

inline void setLane(Lanes3& v, std::size_t lane, const Vec3& to) {
  v.x[lane] = to.x;
  v.y[lane] = to.y;
  v.z[lane] = to.z;
}
inline Vec3 laneOf(const Lanes3& v, std::size_t lane) { return {v.x[lane], v.y[lane], v.z[lane]}; }
inline float largest(const Lanes& x) { return std::max(std::max(x[0], x[1]), std::max(x[2], x[3])); }

// The frames of four roots.
struct FrameLanes {
  Lanes3 origin{}, x{}, y{}, z{};
  Lanes3 turned(const Lanes3& v) const { return x * v.x + y * v.y + z * v.z; }
  Lanes3 turnedBack(const Lanes3& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  Lanes3 placed(const Lanes3& p) const { return origin + turned(p); }
  Lanes3 placedBack(const Lanes3& p) const { return turnedBack(p - origin); }
  void set(std::size_t lane, const RootFrame& frame);
  RootFrame at(std::size_t lane) const;
};
// Straight between two, at right angles.
FrameLanes mix(const FrameLanes& a, const FrameLanes& b, float share);
bool same(const FrameLanes& a, const FrameLanes& b);

struct GuideBlocks {
  int nodes = 0;
  std::size_t guides = 0, blocks = 0;
  std::vector<std::uint32_t> guideAt;  // kLanes * block + lane -> guide

  // Of each block.
  std::vector<FrameLanes> roots, rootsBefore;  // at the last step and the one before
  std::vector<LaneMask> still;                 // static guides
  std::vector<Lanes> reach;                    // how far a guide can come from its root
  std::vector<Lanes3> windMiddle, windTip;     // acceleration of dry hair

  // Of each node of each block, first() on.
  std::vector<Lanes3> rests;                   // in the root's frame
  std::vector<Lanes3> raises;                  // in the root's frame: what gravity 1 asks of the springs at rest, per mass
  std::vector<Lanes3> raisesAlone;             // the same where segments do not hang from each other
  std::vector<Lanes> lengths, lengthInverses;  // of the segment up to the node; 0 at the root
  std::vector<Lanes> leastCosines;             // between the segments at the node before: they turn no further
  std::vector<Lanes> fromRoot;                 // distance along the rest shape
  std::vector<Lanes3> positions, earlier;      // at the last step and the one before
  std::vector<Lanes3> before;                  // earlier, but for what contacts have taken of the speed
  std::vector<Lanes3> goals;                   // the rest shape at the last step, world space
  std::vector<Lanes> stiffness;                // of dry hair, 1 / s^2
  std::vector<Lanes> wetness;                  // 0..1
  std::vector<Lanes3> pushes;                  // of crowding, acceleration

  std::size_t first(std::size_t block) const { return block * static_cast<std::size_t>(nodes); }
  std::size_t nodeCount() const { return blocks * static_cast<std::size_t>(nodes); }
  // The guides' rest shapes; they are at rest. Guides that are near each other come to stand near each other.
  void assign(const Guides& guides, std::span<const RootFrame> rootsAsMade);
};

}  // namespace fur::hair
