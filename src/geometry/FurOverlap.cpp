#include "geometry/FurOverlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

#include "core/Numbering.h"
#include "geometry/Adjacency.h"

namespace fur::geometry {

namespace {

constexpr std::uint32_t kNoCorner = 0xffffffffu;
constexpr float kFar = std::numeric_limits<float>::infinity();

// No chart of lower index is near. Any number well below 0 does, and none so low that it costs the
// interpolated values their precision.
constexpr float kNobody = -16.0f;

// Charts below this part of the surface's area cost little, however often they are covered.
constexpr double kSmallChart = 0.01;

// Where a triangle is unfolded along two ways that end apart (round a spike), it gets a corner of its own
// when they differ by more than this part of an edge; less is stretched away.
constexpr float kStretch = 0.5f;

// A corner in a chart's plane, beyond or on its border.
struct FlatCorner {
  std::uint32_t point;  // welded
  Vec2 fur;
  float g;
  std::uint32_t next;   // another one of this chart at the same point
};

struct Copy {
  std::uint32_t triangle;
  std::uint32_t corners[3];
};

struct Lap {
  std::vector<std::pair<std::uint32_t, float>> near;  // points with a distance, and their g
  std::vector<FlatCorner> corners;
  std::vector<Copy> copies;
};

class Lapper {
 public:
  Lapper(Surface& surface, const std::vector<std::uint32_t>& chartOf, std::uint32_t chartCount, const Weld& weld)
      : surface_(surface), chartOf_(chartOf), weld_(weld), laps_(chartCount), trianglesOfChart_(chartCount) {
    const std::size_t count = chartOf.size();
    across_ = neighboursAcrossSides(sortedSides(surface.indices, weld), count);
    for (std::uint32_t t = 0; t < count; ++t) trianglesOfChart_[chartOf[t]].push_back(t);
    listTrianglesOfPoints();
    distance_.assign(weld.count, kFar);
    firstCorner_.assign(weld.count, kNoCorner);
    visitedBy_.assign(count, kNoCorner);
  }

  FurOverlap run() {
    std::size_t copies = 0;
    for (std::uint32_t chart = 0; chart < laps_.size(); ++chart) {
      reachOut(chart);
      copies += laps_[chart].copies.size();
      if (copies <= kMostCopies * chartOf_.size()) continue;
      laps_[chart] = {};
      break;
    }
    findHardCharts();
    return emit();
  }

 private:
  const Vec3& position(std::uint32_t triangle, std::size_t k) const {
    return surface_.vertices[surface_.indices[3 * triangle + k % 3]].position;
  }
  const Vec2& ownFur(std::uint32_t triangle, std::size_t k) const {
    return surface_.vertices[surface_.indices[3 * triangle + k % 3]].fur;
  }
  std::uint32_t point(std::uint32_t triangle, std::size_t k) const {
    return weld_.idOf[surface_.indices[3 * triangle + k % 3]];
  }
  float area(std::uint32_t t) const {
    const Vec3 cross = glm::cross(position(t, 1) - position(t, 0), position(t, 2) - position(t, 0));
    return 0.5f * std::sqrt(glm::dot(cross, cross));
  }

  void listTrianglesOfPoints() {
    firstOfPoint_.assign(weld_.count + 1, 0);
    for (const std::uint32_t v : surface_.indices) ++firstOfPoint_[weld_.idOf[v] + 1];
    for (std::size_t i = 1; i < firstOfPoint_.size(); ++i) firstOfPoint_[i] += firstOfPoint_[i - 1];
    trianglesOfPoint_.resize(surface_.indices.size());
    std::vector<std::uint32_t> next(firstOfPoint_.begin(), firstOfPoint_.end() - 1);
    for (std::size_t i = 0; i < surface_.indices.size(); ++i)
      trianglesOfPoint_[next[weld_.idOf[surface_.indices[i]]]++] = static_cast<std::uint32_t>(i / 3);
  }

