// What a person can take hold of at the spheres and capsules that hair does not enter.
#pragma once

#include <optional>
#include <span>

#include "hair/Body.h"

namespace fur::app {

struct BodyGrip {
  enum class Part { Whole, A, B, Radius };
  std::size_t body;
  Part part;
  Vec3 at;  // the place that is held
};

// The place of the handle for its radius: beside its middle as the eye sees it.
Vec3 radiusHandle(const hair::Body& body, const Vec3& eye);
// Where a ray (`direction` unit) meets a plane; none where it runs along it or away.
std::optional<Vec3> onPlane(const Vec3& origin, const Vec3& direction, const Vec3& point, const Vec3& normal);
// A handle of the selected body (-1: none) that the ray passes within `reach` at distance 1, else the first body that it meets.
std::optional<BodyGrip> gripAt(std::span<const hair::Body> bodies, int selected, const Vec3& origin, const Vec3& direction, float reach);
// The body after what is held has been moved from there to `to`.
hair::Body dragged(hair::Body body, const BodyGrip& grip, const Vec3& to);

}  // namespace fur::app
