// What a rig does at one time, of several of its animations at once.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::scene {

struct PlayedClip {
  int animation = -1;  // of the rig; -1: as it rests
  float seconds = 0;
  float weight = 1;
};

struct JointTurn {
  std::uint32_t node = 0;
  Quat turn{1, 0, 0, 0};  // in the joint's own axes, before what else turns it
};

struct PoseMix {
  std::vector<PlayedClip> bodies;  // whole bodies, by their shares of the sum of weights; none: as it rests
  std::vector<PlayedClip> layers;  // what they differ from the rest by is added, times the weight
  std::vector<JointTurn> turns;    // over all that

  void clear() { bodies.clear(), layers.clear(), turns.clear(); }
};

}  // namespace fur::scene