  template <class Visit>
  void forHigherTrianglesAt(std::uint32_t p, std::uint32_t chart, Visit visit) const {
    for (std::uint32_t i = firstOfPoint_[p]; i < firstOfPoint_[p + 1]; ++i)
      if (chartOf_[trianglesOfPoint_[i]] > chart) visit(trianglesOfPoint_[i]);
  }

  void reachOut(std::uint32_t chart) {
    measure(chart);
    unfold(chart);
    for (const auto& [p, g] : laps_[chart].near) distance_[p] = kFar;
    for (const FlatCorner& corner : laps_[chart].corners) firstCorner_[corner.point] = kNoCorner;
  }

  // Distances from the chart's border over triangles of higher index (Dijkstra, along edges), for the points
  // nearer than kReach and all their neighbours.
  void measure(std::uint32_t chart) {
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    std::vector<std::uint32_t> met;
    const auto offer = [&](std::uint32_t p, float d) {
      if (d >= distance_[p]) return;
      if (distance_[p] == kFar) met.push_back(p);
      distance_[p] = d;
      front.emplace(d, p);
    };
    for (const std::uint32_t t : trianglesOfChart_[chart])
      for (std::size_t k = 0; k < 3; ++k)
        forHigherTrianglesAt(point(t, k), chart, [&](std::uint32_t) { offer(point(t, k), 0.0f); });
    while (!front.empty() && front.top().first < kReach) {
      const auto [d, p] = front.top();
      front.pop();
      if (d > distance_[p]) continue;
      forHigherTrianglesAt(p, chart, [&, d = d, p = p](std::uint32_t t) {
        std::size_t here = 0;
        while (point(t, here) != p) ++here;
        for (const std::size_t k : {here + 1, here + 2}) {
          const Vec3 edge = position(t, k) - position(t, here);
          offer(point(t, k), d + std::sqrt(glm::dot(edge, edge)));
        }
      });
    }
    for (const std::uint32_t p : met) laps_[chart].near.emplace_back(p, std::max(1.0f - distance_[p] / kReach, kNobody));
  }

  std::uint32_t cornerAt(std::uint32_t chart, std::uint32_t p, const Vec2& fur, float tolerance) {
    std::vector<FlatCorner>& corners = laps_[chart].corners;
    for (std::uint32_t i = firstCorner_[p]; i != kNoCorner; i = corners[i].next) {
      const Vec2 apart = corners[i].fur - fur;
      if (glm::dot(apart, apart) <= tolerance * tolerance) return i;
    }
    corners.push_back({p, fur, std::max(1.0f - distance_[p] / kReach, kNobody), firstCorner_[p]});
    return firstCorner_[p] = static_cast<std::uint32_t>(corners.size() - 1);
  }

  struct Entrance {
    std::uint32_t triangle;
    std::size_t side;
    std::uint32_t from, to;  // flat corners at the ends of the side
    Vec2 behind;             // on the other side of it
  };

  // Copies every triangle of higher index with a corner that has a distance, each laid beside the one before.
  void unfold(std::uint32_t chart) {
    std::vector<Entrance> queue;
    for (const std::uint32_t t : trianglesOfChart_[chart]) {
      for (std::size_t side = 0; side < 3; ++side) {
        const std::uint32_t other = across_[3 * t + side];
        if (other == kNoTriangle || chartOf_[other] <= chart) continue;
        const std::uint32_t a = cornerAt(chart, point(t, side), ownFur(t, side), 0.0f);
        const std::uint32_t b = cornerAt(chart, point(t, side + 1), ownFur(t, side + 1), 0.0f);
        queue.push_back({other, sideBetween(other, point(t, side + 1)), b, a, ownFur(t, side + 2)});
      }
    }
    unfoldFrom(queue, chart);
    // What only touches the chart at a point, or across an edge of more than two triangles.
    for (const auto& [near, g] : laps_[chart].near) {
      const std::uint32_t p = near;
      forHigherTrianglesAt(p, chart, [&](std::uint32_t t) {
        if (visitedBy_[t] == chart) return;
        std::size_t here = 0;
        while (point(t, here) != p) ++here;
        const Vec2 at = firstCorner_[p] == kNoCorner ? Vec2(0.0f) : laps_[chart].corners[firstCorner_[p]].fur;
        const Vec3 edge = position(t, here + 1) - position(t, here);
        const Vec2 to = at + Vec2(std::sqrt(glm::dot(edge, edge)), 0.0f);
        queue.assign(1, {t, here, cornerAt(chart, p, at, 0.0f), cornerAt(chart, point(t, here + 1), to, 0.0f),
                         at - Vec2(0.0f, 1.0f)});
        unfoldFrom(queue, chart);
      });
    }
  }

