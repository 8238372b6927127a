#include "scene/StrandTracing.h"

#include <algorithm>
#include <limits>

#include "furgen/Coat.h"
#include "scene/import/CornerMesh.h"

namespace fur::scene {

namespace {

// Texels of a cut may be this far apart: another strand may cover what lies between them.
constexpr int kBridge = 2;
// A strand finer than a texel may be missing from a layer; not from two.
constexpr int kMaxStep = 2;
constexpr std::uint32_t kNone = 0xffffffffu;

struct Link {
  int layer;
  int values;                    // variance and dominance
  std::uint32_t parent = kNone;  // the cut below it
  Vec2 path{0.0f};               // from the strand's first cut
  // The nearest of those that go on from it, and the way to it.
  std::uint32_t child = kNone;
  Vec2 above{0.0f};
  int stepAbove = 0;             // layers; 0: there is none
};

class Tracer {
 public:
  explicit Tracer(const MapStack& maps) : maps_(maps) {
    trace_.cutOf.assign(maps.coverage.size(), 0);
  }

  StrandTrace run() {
    for (int layer = 0; layer < maps_.layers; ++layer) {
      const std::size_t firstCut = trace_.cuts.size();
      labelLayer(layer);
      for (std::size_t cut = firstCut; cut < trace_.cuts.size(); ++cut) link(static_cast<std::uint32_t>(cut));
      takeTips(layer);
    }
    finish();
    return std::move(trace_);
  }

 private:
  std::size_t texelAt(int layer, int x, int y) const {
    const int column = x & (maps_.width - 1), row = y & (maps_.height - 1);
    return (static_cast<std::size_t>(layer) * maps_.height + row) * maps_.width + column;
  }
  int valuesAt(std::size_t texel) const { return maps_.variance[texel] * 256 + maps_.dominance[texel]; }

  void labelLayer(int layer) {
    for (int y = 0; y < maps_.height; ++y)
      for (int x = 0; x < maps_.width; ++x) {
        const std::size_t texel = texelAt(layer, x, y);
        if (maps_.coverage[texel] && !trace_.cutOf[texel]) addCut(layer, x, y);
      }
  }

  // The cut that holds the texel, by flooding.
  void addCut(int layer, int startX, int startY) {
    const auto label = static_cast<std::uint32_t>(trace_.cuts.size() + 1);
    const int values = valuesAt(texelAt(layer, startX, startY));
    flood_.assign(1, {startX, startY});
    trace_.cutOf[texelAt(layer, startX, startY)] = label;
    Vec2 sum(0.0f);
    float weight = 0.0f;
    while (!flood_.empty()) {
      const IVec2 at = flood_.back();
      flood_.pop_back();
      const float cover = maps_.coverage[texelAt(layer, at.x, at.y)];
      sum += (Vec2(at - IVec2(startX, startY))) * cover;
      weight += cover;
      for (int dy = -kBridge; dy <= kBridge; ++dy)
        for (int dx = -kBridge; dx <= kBridge; ++dx) {
          const std::size_t texel = texelAt(layer, at.x + dx, at.y + dy);
          if (!maps_.coverage[texel] || trace_.cutOf[texel] || valuesAt(texel) != values) continue;
          trace_.cutOf[texel] = label;
          flood_.push_back({at.x + dx, at.y + dy});
        }
    }
    StrandCut cut;
    cut.axis = Vec2(startX, startY) + 0.5f + sum / weight;
    const Vec2 extent(static_cast<float>(maps_.width), static_cast<float>(maps_.height));
    cut.axis -= extent * glm::floor(cut.axis / extent);
    trace_.cuts.push_back(cut);
    links_.push_back({layer, values});
  }

  int rowOf(std::uint32_t cut) const { return static_cast<int>(trace_.cuts[cut].axis.y); }
  Vec2 way(const StrandCut& from, const StrandCut& to) const {
    return {furgen::torusDelta(to.axis.x, from.axis.x, static_cast<float>(maps_.width)),
            furgen::torusDelta(to.axis.y, from.axis.y, static_cast<float>(maps_.height))};
  }

