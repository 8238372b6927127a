// Guides: the few strands by which a person shapes long hair, and that are simulated (Halen & Wester 2007, 2.5). Every wisp
// follows three of them.
//
// A guide is a row of nodes from its root on the skin to its tip. All guides of a scalp have the same number of nodes.
// Positions are in model space, on the skin as the model was made; where the model is posed or moved, a guide goes with the
// frame of its root (RootFrame).
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/Math.h"

namespace fur::hair {

inline constexpr int kLeastNodes = 4, kMostNodes = 32;
inline constexpr std::size_t kMostGuides = 1024;  // of a scalp
inline constexpr float kFarthestNode = 1e6f;      // along each axis, model units

inline bool finite(const Vec3& v) { return std::isfinite(v.x + v.y + v.z); }

enum GuideFlag : std::uint8_t {
  kStatic = 1,  // it is not simulated: it stands on the skin in its rest shape
  kHidden = 2,  // panels and tools leave it alone
};

struct Guides {
  int nodes = 8;                    // of each guide, kLeastNodes..kMostNodes
  std::vector<Vec3> positions;      // guide after guide, each from root to tip
  std::vector<std::uint8_t> flags;  // GuideFlags, one a guide

  std::size_t count() const { return flags.size(); }
  std::span<const Vec3> of(std::size_t guide) const { return {&positions[guide * static_cast<std::size_t>(nodes)], static_cast<std::size_t>(nodes)}; }
  std::span<Vec3> of(std::size_t guide) { return {&positions[guide * static_cast<std::size_t>(nodes)], static_cast<std::size_t>(nodes)}; }
  const Vec3& root(std::size_t guide) const { return positions[guide * static_cast<std::size_t>(nodes)]; }
  bool operator==(const Guides&) const = default;
};

// Where a guide stands on the skin and how the skin lies there. Unit vectors, perpendicular to each other.
struct RootFrame {
  Vec3 position{0};
  Vec3 normal{0, 1, 0}, tangent{1, 0, 0};
};

// A node as it is shown: where it is, and the frame of its root as it has turned on the way there, without twist. `frame` takes
// what is given along (tangent, normal, tangent x normal) of the root to where the node has it, in the space of the positions;
// (0, 1, 0) goes along the hair. A quaternion and its negative are the same frame: align signs before they are blended.
struct GuideNode {
  Vec3 position{0};
  float wetness = 0;      // 0..1
  Quat frame{1, 0, 0, 0};
};

// The frames of one chain of nodes by parallel transport from its root's; nodes at one place keep the frame before. `out` has as
// many nodes as `positions`.
void frameNodes(std::span<const Vec3> positions, const RootFrame& root, std::span<GuideNode> out);
// Those of all guides as they are made, one root a guide.
std::vector<GuideNode> restNodes(const Guides& guides, std::span<const RootFrame> roots);

// Makes guides from outside valid: false when a number is not finite or beyond kFarthestNode, or they have not the nodes that
// `guides.nodes` says; otherwise segments of no length become short ones.
bool makeSound(Guides& guides);

// The same chain with another number of nodes, evenly spaced along it; as long as it was, for which it is scaled about its root.
std::vector<Vec3> resampled(std::span<const Vec3> chain, int nodes);
float lengthOf(std::span<const Vec3> chain);

}  // namespace fur::hair
