#include "wet/ClumpSites.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fur::wet {

namespace {

// A clump reaches past the farthest texel that is drawn to it, so that fur has no gaps until it is really wet.
constexpr float kRadiiPerSpacing = 1.2f;

// So far out, in radii, a place may lie in its clump: all sites are nearer than 1 / kRadiiPerSpacing.
constexpr float kHeld = 0.9f;

// The 27 cells round one, as x + 3 y + 9 z: it itself, those at its sides, edges and corners.
constexpr int kCells[27] = {13, 4, 10, 12, 14, 16, 22, 1, 3, 5, 7, 9, 11, 15, 17, 19, 21, 23, 25, 0, 2, 6, 8, 18, 20, 24, 26};

int cell(float x, float spacing) { return static_cast<int>(std::floor(x / spacing)); }

}  // namespace

ClumpSites::ClumpSites(const SurfaceTexels& texels, float radius) : radius_(radius), spacing_(radius / kRadiiPerSpacing) {
  const auto count = static_cast<std::uint32_t>(texels.places().size());
  std::size_t buckets = 256;
  while (buckets < count / 8) buckets *= 2;
  heads_.assign(buckets, SurfaceTexels::kNone);
  siteOf_.assign(count, SurfaceTexels::kNone);
  // Steps by the golden section visit places evenly.
  stride_ = static_cast<std::uint32_t>(0.6180339887 * count) | 1u;
  const auto common = [](std::uint32_t a, std::uint32_t b) {
    while (b) a %= b, std::swap(a, b);
    return a;
  };
  while (count > 1 && common(stride_, count) != 1) stride_ += 2;
}

// Every place becomes a site unless one is near.
bool ClumpSites::find(const SurfaceTexels& texels, std::uint32_t places) {
  const std::uint64_t count = siteOf_.size(), end = std::min<std::uint64_t>(count, std::uint64_t{seen_} + places);
  for (; seen_ < end; ++seen_) {
    const auto index = static_cast<std::uint32_t>(std::uint64_t{seen_} * stride_ % count);
    const SurfaceTexels::Place& place = texels.places()[index];
    bool free = true;
    forSitesNear(place.position, [&](std::uint32_t site) {
      const SurfaceTexels::Place& other = texels.places()[sites_[site]];
      const Vec3 way = other.position - place.position;
      free &= glm::dot(way, way) >= spacing_ * spacing_ || glm::dot(other.normal, place.normal) <= 0.0f;
      return free;
    });
    if (!free) continue;
    std::uint32_t& head = heads_[bucketOf(cell(place.position.x, spacing_), cell(place.position.y, spacing_), cell(place.position.z, spacing_))];
    next_.push_back(head);
    head = static_cast<std::uint32_t>(sites_.size());
    sites_.push_back(index);
  }
  return seen_ == count;
}

std::size_t ClumpSites::bucketOf(int x, int y, int z) const {
  const std::uint32_t hash = static_cast<std::uint32_t>(x) * 73856093u ^ static_cast<std::uint32_t>(y) * 19349663u ^
                             static_cast<std::uint32_t>(z) * 83492791u;
  return hash & (heads_.size() - 1);
}

// Those in the 27 cells round the position, and some that share their buckets; visit(site) says whether to go on.
template <class Visit>
void ClumpSites::forSitesNear(const Vec3& position, Visit visit) const {
  const int x = cell(position.x, spacing_), y = cell(position.y, spacing_), z = cell(position.z, spacing_);
  // The nearest cells first, in which a visit most likely ends.
  for (const int k : kCells) {
    for (std::uint32_t site = heads_[bucketOf(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1)]; site != SurfaceTexels::kNone; site = next_[site])
      if (!visit(site)) return;
  }
}

std::uint32_t ClumpSites::siteOf(const SurfaceTexels& texels, std::uint32_t index) {
  if (siteOf_[index] != SurfaceTexels::kNone) return siteOf_[index];
  const SurfaceTexels::Place& place = texels.places()[index];
  float nearest = 1e9f;
  forSitesNear(place.position, [&](std::uint32_t site) {
    const SurfaceTexels::Place& other = texels.places()[sites_[site]];
    const Vec3 way = other.position - place.position;
    const float squared = glm::dot(way, way);
    if (glm::dot(other.normal, place.normal) <= 0.0f || squared > nearest) return true;
    // Of two equally near the first, in whatever order buckets have them.
    if (squared == nearest && siteOf_[index] < site) return true;
    nearest = squared;
    siteOf_[index] = site;
    return true;
  });
  return siteOf_[index];
}

Vec3 ClumpSites::clumpOf(const SurfaceTexels& texels, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                         const SurfaceWetting& wetting, std::uint32_t index) {
  const SurfaceTexels::Place& place = texels.places()[index];
  const std::uint32_t site = siteOf(texels, index);
  if (site != last_) {
    last_ = site;
    const SurfaceTexels::Place& middle = texels.places()[sites_[site]];
    sheets_ = wetting.sheetsAt(surface, query, middle.position, middle.normal, radius_);
  }
  const auto size = static_cast<std::uint32_t>(texels.size());
  const Vec2 at = (Vec2(place.texel % size, place.texel / size) + 0.5f) / static_cast<float>(size);
  // By the sheet of its chart that lies nearest, and by the place's own triangle where that is too far off to hold the place or
  // there is none, as along the borders of charts: a place outside its own clump would be a hole in the coat.
  const auto seenBy = [&](const SurfaceWetting::Sheet& sheet) {
    const Vec2 way = sheet.centre - at;
    const float squared = glm::dot(way, way), stretched = squaredIn(sheet.shape(), way);
    return Vec3(sheet.centre, radius_ * sheet.scale() * (stretched > 0.0f ? std::sqrt(squared / stretched) : 1.0f));
  };
  Vec3 clump(0);
  float nearest = 1e9f;
  for (const SurfaceWetting::Sheet& sheet : sheets_) {
    const Vec2 way = sheet.centre - at;
    if (sheet.chart != wetting.chartOfTexel()[place.texel] || glm::dot(way, way) >= nearest) continue;
    nearest = glm::dot(way, way);
    clump = seenBy(sheet);
  }
  if (nearest <= kHeld * kHeld * clump.z * clump.z) return clump;
  clump = seenBy(wetting.sheetOf(surface, place.triangle, texels.places()[sites_[site]].position));
  const Vec2 way = Vec2(clump) - at;
  // Where the atlas is stretched past what shape() tells the radius is what holds the place.
  return Vec3(Vec2(clump), std::max(clump.z, glm::length(way) / kHeld));
}

}  // namespace fur::wet
