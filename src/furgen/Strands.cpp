#include "furgen/Strands.h"

#include <algorithm>
#include <bit>

#include "core/PortableMath.h"
#include "core/Random.h"
#include "furgen/Strand.h"

namespace fur::furgen {

namespace {

constexpr float kStrandsPerTile = 1500.0f;  // m of Sheppard Eq. 4.1, for 256 x 256 texels
constexpr float kReferenceArea = 256.0f * 256.0f;
constexpr int kRedraws = 100;
constexpr float kMaxPhase = 7.0f;      // radians (Sheppard 3.3.3)
constexpr float kMaxMagnitude = 4.0f;  // radii (Sheppard 3.3.3)
constexpr float kRadiusSpread = 0.25f;

// Share of the tile that the root discs of the densest coat would cover if every strand found a
// place, from the finest to the thickest strands.
constexpr float kFineCover = 0.34f;
constexpr float kThickCover = 0.64f;
// Equal discs placed at random jam at 0.547 of the plane. Hence a candidate gets finer, the more often
// it has been drawn in vain, down to this share of its radius: late strands fill the gaps.
constexpr float kLastRadius = 0.5f;

constexpr float kStrandsPerLock = 14.0f;
// How near to touching the strands of a lock are drawn at the tip: below 1, so that they never do.
constexpr float kLockTightness = 0.95f;

float cleanUnit(float x, float fallback) { return std::isnan(x) ? fallback : saturate(x); }

// Which strands stand where, on the skin and on each layer. Cells are wide enough that discs which
// touch lie in neighbouring cells.
class OccupancyGrid {
 public:
  OccupancyGrid(int size, int levels, float maxDistance, int maxStrands)
      : size_(static_cast<float>(size)) {
    // With fewer than three cells the neighbours of a cell would be counted twice.
    cells_ = std::max(1, static_cast<int>(size_ / maxDistance));
    if (cells_ < 3) cells_ = 1;
    heads_.assign(static_cast<std::size_t>(levels) * cells_ * cells_, -1);
    discs_.reserve(static_cast<std::size_t>(levels) * maxStrands);
  }

  bool collides(int level, const Vec2& at, float radius) const {
    if (radius <= 0.0f) return false;
    const int cx = cellOf(at.x), cy = cellOf(at.y), reach = cells_ == 1 ? 0 : 1;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        for (int i = heads_[slot(level, wrapCell(cx + dx), wrapCell(cy + dy))]; i >= 0; i = discs_[i].next) {
          const Disc& disc = discs_[i];
          const float x = torusDelta(at.x, disc.at.x, size_), y = torusDelta(at.y, disc.at.y, size_);
          const float near = radius + disc.radius;
          if (x * x + y * y < near * near) return true;
        }
    return false;
  }

  void add(int level, const Vec2& at, float radius) {
    if (radius <= 0.0f) return;
    int& head = heads_[slot(level, cellOf(at.x), cellOf(at.y))];
    discs_.push_back({at, radius, head});
    head = static_cast<int>(discs_.size()) - 1;
  }

 private:
  struct Disc {
    Vec2 at;
    float radius;
    int next;
  };

  int cellOf(float x) const {
    const float turns = x / size_;
    return std::min(static_cast<int>((turns - std::floor(turns)) * static_cast<float>(cells_)), cells_ - 1);
  }
  int wrapCell(int c) const { return c < 0 ? c + cells_ : c >= cells_ ? c - cells_ : c; }
  std::size_t slot(int level, int x, int y) const {
    return (static_cast<std::size_t>(level) * cells_ + y) * cells_ + x;
  }

  float size_;
  int cells_ = 1;
  std::vector<int> heads_;
  std::vector<Disc> discs_;
};

// Centres of locks, one in each cell of a jittered grid.
class Locks {
 public:
  Locks(const FurParameters& p, int strands) : size_(static_cast<float>(p.size)) {
    side_ = std::max(2, static_cast<int>(std::sqrt(static_cast<float>(strands) / kStrandsPerLock) + 0.5f));
    Random random(p.seed, 0);
    const float cell = size_ / static_cast<float>(side_);
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) {
        const float u = random.uniform(), v = random.uniform();
        centres_.push_back({(static_cast<float>(x) + u) * cell, (static_cast<float>(y) + v) * cell});
      }
  }

  // Two cells away is enough: the own cell's centre is never farther than its diagonal.
  Vec2 towardsNearest(const Vec2& root) const {
    const int cx = static_cast<int>(root.x / size_ * static_cast<float>(side_));
    const int cy = static_cast<int>(root.y / size_ * static_cast<float>(side_));
    Vec2 best{0};
    float bestSquared = 1e30f;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const int x = ((cx + dx) % side_ + side_) % side_, y = ((cy + dy) % side_ + side_) % side_;
        const Vec2& c = centres_[static_cast<std::size_t>(y * side_ + x)];
        const Vec2 way{torusDelta(c.x, root.x, size_), torusDelta(c.y, root.y, size_)};
        const float squared = way.x * way.x + way.y * way.y;
        if (squared < bestSquared) bestSquared = squared, best = way;
      }
    return best;
  }

 private:
  float size_;
  int side_;
  std::vector<Vec2> centres_;
};

