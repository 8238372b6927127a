// How charts of the atlas go on beyond their borders: for each edge of a border what takes its chart's coordinates, laid out flat beyond the edge,
// to those of the chart that lies there. By it a ray finds the strands that lean over a border, and the clumps to which they belong.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/Surface.h"
#include "shared/Wet.h"
#include "wet/SurfaceWetting.h"

namespace fur::wet {

class ChartBorders {
 public:
  // None has an edge at which the surface ends, nor one between charts of which one is mirrored or stretched to more than four times the area;
  // nor those that come after FUR_MOST_BORDERS others.
  ChartBorders(const geometry::Surface& surface, const SurfaceWetting& wetting);

  // FUR_BORDER_TEXELS for each: a matrix by columns of atlas coordinates, one of fur coordinates, where the origins of both come to, and zero.
  // Whole rows as wide as the mask, of which zeros fill the last.
  const std::vector<Vec4>& texels() const { return texels_; }
  // Gutter texels of the mask, row-major, and the numbers, from 1 on, of the edges of their charts that are nearest to them; 0: none.
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& gutter() const { return gutter_; }

 private:
  std::vector<Vec4> texels_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> gutter_;
};

}  // namespace fur::wet
