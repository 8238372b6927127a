#include "wet/WetnessMask.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/Assert.h"

namespace fur::wet {

namespace {

// A disc of this radius in texels holds at least one texel centre, wherever it lies.
constexpr float kLeastReach = 0.7072f;

bool usable(const Droplet& droplet) {
  return std::isfinite(droplet.centre.x) && std::isfinite(droplet.centre.y) && std::isfinite(droplet.radius) &&
         droplet.radius > 0.0f && droplet.wetness > 0.0f;
}

// Calls `change(texel)` for each texel of the chart whose centre lies within the droplet; it returns
// whether the texel is another now. Returns the tight rectangle of those.
template <class Change>
TexelRect visitDisc(std::vector<Vec4>& texels, int size, const Droplet& droplet, const std::uint16_t* chartOfTexel,
                    std::uint16_t chart, const Change& change) {
  TexelRect changed;
  const float scale = static_cast<float>(size);
  const float reach = std::max(droplet.radius * scale, kLeastReach);
  const Vec2 centre = droplet.centre * scale - 0.5f;  // in texels, whose centres are whole numbers here
  const auto within = [size](float x) { return static_cast<int>(glm::clamp(x, -1.0f, static_cast<float>(size))); };
  const int y0 = std::max(within(std::ceil(centre.y - reach)), 0);
  const int y1 = std::min(within(std::floor(centre.y + reach)), size - 1);
  for (int y = y0; y <= y1; ++y) {
    const float dy = static_cast<float>(y) - centre.y;
    const float half = std::sqrt(std::max(reach * reach - dy * dy, 0.0f));
    const int x0 = std::max(within(std::ceil(centre.x - half)), 0);
    const int x1 = std::min(within(std::floor(centre.x + half)), size - 1);
    for (int x = x0; x <= x1; ++x) {
      const std::size_t texel = static_cast<std::size_t>(y) * size + x;
      if (chartOfTexel && chartOfTexel[texel] != chart) continue;
      if (change(texels[texel])) changed.include(x, y);
    }
  }
  return changed;
}

// Silva Algorithm 1 for one texel.
bool blend(Vec4& texel, const Droplet& droplet, float wetness) {
  const Vec4 before = texel;
  const float dx = texel.x - droplet.centre.x, dy = texel.y - droplet.centre.y;
  const bool near = dx * dx + dy * dy <= droplet.radius * droplet.radius;
  const Vec4 drop(droplet.centre.x, droplet.centre.y, droplet.radius, wetness);
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
  return texel != before;
}

}  // namespace

WetnessMask::WetnessMask(int size)
    : size_(std::clamp(size, 16, 2048)), texels_(static_cast<std::size_t>(size_) * size_, Vec4(0)) {}

TexelRect WetnessMask::addDroplet(const Droplet& droplet, const std::uint16_t* chartOfTexel, std::uint16_t chart) {
  if (!usable(droplet)) return {};
  const float wetness = std::min(droplet.wetness, 1.0f);
  const TexelRect changed = visitDisc(texels_, size_, droplet, chartOfTexel, chart, [&](Vec4& texel) {
    wetTexels_ += texel.w <= 0.0f;
    return blend(texel, droplet, wetness);
  });
  changed_ = unite(changed_, changed);
  return changed;
}

TexelRect WetnessMask::dryAt(const Droplet& brush, const std::uint16_t* chartOfTexel, std::uint16_t chart) {
  if (!usable(brush) || isDry()) return {};
  const TexelRect changed = visitDisc(texels_, size_, brush, chartOfTexel, chart, [&](Vec4& texel) {
    return lower(texel, brush.wetness);
  });
  changed_ = unite(changed_, changed);
  return changed;
}

bool WetnessMask::lower(Vec4& texel, float amount) {
  if (texel.w <= 0.0f) return false;
  const float before = texel.w;
  texel.w -= amount;
  if (texel.w <= 0.0f) {
    texel = Vec4(0);
    --wetTexels_;
  }
  return texel.w != before;
}

TexelRect WetnessMask::dry(float seconds, float rate) {
  const float amount = seconds * rate;
  if (!(amount > 0.0f) || isDry()) return {};
  TexelRect changed;
  for (int y = 0; y < size_; ++y) {
    Vec4* row = &texels_[static_cast<std::size_t>(y) * size_];
    int first = size_, last = -1;
    for (int x = 0; x < size_; ++x)
      if (lower(row[x], amount)) first = std::min(first, x), last = x;
    if (last >= 0) changed = unite(changed, {first, y, last + 1, y + 1});
  }
  changed_ = unite(changed_, changed);
  return changed;
}

void WetnessMask::clear() {
  if (isDry()) return;
  TexelRect changed;
  for (int y = 0; y < size_; ++y)
    for (int x = 0; x < size_; ++x) {
      Vec4& texel = texels_[static_cast<std::size_t>(y) * size_ + x];
      if (texel.w <= 0.0f) continue;
      texel = Vec4(0);
      changed.include(x, y);
    }
  wetTexels_ = 0;
  changed_ = unite(changed_, changed);
}

void WetnessMask::restore(std::vector<Vec4> texels) {
  FUR_ASSERT(texels.size() == texels_.size(), "WetnessMask::restore()", std::to_string(texels_.size()).c_str(),
             texels.size());
  texels_ = std::move(texels);
  wetTexels_ = 0;
  for (Vec4& texel : texels_) {
    const bool sound = std::isfinite(texel.x + texel.y + texel.z + texel.w) && texel.w > 0.0f && texel.z > 0.0f;
    if (!sound) texel = Vec4(0);
    texel.w = std::min(texel.w, 1.0f);
    wetTexels_ += sound;
  }
  changed_ = {0, 0, size_, size_};
}

float WetnessMask::meanWetness() const {
  if (isDry()) return 0.0f;
  double sum = 0;
  for (const Vec4& texel : texels_) sum += texel.w;
  return static_cast<float>(sum / static_cast<double>(texels_.size()));
}

Vec4 WetnessMask::at(float u, float v) const {
  const auto index = [this](float c) {
    return std::isnan(c) ? 0 : static_cast<int>(saturate(c) * static_cast<float>(size_) * 0.9999999f);
  };
  return texels_[static_cast<std::size_t>(index(v)) * size_ + index(u)];
}

std::uint64_t WetnessMask::hash() const {
  std::uint64_t hash = 1469598103934665603ull;
  const auto* bytes = reinterpret_cast<const unsigned char*>(texels_.data());
  for (std::size_t i = 0; i < texels_.size() * sizeof(Vec4); ++i) hash = (hash ^ bytes[i]) * 1099511628211ull;
  return hash;
}

TexelRect WetnessMask::takeChanged() { return std::exchange(changed_, TexelRect{}); }

}  // namespace fur::wet