  // Finds the cut that this one goes on from, among the tips of the layers below.
  void link(std::uint32_t cut) {
    const Link& self = links_[cut];
    const float x = trace_.cuts[cut].axis.x;
    const int row = rowOf(cut), window = static_cast<int>(maps_.reach * kMaxStep) + 1;
    float nearest = std::numeric_limits<float>::max();
    std::uint32_t parent = kNone;
    for (int turn = -1; turn <= 1; ++turn) {
      const int low = row - window + turn * maps_.height;
      const auto before = [&](std::uint32_t tip, int bound) {
        return links_[tip].values != self.values ? links_[tip].values < self.values : rowOf(tip) < bound;
      };
      auto tip = std::lower_bound(tips_.begin(), tips_.end(), low, before);
      for (; tip != tips_.end() && links_[*tip].values == self.values && rowOf(*tip) <= low + 2 * window; ++tip) {
        const int step = self.layer - links_[*tip].layer;
        const float reach = maps_.reach * static_cast<float>(step);
        const float across = std::abs(trace_.cuts[*tip].axis.x - x);
        if (std::min(across, static_cast<float>(maps_.width) - across) > reach) continue;
        const float distance = glm::length(way(trace_.cuts[*tip], trace_.cuts[cut]));
        if (distance > reach) continue;
        const float cost = distance + maps_.reach * static_cast<float>(step - 1);
        if (cost < nearest) nearest = cost, parent = *tip;
      }
    }
    join(cut, parent);
  }

  void join(std::uint32_t cut, std::uint32_t parent) {
    Link& self = links_[cut];
    self.parent = parent;
    if (parent == kNone) {
      trace_.cuts[cut].strand = static_cast<std::uint32_t>(++trace_.strandCount);
      firstCuts_.push_back(cut);
      return;
    }
    Link& below = links_[parent];
    const Vec2 step = way(trace_.cuts[parent], trace_.cuts[cut]);
    self.path = below.path + step;
    trace_.cuts[cut].strand = trace_.cuts[parent].strand;
    if (below.stepAbove == 0 || glm::length(step) < glm::length(below.above)) {
      below.child = cut;
      below.above = step;
      below.stepAbove = self.layer - below.layer;
    }
  }

  // The cuts that the next layer may go on from, sorted for link(): this layer's, and those below that
  // nothing in it goes on from.
  void takeTips(int layer) {
    std::size_t first = trace_.cuts.size();
    while (first > 0 && links_[first - 1].layer > layer - kMaxStep) --first;
    tips_.clear();
    for (std::size_t cut = first; cut < trace_.cuts.size(); ++cut)
      if (links_[cut].stepAbove == 0) tips_.push_back(static_cast<std::uint32_t>(cut));
    std::vector<Corner> keys;
    for (const std::uint32_t cut : tips_)
      keys.push_back({static_cast<std::uint32_t>(rowOf(cut)), static_cast<std::uint32_t>(links_[cut].values), 0});
    const std::vector<std::uint32_t> found = tips_;
    const std::vector<std::uint32_t> order = sortedCorners(keys, {static_cast<std::uint32_t>(maps_.height), 0xffff, 0});
    for (std::size_t i = 0; i < order.size(); ++i) tips_[i] = found[order[i]];
  }

  void finish() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Link& self = links_[i];
      Vec2 way = self.above;
      float rise = heightOf(self.layer + self.stepAbove) - heightOf(self.layer);
      if (self.parent != kNone) {
        way += self.path - links_[self.parent].path;
        rise += heightOf(self.layer) - heightOf(links_[self.parent].layer);
      }
      if (rise > 0.0f) trace_.cuts[i].slope = way / rise;
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      StrandCut& cut = trace_.cuts[i];
      cut.shift = links_[i].path + rootToFirst(firstCuts_[cut.strand - 1]);
    }
  }

  // From the root to a strand's first cut.
  Vec2 rootToFirst(std::uint32_t first) const {
    const Link& self = links_[first];
    if (self.layer > 0) return Vec2(0.0f);
    const Vec2 slope = trace_.cuts[first].slope;
    // Newton's form of the parabola at height 0; the second cut's slope is that from the first to the third.
    const Vec2 start = self.stepAbove == 1 ? 3.0f * slope - 2.0f * trace_.cuts[self.child].slope : slope;
    return start * maps_.lowest;
  }

  float heightOf(int layer) const { return layer == 0 ? maps_.lowest : static_cast<float>(layer + 1); }

  const MapStack& maps_;
  StrandTrace trace_;
  std::vector<Link> links_;  // one a cut
  std::vector<std::uint32_t> tips_, firstCuts_;
  std::vector<IVec2> flood_;
};

}  // namespace

StrandTrace traceStrands(const MapStack& maps) { return Tracer(maps).run(); }

}  // namespace fur::scene
