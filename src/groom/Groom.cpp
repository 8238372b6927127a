#include "groom/Groom.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "core/Fnv1a.h"
#include "geometry/Adjacency.h"
#include "geometry/Weld.h"

namespace fur::groom {

GroomMap::Texel GroomMap::sound(Texel t) const {
  if (plain_ != kPlain) return t;
  const int sum = t[1] + t[2] + t[3];
  if (sum > 255)
    for (std::size_t k = 1; k < 4; ++k) t[k] = static_cast<std::uint8_t>(t[k] * 255 / sum);
  return t;
}

GroomMap::GroomMap(int size, const Texel& plain)
    : size_(std::clamp(size, kLeastSize, kMostSize)),
      plain_(plain),
      texels_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), plain),
      changed_{0, 0, size_, size_} {}

void GroomMap::set(std::uint32_t texel, Texel value) {
  value = sound(value);
  if (texels_[texel] == value) return;
  texels_[texel] = value;
  changed_.include(static_cast<int>(texel) % size_, static_cast<int>(texel) / size_);
}

void GroomMap::restore(std::vector<Texel> texels) {
  FUR_ASSERT(texels.size() == texels_.size(), "GroomMap::restore()", "size * size texels", texels.size());
  texels_ = std::move(texels);
  for (Texel& texel : texels_) texel = sound(texel);
  changed_ = {0, 0, size_, size_};
}

void GroomMap::fillGutter(const geometry::AtlasTexels& atlas, const geometry::TexelRect& changed) {
  FUR_ASSERT(atlas.size() == size_, "GroomMap::fillGutter()", "an atlas of the map's size", atlas.size());
  constexpr int kReach = geometry::AtlasTexels::kGutter;
  for (const auto& [texel, source] : atlas.gutter()) {
    const int x = static_cast<int>(texel) % size_, y = static_cast<int>(texel) / size_;
    const bool across = x >= changed.x0 - kReach && x < changed.x1 + kReach;
    if (across && y >= changed.y0 - kReach && y < changed.y1 + kReach) set(texel, texels_[source]);
  }
}

bool GroomMap::isPlain() const {
  const bool blank = plain_ == kBlank;
  return std::all_of(texels_.begin(), texels_.end(), [&](const Texel& texel) { return blank ? texel[3] == 0 : texel == plain_; });
}

Vec4 GroomMap::at(const Vec2& atlas) const {
  const auto last = static_cast<float>(size_ - 1);
  const Vec2 at = glm::clamp(atlas * static_cast<float>(size_) - 0.5f, Vec2(0.0f), Vec2(last));
  const auto side = static_cast<std::size_t>(size_);
  const auto x0 = static_cast<std::size_t>(at.x), y0 = static_cast<std::size_t>(at.y);
  const std::size_t x1 = std::min(x0 + 1, side - 1), y1 = std::min(y0 + 1, side - 1);
  const Vec2 part = at - Vec2(static_cast<float>(x0), static_cast<float>(y0));
  const auto texel = [&](std::size_t x, std::size_t y) {
    const Texel& t = texels_[y * side + x];
    return Vec4(t[0], t[1], t[2], t[3]);
  };
  const Vec4 low = glm::mix(texel(x0, y0), texel(x1, y0), part.x), high = glm::mix(texel(x0, y1), texel(x1, y1), part.x);
  return glm::mix(low, high, part.y) / 255.0f;
}

int GroomMap::typeAt(const Vec2& atlas) const {
  const Vec2 at = glm::clamp(atlas * static_cast<float>(size_), Vec2(0.0f), Vec2(static_cast<float>(size_ - 1)));
  const auto x = static_cast<std::size_t>(at.x), y = static_cast<std::size_t>(at.y);
  const Texel& t = texels_[y * static_cast<std::size_t>(size_) + x];
  const int presence[kTypes] = {255 - t[1] - t[2] - t[3], t[1], t[2], t[3]};
  return static_cast<int>(std::max_element(presence, presence + kTypes) - presence) + 1;
}

std::uint64_t GroomMap::hash() const {
  Fnv1a hash;
  hash.addAll(texels_);
  return hash.value();
}

geometry::TexelRect GroomMap::takeChanged() { return std::exchange(changed_, geometry::TexelRect{}); }

GroomMap resized(const GroomMap& map, int size) {
  GroomMap out(size, GroomMap::kBlank);
  const auto from = static_cast<std::size_t>(map.size()), to = static_cast<std::size_t>(out.size());
  std::vector<GroomMap::Texel> texels;
  texels.reserve(to * to);
  for (std::size_t y = 0; y < to; ++y)
    for (std::size_t x = 0; x < to; ++x)
      texels.push_back(map.texels()[(2 * y + 1) * from / (2 * to) * from + (2 * x + 1) * from / (2 * to)]);
  out.restore(std::move(texels));
  return out;
}

