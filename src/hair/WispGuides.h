// Which three guides a wisp follows, and how much each.
//
// The guides' roots p, as seen from the wisp's root, are mixed by weights w so that |x|^2 + kSpread (sum w |p|^2) is least, where
// x = sum w p is how far the mixture lies from the wisp's root in the tangent plane. Of all ways to
// mix a point, those of Delaunay's triangles have the least sum; so w are barycentric coordinates in them. The first term alone
// would make x the root itself, or the nearest point to it beyond the outermost guides. With the second, x keeps out of
// triangles that are mere slivers, as between guides in a row, along which wisps follow the two next to them.
//
// x depends smoothly on the wisp's root, so that neighbouring wisps follow nearly the same. Guides whose roots' normals oppose
// the wisp's stand on the other side of a sheet and count only where there is no other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "hair/Guides.h"

namespace fur::hair {

// Within a triangle x is moved away from the middle of its circle by this share of the way.
inline constexpr double kSpread = 0.03;

struct Following {
  std::array<std::uint32_t, 3> guides{};  // the same once more where fewer are enough
  Vec3 weights{1, 0, 0};                  // 0..1, of sum 1
};

class WispGuides {
 public:
  // At least one root; kept by reference.
  explicit WispGuides(std::span<const RootFrame> roots);
  Following at(const Vec3& position, const Vec3& normal) const;

 private:
  std::span<const RootFrame> roots_;
  std::vector<double> trifles_;  // one a guide
};

}  // namespace fur::hair
