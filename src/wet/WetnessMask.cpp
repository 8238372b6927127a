#include "wet/WetnessMask.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/Assert.h"
#include "core/Fnv1a.h"
#include "core/NumberText.h"
#include "wet/Drying.h"

namespace fur::wet {

namespace {

// A disc of this radius in texels holds at least one texel centre, wherever it lies.
constexpr float kLeastReach = 0.7072f;

bool usable(const Droplet& droplet) {
  if (!(droplet.shape.x > 0.0f) || !std::isfinite(droplet.shape.y + droplet.shape.z)) return false;
  return std::isfinite(droplet.centre.x) && std::isfinite(droplet.centre.y) && std::isfinite(droplet.radius) &&
         droplet.radius > 0.0f && droplet.wetness > 0.0f;
}

// Calls `change(texel)` for each texel of the chart whose centre lies within the droplet; it returns
// whether the texel is another now. Returns the tight rectangle of those.
template <class Change>
TexelRect visitDisc(int size, const Droplet& droplet, const std::uint16_t* chartOfTexel,
                    std::uint16_t chart, const Change& change) {
  TexelRect changed;
  const float scale = static_cast<float>(size);
  const float reach = std::max(droplet.radius * scale, kLeastReach);
  const Vec2 centre = droplet.centre * scale - 0.5f;  // in texels, whose centres are whole numbers here
  const auto within = [size](float x) { return static_cast<int>(glm::clamp(x, -1.0f, static_cast<float>(size))); };
  const Vec3& shape = droplet.shape;
  const float high = reach * std::sqrt(shape.x);
  const int y0 = std::max(within(std::ceil(centre.y - high)), 0);
  const int y1 = std::min(within(std::floor(centre.y + high)), size - 1);
  for (int y = y0; y <= y1; ++y) {
    const float dy = static_cast<float>(y) - centre.y;
    const float half = std::sqrt(std::max(shape.x * reach * reach - dy * dy, 0.0f)) / shape.x;
    const float middle = centre.x - shape.y * dy / shape.x;
    const int x0 = std::max(within(std::ceil(middle - half)), 0);
    const int x1 = std::min(within(std::floor(middle + half)), size - 1);
    for (int x = x0; x <= x1; ++x) {
      const std::size_t texel = static_cast<std::size_t>(y) * size + x;
      if (chartOfTexel && chartOfTexel[texel] != chart) continue;
      if (change(texel)) changed.include(x, y);
    }
  }
  return changed;
}

// Silva Algorithm 1 for one texel.
void blend(Vec4& texel, const Droplet& droplet, float radius, float wetness) {
  const bool near = squaredIn(droplet.shape, Vec2(texel) - droplet.centre) <= droplet.radius * droplet.radius;
  const Vec4 drop(droplet.centre.x, droplet.centre.y, radius, wetness);
  // As printed, a dry texel is one whose stored centre (0, 0) happens to be far away, and droplets
  // near the origin never take hold: the wetness says what is dry.
  if (texel.w <= 0.0f || !near) {
    texel = drop;
  } else {
    const float total = std::min(texel.w + wetness, 1.0f);
    const float alpha = wetness / total;
    texel += (drop - texel) * alpha;
    texel.w = total;
  }
}

}  // namespace

WetnessMask::WetnessMask(int size)
    : size_(std::clamp(size, 16, 2048)), texels_(static_cast<std::size_t>(size_) * size_, Vec4(0)), changed_(size_) {}

TexelRect WetnessMask::addDroplet(const Droplet& droplet, const std::uint16_t* chartOfTexel, std::uint16_t chart) {
  if (!usable(droplet)) return {};
  const float wetness = std::min(droplet.wetness, 1.0f);
  const bool round = droplet.shape == Vec3(1, 0, 1);
  const TexelRect changed = visitDisc(size_, droplet, chartOfTexel, chart, [&](std::size_t at) {
    Vec4& texel = texels_[at];
    const Vec4 before = texel;
    wetTexels_ += texel.w <= 0.0f;
    const Vec2 way = texelCentre(at) - droplet.centre;
    const float squared = glm::dot(way, way);
    const bool even = round || !(squared > 0.0f);
    blend(texel, droplet, even ? droplet.radius : droplet.radius * std::sqrt(squared / squaredIn(droplet.shape, way)), wetness);
    const float spilt = before.w + wetness - texel.w;
    if (spilt > 0.0f) setFilm(at, filmAt(at) + spilt);
    return texel != before || spilt > 0.0f;
  });
  note(changed);
  return changed;
}

TexelRect WetnessMask::dryAt(const Droplet& brush, const std::uint16_t* chartOfTexel, std::uint16_t chart) {
  if (!usable(brush) || isDry()) return {};
  const TexelRect changed = visitDisc(size_, brush, chartOfTexel, chart,
                                      [&](std::size_t texel) { return lower(texel, brush.wetness); });
  note(changed);
  return changed;
}

bool WetnessMask::lower(std::size_t at, float amount) {
  const float film = filmAt(at), before = texels_[at].w;
  if (film > 0.0f) setFilm(at, std::max(film - amount, 0.0f));
  if (before <= 0.0f) return film > 0.0f;
  texels_[at].w -= amount;
  if (texels_[at].w <= 0.0f) {
    texels_[at] = Vec4(0);
    --wetTexels_;
  }
  return film > 0.0f || texels_[at].w != before;
}

TexelRect WetnessMask::dry(float seconds, float rate) {
  const float drying = longDrying(seconds * rate);
  if (!(drying > 0.0f) || isDry()) return {};
  TexelRect changed;
  for (int y = 0; y < size_; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * size_;
    int first = size_, last = -1;
    for (int x = 0; x < size_; ++x)
      if (lower(row + x, dryingLoss(texels_[row + x].w, drying))) first = std::min(first, x), last = x;
    if (last >= 0) changed = unite(changed, {first, y, last + 1, y + 1});
  }
  note(changed);
  return changed;
}

void WetnessMask::clear() {
  if (isDry()) return;
  TexelRect changed;
  for (int y = 0; y < size_; ++y)
    for (int x = 0; x < size_; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * size_ + x;
      if (texels_[at].w <= 0.0f && filmAt(at) <= 0.0f) continue;
      texels_[at] = Vec4(0);
      changed.include(x, y);
    }
  wetTexels_ = filmTexels_ = 0;
  film_.clear();
  note(changed);
}

void WetnessMask::restore(std::vector<Vec4> texels, std::vector<float> film) {
  FUR_ASSERT(texels.size() == texels_.size() && (film.empty() || film.size() == texels_.size()), "WetnessMask::restore()",
             decimal(texels_.size()).c_str(), texels.size());
  texels_ = std::move(texels);
  film_ = std::move(film);
  wetTexels_ = filmTexels_ = 0;
  for (Vec4& texel : texels_) {
    const bool sound = std::isfinite(texel.x + texel.y + texel.z + texel.w) && texel.w > 0.0f && texel.z > 0.0f;
    if (!sound) texel = Vec4(0);
    texel.w = std::min(texel.w, 1.0f);
    wetTexels_ += sound;
  }
  for (float& water : film_) {
    if (!(water > 0.0f && water < 1e6f)) water = 0.0f;
    filmTexels_ += water > 0.0f;
  }
  note({0, 0, size_, size_});
}

void WetnessMask::note(const TexelRect& changed) {
  if (changed.empty()) return;
  ++revision_;
  painted_ = unite(painted_, changed);
  touch(changed);
}

float WetnessMask::meanWetness() const {
  if (isDry()) return 0.0f;
  double sum = 0;
  for (const Vec4& texel : texels_) sum += texel.w;
  return static_cast<float>(sum / static_cast<double>(texels_.size()));
}

std::size_t WetnessMask::indexAt(float u, float v) const {
  const auto index = [this](float c) {
    return std::isnan(c) ? 0 : static_cast<int>(saturate(c) * static_cast<float>(size_) * 0.9999999f);
  };
  return static_cast<std::size_t>(index(v)) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(index(u));
}

std::uint64_t WetnessMask::hash() const {
  Fnv1a hash;
  hash.addAll(texels_);
  return hash.value();
}

}  // namespace fur::wet
