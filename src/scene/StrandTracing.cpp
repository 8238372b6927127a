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
// Tips are searched by strips of so many columns: about the reach, so that two or three strips hold all that count.
constexpr int kStrip = 32;
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

// A cut that the next layer may go on from, by where it is looked for.
struct Tip {
  int values, strip, row;
  std::uint32_t cut;
  bool operator<(const Tip& other) const {
    return values != other.values ? values < other.values : strip != other.strip ? strip < other.strip : row < other.row;
  }
};

struct Nearest {
  float within;  // texels: what is farther away is none
  float cost = std::numeric_limits<float>::max();
  std::uint32_t parent = kNone;
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

  Tip keyOf(std::uint32_t cut) const {
    const Vec2 axis = trace_.cuts[cut].axis;
    return {links_[cut].values, static_cast<int>(axis.x) / kStrip, static_cast<int>(axis.y), cut};
  }
  Vec2 way(const StrandCut& from, const StrandCut& to) const {
    return {furgen::torusDelta(to.axis.x, from.axis.x, static_cast<float>(maps_.width)),
            furgen::torusDelta(to.axis.y, from.axis.y, static_cast<float>(maps_.height))};
  }

  // Finds the cut that this one goes on from, among the tips of the layers below.
  void link(std::uint32_t cut) {
    const Tip key = keyOf(cut);
    const auto at = [&](int values) { return std::lower_bound(tips_.begin(), tips_.end(), Tip{values, 0, 0, 0}) - tips_.begin(); };
    const std::ptrdiff_t first = at(key.values), last = at(key.values + 1);
    const std::span<const Tip> same(tips_.data() + first, static_cast<std::size_t>(last - first));
    Nearest nearest{maps_.reach * kMaxStep};
    const int strips = same.empty() ? 0 : std::max(1, maps_.width / kStrip);
    // Its own strip, then those on either side of it.
    for (int k = 0; k < strips; ++k) {
      const int strip = (key.strip + (k % 2 ? k / 2 + 1 : strips - k / 2)) % strips;
      const float middle = (static_cast<float>(strip) + 0.5f) * kStrip, x = trace_.cuts[cut].axis.x;
      const float across = std::abs(furgen::torusDelta(middle, x, static_cast<float>(maps_.width))) - 0.5f * kStrip;
      if (strips == 1 || across <= nearest.within) searchStrip(same, strip, cut, nearest);
    }
    join(cut, nearest.parent);
  }

  // From the cut's own row up and down at once, so that it ends at the rows beyond which no tip is nearer.
  void searchStrip(std::span<const Tip> same, int strip, std::uint32_t cut, Nearest& nearest) {
    const Tip key = keyOf(cut);
    const auto from = [&](int inStrip, int row) {
      return static_cast<std::size_t>(std::lower_bound(same.begin(), same.end(), Tip{key.values, inStrip, row, 0}) - same.begin());
    };
    const std::size_t first = from(strip, 0), last = from(strip + 1, 0);
    std::size_t up = from(strip, key.row), down = up;
    for (std::size_t left = last - first; left > 0; --left) {
      const std::size_t above = up == last ? first : up, below = (down == first ? last : down) - 1;
      const int rise = (same[above].row - key.row) & (maps_.height - 1), fall = (key.row - same[below].row) & (maps_.height - 1);
      if (static_cast<float>(std::min(rise, fall) - 1) > nearest.within) return;
      weigh(cut, same[rise < fall ? above : below].cut, nearest);
      if (rise < fall) up = above + 1;
      else down = below;
    }
  }

  void weigh(std::uint32_t cut, std::uint32_t tip, Nearest& nearest) {
    ++trace_.tipsWeighed;
    const auto steps = static_cast<float>(links_[cut].layer - links_[tip].layer);
    const float distance = glm::length(way(trace_.cuts[tip], trace_.cuts[cut]));
    if (distance > maps_.reach * steps) return;
    const float cost = distance + maps_.reach * (steps - 1.0f);
    if (cost > nearest.cost || (cost == nearest.cost && tip > nearest.parent)) return;
    nearest = {std::min(nearest.within, cost), cost, tip};
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
    std::vector<Tip> found;
    std::vector<Corner> keys;
    for (std::size_t cut = first; cut < trace_.cuts.size(); ++cut) {
      if (links_[cut].stepAbove != 0) continue;
      const Tip tip = found.emplace_back(keyOf(static_cast<std::uint32_t>(cut)));
      keys.push_back({static_cast<std::uint32_t>(tip.row), static_cast<std::uint32_t>(tip.strip), static_cast<std::uint32_t>(tip.values)});
    }
    const auto limit = [](int side) { return static_cast<std::uint32_t>(side); };
    tips_.clear();
    for (const std::uint32_t i : sortedCorners(keys, {limit(maps_.height), limit(maps_.width), 0xffff})) tips_.push_back(found[i]);
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
  std::vector<Tip> tips_;    // sorted
  std::vector<std::uint32_t> firstCuts_;
  std::vector<IVec2> flood_;
};

}  // namespace

StrandTrace traceStrands(const MapStack& maps) { return Tracer(maps).run(); }

}  // namespace fur::scene
