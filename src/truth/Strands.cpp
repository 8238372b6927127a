#include "truth/Strands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "truth/Parallel.h"
#include "truth/Truth.h"

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

void placeStrand(const FurMap& map, const furgen::Coat& coat, const Root& root, float tolerance,
                 std::vector<TubeNode>& scratch, Tubes& out) {
  const furgen::Strand& strand = coat.strands[root.strand];
  const auto size = static_cast<double>(coat.parameters.size);
  scratch.clear();
  ChartPoint spot = root.spot;
  for (const furgen::Node& node : coat.nodesOf(strand)) {
    spot = map.find(spot.triangle, root.tile + glm::dvec2(node.shift) / size);
    const float radius = node.radius / static_cast<float>(size) * map.scale(spot, node.height);
    scratch.push_back({map.point(spot, node.height), radius, map.normal(spot), node.height});
  }
  const auto first = static_cast<std::uint32_t>(out.nodes.size());
  appendSimplified(scratch, tolerance, out.nodes);
  out.tubes.push_back({first, static_cast<std::uint32_t>(out.nodes.size()) - first, strand.variance});
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
        if (number >= shown.x && number < shown.y) out.push_back({*it, tile, spot});
      }
    }
  }
}

Tubes placeStrands(const FurMap& map, const furgen::Coat& coat, float tolerance) {
  const RootFinder finder(map, coat);
  const std::size_t pieces = (map.triangleCount() + kTrianglesAPiece - 1) / kTrianglesAPiece;
  std::vector<Tubes> parts(pieces);
  inParallel(pieces, [&](std::size_t piece) {
    std::vector<Root> roots;
    const std::size_t end = std::min<std::size_t>((piece + 1) * kTrianglesAPiece, map.triangleCount());
    for (std::size_t t = piece * kTrianglesAPiece; t < end; ++t) finder.find(static_cast<std::uint32_t>(t), roots);
    std::vector<TubeNode> scratch;
    for (const Root& root : roots) placeStrand(map, coat, root, tolerance, scratch, parts[piece]);
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
