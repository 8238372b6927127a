#include "geometry/Charts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "core/Sort.h"
#include "geometry/Adjacency.h"
#include "geometry/ChartRelaxation.h"
#include "geometry/TriangleGrid.h"

namespace fur::geometry {

namespace {

constexpr std::uint32_t kNoRegion = 0xffffffffu;

// cos 60 degrees: a region takes triangles up to here from its mean (smoothed) normal.
constexpr float kGrowLimit = 0.5f;
// cos 73 degrees: no triangle of a chart is flattened to less than three tenths of its area...
constexpr float kFlatLimit = 0.3f;
// ...but in scraps that are not worth a chart of their own (cos 87 degrees).
constexpr float kScrapFlatLimit = 0.05f;
// A region below this part of the surface's area is a scrap.
constexpr float kScrapArea = 0.002f;
// cos 50 degrees: no chart goes over an edge as sharp as that which bounds a face, if the faces are no scraps. Laid flat
// across it both would be stretched.
constexpr float kSharp = 0.643f;
constexpr int kRelaxations = 4;
// Rounds of shortenBorders(): two or three are enough.
constexpr int kShortenings = 8;

struct Region {
  Vec3 axis{0.0f};
  float area = 0.0f;
  std::vector<std::uint32_t> triangles;
};

// An orthonormal frame with w = axis and v as near to +y as that allows.
struct Frame {
  explicit Frame(const Vec3& axis) {
    const Vec3 up = std::abs(axis.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(0, 0, axis.y > 0.0f ? -1.0f : 1.0f);
    u = normalizeOr(glm::cross(up, axis), Vec3(1, 0, 0));
    v = glm::cross(axis, u);
  }
  Vec2 operator()(const Vec3& p) const { return Vec2(glm::dot(u, p), glm::dot(v, p)); }
  Vec3 u, v;
};

// A step goes on until it has compared so many triangles.
constexpr std::size_t kComparisonsAStep = 30000;

// Flattening loses area where a surface bulges: every chart gets as much as it has on the surface.
void restoreAreas(Charts& charts, const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices) {
  std::vector<double> flat(charts.count, 0.0), round(charts.count, 0.0);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec2 a = charts.corners[i + 1] - charts.corners[i], b = charts.corners[i + 2] - charts.corners[i];
    const Vec3 cross = glm::cross(positions[indices[i + 1]] - positions[indices[i]], positions[indices[i + 2]] - positions[indices[i]]);
    flat[charts.chartOf[i / 3]] += std::abs(a.x * b.y - a.y * b.x);
    round[charts.chartOf[i / 3]] += std::sqrt(glm::dot(cross, cross));
  }
  for (std::size_t i = 0; i < charts.corners.size(); ++i) {
    const std::uint32_t chart = charts.chartOf[i / 3];
    if (flat[chart] > 0.0) charts.corners[i] *= static_cast<float>(std::sqrt(round[chart] / flat[chart]));
  }
}

}  // namespace

class ChartMaking::Maker {
 public:
  Maker(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices, const Weld& weld)
      : positions_(positions), indices_(indices), weld_(weld) {}

  bool step() {
    switch (stage_) {
      case Stage::Measure:
        across_ = neighboursAcrossSides(sortedSides(indices_, weld_), indices_.size() / 3);
        measureFaces();
        regionOf_.assign(areas_.size(), kNoRegion);
        stage_ = Stage::Grow;
        return false;
      case Stage::Grow:
        if (relaxations_ < 0) seedUntilCovered();
        else relax();
        if (++relaxations_ < kRelaxations) return false;
        shortenBorders();
        beginFlat();
        stage_ = Stage::LayFlat;
        return false;
      case Stage::LayFlat:
        if (layFlat()) stage_ = Stage::Join;
        return false;
      case Stage::Join:
        if (!joinRegions()) return false;
        charts_ = result();
        relaxation_.emplace(charts_, positions_, indices_, weld_);
        stage_ = Stage::Relax;
        return false;
      case Stage::Relax: break;
    }
    if (!relaxation_->step()) return false;
    restoreAreas(charts_, positions_, indices_);
    return true;
  }

