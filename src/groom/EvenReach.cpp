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

// Of each texel its chart's number, as withCharts() has it.
std::vector<std::uint8_t> chartsOf(const geometry::Surface& surface, const geometry::AtlasTexels& atlas) {
  std::vector<std::uint8_t> out;
  out.reserve(atlas.triangleOf().size());
  for (const std::uint32_t triangle : atlas.triangleOf())
    out.push_back(triangle == geometry::kNoTriangle ? std::uint8_t{0} : static_cast<std::uint8_t>(surface.vertices[surface.indices[3 * triangle]].chart % 255 + 1));
  for (const auto& [texel, source] : atlas.gutter()) out[texel] = out[source];
  return out;
}

// Calls visit(neighbour) for those of the four neighbours before the texel, row by row (`back`: after it), that are of its chart.
constexpr int kBefore[4][2] = {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
template <class Visit>
void forBeside(const std::vector<std::uint8_t>& charts, int size, int x, int y, bool back, Visit visit) {
  const std::uint8_t chart = charts[static_cast<std::size_t>(y * size + x)];
  for (const auto& way : kBefore) {
    const int u = back ? x - way[0] : x + way[0], v = back ? y - way[1] : y + way[1];
    const auto there = static_cast<std::size_t>(v * size + u);
    if (u >= 0 && v >= 0 && u < size && v < size && charts[there] == chart) visit(there);
  }
}

// 0 where a neighbour on the chart is another, else the most.
std::vector<std::uint8_t> borders(const GroomMap& map, const geometry::AtlasTexels& atlas, const std::vector<std::uint8_t>& charts) {
  const int size = map.size();
  const std::vector<GroomMap::Texel>& texels = map.texels();
  const auto onChart = [&](std::size_t i) { return atlas.triangleOf()[i] != geometry::kNoTriangle; };
  std::vector<std::uint8_t> out(texels.size(), kMostReach);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto at = static_cast<std::size_t>(y * size + x);
      if (!onChart(at)) continue;
      if (onlyType(texels[at]) < 0) out[at] = 0;
      forBeside(charts, size, x, y, false, [&](std::size_t there) {
        if (onChart(there) && texels[at] != texels[there]) out[at] = out[there] = 0;
      });
    }
  return out;
}

// The distance from the nearest 0, a step to any of eight neighbours.
void spread(std::vector<std::uint8_t>& reach, const std::vector<std::uint8_t>& charts, int size) {
  for (const bool back : {false, true})
    for (int i = 0; i < size * size; ++i) {
      const int at = back ? size * size - 1 - i : i;
      std::uint8_t& here = reach[static_cast<std::size_t>(at)];
      forBeside(charts, size, at % size, at / size, back, [&](std::size_t there) { here = std::min(here, static_cast<std::uint8_t>(reach[there] + 1)); });
    }
}

}  // namespace

std::vector<EvenTexel> evenReach(const GroomMap& map, const geometry::Surface& surface, const geometry::AtlasTexels& atlas) {
  FUR_ASSERT(atlas.size() == map.size(), "groom::evenReach()", "an atlas of the map's size", atlas.size());
  const std::vector<std::uint8_t> charts = chartsOf(surface, atlas);
  std::vector<std::uint8_t> reach = borders(map, atlas, charts);
  spread(reach, charts, map.size());
  std::vector<EvenTexel> out;
  out.reserve(reach.size());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const int type = onlyType(map.texels()[i]);
    out.push_back({type < 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(type + 4 * reach[i]), map.texels()[i][0], charts[i], 0});
  }
  return out;
}

GroomMap withCharts(GroomMap map, const geometry::Surface& surface, const geometry::AtlasTexels& atlas) {
  FUR_ASSERT(atlas.size() == map.size(), "groom::withCharts()", "an atlas of the map's size", atlas.size());
  const std::vector<std::uint8_t> charts = chartsOf(surface, atlas);
  std::vector<GroomMap::Texel> texels = map.texels();
  for (std::size_t i = 0; i < charts.size(); ++i) texels[i] = {texels[i][0], 0, 0, charts[i]};
  map.restore(std::move(texels));
  return map;
}

}  // namespace fur::groom
