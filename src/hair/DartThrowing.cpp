#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Random.h"
#include "hair/Wisps.h"

namespace fur::hair {

namespace {

// Densities below this keep darts apart as this one does.
constexpr float kThinnest = 1.0f / 16;
// After so many darts in a row that come too near to others the radius shrinks by this factor. Radii begin where a handful of
// darts fills the scalp: each dart keeps from those before it by a radius that suited their number (McCool & Fiume 1992).
constexpr int kMostMisses = 96;
constexpr float kShrink = 0.95f;
constexpr double kFirstDarts = 12;
// Of the radius at which as many discs as there are darts would fill the plane: what the last darts keep, about.
constexpr double kUsualShare = 0.7;
constexpr int kMostParts = 4;     // into which an edge is divided to find its triangle's density
constexpr int kThinningTries = 64;

double packedRadius(double area, double count) { return std::sqrt(area * 2 / (std::sqrt(3.0) * count)); }

struct Triangle {
  const geometry::SurfaceVertex* corners[3];
  template <class T>
  T at(T geometry::SurfaceVertex::*value, const Vec3& weights) const {
    return corners[0]->*value * weights.x + corners[1]->*value * weights.y + corners[2]->*value * weights.z;
  }
};

// The triangles' areas times their density, summed up.
class AreaTable {
 public:
  explicit AreaTable(const ScalpSurface& scalp) : scalp_(scalp) {
    double sum = 0;
    for (std::uint32_t t = 0; t < scalp.surface.triangleCount(); ++t) {
      const Density density = densityOf(triangle(t));
      sum += areaOf(triangle(t)) * static_cast<double>(density.mean);
      sums_.push_back(sum);
      peaks_.push_back(density.peak);
    }
  }

  double area() const { return sums_.empty() ? 0 : sums_.back(); }
  Triangle triangle(std::uint32_t t) const {
    const std::uint32_t* at = &scalp_.surface.indices[std::size_t{3} * t];
    return {{&scalp_.surface.vertices[at[0]], &scalp_.surface.vertices[at[1]], &scalp_.surface.vertices[at[2]]}};
  }

  // A point by chance, denser where the scalp is; false where chance found none on a triangle that is nearly bare.
  bool throwAt(Random& random, Dart& dart, float& density) const {
    const double coarse = random.next(), fine = random.next();
    const double at = (coarse + fine / 4294967296.0) / 4294967296.0 * area();
    dart.triangle = static_cast<std::uint32_t>(std::upper_bound(sums_.begin(), sums_.end() - 1, at) - sums_.begin());
    const Triangle t = triangle(dart.triangle);
    for (int k = 0; k < kThinningTries; ++k) {
      const float root = std::sqrt(random.uniform()), way = random.uniform();
      dart.weights = Vec3(1 - root, root * (1 - way), root * way);
      dart.atlas = t.at(&geometry::SurfaceVertex::atlas, dart.weights);
      density = scalp_.scalp.at(dart.atlas).x;
      if (random.uniform() * peaks_[dart.triangle] >= density) continue;
      dart.position = t.at(&geometry::SurfaceVertex::position, dart.weights);
      dart.normal = normalizeOr(t.at(&geometry::SurfaceVertex::normal, dart.weights), t.corners[0]->normal);
      return true;
    }
    return false;
  }

 private:
  struct Density {
    float mean, peak;
  };

  static double areaOf(const Triangle& t) {
    const Vec3 a = t.corners[0]->position;
    return 0.5 * static_cast<double>(glm::length(glm::cross(t.corners[1]->position - a, t.corners[2]->position - a)));
  }

