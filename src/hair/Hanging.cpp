#include "hair/Hanging.h"

#include <algorithm>

namespace fur::hair {

namespace {

// A place that lies below the skin, or nearer to it than the clearance, comes out of it; its side is told by the node before.
Vec3 outside(const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& at, const Vec3& outward, float clearance) {
  constexpr float kReach = 0.6f;  // model units: no segment gets deeper
  const auto near = geometry::nearestPoint(surface, query, at, kReach, outward);
  if (!near) return at;
  const Vec3 skin = positionAt(surface, *near), normal = normalAt(surface, *near);
  const float height = glm::dot(at - skin, normal);
  return height < clearance ? at + normal * (clearance - height) : at;
}

bool hangOne(std::span<Vec3> chain, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& down, float share, float clearance) {
  const std::vector<Vec3> before(chain.begin(), chain.end());
  Vec3 outward = normalizeOr(chain[1] - chain[0], Vec3(0, 1, 0));
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec3 segment = before[i] - before[i - 1];
    const float length = glm::length(segment), up = static_cast<float>(i) / static_cast<float>(chain.size() - 1);
    // A soft bend out of the skin, then down.
    const float turn = share * std::min(1.0f, 2 * up);
    const Vec3 wanted = normalizeOr(glm::mix(normalizeOr(segment, outward), down, turn), outward);
    const Vec3 free = outside(surface, query, chain[i - 1] + wanted * length, outward, clearance);
    chain[i] = chain[i - 1] + normalizeOr(free - chain[i - 1], wanted) * length;
  }
  return !std::equal(chain.begin(), chain.end(), before.begin());
}

}  // namespace

bool hang(Guides& guides, const geometry::Surface& surface, const geometry::SurfaceQuery& query, const Vec3& down, float share, float clearance) {
  const Vec3 way = normalizeOr(down, Vec3(0));
  if (way == Vec3(0) || !(share > 0)) return false;
  bool changed = false;
  for (std::size_t g = 0; g < guides.count(); ++g)
    if (!(guides.flags[g] & kHidden)) changed |= hangOne(guides.of(g), surface, query, way, std::min(share, 1.0f), clearance);
  return changed;
}

}  // namespace fur::hair