  // The side of `triangle` that starts at p.
  std::size_t sideBetween(std::uint32_t triangle, std::uint32_t p) const {
    std::size_t side = 0;
    while (side < 2 && point(triangle, side) != p) ++side;
    return side;
  }

  void unfoldFrom(std::vector<Entrance>& queue, std::uint32_t chart) {
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const Entrance in = queue[i];
      const std::uint32_t t = in.triangle;
      const float nearest = std::min({distance_[point(t, 0)], distance_[point(t, 1)], distance_[point(t, 2)]});
      if (visitedBy_[t] == chart || nearest == kFar) continue;
      visitedBy_[t] = chart;
      const Vec2 a = laps_[chart].corners[in.from].fur, b = laps_[chart].corners[in.to].fur;
      const std::uint32_t apex = layApex(in, chart, a, b);
      Copy copy{t, {}};
      copy.corners[in.side] = in.from;
      copy.corners[(in.side + 1) % 3] = in.to;
      copy.corners[(in.side + 2) % 3] = apex;
      laps_[chart].copies.push_back(copy);
      for (const std::size_t side : {in.side + 1, in.side + 2}) {
        const std::uint32_t other = across_[3 * t + side % 3];
        if (other == kNoTriangle || chartOf_[other] <= chart) continue;
        const std::uint32_t from = copy.corners[side % 3], to = copy.corners[(side + 1) % 3];
        queue.push_back({other, sideBetween(other, point(t, side + 1)), to, from,
                         laps_[chart].corners[copy.corners[(side + 2) % 3]].fur});
      }
    }
  }

  // The third corner: as far along the side and as high above it as on the surface.
  std::uint32_t layApex(const Entrance& in, std::uint32_t chart, const Vec2& a, const Vec2& b) {
    const std::uint32_t t = in.triangle;
    const Vec3 edge = position(t, in.side + 1) - position(t, in.side), way = position(t, in.side + 2) - position(t, in.side);
    const float along = glm::dot(way, edge) / glm::dot(edge, edge);
    const Vec3 up = way - edge * along;
    const float height = std::sqrt(glm::dot(up, up));
    const Vec2 flat = b - a;
    const float length = std::sqrt(glm::dot(flat, flat));
    Vec2 across = length > 1e-12f ? Vec2(-flat.y, flat.x) / length : Vec2(0.0f, 1.0f);
    if (glm::dot(across, in.behind - a) > 0.0f) across = -across;
    const float longest = std::sqrt(std::max(glm::dot(edge, edge), glm::dot(way, way)));
    return cornerAt(chart, point(t, in.side + 2), a + flat * along + across * height, kStretch * longest);
  }

  void findHardCharts() {
    std::vector<double> areas(laps_.size(), 0.0), covered(laps_.size(), 0.0);
    double total = 0.0;
    for (std::uint32_t t = 0; t < chartOf_.size(); ++t) areas[chartOf_[t]] += area(t);
    for (const double part : areas) total += part;
    for (const Lap& lap : laps_)
      for (const Copy& copy : lap.copies)
        if (std::any_of(copy.corners, copy.corners + 3, [&](std::uint32_t c) { return lap.corners[c].g > 0.0f; }))
          covered[chartOf_[copy.triangle]] += area(copy.triangle);
    hard_.resize(laps_.size());
    for (std::size_t k = 0; k < laps_.size(); ++k)
      hard_[k] = areas[k] > kSmallChart * total && covered[k] > areas[k];
  }