  // At the middles of n^2 small triangles, about one a texel.
  Density densityOf(const Triangle& t) const {
    float longest = 0;
    for (int k = 0; k < 3; ++k) longest = std::max(longest, glm::length(t.corners[k]->atlas - t.corners[(k + 1) % 3]->atlas));
    const int n = std::clamp(static_cast<int>(longest * static_cast<float>(scalp_.scalp.size())) + 1, 1, kMostParts);
    Density out{0, 0};
    const auto add = [&](float x, float y) {
      const Vec3 weights = Vec3(static_cast<float>(n) - x - y, x, y) / static_cast<float>(n);
      const float density = scalp_.scalp.at(t.at(&geometry::SurfaceVertex::atlas, weights)).x;
      out.mean += density / static_cast<float>(n * n);
      out.peak = std::max(out.peak, density);
    };
    for (int y = 0; y < n; ++y)
      for (int x = 0; x + y < n; ++x) {
        add(static_cast<float>(x) + 1.0f / 3, static_cast<float>(y) + 1.0f / 3);
        if (x + y + 1 < n) add(static_cast<float>(x) + 2.0f / 3, static_cast<float>(y) + 2.0f / 3);
      }
    return out;
  }

  const ScalpSurface& scalp_;
  std::vector<double> sums_;
  std::vector<float> peaks_;  // the greatest density of a triangle
};

// Darts by the cell of a grid in which they lie.
class DartGrid {
 public:
  DartGrid(const std::vector<Dart>& darts, float cell, std::size_t count) : darts_(darts), cell_(cell) {
    std::size_t heads = 64;
    while (heads < 2 * count) heads *= 2;
    first_.assign(heads, kNone);
  }

  void add(std::uint32_t dart) {
    std::uint32_t& first = first_[headOf(cellOf(darts_[dart].position))];
    next_.push_back(first);
    first = dart;
  }

  // Whether there is one within the radius, on the same side of a sheet.
  bool isNear(const Dart& dart, float radius) const {
    const auto low = cellOf(dart.position - radius), high = cellOf(dart.position + radius);
    const glm::ivec3 cells = high - low + 1;
    if (static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z) >= darts_.size()) {
      return std::any_of(darts_.begin(), darts_.end(), [&](const Dart& other) { return meet(dart, other, radius); });
    }
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
          for (std::uint32_t i = first_[headOf({x, y, z})]; i != kNone; i = next_[i])
            if (meet(dart, darts_[i], radius)) return true;
    return false;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  static bool meet(const Dart& a, const Dart& b, float radius) {
    const Vec3 away = a.position - b.position;
    return glm::dot(away, away) < radius * radius && glm::dot(a.normal, b.normal) > 0;
  }
  glm::ivec3 cellOf(const Vec3& p) const { return glm::ivec3(glm::floor(p / cell_)); }
  std::size_t headOf(const glm::ivec3& cell) const {
    const std::uint32_t hash = static_cast<std::uint32_t>(cell.x) * 73856093u ^ static_cast<std::uint32_t>(cell.y) * 19349663u ^
                               static_cast<std::uint32_t>(cell.z) * 83492791u;
    return (hash ^ hash >> 15) & (first_.size() - 1);
  }

  const std::vector<Dart>& darts_;
  float cell_;
  std::vector<std::uint32_t> first_, next_;
};

}  // namespace

double areaOf(const ScalpSurface& scalp) { return AreaTable(scalp).area(); }

std::vector<Dart> throwDarts(const ScalpSurface& scalp, int count, std::uint64_t seed) {
  std::vector<Dart> darts;
  const AreaTable table(scalp);
  if (count <= 0 || !(table.area() > 0)) return darts;
  const auto wanted = static_cast<std::size_t>(count);
  darts.reserve(wanted);
  DartGrid grid(darts, static_cast<float>(kUsualShare * packedRadius(table.area(), count)), wanted);
  Random random(seed, 71);
  auto radius = static_cast<float>(packedRadius(table.area(), kFirstDarts));
  // Thinning may fail for long on a scalp that is bare but for single texels.
  for (std::size_t left = 20000 + 1000 * wanted; left > 0 && darts.size() < wanted; --left) {
    Dart dart;
    float density = 1;
    int misses = 0;
    for (; misses < kMostMisses; ++misses)
      if (table.throwAt(random, dart, density) && !grid.isNear(dart, radius / std::sqrt(std::max(density, kThinnest)))) break;
    if (misses == kMostMisses) {
      radius *= kShrink;
      continue;
    }
    darts.push_back(dart);
    grid.add(static_cast<std::uint32_t>(darts.size() - 1));
  }
  return darts;
}

}  // namespace fur::hair
