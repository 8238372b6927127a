#include "truth/Strands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "truth/Parallel.h"
#include "truth/Truth.h"
#include "truth/Wetting.h"

namespace fur::truth {

namespace {

// Light changes along a straight strand too: no piece is longer than this part of the coat's height.
constexpr float kLongestPiece = 0.13f;
constexpr std::size_t kTrianglesAPiece = 256;

// Which side of the line through a and b, the same number with the other sign for b and a: neighbours agree.
double sideOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
  const bool turned = std::pair(b.x, b.y) < std::pair(a.x, a.y);
  const glm::dvec2 &from = turned ? b : a, &to = turned ? a : b;
  const double side = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
  // A point on the line itself counts as left of it, seen from the lower end.
  return (turned ? -1 : 1) * (side == 0 ? 1e-300 : side);
}

bool isInside(const std::array<glm::dvec2, 3>& c, const glm::dvec2& p) {
  const bool left = sideOf(c[0], c[1], p) > 0;
  return (sideOf(c[1], c[2], p) > 0) == left && (sideOf(c[2], c[0], p) > 0) == left;
}

bool isStraight(std::span<const TubeNode> nodes, float tolerance) {
  const TubeNode &a = nodes.front(), &b = nodes.back();
  if (std::abs(a.height - b.height) > kLongestPiece) return false;
  const Vec3 way = b.position - a.position;
  const float squared = std::max(glm::dot(way, way), 1e-20f);
  for (const TubeNode& n : nodes.subspan(1, nodes.size() - 2)) {
    const float t = glm::dot(n.position - a.position, way) / squared;
    if (t <= 0 || t >= 1 || glm::length(a.position + way * t - n.position) > tolerance) return false;
    if (std::abs(glm::mix(a.radius, b.radius, t) - n.radius) > tolerance) return false;
  }
  return true;
}

void appendSimplified(std::span<const TubeNode> nodes, float tolerance, std::vector<TubeNode>& out) {
  std::size_t from = 0;
  out.push_back(nodes[0]);
  for (std::size_t to = 2; to <= nodes.size(); ++to) {
    if (to < nodes.size() && isStraight(nodes.subspan(from, to - from + 1), tolerance)) continue;
    from = to - 1;
    out.push_back(nodes[from]);
  }
}

// Pieces of a wet strand between two nodes of a dry one. Water draws its foot aside more in a layer than a dry one bends in all.
constexpr int kWetPieces = 4;
// Where a strand stands lower than a dry one as long, its tip is beyond the height at which the dry one ends, up to so far.
constexpr float kHighestTip = 3, kBeyondTip = 1.0f / 32;

void placeDry(const FurMap& map, const furgen::Coat& coat, const Root& root, std::vector<TubeNode>& out) {
  const auto size = static_cast<double>(coat.parameters.size);
  ChartPoint spot = root.spot;
  for (const furgen::Node& node : coat.nodesOf(coat.strands[root.strand])) {
    spot = map.find(spot.triangle, root.tile + glm::dvec2(node.shift) / size);
    const float radius = node.radius / static_cast<float>(size) * map.scale(spot, node.height);
    out.push_back({map.point(spot, node.height), radius, map.normal(spot), node.height});
  }
}

// A walk along the curve on which a wet strand lies, from its root on.
class WetCurve {
 public:
  WetCurve(const FurMap& map, const Wetting& wetting, const Wetting::Strand& wet) : map_(map), wetting_(wetting), wet_(wet) {}

  void begin(const Root& root, const furgen::Node& foot, double size) {
    spot_ = root.spot;
    size_ = size;
    dry_ = foot;
    here_ = there_ = at(foot);
  }
  // Goes on until it has come `length` from the root; the nodes of the dry strand lead it.
  TubeNode walkTo(float length, std::span<const furgen::Node> nodes) {
    while (come_ + piece_ < length && advance(nodes)) {}
    const float t = piece_ > 0 ? saturate((length - come_) / piece_) : 0.0f;
    return {glm::mix(here_.position, there_.position, t), 0, normalizeOr(glm::mix(here_.normal, there_.normal, t), here_.normal), 0};
  }