Strand drawStrand(Random& random, const FurParameters& p, float radius, const Locks& locks) {
  // One draw a line: the order of evaluation inside an expression is the compiler's.
  Strand strand;
  const float size = static_cast<float>(p.size);
  strand.root.x = random.uniform() * size;
  strand.root.y = random.uniform() * size;
  strand.radius = radius * random.uniform(1.0f - kRadiusSpread, 1.0f + kRadiusSpread);
  strand.length = std::max(p.length * (1.0f - p.lengthVariation * random.uniform()), layerHeight(0, p.layers));
  strand.dominance = random.uniform(0.5f, 1.0f);
  strand.variance = random.uniform();
  const float limit = kMaxMagnitude * strand.radius * p.curl;
  for (int curve = 0; curve < 2; ++curve)
    for (int axis = 0; axis < 2; ++axis) {
      strand.magnitude[curve][axis] = limit * random.uniform(-1.0f, 1.0f);
      strand.phase[curve][axis] = kMaxPhase * random.uniform();
    }
  if (p.clump > 0.0f) strand.toLock = locks.towardsNearest(strand.root) * p.clump;
  return strand;
}

bool fits(const OccupancyGrid& grid, const Strand& strand, int layers) {
  if (grid.collides(0, strand.root, strandRadius(strand, 0.0f))) return false;
  for (int layer = 0; layer < layers; ++layer) {
    const float h = layerHeight(layer, layers);
    if (h > strand.length) break;
    if (grid.collides(layer + 1, strand.root + strandShift(strand, h), strandRadius(strand, h))) return false;
  }
  return true;
}

void occupy(OccupancyGrid& grid, const Strand& strand, int layers) {
  grid.add(0, strand.root, strandRadius(strand, 0.0f));
  for (int layer = 0; layer < layers; ++layer) {
    const float h = layerHeight(layer, layers);
    if (h > strand.length) break;
    grid.add(layer + 1, strand.root + strandShift(strand, h), strandRadius(strand, h));
  }
}

}  // namespace

float torusDelta(float a, float b, float size) {
  const float d = a - b;
  return d - size * std::floor(d / size + 0.5f);
}

Vec2 strandShift(const Strand& strand, float height) {
  Vec2 shift{0};
  for (int curve = 0; curve < 2; ++curve)
    for (int axis = 0; axis < 2; ++axis)
      if (strand.magnitude[curve][axis] != 0.0f)
        shift[axis] += strand.magnitude[curve][axis] * portableSin(strand.phase[curve][axis] * height);
  // A lock closes as fast as its strands thin, so that straight strands never run into each other.
  const float closing = 1.0f - strandThinning(std::min(height, 1.0f)) / strandThinning(0.0f);
  return shift + strand.toLock * (closing * kLockTightness);
}

float strandRadius(const Strand& strand, float height) {
  return strand.radius * strandThinning(height / strand.length);
}

float meanRadius(float thickness) {
  // The radius at which the wanted strands of the densest coat cover the wanted share of the skin:
  // cover * area = count * pi * (radius * thinning(0))^2.
  const float cover = kFineCover + (kThickCover - kFineCover) * thickness;
  const float areaOfOne = kReferenceArea / (kStrandsPerTile * (1.0f - 0.7f * thickness));
  return std::sqrt(cover * areaOfOne / kPi) / strandThinning(0.0f);
}

int wantedStrands(const FurParameters& p) {
  if (p.density <= 0.0f) return 0;
  const float area = static_cast<float>(p.size) * static_cast<float>(p.size) / kReferenceArea;
  const float count = p.density * kStrandsPerTile * area * (1.0f - 0.7f * p.thickness);  // Sheppard Eq. 4.1
  return std::max(1, static_cast<int>(count + 0.5f));
}

FurParameters clampedParameters(const FurParameters& given) {
  const FurParameters standard;
  FurParameters p = given;
  p.size = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::clamp(given.size, 64, 1024))));
  p.layers = std::clamp(given.layers, 4, 128);
  p.density = cleanUnit(given.density, standard.density);
  p.thickness = cleanUnit(given.thickness, standard.thickness);
  p.lengthVariation = cleanUnit(given.lengthVariation, standard.lengthVariation);
  p.length = cleanUnit(given.length, standard.length);
  p.curl = cleanUnit(given.curl, standard.curl);
  p.clump = cleanUnit(given.clump, standard.clump);
  return p;
}

std::vector<Strand> growStrands(const FurParameters& given) {
  const FurParameters p = clampedParameters(given);
  const int wanted = wantedStrands(p);
  std::vector<Strand> strands;
  if (wanted == 0) return strands;
  const float radius = meanRadius(p.thickness);
  // The locks of the full coat, so that density does not move them.
  FurParameters full = p;
  full.density = 1.0f;
  const Locks locks(p, wantedStrands(full));
  const float maxDistance = 2.0f * radius * (1.0f + kRadiusSpread) * strandThinning(0.0f);
  OccupancyGrid grid(p.size, p.layers + 1, maxDistance, wanted);
  for (int index = 0; index < wanted; ++index) {
    Random random(p.seed, static_cast<std::uint64_t>(index) + 1);
    for (int attempt = 0; attempt <= kRedraws; ++attempt) {
      const float finer = 1.0f - (1.0f - kLastRadius) * static_cast<float>(attempt) / kRedraws;
      const Strand strand = drawStrand(random, p, radius * finer, locks);
      if (!fits(grid, strand, p.layers)) continue;
      occupy(grid, strand, p.layers);
      strands.push_back(strand);
      break;
    }
  }
  return strands;
}

}  // namespace fur::furgen