void resize(Groom& groom, int size) {
  const Groom before = std::exchange(groom, {GroomMap(size), groom.comb, groom.whiskers, groom.bare});
  for (const auto map : kMaps) (groom.*map).restore(resized(before.*map, groom.map.size()).texels());
}

SurfacePoints::SurfacePoints(const geometry::Surface& surface) {
  std::vector<Vec3> all;
  all.reserve(surface.vertices.size());
  for (const auto& vertex : surface.vertices) all.push_back(vertex.position);
  const geometry::Weld weld = geometry::weldPositions(all);
  pointOf = weld.idOf;
  positions.resize(weld.count);
  normals.assign(weld.count, Vec3(0));
  for (std::size_t i = 0; i < all.size(); ++i) positions[pointOf[i]] = all[i];
  for (std::size_t i = 0; i < surface.trueVertexCount; ++i) normals[pointOf[i]] += surface.vertices[i].normal;
  for (Vec3& normal : normals) normal = normalizeOr(normal, Vec3(0, 1, 0));
}

std::vector<std::uint32_t> SurfacePoints::at(const std::vector<Vec3>& places) const {
  std::vector<Vec3> all = positions;
  all.insert(all.end(), places.begin(), places.end());
  const geometry::Weld weld = geometry::weldPositions(all);
  std::vector<std::uint32_t> out(weld.idOf.begin() + static_cast<std::ptrdiff_t>(count()), weld.idOf.end());
  for (std::uint32_t& point : out)
    if (point >= count()) point = kNoPoint;
  return out;
}

std::vector<Vec3> soundComb(std::vector<Vec3> comb, const SurfacePoints& points) {
  FUR_ASSERT(comb.size() == points.count(), "groom::soundComb()", "one a point", comb.size());
  for (std::size_t i = 0; i < comb.size(); ++i) {
    // One that is sound but for rounding stays as it is, to the bit.
    constexpr float kRounding = 1e-5f;
    const float up = glm::dot(comb[i], points.normals[i]);
    const Vec3 across = std::abs(up) < kRounding ? comb[i] : comb[i] - points.normals[i] * up;
    const float squared = glm::dot(across, across);
    if (!(squared < 1e12f)) comb[i] = Vec3(0);  // nor what is not finite
    else comb[i] = squared > kMaxComb * kMaxComb * (1 + kRounding) ? across * (kMaxComb / std::sqrt(squared)) : across;
  }
  return comb;
}

unsigned typesPresent(const GroomMap& map) {
  unsigned types = 1;
  for (const GroomMap::Texel& texel : map.texels())
    for (unsigned type = 1; type < kTypes; ++type)
      if (texel[type] > 0) types |= 1u << type;
  return types;
}

bool Groom::isPlain() const {
  return whiskers.empty() && map.isPlain() && paint.isPlain() && mask.isPlain() && std::all_of(comb.begin(), comb.end(), [](const Vec3& c) { return c == Vec3(0); });
}

Groom plainGroom(int mapSize, const SurfacePoints& points) {
  return {GroomMap(mapSize), std::vector<Vec3>(points.count(), Vec3(0))};
}

Vec3 bendAt(const Groom& groom, std::span<const Vec3> lie, std::size_t point) {
  const Vec3& comb = groom.comb[point];
  return lie.empty() || comb != Vec3(0) ? comb : lie[point];
}

Vec3 combOf(const Vec3& bend, std::span<const Vec3> lie, std::size_t point) {
  constexpr float kUpright = 1e-3f, kStanding = 1e-4f;  // radians; not ever nearer to upright
  if (glm::dot(bend, bend) >= kUpright * kUpright) return bend;
  return lie.empty() ? Vec3(0) : kStanding * normalizeOr(lie[point], Vec3(0));
}

std::vector<Vec3> restBends(const Groom& groom, const geometry::Surface& surface, const SurfacePoints& points, std::span<const Vec3> lie) {
  FUR_ASSERT(groom.comb.size() == points.count(), "groom::restBends()", "a comb of the surface's points", groom.comb.size());
  std::vector<Vec3> out;
  out.reserve(surface.vertices.size());
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const Vec3 bend = bendAt(groom, lie, points.pointOf[i]);
    const Vec3& normal = surface.vertices[i].normal;
    out.push_back(bend - normal * glm::dot(bend, normal));
  }
  return out;
}

namespace {

// Calls visit(texel) for those of the map that a filtered look-up on the triangle meets, one texel to each side, while it
// returns true.
template <class Visit>
void forTexelsNear(const GroomMap& map, const geometry::AtlasTriangle& flat, Visit visit) {
  const geometry::TexelRect box = flat.bounds(1.0f);
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x)
      if (flat.meets(x, y, 1.0f) && !visit(map.texels()[static_cast<std::size_t>(y) * map.size() + x])) return;
}

}  // namespace