 private:
  TubeNode at(const furgen::Node& dry) {
    const glm::dvec2 tile = wetting_.tileAt(wet_, wet_.root + glm::dvec2(dry.shift) / size_, dry.height);
    spot_ = map_.find(spot_.triangle, tile);
    return {map_.point(spot_, wetting_.heightAt(wet_, dry.height)), 0, map_.normal(spot_), 0};
  }
  // One piece on; false at the end.
  bool advance(std::span<const furgen::Node> nodes) {
    furgen::Node next = dry_;
    if (step_ / kWetPieces + 1 < nodes.size()) {
      const furgen::Node &a = nodes[step_ / kWetPieces], &b = nodes[step_ / kWetPieces + 1];
      const float t = static_cast<float>(step_ % kWetPieces + 1) / kWetPieces;
      next = {glm::mix(a.shift, b.shift, t), glm::mix(a.height, b.height, t), 0};
    } else if (dry_.height < kHighestTip) {
      next.height += kBeyondTip;
    } else {
      return false;
    }
    ++step_;
    dry_ = next;
    come_ += piece_;
    here_ = there_;
    there_ = at(next);
    piece_ = glm::distance(here_.position, there_.position);
    return true;
  }

  const FurMap& map_;
  const Wetting& wetting_;
  const Wetting::Strand& wet_;
  ChartPoint spot_;
  furgen::Node dry_{};
  TubeNode here_{}, there_{};
  double size_ = 1;
  std::size_t step_ = 0;
  float come_ = 0, piece_ = 0;
};

// `nodes` of a dry strand to where they are when it is wet: each as far along the strand as before, so that it keeps its length.
void wetten(const FurMap& map, const Wetting& wetting, const Wetting::Strand& wet, const furgen::Coat& coat, const Root& root,
            std::vector<TubeNode>& nodes) {
  const auto dry = coat.nodesOf(coat.strands[root.strand]);
  WetCurve curve(map, wetting, wet);
  curve.begin(root, dry[0], static_cast<double>(coat.parameters.size));
  std::vector<TubeNode> out;
  float length = 0;
  for (std::size_t k = 0; k + 1 < nodes.size() || k == 0; ++k) {
    const TubeNode &a = nodes[k], &b = nodes[std::min(k + 1, nodes.size() - 1)];
    const float piece = glm::distance(a.position, b.position);
    for (int i = k == 0 ? 0 : 1; i <= kWetPieces; ++i) {
      const float t = static_cast<float>(i) / kWetPieces;
      TubeNode node = curve.walkTo((length + t * piece) / wet.shorter, dry);
      node.radius = glm::mix(a.radius, b.radius, t);
      node.height = glm::mix(a.height, b.height, t);
      const Vec3& p = node.position;
      if (!std::isfinite(p.x + p.y + p.z)) return;  // a mask that makes no sense
      out.push_back(node);
    }
    length += piece;
  }
  nodes = std::move(out);
}

void placeStrand(const FurMap& map, const furgen::Coat& coat, const Root& root, float tolerance, const Wetting* wetting,
                 std::vector<TubeNode>& scratch, Tubes& out) {
  scratch.clear();
  placeDry(map, coat, root, scratch);
  const auto wet = wetting ? wetting->at(root) : std::nullopt;
  if (wet) wetten(map, *wetting, *wet, coat, root, scratch);
  const auto first = static_cast<std::uint32_t>(out.nodes.size());
  appendSimplified(scratch, tolerance, out.nodes);
  out.tubes.push_back({first, static_cast<std::uint32_t>(out.nodes.size()) - first, coat.strands[root.strand].variance, 0, wet ? wet->water : Wetness{}});
}

}  // namespace