  Charts take() { return std::move(charts_); }

 private:
  struct Candidate {
    float cost;
    std::uint32_t triangle, region;
    bool operator<(const Candidate& o) const {  // std::priority_queue: the cheapest comes first
      return cost != o.cost ? cost > o.cost : triangle != o.triangle ? triangle > o.triangle : region > o.region;
    }
  };
  using Front = std::priority_queue<Candidate>;

  void measureFaces() {
    const std::size_t count = indices_.size() / 3;
    normals_.resize(count);
    areas_.resize(count);
    for (std::size_t t = 0; t < count; ++t) {
      const Vec3 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
      const glm::dvec3 cross = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
      const double length = std::sqrt(glm::dot(cross, cross));
      areas_[t] = static_cast<float>(length * 0.5);
      normals_[t] = length > 0.0 ? Vec3(cross / length) : Vec3(0, 1, 0);
      totalArea_ += areas_[t];
    }
    partFaces();
    // Two rounds over the neighbours: scans are noisy, and a region should not stop at each bump.
    smooth_ = normals_;
    for (int round = 0; round < 2; ++round) {
      std::vector<Vec3> next(count);
      for (std::size_t t = 0; t < count; ++t) {
        Vec3 sum = smooth_[t] * areas_[t];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t other = across_[3 * t + k];
          if (other != kNoTriangle) sum += smooth_[other] * areas_[other];
        }
        next[t] = normalizeOr(sum, normals_[t]);
      }
      smooth_.swap(next);
    }
  }

  // Parts what lies smooth in itself from what meets it at sharp edges.
  void partFaces() {
    const auto smooth = [this](std::uint32_t t, std::size_t, std::uint32_t other) {
      return glm::dot(normals_[t], normals_[other]) > kSharp;
    };
    std::uint32_t count = 0;
    const std::vector<std::uint32_t> faceOf = connectedPieces(across_, smooth, count);
    std::vector<double> areas(count, 0.0);
    for (std::size_t t = 0; t < areas_.size(); ++t) areas[faceOf[t]] += areas_[t];
    for (std::size_t i = 0; i < across_.size(); ++i) {
      if (across_[i] == kNoTriangle) continue;
      const std::uint32_t a = faceOf[i / 3], b = faceOf[across_[i]];
      if (a != b && std::min(areas[a], areas[b]) >= kScrapArea * totalArea_) across_[i] = kNoTriangle;
    }
  }

  const Vec3& corner(std::size_t triangle, std::size_t k) const { return positions_[indices_[3 * triangle + k]]; }
  Vec3 centre(std::size_t t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0f; }

  // Distance counts a little, so that regions on flat ground come out round.
  float costOf(std::uint32_t triangle, const Vec3& axis, const Vec3& from) const {
    const Vec3 d = centre(triangle) - from;
    return 1.0f - glm::dot(smooth_[triangle], axis) + 0.2f * glm::dot(d, d);
  }

