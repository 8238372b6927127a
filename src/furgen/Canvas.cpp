#include "furgen/Canvas.h"

#include <algorithm>
#include <cmath>

namespace fur::furgen {

namespace {

// A swept disc, blurred by about a texel, its sum over the texels kept at the area pi r^2 + 2 r l that it
// covers: down to r^2 = 1/3 a truncated cone with edge slope 1, below a cone whose height falls instead of
// its width, so that a strand much finer than a texel still counts for what it covers.
struct SoftCapsule {
  SoftCapsule(float radius, float length) {
    const float squared = radius * radius;
    const bool wide = squared >= 1.0f / 3.0f;
    outer = wide ? std::sqrt(squared - 1.0f / 12.0f) + 0.5f : 1.0f;
    peak = wide ? 1.0f : std::min((kPi * squared + 2.0f * radius * length) / (kPi / 3.0f + length), 1.0f);
  }
  float at(float distance) const { return peak * saturate(outer - distance); }
  float outer, peak;
};

}  // namespace

Canvas::Canvas(int columns, int rows, bool rowsWrap, float pitch)
    : columns_(columns), rows_(rows), rowsWrap_(rowsWrap), pitch_(pitch) {
  const std::size_t texels = static_cast<std::size_t>(columns) * rows;
  cover_.assign(texels, 0), own_.assign(texels, 0), strongest_.assign(texels, 0);
  ownStrand_.assign(texels, 0), owner_.assign(texels, 0);
}

void Canvas::clear() {
  std::fill(cover_.begin(), cover_.end(), 0.0f);
  std::fill(strongest_.begin(), strongest_.end(), 0.0f);
  std::fill(owner_.begin(), owner_.end(), 0u);
}

void Canvas::draw(const Stroke& s, std::uint32_t id) {
  const float squared = s.way.x * s.way.x + s.way.y * s.way.y;
  const SoftCapsule capsule(s.radius, std::sqrt(squared));
  const float inverse = squared > 1e-12f ? 1.0f / squared : 0.0f;
  const Vec2 to = s.from + s.way;
  const auto first = [&](float low, float pitch) { return static_cast<int>(std::ceil((low - capsule.outer) / pitch - 0.5f)); };
  const auto last = [&](float high, float pitch) { return static_cast<int>(std::floor((high + capsule.outer) / pitch - 0.5f)); };
  int y0 = first(std::min(s.from.y, to.y), pitch_), y1 = last(std::max(s.from.y, to.y), pitch_);
  if (!rowsWrap_) y0 = std::max(y0, 0), y1 = std::min(y1, rows_ - 1);
  const int x0 = first(std::min(s.from.x, to.x), 1.0f), x1 = last(std::max(s.from.x, to.x), 1.0f);
  for (int y = y0; y <= y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(rowsWrap_ ? y & (rows_ - 1) : y) * columns_;
    for (int x = x0; x <= x1; ++x) {
      const Vec2 p(static_cast<float>(x) + 0.5f - s.from.x, (static_cast<float>(y) + 0.5f) * pitch_ - s.from.y);
      const float t = saturate((p.x * s.way.x + p.y * s.way.y) * inverse);
      const Vec2 off = p - s.way * t;
      const float share = capsule.at(std::sqrt(off.x * off.x + off.y * off.y));
      if (share <= 0.0f) continue;
      const std::size_t texel = row + static_cast<std::size_t>(x & (columns_ - 1));
      const bool again = cover_[texel] > 0.0f && ownStrand_[texel] == s.strand;
      if (!again || share > own_[texel]) {
        cover_[texel] += again ? share - own_[texel] : share;
        own_[texel] = share;
        ownStrand_[texel] = s.strand;
      }
      if (share > strongest_[texel]) strongest_[texel] = share, owner_[texel] = id;
    }
  }
}

}  // namespace fur::furgen