  FurOverlap emit() {
    FurOverlap out;
    out.chartOfVertex.resize(surface_.vertices.size());
    std::vector<std::uint32_t> copied, copiedFrom;
    reached_.assign(weld_.count, kNobody);
    ownShown_.assign(chartOf_.size(), true);
    for (std::uint32_t chart = 0; chart < laps_.size(); ++chart) {
      emitOwn(chart, out.chartOfVertex);
      emitCopies(chart, out.chartOfVertex, copied, copiedFrom);
      for (const auto& [p, g] : laps_[chart].near) reached_[p] = std::max(reached_[p], g);
    }
    for (std::uint32_t t = 0; t < chartOf_.size(); ++t)
      if (ownShown_[t]) {
        out.triangleOf.push_back(t);
        for (std::size_t k = 0; k < 3; ++k) surface_.furIndices.push_back(surface_.indices[3 * t + k]);
      }
    out.firstCopy = surface_.furIndices.size();
    surface_.furIndices.insert(surface_.furIndices.end(), copied.begin(), copied.end());
    out.triangleOf.insert(out.triangleOf.end(), copiedFrom.begin(), copiedFrom.end());
    return out;
  }

  void emitOwn(std::uint32_t chart, std::vector<std::uint32_t>& chartOfVertex) {
    for (const std::uint32_t t : trianglesOfChart_[chart]) {
      bool shown = hard_[chart];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = surface_.indices[3 * t + k];
        surface_.vertices[v].strands = Vec2(hard_[chart] ? kNobody : reached_[weld_.idOf[v]], 2.0f);
        chartOfVertex[v] = chart;
        shown = shown || surface_.vertices[v].strands.x < 1.0f;
      }
      ownShown_[t] = shown;
    }
  }

  void emitCopies(std::uint32_t chart, std::vector<std::uint32_t>& chartOfVertex, std::vector<std::uint32_t>& copied,
                  std::vector<std::uint32_t>& copiedFrom) {
    const std::vector<FlatCorner>& corners = laps_[chart].corners;
    const auto first = static_cast<std::uint32_t>(surface_.vertices.size());
    Numbering vertices;
    for (const Copy& copy : laps_[chart].copies) {
      if (hard_[chartOf_[copy.triangle]] || !hasStrands(corners, copy)) continue;
      copiedFrom.push_back(copy.triangle);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t source = surface_.indices[3 * copy.triangle + k];
        const std::uint64_t key = std::uint64_t{copy.corners[k]} << 32 | source;
        copied.push_back(first + vertices.of(key));
        if (copied.back() < surface_.vertices.size()) continue;
        const FlatCorner& corner = corners[copy.corners[k]];
        SurfaceVertex vertex = surface_.vertices[source];
        vertex.fur = corner.fur;
        vertex.strands = Vec2(reached_[corner.point], std::max(reached_[corner.point], corner.g));
        surface_.vertices.push_back(vertex);
        chartOfVertex.push_back(chart);
      }
    }
  }

  bool hasStrands(const std::vector<FlatCorner>& corners, const Copy& copy) const {
    bool starts = false, ends = false, some = false;
    for (const std::uint32_t c : copy.corners) {
      const float lower = reached_[corners[c].point], upper = std::max(lower, corners[c].g);
      starts = starts || lower < 1.0f;
      ends = ends || upper > 0.0f;
      some = some || upper > lower;
    }
    return starts && ends && some;
  }

  Surface& surface_;
  const std::vector<std::uint32_t>& chartOf_;
  const Weld& weld_;
  std::vector<Lap> laps_;
  std::vector<std::vector<std::uint32_t>> trianglesOfChart_;
  std::vector<std::uint32_t> across_, firstOfPoint_, trianglesOfPoint_, visitedBy_, firstCorner_;
  std::vector<float> distance_;  // of the chart at work
  std::vector<float> reached_;   // F of all charts so far
  std::vector<std::uint8_t> hard_, ownShown_;
};

}  // namespace

FurOverlap overlapFurCharts(Surface& surface, const std::vector<std::uint32_t>& chartOf, std::uint32_t chartCount,
                            const Weld& weld) {
  return Lapper(surface, chartOf, chartCount, weld).run();
}

}  // namespace fur::geometry
