#include "geometry/ChartPacking.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "core/Sort.h"

namespace {
// Stable, since qsort orders equals differently in each C library.
template <class Rect>
void sortRects(Rect* rects, int count, int (*compare)(const void*, const void*)) {
  fur::sortStably(rects, rects + count, [&](const Rect& a, const Rect& b) { return compare(&a, &b) < 0; });
}
}  // namespace

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#define STBRP_SORT(rects, count, size, compare) sortRects(rects, count, compare)
#include <stb/stb_rect_pack.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace fur::geometry {

namespace {

// Packing works in whole cells, eight to a texel of a 256^2 map.
constexpr int kCells = 2048;
constexpr int kGutterCells = 16;
static_assert(kGutter * kCells == kGutterCells);

struct Box {
  Vec2 low{1e30f}, high{-1e30f};
  Vec2 size() const { return high - low; }
};

std::vector<Box> boxesOf(const Charts& charts, const std::vector<Placement>& placements) {
  std::vector<Box> boxes(charts.count);
  for (std::size_t i = 0; i < charts.corners.size(); ++i) {
    const std::uint32_t chart = charts.chartOf[i / 3];
    const Vec2 p = placements[chart].apply(charts.corners[i]);
    boxes[chart].low = glm::min(boxes[chart].low, p);
    boxes[chart].high = glm::max(boxes[chart].high, p);
  }
  return boxes;
}

// Turns every chart to the one of 24 directions over a quarter turn that has the smallest box.
std::vector<Placement> turned(const Charts& charts) {
  constexpr int kDirections = 24;
  std::vector<Placement> best(charts.count);
  std::vector<float> bestArea(charts.count, 1e30f);
  for (int i = 0; i < kDirections; ++i) {
    const float angle = 0.5f * kPi * static_cast<float>(i) / kDirections;
    const std::vector<Placement> trial(charts.count, {portableCos(angle), portableSin(angle), 1.0f, Vec2(0.0f)});
    const std::vector<Box> boxes = boxesOf(charts, trial);
    for (std::uint32_t chart = 0; chart < charts.count; ++chart) {
      const float area = boxes[chart].size().x * boxes[chart].size().y;
      if (area >= bestArea[chart] * 0.999f) continue;
      bestArea[chart] = area;
      best[chart] = trial[chart];
    }
  }
  return best;
}

// Cells that a length takes at a scale, with its gutter.
int cellsFor(float length, float scale, int gutter) {
  return std::max(1, static_cast<int>(std::ceil(length * scale))) + gutter;
}

// Above this many a skyline takes seconds (its time grows with count times width); rows do nearly as well then.
constexpr std::size_t kMaxSkylineBoxes = 5000;

// Rows from the highest box to the lowest.
bool packRows(std::vector<stbrp_rect>& rects, int cells) {
  std::vector<std::size_t> order(rects.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  sortStably(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rects[a].h > rects[b].h; });
  int x = 0, y = 0, rowHeight = 0;
  for (const std::size_t i : order) {
    if (x + rects[i].w > cells) {
      y += rowHeight;
      x = rowHeight = 0;
    }
    rowHeight = std::max(rowHeight, rects[i].h);
    if (y + rowHeight > cells) return false;
    rects[i].x = x;
    rects[i].y = y;
    x += rects[i].w;
  }
  return true;
}

bool pack(const std::vector<Box>& boxes, float scale, int cells, std::vector<stbrp_rect>& rects) {
  rects.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec2 size = boxes[i].size();
    const int width = cellsFor(size.x, scale, kGutterCells), height = cellsFor(size.y, scale, kGutterCells);
    if (width > cells || height > cells) return false;
    rects[i] = {static_cast<int>(i), width, height, 0, 0, 0};
  }
  if (rects.size() > kMaxSkylineBoxes) return packRows(rects, cells);
  std::vector<stbrp_node> nodes(static_cast<std::size_t>(cells));
  stbrp_context context;
  stbrp_init_target(&context, cells, cells, nodes.data(), cells);
  stbrp_setup_heuristic(&context, STBRP_HEURISTIC_Skyline_BF_sortHeight);
  return stbrp_pack_rects(&context, rects.data(), static_cast<int>(rects.size())) == 1;
}

}  // namespace

std::vector<Placement> packCharts(const Charts& charts) {
  std::vector<Placement> placements = turned(charts);
  const std::vector<Box> boxes = boxesOf(charts, placements);
  double area = 0.0;
  float longest = 0.0f;
  for (const Box& box : boxes) {
    area += static_cast<double>(box.size().x) * box.size().y;
    longest = std::max({longest, box.size().x, box.size().y});
  }
  // Without room for the gutters alone, finer cells make them narrower.
  int cells = kCells;
  const double perChart = static_cast<double>(kGutterCells + 1) * (kGutterCells + 1);
  while (perChart * static_cast<double>(boxes.size()) > 0.6 * cells * cells) cells *= 2;

  // The largest scale that fits: between nothing and a square filled to the last cell.
  std::vector<stbrp_rect> rects, trial;
  float low = 0.0f;
  float high = static_cast<float>(cells / std::max(std::sqrt(area), static_cast<double>(longest)));
  while (!pack(boxes, low, cells, rects)) cells *= 2;
  for (int i = 0; i < 14; ++i) {
    const float middle = 0.5f * (low + high);
    if (pack(boxes, middle, cells, trial)) {
      low = middle;
      rects.swap(trial);
    } else {
      high = middle;
    }
  }
  const float cell = 1.0f / static_cast<float>(cells);
  for (const stbrp_rect& rect : rects) {
    const auto chart = static_cast<std::size_t>(rect.id);
    placements[chart].scale = low * cell;
    const Vec2 corner = Vec2(rect.x + kGutterCells / 2, rect.y + kGutterCells / 2) * cell;
    placements[chart].offset = corner - boxes[chart].low * low * cell;
  }
  return placements;
}

}  // namespace fur::geometry
