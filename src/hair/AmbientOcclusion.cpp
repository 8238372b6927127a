#include "hair/AmbientOcclusion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/PortableMath.h"
#include "hair/CellCorners.h"

namespace fur::hair {

namespace {

constexpr int kPoints = kStripSegments + 1;
constexpr int kMostCells = 32;  // along a side
// Hairs scatter some of their light forward: of what they block so much is lost.
constexpr float kLost = 0.8f;
// Bare skin gets the light of half of all directions.
constexpr float kOfSkin = 0.5f;

// A box of cubes round all points, with one beyond them on each side.
class Grid {
 public:
  explicit Grid(std::span<const Vec3> points) {
    Vec3 low = points[0], high = points[0];
    for (const Vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
    const Vec3 span = high - low;
    cell_ = std::max(std::max({span.x, span.y, span.z}) / (kMostCells - 3), 1e-4f);
    low_ = low - 1.5f * cell_;
    const auto count = [&](float side) { return std::min(static_cast<int>(side / cell_) + 4, kMostCells); };
    cells_ = {count(span.x), count(span.y), count(span.z)};
    const std::size_t all = cells_.all();
    extinction_.assign(all, 0);
    solid_.assign(all, 0);
    light_.assign(all, 0);
  }

  float cell() const { return cell_; }

  // Hair of that area, as seen from its side.
  void addHair(const Vec3& at, float area) { atCorners(at, [&](std::size_t c, float weight) { extinction_[c] += weight * area / (cell_ * cell_ * cell_); }); }

  void addSkin(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (const Vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c)); !meets(low, high)) return;
    const float longest = std::max({glm::length(b - a), glm::length(c - a), glm::length(c - b)});
    const int steps = std::min(static_cast<int>(2 * longest / cell_) + 1, 2 * kMostCells);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j + i <= steps; ++j) {
        const float u = static_cast<float>(i) / static_cast<float>(steps), v = static_cast<float>(j) / static_cast<float>(steps);
        const Vec3 p = (a + u * (b - a) + v * (c - a) - low_) / cell_;
        const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y)), z = static_cast<int>(std::floor(p.z));
        if (inside(x, y, z)) solid_[cells_.index(x, y, z)] = 1;
      }
  }

  // Light that comes that way, each of -1, 0 or 1, from outside: what is left of it in the middle of each cell.
  void sweep(int dx, int dy, int dz) {
    const float step = cell_ * std::sqrt(static_cast<float>(dx * dx + dy * dy + dz * dz));
    const auto ordered = [](int i, int count, int way) { return way < 0 ? count - 1 - i : i; };
    for (int k = 0; k < cells_.z; ++k)
      for (int j = 0; j < cells_.y; ++j)
        for (int i = 0; i < cells_.x; ++i) {
          const int x = ordered(i, cells_.x, dx), y = ordered(j, cells_.y, dy), z = ordered(k, cells_.z, dz);
          const std::size_t here = cells_.index(x, y, z);
          float light = 1, before = 0;
          if (inside(x - dx, y - dy, z - dz)) {
            const std::size_t from = cells_.index(x - dx, y - dy, z - dz);
            light = solid_[from] ? 0 : light_[from];
            before = extinction_[from];
          }
          light_[here] = light > 0 ? light * portableExp(-std::min(0.5f * step * (before + extinction_[here]), 20.0f)) : 0;
        }
  }

  float lightAt(const Vec3& at) const {
    float sum = 0;
    atCorners(at, [&](std::size_t c, float weight) { sum += weight * light_[c]; });
    return sum;
  }

 private:
  bool inside(int x, int y, int z) const { return x >= 0 && y >= 0 && z >= 0 && x < cells_.x && y < cells_.y && z < cells_.z; }
  bool meets(const Vec3& low, const Vec3& high) const {
    const Vec3 top = low_ + cell_ * Vec3(cells_.x, cells_.y, cells_.z);
    return high.x > low_.x && high.y > low_.y && high.z > low_.z && low.x < top.x && low.y < top.y && low.z < top.z;
  }

  // The eight cells whose middles are round a point that lies inside.
  template <class Visit>
  void atCorners(const Vec3& at, Visit visit) const {
    forCorners(cells_, (at - low_) / cell_ - 0.5f, visit);
  }

  float cell_ = 1;
  Vec3 low_{0};
  CellCounts cells_;
  std::vector<float> extinction_, light_;
  std::vector<std::uint8_t> solid_;
};

// The ways to a cube's faces and corners.
std::array<std::array<int, 3>, 14> directions() {
  std::array<std::array<int, 3>, 14> all{};
  for (std::size_t axis = 0; axis < 3; ++axis) all[2 * axis][axis] = 1, all[2 * axis + 1][axis] = -1;
  for (std::size_t corner = 0; corner < 8; ++corner)
    all[6 + corner] = {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
  return all;
}

}  // namespace

std::vector<std::uint8_t> ambientVisibility(const geometry::Surface& surface, std::span<const Wisp> wisps, std::span<const GuideNode> nodes,
                                            int nodesEach, const HairValues& values) {
  const WispShape shape = shapeOf(values);
  std::vector<Vec3> points, ways;
  points.reserve(wisps.size() * kPoints);
  ways.reserve(wisps.size() * kPoints);
  for (const Wisp& wisp : wisps)
    for (int i = 0; i < kPoints; ++i) {
      const WispPoint point = wispPoint(wisp, nodes, nodesEach, shape, static_cast<float>(i) / kStripSegments);
      points.push_back(point.position);
      ways.push_back(point.along);
    }
  if (points.empty()) return {};
  Grid grid(points);
  // Seen from anywhere, a strand shows pi / 4 of its side.
  const float area = kLost * 0.25f * kPi * static_cast<float>(values.strands) * values.strandWidth;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (i % kPoints != 0) grid.addHair(0.5f * (points[i - 1] + points[i]), area * glm::length(points[i] - points[i - 1]));
  for (std::size_t i = 0; i < surface.indices.size(); i += 3)
    grid.addSkin(surface.vertices[surface.indices[i]].position, surface.vertices[surface.indices[i + 1]].position,
                 surface.vertices[surface.indices[i + 2]].position);
  // Within the skin's own cells it is dark on one side: points are looked up a little further out.
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += 0.75f * grid.cell() * wisps[i / kPoints].normal;

  std::vector<float> light(points.size()), whole(points.size());
  for (const auto& [dx, dy, dz] : directions()) {
    grid.sweep(dx, dy, dz);
    const Vec3 way = glm::normalize(Vec3(dx, dy, dz));
    for (std::size_t i = 0; i < points.size(); ++i) {
      // Light along a hair lights it least: sin(T, d).
      const float along = glm::dot(ways[i], way), share = std::sqrt(std::max(1 - along * along, 0.0f));
      light[i] += share * grid.lightAt(points[i]);
      whole[i] += share;
    }
  }
  std::vector<std::uint8_t> out(points.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::uint8_t>(255 * saturate(light[i] / (kOfSkin * whole[i])) + 0.5f);
  return out;
}

}  // namespace fur::hair
