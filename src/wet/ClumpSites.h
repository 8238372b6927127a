// Where clumps form by themselves: points all over the surface, no two nearer than `spacing` and none farther from
// the next, to which fur that running water or rain wets is drawn. The same model gives the same sites.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/SurfaceQuery.h"
#include "wet/SurfaceTexels.h"
#include "wet/SurfaceWetting.h"

namespace fur::wet {

class ClumpSites {
 public:
  ClumpSites() = default;
  // `radius`: of the clumps, model units.
  ClumpSites(const SurfaceTexels& texels, float radius);

  float radius() const { return radius_; }
  // The place in whose middle the nearest site lies, of those that face the same way.
  std::uint32_t siteOf(const SurfaceTexels& texels, std::uint32_t place);
  // What Algorithm 1 stores in that texel for a droplet at its site: centre and radius as its chart sees them.
  Vec3 clumpOf(const SurfaceTexels& texels, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
               const SurfaceWetting& wetting, std::uint32_t place);
  const std::vector<std::uint32_t>& sites() const { return sites_; }

 private:
  template <class Visit>
  void forSitesNear(const Vec3& position, Visit visit) const;
  std::size_t bucketOf(int x, int y, int z) const;

  float radius_ = 0, spacing_ = 0;
  std::vector<std::uint32_t> sites_;          // places
  std::vector<std::uint32_t> heads_, next_;   // buckets of sites by the cell that they lie in
  std::vector<std::uint32_t> siteOf_;         // one a place, index of a site; kNone: not asked for yet
  std::uint32_t last_ = SurfaceTexels::kNone;  // the site that was asked for last: its neighbours follow
  std::vector<SurfaceWetting::Sheet> sheets_;
};

}  // namespace fur::wet
