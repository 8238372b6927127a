#include "groom/Groom.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Assert.h"
#include "geometry/Adjacency.h"
#include "geometry/Weld.h"

namespace fur::groom {

namespace {

GroomMap::Texel sound(GroomMap::Texel t) {
  const int sum = t[1] + t[2] + t[3];
  if (sum > 255)
    for (std::size_t k = 1; k < 4; ++k) t[k] = static_cast<std::uint8_t>(t[k] * 255 / sum);
  return t;
}

}  // namespace

GroomMap::GroomMap(int size)
    : size_(std::clamp(size, kLeastSize, kMostSize)),
      texels_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_), kPlain),
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
  return std::all_of(texels_.begin(), texels_.end(), [](const Texel& texel) { return texel == kPlain; });
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
  std::uint64_t hash = 1469598103934665603ull;
  for (const Texel& texel : texels_)
    for (const std::uint8_t byte : texel) hash = (hash ^ byte) * 1099511628211ull;
  return hash;
}

geometry::TexelRect GroomMap::takeChanged() { return std::exchange(changed_, geometry::TexelRect{}); }

GroomMap resized(const GroomMap& map, int size) {
  GroomMap out(size);
  const auto from = static_cast<std::size_t>(map.size()), to = static_cast<std::size_t>(out.size());
  std::vector<GroomMap::Texel> texels;
  texels.reserve(to * to);
  for (std::size_t y = 0; y < to; ++y)
    for (std::size_t x = 0; x < to; ++x)
      texels.push_back(map.texels()[(2 * y + 1) * from / (2 * to) * from + (2 * x + 1) * from / (2 * to)]);
  out.restore(std::move(texels));
  return out;
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
    const Vec3 across = comb[i] - points.normals[i] * glm::dot(comb[i], points.normals[i]);
    const float squared = glm::dot(across, across);
    if (!(squared < 1e12f)) comb[i] = Vec3(0);  // nor what is not finite
    else comb[i] = squared > kMaxComb * kMaxComb ? across * (kMaxComb / std::sqrt(squared)) : across;
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
  return whiskers.empty() && map.isPlain() && std::all_of(comb.begin(), comb.end(), [](const Vec3& c) { return c == Vec3(0); });
}

Groom plainGroom(int mapSize, const SurfacePoints& points) {
  return {GroomMap(mapSize), std::vector<Vec3>(points.count(), Vec3(0))};
}

std::vector<Vec3> restBends(const Groom& groom, const geometry::Surface& surface, const SurfacePoints& points) {
  FUR_ASSERT(groom.comb.size() == points.count(), "groom::restBends()", "a comb of the surface's points", groom.comb.size());
  std::vector<Vec3> out;
  out.reserve(surface.vertices.size());
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const Vec3& comb = groom.comb[points.pointOf[i]];
    const Vec3& normal = surface.vertices[i].normal;
    out.push_back(comb - normal * glm::dot(comb, normal));
  }
  return out;
}

std::vector<float> vertexLengths(const GroomMap& map, const geometry::Surface& surface, const SurfacePoints& points,
                                 const TypeHeights& heights) {
  const auto heightAt = [&](const Vec4& dressed) {
    float tallest = std::min(2 * (1 - dressed.y - dressed.z - dressed.w), 1.0f) * heights[0];
    for (int k = 1; k < kTypes; ++k) tallest = std::max(tallest, std::min(2 * dressed[k], 1.0f) * heights[static_cast<std::size_t>(k)]);
    return tallest * dressed.x;
  };
  std::vector<float> sum(points.count(), 0.0f), weight(points.count(), 0.0f);
  for (std::size_t i = 0; i < surface.trueVertexCount; ++i) {
    sum[points.pointOf[i]] += heightAt(map.at(surface.vertices[i].atlas));
    weight[points.pointOf[i]] += 1.0f;
  }
  std::vector<float> out;
  out.reserve(surface.vertices.size());
  for (const std::uint32_t point : points.pointOf) out.push_back(sum[point] / std::max(weight[point], 1.0f));
  return out;
}

std::vector<std::uint32_t> furryTriangles(const GroomMap& map, const geometry::Surface& surface,
                                          const std::vector<std::uint32_t>& indices, const TypeHeights& heights) {
  const auto bald = [&heights](const GroomMap::Texel& texel) {
    if (texel[0] == 0) return true;
    bool furry = heights[0] > 0 && texel[1] + texel[2] + texel[3] < 255;
    for (std::size_t k = 1; k < kTypes; ++k) furry |= heights[k] > 0 && texel[k] > 0;
    return !furry;
  };
  if (std::none_of(map.texels().begin(), map.texels().end(), bald)) return indices;
  std::vector<std::uint32_t> kept;
  const auto atlas = [&](std::size_t i) { return surface.vertices[indices[i]].atlas; };
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const geometry::AtlasTriangle flat(atlas(i), atlas(i + 1), atlas(i + 2), map.size());
    // A filtered look-up reaches one texel to each side.
    const geometry::TexelRect box = flat.bounds(1.0f);
    // What has no area in the atlas stays: nobody can say what it shows.
    bool furry = !(flat.area > 0.0f);
    for (int y = box.y0; y < box.y1 && !furry; ++y)
      for (int x = box.x0; x < box.x1 && !furry; ++x)
        furry = !bald(map.texels()[static_cast<std::size_t>(y) * map.size() + x]) && flat.meets(x, y, 1.0f);
    if (furry) kept.insert(kept.end(), &indices[i], &indices[i] + 3);
  }
  return kept;
}

std::vector<GroomMap::Texel> picture(const GroomMap& map) {
  std::vector<GroomMap::Texel> out;
  out.reserve(map.texels().size());
  for (const GroomMap::Texel& t : map.texels()) {
    const int others = t[1] + t[2] + t[3];
    // A tint leaves a third of the other two colours.
    const auto shade = [&](int own) {
      return static_cast<std::uint8_t>(t[0] * (255 - others + own + (others - own) / 3) / 255);
    };
    out.push_back({shade(t[1]), shade(t[2]), shade(t[3]), 255});
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
