#include "groom/EvenReach.h"

#include <algorithm>

#include "core/Assert.h"
#include "geometry/Adjacency.h"

namespace fur::groom {

namespace {

// Of a texel; -1: several share it.
int onlyType(const GroomMap::Texel& texel) {
  if (texel[1] + texel[2] + texel[3] == 0) return 0;
  for (int type = 1; type < kTypes; ++type)
    if (texel[static_cast<std::size_t>(type)] == 255) return type;
  return -1;
}

// 0 where a neighbour is another, else the most.
std::vector<std::uint8_t> borders(const GroomMap& map, const geometry::AtlasTexels& atlas) {
  const int size = map.size();
  const std::vector<GroomMap::Texel>& texels = map.texels();
  std::vector<std::uint8_t> out(texels.size(), kMostReach);
  const auto onChart = [&](std::size_t i) { return atlas.triangleOf()[i] != geometry::kNoTriangle; };
  const auto meet = [&](std::size_t a, std::size_t b) {
    if (onChart(a) && onChart(b) && texels[a] != texels[b]) out[a] = out[b] = 0;
  };
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto at = static_cast<std::size_t>(y * size + x), row = static_cast<std::size_t>(size);
      if (onChart(at) && onlyType(texels[at]) < 0) out[at] = 0;
      if (x + 1 < size) meet(at, at + 1);
      if (y + 1 == size) continue;
      meet(at, at + row);
      if (x > 0) meet(at, at + row - 1);
      if (x + 1 < size) meet(at, at + row + 1);
    }
  return out;
}

// The distance from the nearest 0, a step to any of eight neighbours.
void spread(std::vector<std::uint8_t>& reach, int size) {
  const auto closer = [&](int x, int y, int u, int v) {
    if (u < 0 || v < 0 || u >= size || v >= size) return;
    std::uint8_t& here = reach[static_cast<std::size_t>(y * size + x)];
    here = std::min<std::uint8_t>(here, static_cast<std::uint8_t>(reach[static_cast<std::size_t>(v * size + u)] + 1));
  };
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) closer(x, y, x - 1, y), closer(x, y, x - 1, y - 1), closer(x, y, x, y - 1), closer(x, y, x + 1, y - 1);
  for (int y = size - 1; y >= 0; --y)
    for (int x = size - 1; x >= 0; --x) closer(x, y, x + 1, y), closer(x, y, x + 1, y + 1), closer(x, y, x, y + 1), closer(x, y, x - 1, y + 1);
}

}  // namespace

std::vector<EvenTexel> evenReach(const GroomMap& map, const geometry::AtlasTexels& atlas) {
  FUR_ASSERT(atlas.size() == map.size(), "groom::evenReach()", "an atlas of the map's size", atlas.size());
  std::vector<std::uint8_t> reach = borders(map, atlas);
  spread(reach, map.size());
  std::vector<EvenTexel> out;
  out.reserve(reach.size());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const int type = onlyType(map.texels()[i]);
    out.push_back({type < 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(type + 4 * reach[i]), map.texels()[i][0]});
  }
  return out;
}

}  // namespace fur::groom
