// How many strands the key light crosses before it comes to a point: a map seen from the light that keeps, for every
// texel, the depth of each strand that crosses it (a deep shadow map, Lokovic and Veach 2000, without its
// compression: a strand lets a share of the light through, so that the count tells the rest).
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "geometry/Surface.h"
#include "truth/Strands.h"

namespace fur::truth {

class DeepShadow {
 public:
  // `light`: unit, towards it; `texels` along each side. The map takes in all tubes and the surface.
  DeepShadow(const geometry::Surface& surface, const Tubes& tubes, const Vec3& light, int texels);

  // The share of light that comes to a point on the axis of a strand with that radius and unit tangent, when each strand
  // on the last `reach` model units of its way lets `through` of it pass. Its own strand does not count, nor
  // what touches it. Smooth between texels.
  float shareThrough(const Vec3& point, float radius, const Vec3& tangent, float through, float reach) const;
  // The share past the skin, 0 or 1 and smooth between texels: how much of the point's texels no skin shades that is
  // nearer to the light by more than `bias`.
  float sharePastSkin(const Vec3& point, float bias) const;

 private:
  Vec3 toMap(const Vec3& p) const;  // texels, and the depth: model units, rising towards the light
  void drawSkin(const geometry::Surface& surface);
  void drawTubes(const Tubes& tubes);
  // Strands of that texel between two depths.
  int countBetween(int x, int y, float low, float high) const;
  // Mean over the four texels around a place of what `value` gives for each.
  template <class Value>
  float smooth(const Vec3& place, const Value& value) const;

  Vec3 right_, up_, light_;
  float halfSide_ = 1;  // model units
  int texels_;
  std::vector<float> skin_;           // the depth of the skin that the light meets first
  std::vector<std::uint32_t> first_;  // where a texel's depths start; one more for the end
  std::vector<float> depths_;         // falling within a texel
};

}  // namespace fur::truth
