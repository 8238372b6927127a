// Where the fur is wet, and to which clump it belongs (Silva et al. 2010, 3.1, Algorithm 1).
// Does not know the model: a droplet acts in the plane of the atlas. SurfaceWetting carries it over charts.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "geometry/AtlasTexels.h"

namespace fur::wet {

// Atlas units: (u, v) in [0, 1]^2, radius in the same.
struct Droplet {
  Vec2 centre{0.5f};
  float radius = 0.05f;
  float wetness = 0.5f;  // 0..1
};

using geometry::TexelRect;

class WetnessMask {
 public:
  explicit WetnessMask(int size = 256);  // 16..2048

  int size() const { return size_; }
  // Row-major; a texel is (clump centre u, v, clump radius, wetness). All 0 where dry.
  const std::vector<Vec4>& texels() const { return texels_; }

  // Algorithm 1, read as: a dry texel takes the droplet; a wet one blends when the centres lie
  // within the droplet's radius, else the droplet starts a clump of its own there.
  // A texel counts by its centre; a droplet finer than a texel still wets the texel it falls on.
  // Non-finite droplets and those of no radius or wetness do nothing. Returns what changed.
  // `chartOfTexel` (size*size, may be null) limits it to the texels of `chart`: circles must not
  // spill over a gutter into a stranger.
  TexelRect addDroplet(const Droplet& droplet, const std::uint16_t* chartOfTexel = nullptr, std::uint16_t chart = 0);
  // Lowers the wetness within the radius; takes water away, never moves a clump's centre.
  TexelRect dryAt(const Droplet& brush, const std::uint16_t* chartOfTexel = nullptr, std::uint16_t chart = 0);
  // Lowers the wetness of every wet texel by rate * seconds; a texel that reaches 0 forgets its clump.
  TexelRect dry(float seconds, float rate);
  void clear();
  // size * size of them; unsound ones (not finite, no radius) become dry.
  void restore(std::vector<Vec4> texels);

  bool isDry() const { return wetTexels_ == 0; }
  float meanWetness() const;
  Vec4 at(float u, float v) const;
  // FNV-1a over the bytes of the texels.
  std::uint64_t hash() const;
  // What changed since the last call: what the renderer uploads.
  TexelRect takeChanged();

 private:
  bool lower(Vec4& texel, float amount);

  int size_;
  std::vector<Vec4> texels_;
  std::size_t wetTexels_ = 0;
  TexelRect changed_;
};

}  // namespace fur::wet
