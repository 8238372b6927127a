#include "app/stages/BodyGrip.h"

#include <algorithm>
#include <cmath>

namespace fur::app {

namespace {

// The point of a body's axis that is nearest to a ray, and how far along the ray that is; after Ericson 2005, 5.1.9.
struct Passing {
  Vec3 onAxis;
  float along;
};
Passing passing(const hair::Body& body, const Vec3& origin, const Vec3& direction) {
  const Vec3 axis = body.b - body.a, way = origin - body.a;
  const float e = glm::dot(axis, axis), b = glm::dot(direction, axis), c = glm::dot(direction, way), f = glm::dot(axis, way);
  const float across = e - b * b;
  const float t = e > 0 ? saturate(across > 1e-9f ? (f - b * c) / across : 0.5f) : 0;
  const Vec3 at = body.a + axis * t;
  return {at, glm::dot(at - origin, direction)};
}

float distanceToAxis(const hair::Body& body, const Vec3& point) {
  const Vec3 axis = body.b - body.a;
  const float e = glm::dot(axis, axis), t = e > 0 ? saturate(glm::dot(point - body.a, axis) / e) : 0;
  return glm::distance(point, body.a + axis * t);
}

}  // namespace

Vec3 radiusHandle(const hair::Body& body, const Vec3& eye) {
  const Vec3 middle = 0.5f * (body.a + body.b), axis = normalizeOr(body.b - body.a, Vec3(0, 1, 0));
  return middle + normalizeOr(glm::cross(axis, eye - middle), Vec3(1, 0, 0)) * body.radius;
}

std::optional<Vec3> onPlane(const Vec3& origin, const Vec3& direction, const Vec3& point, const Vec3& normal) {
  const float slope = glm::dot(direction, normal);
  if (std::abs(slope) < 1e-4f) return std::nullopt;
  const float t = glm::dot(point - origin, normal) / slope;
  return t > 0 ? std::optional(origin + direction * t) : std::nullopt;
}

std::optional<BodyGrip> gripAt(std::span<const hair::Body> bodies, int selected, const Vec3& origin, const Vec3& direction, float reach) {
  using Part = BodyGrip::Part;
  if (selected >= 0 && selected < static_cast<int>(bodies.size())) {
    const hair::Body& body = bodies[static_cast<std::size_t>(selected)];
    const bool sphere = body.a == body.b;
    std::optional<BodyGrip> best;
    float nearest = reach;
    for (const auto& [part, at] : {std::pair(Part::Radius, radiusHandle(body, origin)), {sphere ? Part::Whole : Part::A, body.a}, {sphere ? Part::Whole : Part::B, body.b}}) {
      const float along = glm::dot(at - origin, direction);
      const float apart = along > 0 ? glm::distance(at, origin + direction * along) / along : reach;
      if (apart >= nearest) continue;
      nearest = apart;
      best = BodyGrip{static_cast<std::size_t>(selected), part, at};
    }
    if (best) return best;
  }
  std::optional<BodyGrip> first;
  float least = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Passing at = passing(bodies[i], origin, direction);
    const Vec3 aside = origin + direction * at.along - at.onAxis;
    const float inside = bodies[i].radius * bodies[i].radius - glm::dot(aside, aside);
    const float along = at.along - std::sqrt(std::max(inside, 0.0f));
    if (inside <= 0 || at.along <= 0 || (first && along >= least)) continue;
    least = along;
    first = BodyGrip{i, Part::Whole, origin + direction * std::max(along, 0.0f)};
  }
  return first;
}

hair::Body dragged(hair::Body body, const BodyGrip& grip, const Vec3& to) {
  const Vec3 move = to - grip.at;
  if (grip.part == BodyGrip::Part::Radius) body.radius = glm::clamp(distanceToAxis(body, to), hair::kLeastBody, hair::kLargestBody);
  if (grip.part == BodyGrip::Part::Whole || grip.part == BodyGrip::Part::A) body.a += move;
  if (grip.part == BodyGrip::Part::Whole || grip.part == BodyGrip::Part::B) body.b += move;
  return body;
}

}  // namespace fur::app
