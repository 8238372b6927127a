// Which parts of a square map have changed since they were last taken: tiles, and one rectangle round all of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/AtlasTexels.h"

namespace fur::wet {

class ChangedTiles {
 public:
  explicit ChangedTiles(int size) : size_(size) {}

  void note(const geometry::TexelRect& changed);
  // One rectangle round all of it, empty: nothing has changed; or a few that are smaller together.
  geometry::TexelRect take();
  std::vector<geometry::TexelRect> takeParts();

 private:
  static constexpr int kTiles = 16;  // along the map

  int tile() const { return (size_ + kTiles - 1) / kTiles; }

  int size_;
  geometry::TexelRect all_;
  std::array<std::uint16_t, kTiles> rows_{};  // a bit for each tile of a row
};

}  // namespace fur::wet
