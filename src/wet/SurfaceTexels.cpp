#include "wet/SurfaceTexels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/Adjacency.h"

namespace fur::wet {

namespace {

using geometry::Surface;

const geometry::SurfaceVertex& corner(const Surface& surface, std::uint32_t triangle, std::size_t k) {
  return surface.vertices[surface.indices[std::size_t{3} * triangle + k]];
}

// Steps along the surface for one unit of u and of v; both 0 where the triangle has no area in the atlas.
std::pair<Vec3, Vec3> stepsAlong(const Surface& surface, std::uint32_t triangle) {
  const auto &a = corner(surface, triangle, 0), &b = corner(surface, triangle, 1), &c = corner(surface, triangle, 2);
  const Vec2 ab = b.atlas - a.atlas, ac = c.atlas - a.atlas;
  const Vec3 up = b.position - a.position, over = c.position - a.position;
  const float area = ab.x * ac.y - ab.y * ac.x;
  if (!(std::abs(area) > 1e-14f)) return {Vec3(0), Vec3(0)};
  return {(up * ac.y - over * ab.y) / area, (over * ab.x - up * ac.x) / area};
}

}  // namespace

SurfaceTexels::SurfaceTexels(const Surface& surface, const geometry::AtlasTexels& atlas)
    : size_(atlas.size()), placeOf_(atlas.triangleOf().size(), kNone) {
  const float texel = 1.0f / static_cast<float>(size_);
  const std::size_t free = std::count(atlas.triangleOf().begin(), atlas.triangleOf().end(), geometry::kNoTriangle), most = placeOf_.size() - free;
  places_.reserve(most);
  blockOf_.reserve(most);
  for (int y0 = 0; y0 < size_; y0 += kBlock)
    for (int x0 = 0; x0 < size_; x0 += kBlock) {
      Block block{static_cast<std::uint32_t>(places_.size()), 0, {}, Vec3(0), 0};
      constexpr int kRim = geometry::AtlasTexels::kGutter;
      block.rect = {std::max(x0 - kRim, 0), std::max(y0 - kRim, 0), std::min(x0 + kBlock + kRim, size_), std::min(y0 + kBlock + kRim, size_)};
      Vec3 low(1e9f), high(-1e9f);
      for (int y = y0; y < std::min(y0 + kBlock, size_); ++y)
        for (int x = x0; x < std::min(x0 + kBlock, size_); ++x) {
          const auto at = static_cast<std::uint32_t>(y * size_ + x);
          const std::uint32_t triangle = atlas.triangleOf()[at];
          if (triangle == geometry::kNoTriangle) continue;
          const geometry::SurfacePoint point{triangle, atlas.weightsAt(surface, triangle, at), 0};
          const auto [alongU, alongV] = stepsAlong(surface, triangle);
          const float area = glm::length(glm::cross(alongU, alongV)) * texel * texel;
          // Where nothing of the surface lies on a texel it can hold no water.
          if (!(area > 1e-12f)) continue;
          placeOf_[at] = static_cast<std::uint32_t>(places_.size());
          blockOf_.push_back(static_cast<std::uint32_t>(blocks_.size()));
          places_.push_back({positionAt(surface, point), normalAt(surface, point), area, at, triangle});
          low = glm::min(low, places_.back().position);
          high = glm::max(high, places_.back().position);
        }
      block.end = static_cast<std::uint32_t>(places_.size());
      if (block.end == block.first) continue;
      block.centre = 0.5f * (low + high);
      block.radius = 0.5f * glm::length(high - low);
      blocks_.push_back(block);
    }

  Links none;
  none.fill(kNone);
  links_.assign(places_.size(), none);

  // A triangle that is squeezed in the atlas gives its texels more than there is, one finer than a texel gets a whole one.
  double area = 0;
  for (std::uint32_t t = 0; t < surface.triangleCount(); ++t) {
    const Vec3 a = corner(surface, t, 0).position, b = corner(surface, t, 1).position, c = corner(surface, t, 2).position;
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  const float mostArea = static_cast<float>(8 * area / static_cast<double>(std::max<std::size_t>(places_.size(), 1)));
  double sum = 0;
  for (Place& place : places_) sum += place.area = std::min(place.area, mostArea);
  for (Place& place : places_) place.area *= static_cast<float>(area / sum);
  meanWidth_ = static_cast<float>(std::sqrt(area / static_cast<double>(std::max<std::size_t>(places_.size(), 1))));

  // Gutters, by the place that they repeat.
  mirrorStart_.assign(places_.size() + 1, 0);
  for (const auto& [at, source] : atlas.gutter())
    if (placeOf_[source] != kNone) ++mirrorStart_[placeOf_[source] + 1];
  for (std::size_t i = 1; i < mirrorStart_.size(); ++i) mirrorStart_[i] += mirrorStart_[i - 1];
  mirrors_.resize(mirrorStart_.back());
  std::vector<std::uint32_t> next(mirrorStart_.begin(), mirrorStart_.end() - 1);
  for (const auto& [at, source] : atlas.gutter())
    if (placeOf_[source] != kNone) mirrors_[next[placeOf_[source]]++] = at;
  for (Block& block : blocks_) block.repeated = mirrorStart_[block.end] > mirrorStart_[block.first];
  // Only now: a gutter texel is nobody's source.
  for (const auto& [at, source] : atlas.gutter()) placeOf_[at] = placeOf_[source];
}

std::uint32_t SurfaceTexels::placeAt(const Vec2& atlas) const {
  const auto index = [this](float c) {
    return static_cast<std::uint32_t>(glm::clamp(c * static_cast<float>(size_), 0.0f, static_cast<float>(size_ - 1)));
  };
  return placeOf_[index(atlas.y) * static_cast<std::uint32_t>(size_) + index(atlas.x)];
}

std::pair<Vec3, Vec3> SurfaceTexels::stepsAt(const Surface& surface, std::uint32_t place) const {
  const auto [alongU, alongV] = stepsAlong(surface, places_[place].triangle);
  return {alongU / static_cast<float>(size_), alongV / static_cast<float>(size_)};
}

Vec2 SurfaceTexels::partsOf(const Surface& surface, std::uint32_t place, const Vec3& direction) const {
  constexpr float kNoStep = 1e-12f;  // squared
  const auto [u, v] = stepsAt(surface, place);
  const float uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), along = glm::dot(direction, u), across = glm::dot(direction, v);
  const float area = uu * vv - uv * uv;
  if (area > 0.05f * uu * vv) return Vec2(along * vv - across * uv, across * uu - along * uv) / area;
  return {uu > kNoStep ? along / uu : 0.0f, vv > kNoStep ? across / vv : 0.0f};
}

bool SurfaceTexels::link(const Surface& surface, const geometry::SurfaceQuery& query, std::uint32_t count) {
  const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(places_.size(), std::size_t{linked_} + count));
  for (; linked_ < end; ++linked_) {
    const Place& place = places_[linked_];
    const int x = static_cast<int>(place.texel) % size_, y = static_cast<int>(place.texel) / size_;
    for (int side = 0; side < kSides; ++side) {
      std::uint32_t& link = links_[linked_][static_cast<std::size_t>(side)];
      const int nx = x + kSteps[side][0], ny = y + kSteps[side][1];
      const bool inside = nx >= 0 && ny >= 0 && nx < size_ && ny < size_;
      link = inside ? placeOf_[static_cast<std::size_t>(ny) * size_ + nx] : kNone;
      if (link != kNone && places_[link].texel == static_cast<std::uint32_t>(ny * size_ + nx) &&
          corner(surface, places_[link].triangle, 0).chart == corner(surface, place.triangle, 0).chart)
        continue;
      constexpr float kAside = 0.3f;
      link = acrossBorder(surface, query, linked_, side, kAside);
      const std::uint32_t other = acrossBorder(surface, query, linked_, side, -kAside);
      if (link == kNone) link = other;
      if (other != kNone && other != link) crossings_.push_back({linked_, side, {link, other}});
    }
  }
  if (linked_ < places_.size()) return false;
  if (besideStart_.empty()) joinBlocks();
  return true;
}

