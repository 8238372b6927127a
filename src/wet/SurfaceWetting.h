// A droplet on the surface of a model: wets every chart that it touches, with one clump centre in
// space (each chart sees it in its own coordinates).
#pragma once

#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

class SurfaceWetting {
 public:
  // Rasterises the charts at the mask's size, with a gutter of two texels.
  SurfaceWetting(const geometry::Surface& surface, int maskSize);

  // `centre` on the surface, radius in model units. Charts whose normals face away from `normal`
  // (the far side of a thin ear) stay as they are.
  void addDroplet(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
                  const Vec3& centre, const Vec3& normal, float radius, float wetness) const;
  void dryAt(WetnessMask& mask, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
             const Vec3& centre, const Vec3& normal, float radius, float amount) const;

  static constexpr std::uint16_t kNoChart = 0xffff;
  const std::vector<std::uint16_t>& chartOfTexel() const { return chartOfTexel_; }

 private:
  std::vector<std::uint16_t> chartOfTexel_;
};

}  // namespace fur::wet
