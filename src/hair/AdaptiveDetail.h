// Fewer guides where hair is calm (after Bertails et al. 2003, Halen & Wester 2007, 4.1): neighbours that move alike are simulated
// by some of them, and the others take their motion, the difference from the rest shape in the root's frame, from those.
//
// Guides stand in clusters of four blocks: the first block has every fourth of the cluster's guides, the first two every second. As
// in 4.1 it is acceleration times radius that splits a cluster, at once, and that lets it merge when it has been small for a while
// and those that will follow are where they would follow to, but for little, which fades. So nothing jumps.
#pragma once

#include <vector>

#include "hair/GuideBlocks.h"

namespace fur::hair {

class AdaptiveDetail {
 public:
  static constexpr std::size_t kBlocks = 4;  // of a cluster

  void reset(const GuideBlocks& guides);
  // Where guides of a cluster are not equally wet they do not move alike.
  void takeWetness(const GuideBlocks& guides);
  std::size_t clusters() const { return clusters_.size(); }
  // Decides how many blocks of a cluster the next step simulates: 4, 2 or 1.
  std::size_t choose(const GuideBlocks& guides, std::size_t cluster, bool mayMerge);
  // The largest acceleration of a node in the step.
  void note(std::size_t cluster, float acceleration) { clusters_[cluster].acceleration = acceleration; }
  bool follows(std::size_t block) const { return block / kBlocks < clusters_.size() && block % kBlocks >= clusters_[block / kBlocks].simulated; }
  // Where the nodes of a block that follows go, by the blocks that lead, whose step is done.
  void follow(const GuideBlocks& guides, std::size_t block, const FrameLanes& root, Lanes3* next);

 private:
  struct Cluster {
    std::size_t simulated = kBlocks;
    float radius = 0, acceleration = 1e9f;
    int calmSteps = 0;
    bool alike = true;  // in wetness, and none is static
  };
  // The differences from rest that a follower takes from the first `leaders` blocks.
  Lanes3 led(const GuideBlocks& guides, std::size_t block, std::size_t leaders, std::size_t node) const;
  bool merge(const GuideBlocks& guides, std::size_t cluster, std::size_t leaders);

  std::vector<Cluster> clusters_;
  std::vector<Lanes> shares_;      // of a block in the guides of the first block, and in those of the first two: 4 + 8
  std::vector<Lanes3> offsets_;    // of followers, from where they follow to, in the root's frame
};

// The order in which guides fill blocks, such that clusters are near each other and led from all over: their numbers.
std::vector<std::uint32_t> clusteredOrder(std::span<const Vec3> roots, std::span<const std::uint8_t> flags);

}  // namespace fur::hair
