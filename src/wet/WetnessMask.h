// Where the fur is wet, and to which clump it belongs (Silva et al. 2010, 3.1, Algorithm 1).
// Does not know the model: a droplet acts in the plane of the atlas. SurfaceWetting maps it onto the charts.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/Math.h"
#include "geometry/AtlasTexels.h"
#include "wet/ChangedTiles.h"

namespace fur::wet {

// Atlas units: (u, v) in [0, 1]^2, radius in the same.
struct Droplet {
  Vec2 centre{0.5f};
  float radius = 0.05f;
  float wetness = 0.5f;  // 0..1
  // An ellipse, as the atlas may stretch the skin: shape.x du^2 + 2 shape.y du dv + shape.z dv^2 <= radius^2, with
  // x z - y^2 = 1. (1, 0, 1) is the paper's circle.
  Vec3 shape{1, 0, 1};
};

// shape.x du^2 + 2 shape.y du dv + shape.z dv^2
inline float squaredIn(const Vec3& shape, const Vec2& way) {
  return shape.x * way.x * way.x + 2.0f * shape.y * way.x * way.y + shape.z * way.y * way.y;
}

using geometry::TexelRect;

class WetnessMask {
 public:
  explicit WetnessMask(int size = 256);  // 16..2048

  int size() const { return size_; }
  // Row-major; a texel is (clump centre u, v, clump radius, wetness). All 0 where dry.
  const std::vector<Vec4>& texels() const { return texels_; }
  // Row-major: the water on the fur beyond what it holds, in units of what it holds at wetness 1. Empty while there is none.
  // Water that Algorithm 1 drops (above 1, or of a clump that is replaced) goes here, so that no water is lost.
  const std::vector<float>& film() const { return film_; }
  float filmAt(std::size_t texel) const { return film_.empty() ? 0.0f : film_[texel]; }

  // Algorithm 1: a dry texel takes the droplet; a wet one blends with it when the centres lie within the droplet's radius, else
  // the droplet starts a new clump there. For an ellipse, each texel stores the radius in its direction from the centre.
  // A texel counts by its centre; a droplet smaller than a texel wets the texel under it. Droplets that are not finite, or
  // without radius or wetness, do nothing. Returns the changed rectangle.
  // `chartOfTexel` (size*size, may be null) limits the droplet to texels of `chart`.
  TexelRect addDroplet(const Droplet& droplet, const std::uint16_t* chartOfTexel = nullptr, std::uint16_t chart = 0);
  // Lowers the wetness within the radius; takes water away, never moves a clump's centre.
  TexelRect dryAt(const Droplet& brush, const std::uint16_t* chartOfTexel = nullptr, std::uint16_t chart = 0);
  // Dries all of it as fur dries in still air (Drying.h); a texel that reaches 0 forgets its clump.
  TexelRect dry(float seconds, float rate);
  void clear();
  // size * size texels; invalid ones (not finite, no radius) become dry.
  void restore(std::vector<Vec4> texels, std::vector<float> film = {});
  // Sets one texel, for Water.h; the caller reports the changed rectangle with touch().
  void set(std::uint32_t texel, const Vec4& value, float film) {
    wetTexels_ += static_cast<std::size_t>(value.w > 0.0f) - static_cast<std::size_t>(texels_[texel].w > 0.0f);
    texels_[texel] = value;
    setFilm(texel, film);
  }
  // The same for a texel that is wet and stays wet, which keeps its clump. `before`: its filmAt().
  void setWater(std::uint32_t texel, float wetness, float film, float before) {
    texels_[texel].w = wetness;
    if (film == before) return;
    if (film_.empty()) film_.assign(texels_.size(), 0.0f);
    filmTexels_ += static_cast<std::size_t>(film > 0.0f) - static_cast<std::size_t>(before > 0.0f);
    film_[texel] = film;
  }
  void touch(const TexelRect& changed) { changed_.note(changed); }

  // In atlas units.
  Vec2 texelCentre(std::size_t texel) const {
    const auto size = static_cast<std::size_t>(size_);
    return (Vec2(texel % size, texel / size) + 0.5f) / static_cast<float>(size_);
  }

  bool isDry() const { return wetTexels_ == 0 && filmTexels_ == 0; }
  // Changes with every change other than set() and setWater(); and the rectangle of those since the last call.
  std::uint32_t revision() const { return revision_; }
  TexelRect takePainted() { return std::exchange(painted_, TexelRect{}); }
  float meanWetness() const;
  // Of texels().
  std::size_t indexAt(float u, float v) const;
  Vec4 at(float u, float v) const { return texels_[indexAt(u, v)]; }
  // FNV-1a over the bytes of the texels; a film is not part of it.
  std::uint64_t hash() const;
  // What changed since the last call: what the renderer uploads. One rectangle round all of it, or a few that are
  // smaller together.
  TexelRect takeChanged() { return changed_.take(); }
  std::vector<TexelRect> takeChangedParts() { return changed_.takeParts(); }

 private:
  bool lower(std::size_t texel, float amount);
  void setFilm(std::size_t texel, float value) {
    if (film_.empty()) {
      if (value == 0.0f) return;
      film_.assign(texels_.size(), 0.0f);
    }
    filmTexels_ += static_cast<std::size_t>(value > 0.0f) - static_cast<std::size_t>(film_[texel] > 0.0f);
    film_[texel] = value;
  }
  void note(const TexelRect& changed);

  int size_;
  std::vector<Vec4> texels_;
  std::vector<float> film_;
  std::size_t wetTexels_ = 0, filmTexels_ = 0;
  std::uint32_t revision_ = 0;
  ChangedTiles changed_;
  TexelRect painted_;
};

}  // namespace fur::wet
