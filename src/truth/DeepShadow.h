// How many strands the key light crosses before it reaches a point: a map seen from the light that stores, for each texel, the
// depths of all strands that cross it (a deep shadow map, Lokovic and Veach 2000, without its compression). All strands let
// the same share of light through, so that counting them is enough.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "geometry/Surface.h"
#include "truth/Strands.h"

namespace fur::truth {

class DeepShadow {
 public:
  // `light`: unit, towards it; `texels` along each side. The map covers all tubes and the surface.
  DeepShadow(const geometry::Surface& surface, const Tubes& tubes, const Vec3& light, int texels);

  // The share of light that reaches a point on the axis of a strand with that radius and unit tangent when each strand on the
  // last `reach` model units lets `through` of it pass. Its own strand and what touches it do not count. Smooth
  // between texels.
  float shareThrough(const Vec3& point, float radius, const Vec3& tangent, float through, float reach) const;
  // 0 where skin that is nearer to the light by more than `bias` shades the point, 1 elsewhere; smooth between texels.
  float sharePastSkin(const Vec3& point, float bias) const;

 private:
  Vec3 toMap(const Vec3& p) const;  // xy: texels, z: depth in model units, greater towards the light
  void drawSkin(const geometry::Surface& surface);
  void drawTubes(const Tubes& tubes);
  // Strands of that texel between two depths.
  int countBetween(int x, int y, float low, float high) const;
  // The bilinear mean of `value` over the four texels around a place.
  template <class Value>
  float smooth(const Vec3& place, const Value& value) const;

  Vec3 right_, up_, light_;
  float halfSide_ = 1;  // model units
  int texels_;
  std::vector<float> skin_;           // the depth of the first skin
  std::vector<std::uint32_t> first_;  // where a texel's depths start; one more for the end
  std::vector<float> depths_;         // falling within a texel
};

}  // namespace fur::truth