std::vector<float> vertexLengths(const GroomMap& map, const geometry::Surface& surface, const SurfacePoints& points,
                                 const TypeHeights& heights) {
  const auto heightOf = [&](const GroomMap::Texel& t) {
    float tallest = std::min(2 * (255 - t[1] - t[2] - t[3]), 255) * heights[0];
    for (std::size_t k = 1; k < kTypes; ++k) tallest = std::max(tallest, std::min(2 * t[k], 255) * heights[k]);
    return tallest * t[0] / (255.0f * 255.0f);
  };
  std::vector<float> most(points.count(), 0.0f);
  const auto corner = [&](std::size_t i) { return surface.indices[i]; };
  for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
    const auto atlas = [&](std::size_t k) { return surface.vertices[corner(i + k)].atlas; };
    const geometry::AtlasTriangle flat(atlas(0), atlas(1), atlas(2), map.size());
    // What has no area in the atlas meets no texel.
    float tallest = flat.area > 0.0f ? 0.0f : 1.0f;
    forTexelsNear(map, flat, [&](const GroomMap::Texel& texel) {
      tallest = std::max(tallest, heightOf(texel));
      return tallest < 1;
    });
    for (std::size_t k = 0; k < 3; ++k) {
      float& here = most[points.pointOf[corner(i + k)]];
      here = std::max(here, tallest);
    }
  }
  std::vector<float> out;
  out.reserve(surface.vertices.size());
  for (const std::uint32_t point : points.pointOf) out.push_back(most[point]);
  return out;
}

void keepBare(std::vector<float>& vertexLengths, const SurfacePoints& points, std::span<const std::uint8_t> materialOf, std::span<const std::uint8_t> bare) {
  std::vector<bool> bald(points.count());
  for (std::size_t i = 0; i < materialOf.size(); ++i)
    if (bare[materialOf[i]]) bald[points.pointOf[i]] = true;
  vertexLengths.resize(points.pointOf.size(), 1.0f);
  for (std::size_t i = 0; i < vertexLengths.size(); ++i)
    if (bald[points.pointOf[i]]) vertexLengths[i] = 0;
}

std::vector<std::uint32_t> furryTriangles(const std::vector<std::uint32_t>& indices, std::span<const float> vertexLengths) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    if (vertexLengths[indices[i]] > 0 || vertexLengths[indices[i + 1]] > 0 || vertexLengths[indices[i + 2]] > 0)
      kept.insert(kept.end(), &indices[i], &indices[i] + 3);
  return kept;
}

std::vector<GroomMap::Texel> picture(const Groom& groom) {
  std::vector<GroomMap::Texel> out;
  out.reserve(groom.map.texels().size());
  for (std::size_t i = 0; i < groom.map.texels().size(); ++i) {
    const GroomMap::Texel &t = groom.map.texels()[i], &paint = groom.paint.texels()[i];
    const int others = t[1] + t[2] + t[3];
    // A tint leaves a third of the other two colours.
    const auto shade = [&](std::size_t k) {
      const int own = t[k + 1], tint = 255 - others + own + (others - own) / 3;
      return static_cast<std::uint8_t>(t[0] * (tint * (255 - paint[3]) + paint[k] * paint[3]) / (255 * 255));
    };
    out.push_back({shade(0), shade(1), shade(2), 255});
  }
  return out;
}

Coverage coverage(const GroomMap& map, const geometry::AtlasTexels& atlas) {
  FUR_ASSERT(atlas.size() == map.size(), "groom::coverage()", "an atlas of the map's size", atlas.size());
  double count = 0, bald = 0, length = 0, types[kTypes] = {};
  for (std::size_t i = 0; i < map.texels().size(); ++i) {
    if (atlas.triangleOf()[i] == geometry::kNoTriangle) continue;
    const GroomMap::Texel& t = map.texels()[i];
    ++count;
    bald += t[0] == 0;
    length += t[0] / 255.0;
    if (t[0] == 0) continue;
    types[0] += (255 - t[1] - t[2] - t[3]) / 255.0;
    for (std::size_t k = 1; k < kTypes; ++k) types[k] += t[k] / 255.0;
  }
  Coverage out;
  if (count == 0) return out;
  out.bald = static_cast<float>(bald / count);
  out.length = static_cast<float>(length / count);
  for (std::size_t k = 0; k < kTypes; ++k) out.types[k] = static_cast<float>(types[k] / std::max(count - bald, 1.0));
  return out;
}

}  // namespace fur::groom
