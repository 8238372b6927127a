#include "groom/TypesNear.h"

#include <algorithm>

#include "core/Assert.h"
#include "geometry/Adjacency.h"

namespace fur::groom {

namespace {

struct NearCell {
  std::uint8_t types = 0, shortest = 255, longest = 0;

  void add(const NearCell& other) {
    types |= other.types;
    shortest = std::min(shortest, other.shortest);
    longest = std::max(longest, other.longest);
  }
  void add(const GroomMap::Texel& texel) {
    const bool first = texel[1] + texel[2] + texel[3] < 255;
    add(NearCell{static_cast<std::uint8_t>(first | (texel[1] > 0) << 1 | (texel[2] > 0) << 2 | (texel[3] > 0) << 3), texel[0], texel[0]});
  }
  std::uint8_t bits() const {
    return types == 0 ? 0xff : static_cast<std::uint8_t>(types | (shortest < longest ? kLengthsDiffer : 0));
  }
};

using NearCells = std::vector<NearCell>;

NearCells finest(const GroomMap& map, const geometry::AtlasTexels& atlas, int side) {
  NearCells cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  const int size = map.size();
  std::size_t texel = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x, ++texel)
      if (atlas.triangleOf()[texel] != geometry::kNoTriangle)
        cells[static_cast<std::size_t>(y * side / size * side + x * side / size)].add(map.texels()[texel]);
  return cells;
}

NearCells halved(const NearCells& cells, int side) {
  NearCells out(cells.size() / 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      out[static_cast<std::size_t>(y / 2 * (side / 2) + x / 2)].add(cells[static_cast<std::size_t>(y * side + x)]);
  return out;
}

// Along rows, then along columns.
std::vector<std::uint8_t> withThoseAround(const NearCells& cells, int side) {
  NearCells rows = cells;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const auto at = static_cast<std::size_t>(y * side + x);
      rows[at].add(cells[at + 1]);
      rows[at + 1].add(cells[at]);
    }
  std::vector<std::uint8_t> bits;
  bits.reserve(cells.size());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      NearCell all;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, side - 1); ++v) all.add(rows[static_cast<std::size_t>(v * side + x)]);
      bits.push_back(all.bits());
    }
  return bits;
}

}  // namespace

int nearCells(int mapSize) {
  int side = 1;
  while (2 * side < mapSize) side *= 2;
  return side;
}

std::vector<std::vector<std::uint8_t>> typesNear(const GroomMap& map, const geometry::AtlasTexels& atlas) {
  FUR_ASSERT(atlas.size() == map.size(), "groom::typesNear()", "an atlas of the map's size", atlas.size());
  int side = nearCells(map.size());
  NearCells cells = finest(map, atlas, side);
  std::vector<std::vector<std::uint8_t>> levels{withThoseAround(cells, side)};
  for (; side > 1; side /= 2) {
    cells = halved(cells, side);
    levels.push_back(withThoseAround(cells, side / 2));
  }
  return levels;
}

}  // namespace fur::groom