  void pushNeighbours(Front& front, std::uint32_t triangle, std::uint32_t region, const Vec3& axis, const Vec3& from) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = across_[3 * triangle + k];
      if (other == kNoTriangle || regionOf_[other] != kNoRegion) continue;
      if (glm::dot(smooth_[other], axis) < kGrowLimit) continue;
      front.push({costOf(other, axis, from), other, region});
    }
  }

  // Regions one after the other, each round the normal of its seed, until none is left over.
  void seedUntilCovered() {
    for (std::uint32_t seed = 0; seed < regionOf_.size(); ++seed) {
      if (regionOf_[seed] != kNoRegion) continue;
      const auto region = static_cast<std::uint32_t>(regions_.size());
      const Vec3 axis = smooth_[seed], from = centre(seed);
      Front front;
      regions_.push_back({axis, 0.0f, {}});
      take(seed, region);
      pushNeighbours(front, seed, region, axis, from);
      while (!front.empty()) {
        const std::uint32_t triangle = front.top().triangle;
        front.pop();
        if (regionOf_[triangle] != kNoRegion) continue;
        take(triangle, region);
        pushNeighbours(front, triangle, region, axis, from);
      }
    }
  }

  void take(std::uint32_t triangle, std::uint32_t region) {
    regionOf_[triangle] = region;
    regions_[region].triangles.push_back(triangle);
    regions_[region].area += areas_[triangle];
  }

  Vec3 meanNormal(const std::vector<std::uint32_t>& triangles) const {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t t : triangles) sum += glm::dvec3(normals_[t]) * static_cast<double>(areas_[t]);
    const double length = std::sqrt(glm::dot(sum, sum));
    return length > 1e-12 ? Vec3(sum / length) : normals_[triangles[0]];
  }

  // The triangle of a region that best stands for it: near its middle, along its mean normal.
  std::uint32_t middleOf(const Region& region, const Vec3& axis) const {
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const std::uint32_t t : region.triangles) {
      sum += glm::dvec3(centre(t)) * static_cast<double>(areas_[t]);
      area += areas_[t];
    }
    const Vec3 middle = area > 0.0 ? Vec3(sum / area) : centre(region.triangles[0]);
    std::uint32_t best = region.triangles[0];
    float bestCost = 1e30f;
    for (const std::uint32_t t : region.triangles) {
      const Vec3 d = centre(t) - middle;
      const float cost = glm::dot(d, d) + 0.5f * (1.0f - glm::dot(smooth_[t], axis));
      if (cost < bestCost) {
        bestCost = cost;
        best = t;
      }
    }
    return best;
  }

  // All regions anew at once, each from its middle: scraps disappear, borders fall into the creases.
  void relax() {
    std::vector<std::pair<Vec3, std::uint32_t>> seeds;
    for (const Region& region : regions_) {
      if (region.area < kScrapArea * totalArea_) continue;
      const Vec3 axis = meanNormal(region.triangles);
      seeds.push_back({axis, middleOf(region, axis)});
    }
    regions_.clear();
    std::fill(regionOf_.begin(), regionOf_.end(), kNoRegion);
    Front front;
    for (const auto& [axis, seed] : seeds) {
      const auto region = static_cast<std::uint32_t>(regions_.size());
      regions_.push_back({axis, 0.0f, {}});
      take(seed, region);
    }
    for (std::uint32_t r = 0; r < seeds.size(); ++r) pushNeighbours(front, seeds[r].second, r, seeds[r].first, centre(seeds[r].second));
    while (!front.empty()) {
      const Candidate best = front.top();
      front.pop();
      if (regionOf_[best.triangle] != kNoRegion) continue;
      take(best.triangle, best.region);
      const auto& [axis, seed] = seeds[best.region];
      pushNeighbours(front, best.triangle, best.region, axis, centre(seed));
    }
    seedUntilCovered();
  }

  float sideOf(std::uint32_t t, std::size_t k) const {
    const Vec3 d = corner(t, k) - corner(t, (k + 1) % 3);
    return std::sqrt(glm::dot(d, d));
  }

  // How long the triangle's sides are that lie at the region.
  float sidesAt(std::uint32_t t, std::uint32_t region) const {
    float sum = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = across_[3 * t + k];
      if (other != kNoTriangle && regionOf_[other] == region) sum += sideOf(t, k);
    }
    return sum;
  }

  // Triangles go over to the region at which more of their sides lie: teeth of a border disappear, which have no room for strands that lie.
  void shortenBorders() {
    bool goesOn = true;
    for (int round = 0; goesOn && round < kShortenings; ++round) {
      goesOn = false;
      for (std::uint32_t t = 0; t < regionOf_.size(); ++t) {
        std::uint32_t best = regionOf_[t];
        float most = sidesAt(t, best);
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t other = across_[3 * t + k], region = other == kNoTriangle ? best : regionOf_[other];
          if (region == best || glm::dot(smooth_[t], regions_[region].axis) < kGrowLimit) continue;
          const float length = sidesAt(t, region);
          if (length <= most) continue;
          most = length;
          best = region;
          goesOn = true;
        }
        regionOf_[t] = best;
      }
    }
    // Those that came last are furthest from the middle.
    std::vector<std::uint32_t> moved;
    for (std::uint32_t r = 0; r < regions_.size(); ++r) {
      std::erase_if(regions_[r].triangles, [&](std::uint32_t t) {
        if (regionOf_[t] == r) return false;
        moved.push_back(t);
        return true;
      });
    }
    for (const std::uint32_t t : moved) regions_[regionOf_[t]].triangles.push_back(t);
  }

  FlatTriangle flat(std::uint32_t t, const Frame& frame) const {
    return {frame(corner(t, 0)), frame(corner(t, 1)), frame(corner(t, 2))};
  }

  TriangleGrid gridFor(const std::vector<std::uint32_t>& triangles, const Frame& frame) const {
    Vec2 low(1e30f), high(-1e30f);
    for (const std::uint32_t t : triangles) {
      for (const Vec2& p : flat(t, frame)) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    return TriangleGrid(low, high, triangles.size(), kTouching);
  }

  void beginFlat() {
    pending_.swap(regions_);
    std::fill(regionOf_.begin(), regionOf_.end(), kNoRegion);
    groupOf_.assign(regionOf_.size(), kNoRegion);
    for (std::uint32_t group = 0; group < pending_.size(); ++group) {
      for (const std::uint32_t t : pending_[group].triangles) groupOf_[t] = group;
    }
  }

  // Splits every region until its projection overlaps nowhere and keeps its area. Whether all are.
  bool layFlat() {
    const std::size_t before = comparisons_;
    for (; group_ < pending_.size() && comparisons_ - before < kComparisonsAStep; ++group_) {
      // Triangles are in growth order, from the middle outwards; what is refused starts over.
      std::vector<std::uint32_t> rest = std::move(pending_[group_].triangles);
      while (!rest.empty() && !overBudget()) {
        growFlat(rest, group_, groupOf_);
        std::erase_if(rest, [&](std::uint32_t t) { return regionOf_[t] != kNoRegion; });
      }
      for (const std::uint32_t t : rest) {
        regions_.push_back({normals_[t], 0.0f, {}});
        take(t, static_cast<std::uint32_t>(regions_.size() - 1));
      }
    }
    return group_ == pending_.size();
  }

  void growFlat(const std::vector<std::uint32_t>& rest, std::uint32_t group, const std::vector<std::uint32_t>& groupOf) {
    Vec3 axis = meanNormal(rest);
    if (glm::dot(axis, normals_[rest[0]]) < kFlatLimit) axis = normals_[rest[0]];
    const Frame frame(axis);
    TriangleGrid grid = gridFor(rest, frame);
    const auto region = static_cast<std::uint32_t>(regions_.size());
    regions_.push_back({axis, 0.0f, {}});
    std::vector<std::uint32_t> queue{rest[0]};
    const std::size_t before = comparisons_;
    for (std::size_t i = 0; i < queue.size() && !overBudget(); ++i) {
      const std::uint32_t t = queue[i];
      if (regionOf_[t] != kNoRegion) continue;
      comparisons_ = before + grid.comparisons();
      if (glm::dot(normals_[t], axis) < kFlatLimit || !grid.tryAdd(flat(t, frame))) continue;
      take(t, region);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = across_[3 * t + k];
        if (other != kNoTriangle && groupOf[other] == group && regionOf_[other] == kNoRegion) queue.push_back(other);
      }
    }
  }

  bool overBudget() const { return comparisons_ > kComparisonsPerTriangle * (areas_.size() + 1000); }

  // Joins neighbours whose union lies flat, the longest common borders first, again while any are joined. Whether that is done.
  bool joinRegions() {
    const std::size_t before = comparisons_;
    while (comparisons_ - before < kComparisonsAStep) {
      if (border_ == borders_.size()) {
        if (!joined_ || overBudget()) return true;
        joined_ = false;
        borders_ = commonBorders();
        border_ = 0;
        continue;
      }
      const auto& [length, a, b] = borders_[border_++];
      if (regions_[a].triangles.empty() || regions_[b].triangles.empty()) continue;
      joined_ |= tryJoin(a, b);
    }
    return false;
  }

  struct Border { double length; std::uint32_t a, b; };

  std::vector<Border> commonBorders() const {
    std::vector<Border> borders;
    for (std::uint32_t t = 0; t < regionOf_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = across_[3 * t + k];
        if (other == kNoTriangle || regionOf_[t] >= regionOf_[other]) continue;
        borders.push_back({sideOf(t, k), regionOf_[t], regionOf_[other]});
      }
    }
    const auto byPair = [](const Border& x, const Border& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
    sortStably(borders.begin(), borders.end(), byPair);
    std::vector<Border> sums;
    for (const Border& border : borders) {
      if (!sums.empty() && sums.back().a == border.a && sums.back().b == border.b) sums.back().length += border.length;
      else sums.push_back(border);
    }
    sortStably(sums.begin(), sums.end(), [](const Border& x, const Border& y) { return x.length > y.length; });
    return sums;
  }

  bool tryJoin(std::uint32_t a, std::uint32_t b) {
    std::vector<std::uint32_t> both = regions_[a].triangles;
    both.insert(both.end(), regions_[b].triangles.begin(), regions_[b].triangles.end());
    const bool scrap = std::min(regions_[a].area, regions_[b].area) < kScrapArea * totalArea_;
    const float limit = scrap ? kScrapFlatLimit : kFlatLimit;
    const Vec3 axis = meanNormal(both);
    for (const std::uint32_t t : both) {
      if (glm::dot(normals_[t], axis) < limit) return false;
    }
    const Frame frame(axis);
    TriangleGrid grid = gridFor(both, frame);
    for (const std::uint32_t t : both) {
      const std::size_t before = grid.comparisons();
      const bool free = grid.tryAdd(flat(t, frame));
      comparisons_ += grid.comparisons() - before;
      if (!free || overBudget()) return false;
    }
    for (const std::uint32_t t : regions_[b].triangles) regionOf_[t] = a;
    regions_[a] = {axis, regions_[a].area + regions_[b].area, std::move(both)};
    regions_[b] = {};
    return true;
  }

  Charts result() const {
    Charts charts;
    charts.chartOf.resize(regionOf_.size());
    charts.corners.resize(indices_.size());
    for (const Region& region : regions_) {
      if (region.triangles.empty()) continue;
      const Frame frame(region.axis);
      for (const std::uint32_t t : region.triangles) {
        charts.chartOf[t] = charts.count;
        for (std::size_t k = 0; k < 3; ++k) charts.corners[3 * t + k] = frame(corner(t, k));
      }
      ++charts.count;
    }
    return charts;
  }

  enum class Stage { Measure, Grow, LayFlat, Join, Relax };

  const std::vector<Vec3>& positions_;
  const std::vector<std::uint32_t>& indices_;
  const Weld& weld_;
  Stage stage_ = Stage::Measure;
  int relaxations_ = -1;
  std::vector<Region> pending_;         // that are to be laid flat
  std::vector<std::uint32_t> groupOf_;  // of each triangle: its region among those
  std::uint32_t group_ = 0;
  std::vector<Border> borders_;
  std::size_t border_ = 0;
  bool joined_ = true;
  Charts charts_;
  std::optional<ChartRelaxation> relaxation_;
  std::vector<std::uint32_t> across_;
  std::vector<Vec3> normals_, smooth_;
  std::vector<float> areas_;
  double totalArea_ = 0.0;
  std::size_t comparisons_ = 0;
  std::vector<std::uint32_t> regionOf_;
  std::vector<Region> regions_;
};

ChartMaking::ChartMaking(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& indices, const Weld& weld)
    : maker_(std::make_unique<Maker>(positions, indices, weld)) {}
ChartMaking::~ChartMaking() = default;
bool ChartMaking::step() { return maker_->step(); }
Charts ChartMaking::take() { return maker_->take(); }

}  // namespace fur::geometry