void SurfaceTexels::joinBlocks() {
  besideStart_ = crossingStart_ = {0};
  std::uint32_t crossing = 0;
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    const auto begin = static_cast<std::ptrdiff_t>(besideBlocks_.size());
    const auto join = [&](std::uint32_t place) {
      if (place == kNone || blockOf_[place] == b) return;
      if (std::find(besideBlocks_.begin() + begin, besideBlocks_.end(), blockOf_[place]) == besideBlocks_.end()) besideBlocks_.push_back(blockOf_[place]);
    };
    for (std::uint32_t i = blocks_[b].first; i < blocks_[b].end; ++i)
      for (const std::uint32_t link : links_[i]) join(link);
    for (; crossing < crossings_.size() && crossings_[crossing].from < blocks_[b].end; ++crossing)
      for (const std::uint32_t to : crossings_[crossing].to) join(to);
    besideStart_.push_back(static_cast<std::uint32_t>(besideBlocks_.size()));
    crossingStart_.push_back(crossing);
  }
}

// The place a step away, and so much of a step to the left of it.
std::uint32_t SurfaceTexels::acrossBorder(const Surface& surface, const geometry::SurfaceQuery& query, std::uint32_t index,
                                          int side, float aside) const {
  const Place& place = places_[index];
  const auto [alongU, alongV] = stepsAt(surface, index);
  const float u = static_cast<float>(kSteps[side][0]), v = static_cast<float>(kSteps[side][1]);
  Vec3 step = alongU * (u - aside * v) + alongV * (v + aside * u);
  // A triangle that is squeezed in the atlas must not send its water far away.
  const float length = glm::length(step), most = 2.0f * std::sqrt(place.area);
  if (length > most) step *= most / length;
  // From a little below the skin, as it may turn down over an edge.
  const float wide = glm::length(step);
  const auto placeAfter = [&](float reach) {
    const auto hit = nearestPoint(surface, query, place.position + reach * (step - 0.4f * wide * place.normal), 0.8f * wide, place.normal);
    const std::uint32_t there = hit ? placeAt(atlasAt(surface, *hit)) : kNone;
    return there == index ? kNone : there;
  };
  const auto beside = [&](std::uint32_t there) {
    const int to = static_cast<int>(places_[there].texel), from = static_cast<int>(place.texel);
    return std::abs(to % size_ - from % size_) <= 1 && std::abs(to / size_ - from / size_) <= 1;
  };
  // One step may end on this very place still.
  std::uint32_t there = kNone;
  for (const float reach : {1.0f, 1.35f, 1.7f})
    if (there = placeAfter(reach); there != kNone) break;
  if (there == kNone || beside(there)) return there;
  // The first place behind the border: further on a row of them would be left dry.
  for (const float reach : {0.55f, 0.8f})
    if (const std::uint32_t nearer = placeAfter(reach); nearer != kNone && !beside(nearer)) return nearer;
  return there;
}

}  // namespace fur::wet
