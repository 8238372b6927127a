// Clump centres for water that nobody painted: points spread over the surface at a distance of `spacing` (a Poisson disc
// sampling), to which fur wetted by rain or running water is pulled. The same model gives the same sites.
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
  // `radius`: of the clumps, model units. Sites are missing until find() is done.
  ClumpSites(const SurfaceTexels& texels, float radius);
  // Looks at up to `places` more places; true when sites are spread over all. The result does not depend on the slicing.
  bool find(const SurfaceTexels& texels, std::uint32_t places = 0xffffffffu);

  float radius() const { return radius_; }
  // The place of the nearest site whose normal faces the same way.
  std::uint32_t siteOf(const SurfaceTexels& texels, std::uint32_t place);
  // What Algorithm 1 stores in the place's texel for a droplet at its site: centre and radius in the chart's coordinates.
  Vec3 clumpOf(const SurfaceTexels& texels, const geometry::Surface& surface, const geometry::SurfaceQuery& query,
               const SurfaceWetting& wetting, std::uint32_t place);
  const std::vector<std::uint32_t>& sites() const { return sites_; }

 private:
  template <class Visit>
  void forSitesNear(const Vec3& position, Visit visit) const;
  std::size_t bucketOf(int x, int y, int z) const;

  float radius_ = 0, spacing_ = 0;
  std::uint32_t seen_ = 0, stride_ = 1;  // places that find() has looked at, and from one to the next
  std::vector<std::uint32_t> sites_;          // places
  std::vector<std::uint32_t> heads_, next_;   // buckets of sites by the cell that they lie in
  std::vector<std::uint32_t> siteOf_;         // one a place, index of a site; kNone: not looked up yet
  std::uint32_t last_ = SurfaceTexels::kNone;  // the site looked up last, where the next search begins
  std::vector<SurfaceWetting::Sheet> sheets_;
};

}  // namespace fur::wet
