// Rays and nearest points against a surface, through a bounding volume hierarchy.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/Surface.h"

namespace fur::geometry {

struct SurfacePoint {
  std::uint32_t triangle;  // index of its first corner is 3 * triangle
  Vec3 weights;            // barycentric
  float distance;          // along the ray (in lengths of its direction), or from the point asked for
};

// Keeps no reference to the surface.
class SurfaceQuery {
 public:
  SurfaceQuery() = default;
  explicit SurfaceQuery(const Surface& surface);

  // Refits the hierarchy to moved vertices: faster than a new one, and as good while neighbours stay neighbours.
  void follow(const Surface& surface, std::span<const Vec3> positions);

  // Another position for each corner (of Surface::indices), at most `reach` from its own: the coat's outside, for example.
  struct Lifted {
    float reach = 0;
    virtual Vec3 corner(std::uint32_t index) const = 0;

   protected:
    ~Lifted() = default;
  };

  // The nearest hit with a distance above 0 and not above `farthest`; back faces are ignored. `direction` need not be unit.
  std::optional<SurfacePoint> castRay(const Vec3& origin, const Vec3& direction, const Lifted* lifted = nullptr, float farthest = 3e38f) const;
  // All triangles within `radius` of `centre`, in ascending order.
  std::vector<std::uint32_t> trianglesWithin(const Vec3& centre, float radius) const;
  // Whether there is one.
  bool isNear(const Vec3& centre, float radius) const;

 private:
  template <class Visit>
  void forTrianglesWithin(const Vec3& centre, float radius, Visit visit) const;

  struct Node {
    Vec3 low, high;
    std::uint32_t first, count;  // count 0: an inner node, children at first and first + 1
  };
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Vec3> corners_;  // 3 a triangle
};

// The point of the surface nearest to `to` within `radius`, on a triangle whose plane does not face away from `normal`.
std::optional<SurfacePoint> nearestPoint(const Surface& surface, const SurfaceQuery& query, const Vec3& to, float radius,
                                         const Vec3& normal);
// Barycentric weights of the triangle's point nearest to p.
Vec3 nearestWeights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

Vec3 positionAt(const Surface& surface, const SurfacePoint& point);
Vec3 normalAt(const Surface& surface, const SurfacePoint& point);
Vec2 atlasAt(const Surface& surface, const SurfacePoint& point);
// Interpolates `values`, one for each vertex.
Vec3 valueAt(const Surface& surface, const SurfacePoint& point, std::span<const Vec3> values);

}  // namespace fur::geometry
