// Exact nearest-neighbour fill of a square tile that wraps round (Felzenszwalb & Huttenlocher 2012,
// "Distance Transforms of Sampled Functions"), in time linear in the texels.
#pragma once

#include <cstdint>
#include <vector>

namespace fur::furgen {

class NearestFill {
 public:
  explicit NearestFill(int size);

  // `ids` (size * size, row-major): each 0 gets the value of the nearest texel that is not 0, by Euclidean distance between
  // texel centres on the torus. All zeros stay as they are.
  void fill(std::uint32_t* ids);

 private:
  void sweepColumns(const std::uint32_t* ids);
  void joinRow(int y, std::uint32_t* row);

  int size_;
  // To the nearest non-zero texel in the same column, and its value.
  std::vector<std::int32_t> distance_;
  std::vector<std::uint32_t> columnId_;
  // Lower envelope of the parabolas of one row.
  std::vector<int> apex_, apexHeight_;
  std::vector<float> from_;
};

// The same for one row that wraps round; `columns` is a power of two. False when it is all 0.
bool fillRow(std::uint32_t* row, int columns);

}  // namespace fur::furgen
