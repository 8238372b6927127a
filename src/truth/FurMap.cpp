#include "truth/FurMap.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/CoatThickness.h"

namespace fur::truth {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
// A node lies a few triangles from its root. A chart that is folded could be walked round for ever.
constexpr int kMostSteps = 64;
// A weight as small as this is rounding.
constexpr float kOnBorder = -1e-5f;

double crossOf(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

FurMap::FurMap(const geometry::Surface& surface, std::span<const Vec4> bends, float length, float tiles,
               dynamics::BendCurve curve)
    : surface_(surface), bends_(bends), length_(length), tiles_(tiles), curve_(curve) {
  FUR_ASSERT(bends.size() == surface.vertices.size(), "FurMap::FurMap()", "a bend for every vertex", bends.size());
  joinNeighbours();
}

// Two triangles of a chart meet where both position and fur coordinates of an edge are the same.
void FurMap::joinNeighbours() {
  const auto& vertices = surface_.vertices;
  const auto key = [&](std::uint32_t v) {
    const geometry::SurfaceVertex& x = vertices[v];
    return std::tuple(x.position.x, x.position.y, x.position.z, x.fur.x, x.fur.y);
  };
  std::vector<std::uint32_t> order(vertices.size()), welded(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    welded[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? welded[order[i - 1]] : order[i];

  struct Side {
    std::uint32_t low, high, slot;
  };
  std::vector<Side> sides;
  for (std::uint32_t slot = 0; slot < surface_.furIndices.size(); ++slot) {
    const std::uint32_t first = slot - slot % 3;
    const std::uint32_t a = welded[surface_.furIndices[first + (slot + 1) % 3]];
    const std::uint32_t b = welded[surface_.furIndices[first + (slot + 2) % 3]];
    sides.push_back({std::min(a, b), std::max(a, b), slot});
  }
  const auto pair = [](const Side& s) { return std::pair(s.low, s.high); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return std::pair(pair(a), a.slot) < std::pair(pair(b), b.slot); });
  across_.assign(surface_.furIndices.size(), kNone);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (pair(sides[i]) != pair(sides[i - 1])) continue;
    across_[sides[i].slot] = sides[i - 1].slot / 3;
    across_[sides[i - 1].slot] = sides[i].slot / 3;
  }
}

std::array<glm::dvec2, 3> FurMap::corners(std::uint32_t triangle) const {
  std::array<glm::dvec2, 3> out;
  for (int k = 0; k < 3; ++k) out[static_cast<std::size_t>(k)] = glm::dvec2(corner(triangle, k).fur) * static_cast<double>(tiles_);
  return out;
}

Vec3 FurMap::weightsAt(std::uint32_t triangle, const glm::dvec2& tile) const {
  const auto c = corners(triangle);
  const double area = crossOf(c[1] - c[0], c[2] - c[0]);
  if (area == 0) return {1, 0, 0};
  const double b = crossOf(tile - c[0], c[2] - c[0]) / area, g = crossOf(c[1] - c[0], tile - c[0]) / area;
  return {static_cast<float>(1 - b - g), static_cast<float>(b), static_cast<float>(g)};
}

ChartPoint FurMap::find(std::uint32_t from, const glm::dvec2& tile) const {
  ChartPoint spot{from, weightsAt(from, tile)};
  for (int step = 0; step < kMostSteps; ++step) {
    // Out by the side that lies farthest behind, if a neighbour is there.
    std::uint32_t next = kNone;
    float least = kOnBorder;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t neighbour = across_[3 * spot.triangle + static_cast<std::uint32_t>(k)];
      if (spot.weights[k] >= least || neighbour == kNone) continue;
      least = spot.weights[k];
      next = neighbour;
    }
    if (next == kNone) break;
    spot = {next, weightsAt(next, tile)};
  }
  return spot;
}

Vec3 FurMap::raised(std::uint32_t triangle, int k, float h) const {
  const geometry::SurfaceVertex& v = corner(triangle, k);
  const std::uint32_t index = surface_.furIndices[3 * triangle + static_cast<std::uint32_t>(k)];
  return dynamics::strandPoint(v.position, v.normal, Vec3(bends_[index]), geometry::coatThickness(v, length_), h, curve_);
}

Vec3 FurMap::point(const ChartPoint& spot, float h) const {
  Vec3 sum(0);
  for (int k = 0; k < 3; ++k) sum += spot.weights[k] * raised(spot.triangle, k, h);
  return sum;
}

Vec3 FurMap::normal(const ChartPoint& spot) const {
  Vec3 sum(0);
  for (int k = 0; k < 3; ++k) sum += spot.weights[k] * corner(spot.triangle, k).normal;
  return normalizeOr(sum, corner(spot.triangle, 0).normal);
}

Vec2 FurMap::strands(const ChartPoint& spot) const {
  Vec2 sum(0);
  for (int k = 0; k < 3; ++k) sum += spot.weights[k] * corner(spot.triangle, k).strands;
  return sum;
}

Vec2 FurMap::atlas(const ChartPoint& spot) const {
  Vec2 sum(0);
  for (int k = 0; k < 3; ++k) sum += spot.weights[k] * corner(spot.triangle, k).atlas;
  return sum;
}

glm::dvec2 FurMap::tileFromAtlas(std::uint32_t triangle, const Vec2& step) const {
  const auto c = corners(triangle);
  const glm::dvec2 a(corner(triangle, 0).atlas), u = glm::dvec2(corner(triangle, 1).atlas) - a, v = glm::dvec2(corner(triangle, 2).atlas) - a, way(step);
  const double area = crossOf(u, v);
  if (area == 0) return glm::dvec2(0);
  return (c[1] - c[0]) * (crossOf(way, v) / area) + (c[2] - c[0]) * (crossOf(u, way) / area);
}

glm::dvec2 FurMap::tileStep(const ChartPoint& spot, const Vec3& step) const {
  glm::dvec2 sum(0);
  for (int k = 0; k < 3; ++k) {
    const geometry::SurfaceVertex& v = corner(spot.triangle, k);
    sum += static_cast<double>(spot.weights[k]) * glm::dvec2(glm::dot(v.gradS, step), glm::dot(v.gradT, step));
  }
  return sum * static_cast<double>(tiles_);
}

float FurMap::unitsPerAtlas(std::uint32_t triangle) const {
  const Vec3 a = corner(triangle, 0).position;
  const float area = glm::length(glm::cross(corner(triangle, 1).position - a, corner(triangle, 2).position - a));
  const Vec2 origin = corner(triangle, 0).atlas;
  const auto inAtlas = static_cast<float>(std::abs(crossOf(corner(triangle, 1).atlas - origin, corner(triangle, 2).atlas - origin)));
  return inAtlas > 0 ? std::sqrt(area / inAtlas) : 0.0f;
}

float FurMap::scale(const ChartPoint& spot, float h) const {
  const Vec3 a = raised(spot.triangle, 0, h);
  const float area = glm::length(glm::cross(raised(spot.triangle, 1, h) - a, raised(spot.triangle, 2, h) - a));
  const auto c = corners(spot.triangle);
  const auto tileArea = static_cast<float>(std::abs(crossOf(c[1] - c[0], c[2] - c[0])));
  return tileArea > 0 ? std::sqrt(area / tileArea) : 0.0f;
}

}  // namespace fur::truth
