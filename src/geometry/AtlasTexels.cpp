#include "geometry/AtlasTexels.h"

#include <algorithm>
#include <cmath>

#include "geometry/Adjacency.h"

namespace fur::geometry {

namespace {

float cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

const Vec2& atlasOf(const Surface& surface, std::uint32_t triangle, std::size_t k) {
  return surface.vertices[surface.indices[std::size_t{3} * triangle + k]].atlas;
}

int clamped(float x, int size) { return static_cast<int>(glm::clamp(x, 0.0f, static_cast<float>(size))); }

}  // namespace

void TexelRect::include(int x, int y) { *this = unite(*this, {x, y, x + 1, y + 1}); }

TexelRect unite(const TexelRect& a, const TexelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

AtlasTriangle::AtlasTriangle(const Vec2& a, const Vec2& b, const Vec2& c, int mapSize) : size(mapSize) {
  const auto scale = static_cast<float>(mapSize);
  p[0] = a * scale - 0.5f, p[1] = b * scale - 0.5f, p[2] = c * scale - 0.5f;
  area = cross2(p[1] - p[0], p[2] - p[0]);
  if (area < 0.0f) std::swap(p[1], p[2]), area = -area;
}

TexelRect AtlasTriangle::bounds(float margin) const {
  const Vec2 low = glm::min(p[0], glm::min(p[1], p[2])) - margin, high = glm::max(p[0], glm::max(p[1], p[2])) + margin;
  return {clamped(std::ceil(low.x), size), clamped(std::ceil(low.y), size), clamped(std::floor(high.x) + 1.0f, size),
          clamped(std::floor(high.y) + 1.0f, size)};
}

// Separating axes: the box's by bounds(), the triangle's sides here.
bool AtlasTriangle::meets(int x, int y, float margin) const {
  const Vec2 at(static_cast<float>(x), static_cast<float>(y));
  if (!(area > 0.0f)) return false;
  for (int k = 0; k < 3; ++k) {
    const Vec2 side = p[(k + 1) % 3] - p[k];
    if (cross2(side, at - p[k]) + margin * (std::abs(side.x) + std::abs(side.y)) < 0.0f) return false;
  }
  return true;
}

AtlasTexels::AtlasTexels(const Surface& surface, int size, std::span<const std::uint8_t> without)
    : size_(size), triangleOf_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), kNoTriangle) {
  rasterise(surface);
  growGutter();
  if (!without.empty()) leaveOut(without);
}

AtlasTriangle AtlasTexels::flatten(const Surface& surface, std::uint32_t t) const {
  return {atlasOf(surface, t, 0), atlasOf(surface, t, 1), atlasOf(surface, t, 2), size_};
}

void AtlasTexels::rasterise(const Surface& surface) {
  const auto count = static_cast<std::uint32_t>(surface.triangleCount());
  for (std::uint32_t t = 0; t < count; ++t) {
    const AtlasTriangle flat = flatten(surface, t);
    const TexelRect box = flat.bounds(0.0f);
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x)
        if (flat.meets(x, y, 0.0f)) triangleOf_[static_cast<std::size_t>(y) * size_ + x] = t;
  }
  // Triangles too fine to hold a texel's centre.
  const auto last = static_cast<float>(size_ - 1);
  for (std::uint32_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 at = glm::clamp(atlasOf(surface, t, k) * static_cast<float>(size_), Vec2(0.0f), Vec2(last));
      std::uint32_t& owner = triangleOf_[static_cast<std::size_t>(at.y) * size_ + static_cast<std::size_t>(at.x)];
      if (owner == kNoTriangle) owner = t;
    }
}

void AtlasTexels::growGutter() {
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> source(triangleOf_.size(), kNone);
  for (std::uint32_t i = 0; i < source.size(); ++i)
    if (triangleOf_[i] != kNoTriangle) source[i] = i;
  // Straight neighbours first: they are nearer.
  constexpr int kSteps[8][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  for (int ring = 0; ring < kGutter; ++ring) {
    const std::vector<std::uint32_t> before = source;
    for (int y = 0; y < size_; ++y)
      for (int x = 0; x < size_; ++x) {
        const auto texel = static_cast<std::uint32_t>(y * size_ + x);
        for (int k = 0; k < 8 && source[texel] == kNone; ++k) {
          const int nx = x + kSteps[k][0], ny = y + kSteps[k][1];
          if (nx < 0 || ny < 0 || nx >= size_ || ny >= size_) continue;
          source[texel] = before[static_cast<std::size_t>(ny) * size_ + nx];
        }
      }
  }
  for (std::uint32_t i = 0; i < source.size(); ++i)
    if (triangleOf_[i] == kNoTriangle && source[i] != kNone) gutter_.emplace_back(i, source[i]);
}

// Others do not grow into where they were: what lies there in other maps is theirs.
void AtlasTexels::leaveOut(std::span<const std::uint8_t> without) {
  std::erase_if(gutter_, [&](const auto& pair) { return without[triangleOf_[pair.second]] != 0; });
  for (std::uint32_t& triangle : triangleOf_)
    if (triangle != kNoTriangle && without[triangle]) triangle = kNoTriangle;
}

Vec3 AtlasTexels::weightsAt(const Surface& surface, std::uint32_t t, std::uint32_t texel) const {
  const Vec2 at((static_cast<float>(texel % static_cast<std::uint32_t>(size_)) + 0.5f) / static_cast<float>(size_),
                (static_cast<float>(texel / static_cast<std::uint32_t>(size_)) + 0.5f) / static_cast<float>(size_));
  const Vec2 a = atlasOf(surface, t, 0), ab = atlasOf(surface, t, 1) - a, ac = atlasOf(surface, t, 2) - a, way = at - a;
  const float area = cross2(ab, ac);
  if (!(std::abs(area) > 1e-14f)) return Vec3(1.0f / 3.0f);
  const float b = cross2(way, ac) / area, c = cross2(ab, way) / area;
  const Vec3 weights = glm::clamp(Vec3(1.0f - b - c, b, c), Vec3(0.0f), Vec3(1.0f));
  return weights / (weights.x + weights.y + weights.z);
}

}  // namespace fur::geometry
