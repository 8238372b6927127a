#include "hair/BaseTangents.h"

#include <algorithm>

#include "hair/CellCorners.h"
#include "hair/PlantGuides.h"

namespace fur::hair {

namespace {

// The mean way of the wisps that grow about a place, on a coarse grid; long ones count for more, as short ones hardly leave the skin.
class Ways {
 public:
  explicit Ways(std::span<const Wisp> wisps) {
    Vec3 low = wisps[0].root, high = low;
    for (const Wisp& wisp : wisps) low = glm::min(low, wisp.root), high = glm::max(high, wisp.root);
    const Vec3 span = high - low;
    cell_ = std::max(std::max({span.x, span.y, span.z}) / (kSide - 3), 1e-4f);
    low_ = low - cell_;
    ways_.assign(kCells.all(), Vec3(0));
  }
  void add(const Vec3& at, const Vec3& way) {
    forCorners(kCells, (at - low_) / cell_, [&](std::size_t c, float weight) { ways_[c] += weight * way; });
  }
  Vec3 at(const Vec3& place) const {
    Vec3 sum(0);
    forCorners(kCells, (place - low_) / cell_, [&](std::size_t c, float weight) { sum += weight * ways_[c]; });
    return sum;
  }

 private:
  static constexpr int kSide = 24;
  static constexpr CellCounts kCells{kSide, kSide, kSide};

  float cell_ = 1;
  Vec3 low_{0};
  std::vector<Vec3> ways_;
};

std::uint8_t signedByte(float x) { return static_cast<std::uint8_t>(127.5f + 127.5f * glm::clamp(x, -1.0f, 1.0f) + 0.5f); }

}  // namespace

std::vector<std::array<std::uint8_t, 4>> baseTangents(const ScalpSurface& scalp, std::span<const Wisp> wisps, std::span<const GuideNode> nodes,
                                                      int nodesEach, const HairValues& values) {
  constexpr float kBase = 0.25f;  // up to this height
  const auto& vertices = scalp.surface.vertices;
  std::vector<std::array<std::uint8_t, 4>> out(vertices.size(), {128, 128, 128, 0});
  if (wisps.empty()) return out;
  Ways ways(wisps);
  for (const Wisp& wisp : wisps)
    ways.add(wisp.root, wispPoint(wisp, nodes, nodesEach, shapeOf(values), kBase).position - wisp.root);
  for (std::size_t v = 0; v < out.size(); ++v) {
    const float density = scalp.scalp.at(vertices[v].atlas).x;
    if (density <= 0) continue;
    const Vec3 &normal = vertices[v].normal, x = evenTangent(normal), way = normalizeOr(ways.at(vertices[v].position), normal);
    const Vec3 flat = way - normal * glm::dot(way, normal), along = normalizeOr(flat, x);
    out[v] = {signedByte(glm::dot(along, x)), signedByte(glm::dot(along, glm::cross(normal, x))), signedByte(glm::length(flat)),
              static_cast<std::uint8_t>(255 * saturate(density) + 0.5f)};
  }
  return out;
}

}  // namespace fur::hair
