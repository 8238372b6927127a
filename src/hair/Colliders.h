// Spheres and capsules that guides stay out of: their nodes, and the middles of their segments, from node 2 on.
#pragma once

#include <span>
#include <vector>

#include "hair/GuideBlocks.h"

namespace fur::hair {

// A sphere where both ends are the same, else a capsule. World space.
struct Collider {
  Vec3 a{0}, b{0};
  float radius = 0;
  bool operator==(const Collider&) const = default;
};

// Those of finite numbers and a radius above 0.
std::vector<Collider> soundColliders(std::span<const Collider> colliders);

// A collider within a step.
struct Obstacle {
  Vec3 a{0}, axis{0};                // from a to b
  Vec3 moveA{0}, moveAxis{0};        // in the step
  float radius = 0, perAxis2 = 0;    // 1 / |axis|^2, 0 of a sphere
};
// A share of the way from some colliders to others; `stepShare`: of that way, what is one step. Others in number just appear.
std::vector<Obstacle> obstaclesBetween(std::span<const Collider> from, std::span<const Collider> to, float share, float stepShare);

// Where nodes have touched something.
struct Contacts {
  LaneMask touched[kMostNodes];
  Lanes3 normal[kMostNodes], surfaceMove[kMostNodes];  // out of the collider; of its surface, in the step
  std::vector<Obstacle> near;                          // for placeSegments() to work with
};

// Those of `all` that a guide of the block can come near; `reached` keeps its memory.
void findReached(std::span<const Obstacle> all, const Lanes3& roots, const Lanes& reach, std::vector<Obstacle>& reached);
// Moves nodes out by the shortest way; lengths are for relaxLengths() to restore.
void pushOut(std::span<const Obstacle> obstacles, int nodes, Lanes3* p);
// From root to tip: exact lengths, no segment turned back on the one before, and each turned so far that it is out of the way.
// `first`: of the block's nodes.
void placeSegments(std::span<const Obstacle> obstacles, const GuideBlocks& guides, std::size_t first, const FrameLanes& root, Lanes3* p,
                   Contacts& contacts);
// Where nodes come from that are now at p, such that they do not bounce and rub a little.
void rub(const Contacts& contacts, int nodes, const Lanes3* p, Lanes3* from);

}  // namespace fur::hair
