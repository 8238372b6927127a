// Guides that crowd push each other apart: the volume of hair. How dense nodes lie is kept on a coarse grid, less how dense they
// lie in the rest shape as it stands now, so that this stays as it is; nodes go down the slope (as Petrovic et al. 2005 have it).
#pragma once

#include <vector>

#include "hair/AdaptiveDetail.h"
#include "hair/GuideBlocks.h"

namespace fur::hair {

class Crowding {
 public:
  // For these guides' rest shape.
  void reset(const GuideBlocks& guides);
  // Sets guides.pushes, for roots and nodes as they are, but not of guides that follow others. Strength 0..1.
  void push(GuideBlocks& guides, float strength, const AdaptiveDetail& detail);

 private:
  // The grid repeats itself: hair lies anywhere in the world, but not over more than it spans.
  static constexpr int kSide = 16;
  static constexpr std::size_t kCells = kSide * kSide * kSide;
  struct Corners;
  void spread(const Corners& corners, float weight);
  void findSlopes();

  float perUnit_ = 1;  // cells a model unit
  float usual_ = 1;    // density at a node of the rest shape
  std::vector<float> density_;
  std::vector<Vec3> slopes_;  // a cell
};

}  // namespace fur::hair