void Tubes::append(const Tubes& others) {
  const auto first = static_cast<std::uint32_t>(nodes.size());
  for (Tube tube : others.tubes) {
    tube.firstNode += first;
    tubes.push_back(tube);
  }
  nodes.insert(nodes.end(), others.nodes.begin(), others.nodes.end());
}

RootFinder::RootFinder(const FurMap& map, const furgen::Coat& coat) : map_(map), coat_(coat), byRow_(coat.strands.size()) {
  std::iota(byRow_.begin(), byRow_.end(), 0u);
  std::sort(byRow_.begin(), byRow_.end(), [&](auto a, auto b) { return coat.strands[a].root.y < coat.strands[b].root.y; });
}

void RootFinder::find(std::uint32_t triangle, std::vector<Root>& out) const {
  const auto c = map_.corners(triangle);
  const glm::dvec2 low = glm::min(glm::min(c[0], c[1]), c[2]), high = glm::max(glm::max(c[0], c[1]), c[2]);
  const auto size = static_cast<double>(coat_.parameters.size);
  for (double row = std::floor(low.y); row <= high.y; ++row) {
    const auto below = [&](std::uint32_t strand, double y) { return coat_.strands[strand].root.y < y; };
    const auto begin = std::lower_bound(byRow_.begin(), byRow_.end(), (low.y - row) * size - 1, below);
    for (auto it = begin; it != byRow_.end(); ++it) {
      const furgen::Strand& strand = coat_.strands[*it];
      const glm::dvec2 root = glm::dvec2(strand.root) / size;
      if (root.y + row > high.y) break;
      for (double column = std::ceil(low.x - root.x); column + root.x <= high.x; ++column) {
        const glm::dvec2 tile(root.x + column, root.y + row);
        if (!isInside(c, tile)) continue;
        const ChartPoint spot = map_.find(triangle, tile);
        const Vec2 shown = map_.strands(spot);
        const float number = strandNumber(strand);
        if (number >= shown.x && number < shown.y) out.push_back({*it, tile, spot, number});
      }
    }
  }
}

Tubes placeStrands(const FurMap& map, const furgen::Coat& coat, float tolerance, const Wetting* wetting) {
  const RootFinder finder(map, coat);
  const std::size_t pieces = (map.triangleCount() + kTrianglesAPiece - 1) / kTrianglesAPiece;
  std::vector<Tubes> parts(pieces);
  inParallel(pieces, [&](std::size_t piece) {
    std::vector<Root> roots;
    const std::size_t end = std::min<std::size_t>((piece + 1) * kTrianglesAPiece, map.triangleCount());
    for (std::size_t t = piece * kTrianglesAPiece; t < end; ++t) finder.find(static_cast<std::uint32_t>(t), roots);
    std::vector<TubeNode> scratch;
    for (const Root& root : roots) placeStrand(map, coat, root, tolerance, wetting, scratch, parts[piece]);
  });
  Tubes all;
  for (Tubes& part : parts) {
    all.append(part);
    part = {};
  }
  return all;
}

float densestSection(const furgen::Coat& coat) {
  float densest = 0;
  for (int plane = 0; plane < furgen::kPlanes; ++plane) {
    const float height = (static_cast<float>(plane) + 0.5f) / furgen::kPlanes;
    float area = 0;
    for (const furgen::Strand& strand : coat.strands) {
      const auto nodes = coat.nodesOf(strand);
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        const furgen::Node &a = nodes[i - 1], &b = nodes[i];
        if ((a.height > height) == (b.height > height)) continue;
        const float radius = glm::mix(a.radius, b.radius, (height - a.height) / (b.height - a.height));
        area += kPi * radius * radius;
      }
    }
    densest = std::max(densest, area);
  }
  return std::min(densest / (static_cast<float>(coat.parameters.size) * static_cast<float>(coat.parameters.size)), 1.0f);
}

}  // namespace fur::truth
