#include "geometry/SurfaceQuery.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/Sort.h"

namespace fur::geometry {

namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr float kNever = 3e38f;

// Nearest point of the triangle to p (Ericson, "Real-Time Collision Detection", 5.1.5), squared distance.
float squaredDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const auto squared = [](const Vec3& d) { return glm::dot(d, d); };
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return squared(ap);
  const Vec3 bp = p - b;
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0f && d4 <= d3) return squared(bp);
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return squared(ap - ab * (d1 / (d1 - d3)));
  const Vec3 cp = p - c;
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0f && d5 <= d6) return squared(cp);
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return squared(ap - ac * (d2 / (d2 - d6)));
  const float va = d3 * d6 - d5 * d4;
  const float towardsC = d4 - d3, towardsB = d5 - d6;
  if (va <= 0.0f && towardsC >= 0.0f && towardsB >= 0.0f) {
    return squared(bp - (c - b) * (towardsC / (towardsC + towardsB)));
  }
  const float sum = va + vb + vc;
  return squared(ap - ab * (vb / sum) - ac * (vc / sum));
}

// Where the ray enters the box, or kNever.
float entry(const Vec3& low, const Vec3& high, const Vec3& origin, const Vec3& inverse, float nearest) {
  float from = 0.0f, to = nearest;
  for (int axis = 0; axis < 3; ++axis) {
    const bool backwards = std::signbit(inverse[axis]);
    const float t0 = ((backwards ? high : low)[axis] - origin[axis]) * inverse[axis];
    const float t1 = ((backwards ? low : high)[axis] - origin[axis]) * inverse[axis];
    // Written so that NaN (0 times infinity: the ray runs in the box's face) leaves the interval as it is.
    from = t0 > from ? t0 : from;
    to = t1 < to ? t1 : to;
  }
  return from <= to * 1.000001f ? from : kNever;
}

}  // namespace

SurfaceQuery::SurfaceQuery(const Surface& surface) {
  const std::size_t count = surface.triangleCount();
  if (count == 0) return;
  std::vector<Vec3> centres(count);
  std::vector<Vec3> corners(count * 3);
  order_.resize(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    order_[t] = t;
    for (std::size_t k = 0; k < 3; ++k) corners[3 * t + k] = surface.vertices[surface.indices[3 * t + k]].position;
    centres[t] = (corners[3 * t] + corners[3 * t + 1] + corners[3 * t + 2]) / 3.0f;
  }
  // Median split along the longest side of the centres' box: even leaves bound the depth.
  nodes_.push_back({Vec3(0), Vec3(0), 0, static_cast<std::uint32_t>(count)});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Vec3 low(kNever), high(-kNever), lowCentre(kNever), highCentre(-kNever);
    const std::uint32_t first = nodes_[i].first, size = nodes_[i].count;
    for (std::uint32_t k = first; k < first + size; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        low = glm::min(low, corners[3 * order_[k] + c]);
        high = glm::max(high, corners[3 * order_[k] + c]);
      }
      lowCentre = glm::min(lowCentre, centres[order_[k]]);
      highCentre = glm::max(highCentre, centres[order_[k]]);
    }
    nodes_[i].low = low;
    nodes_[i].high = high;
    if (size <= kLeafSize) continue;
    const Vec3 extent = highCentre - lowCentre;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto begin = order_.begin() + first;
    sortStably(begin, begin + size, [&](std::uint32_t a, std::uint32_t b) {
      return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
    });
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({Vec3(0), Vec3(0), first, size / 2});
    nodes_.push_back({Vec3(0), Vec3(0), first + size / 2, size - size / 2});
    nodes_[i].first = child;
    nodes_[i].count = 0;
  }
  corners_.resize(corners.size());
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t c = 0; c < 3; ++c) corners_[3 * k + c] = corners[3 * order_[k] + c];
  }
}

void SurfaceQuery::follow(const Surface& surface, std::span<const Vec3> positions) {
  for (std::size_t k = 0; k < order_.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) corners_[3 * k + c] = positions[surface.indices[3 * std::size_t{order_[k]} + c]];
  // Children stand behind their parents.
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (node.count == 0) {
      node.low = glm::min(nodes_[node.first].low, nodes_[node.first + 1].low);
      node.high = glm::max(nodes_[node.first].high, nodes_[node.first + 1].high);
      continue;
    }
    node.low = Vec3(kNever);
    node.high = Vec3(-kNever);
    for (std::size_t k = 3 * std::size_t{node.first}; k < 3 * (std::size_t{node.first} + node.count); ++k) {
      node.low = glm::min(node.low, corners_[k]);
      node.high = glm::max(node.high, corners_[k]);
    }
  }
}

std::optional<SurfacePoint> SurfaceQuery::castRay(const Vec3& origin, const Vec3& direction, const Lifted* lifted, float farthest) const {
  std::optional<SurfacePoint> best;
  if (nodes_.empty()) return best;
  float nearest = farthest;
  const Vec3 inverse = 1.0f / direction;
  const float reach = lifted ? lifted->reach : 0.0f, perSquare = 1.0f / glm::dot(direction, direction);
  const auto enters = [&](const Node& node) { return entry(node.low - reach, node.high + reach, origin, inverse, nearest); };
  // Two children wait at each level at most, and 32 levels hold every 32-bit count.
  std::array<std::pair<std::uint32_t, float>, 64> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0u, enters(nodes_[0])};
  while (waiting > 0) {
    const auto [index, from] = stack[--waiting];
    if (from > nearest || from == kNever) continue;
    const Node& node = nodes_[index];
    if (node.count == 0) {
      const float a = enters(nodes_[node.first]), b = enters(nodes_[node.first + 1]);
      stack[waiting++] = a > b ? std::pair(node.first, a) : std::pair(node.first + 1, b);
      stack[waiting++] = a > b ? std::pair(node.first + 1, b) : std::pair(node.first, a);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      Vec3 a = corners_[3 * k], e1 = corners_[3 * k + 1] - a, e2 = corners_[3 * k + 2] - a;
      if (lifted) {
        // Boxes that are wider by the reach hold many that it does not take to the ray.
        const Vec3 way = a - origin, aside = way - direction * (glm::dot(way, direction) * perSquare);
        if (glm::length(aside) > reach + std::sqrt(std::max(glm::dot(e1, e1), glm::dot(e2, e2)))) continue;
        a = lifted->corner(3 * order_[k]);
        e1 = lifted->corner(3 * order_[k] + 1) - a;
        e2 = lifted->corner(3 * order_[k] + 2) - a;
      }
      // Moeller and Trumbore 1997, front faces only.
      const Vec3 p = glm::cross(direction, e2);
      const float det = glm::dot(e1, p);
      if (!(det > 0.0f)) continue;
      const Vec3 s = origin - a;
      const float u = glm::dot(s, p) / det;
      const Vec3 q = glm::cross(s, e1);
      const float v = glm::dot(direction, q) / det;
      const float t = glm::dot(e2, q) / det;
      // A hair wider than the triangle, so that no ray slips through between two.
      if (u < -1e-6f || v < -1e-6f || u + v > 1.000001f || !(t > 0.0f)) continue;
      if (t > nearest || (t == nearest && best && best->triangle < order_[k])) continue;
      nearest = t;
      best = SurfacePoint{order_[k], Vec3(1.0f - u - v, u, v), t};
    }
  }
  return best;
}

// Calls visit(triangle) for those, in no order, until it returns false.
template <class Visit>
void SurfaceQuery::forTrianglesWithin(const Vec3& centre, float radius, Visit visit) const {
  if (nodes_.empty() || !(radius >= 0.0f)) return;
  const float squared = radius * radius;
  std::array<std::uint32_t, 64> stack{};  // as in castRay()
  for (std::size_t waiting = 1; waiting > 0;) {
    const Node& node = nodes_[stack[--waiting]];
    const Vec3 away = centre - glm::clamp(centre, node.low, node.high);
    if (glm::dot(away, away) > squared * 1.00001f) continue;
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = node.first + 1;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if (squaredDistance(centre, corners_[3 * k], corners_[3 * k + 1], corners_[3 * k + 2]) <= squared && !visit(order_[k])) return;
  }
}

std::vector<std::uint32_t> SurfaceQuery::trianglesWithin(const Vec3& centre, float radius) const {
  std::vector<std::uint32_t> found;
  forTrianglesWithin(centre, radius, [&](std::uint32_t triangle) {
    found.push_back(triangle);
    return true;
  });
  sortStably(found.begin(), found.end());
  return found;
}

bool SurfaceQuery::isNear(const Vec3& centre, float radius) const {
  bool near = false;
  forTrianglesWithin(centre, radius, [&](std::uint32_t) {
    near = true;
    return false;
  });
  return near;
}

namespace {

const SurfaceVertex& corner(const Surface& surface, const SurfacePoint& point, std::size_t k) {
  return surface.vertices[surface.indices[3 * static_cast<std::size_t>(point.triangle) + k]];
}

}  // namespace

// Ericson, "Real-Time Collision Detection", 5.1.5.
Vec3 nearestWeights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const float d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0f && d2 <= 0.0f) return {1, 0, 0};
  const float d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0f && d4 <= d3) return {0, 1, 0};
  const float d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0f && d5 <= d6) return {0, 0, 1};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 >= d3 && d5 >= d6) {
    const float way = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - way, way};
  }
  const float sum = va + vb + vc;
  return sum > 0.0f ? Vec3(va, vb, vc) / sum : Vec3(1, 0, 0);
}

std::optional<SurfacePoint> nearestPoint(const Surface& surface, const SurfaceQuery& query, const Vec3& to, float radius,
                                         const Vec3& normal) {
  std::optional<SurfacePoint> best;
  for (const std::uint32_t t : query.trianglesWithin(to, radius)) {
    SurfacePoint point{t, Vec3(1, 0, 0), 0};
    const Vec3 a = corner(surface, point, 0).position, b = corner(surface, point, 1).position, c = corner(surface, point, 2).position;
    if (glm::dot(glm::cross(b - a, c - a), normal) <= 0.0f) continue;
    point.weights = nearestWeights(to, a, b, c);
    point.distance = glm::length(positionAt(surface, point) - to);
    if (!best || point.distance < best->distance) best = point;
  }
  return best;
}

Vec3 positionAt(const Surface& surface, const SurfacePoint& point) {
  return corner(surface, point, 0).position * point.weights.x + corner(surface, point, 1).position * point.weights.y +
         corner(surface, point, 2).position * point.weights.z;
}

Vec3 normalAt(const Surface& surface, const SurfacePoint& point) {
  const Vec3 sum = corner(surface, point, 0).normal * point.weights.x + corner(surface, point, 1).normal * point.weights.y +
                   corner(surface, point, 2).normal * point.weights.z;
  return normalizeOr(sum, corner(surface, point, 0).normal);
}

Vec2 atlasAt(const Surface& surface, const SurfacePoint& point) {
  return corner(surface, point, 0).atlas * point.weights.x + corner(surface, point, 1).atlas * point.weights.y +
         corner(surface, point, 2).atlas * point.weights.z;
}

Vec3 valueAt(const Surface& surface, const SurfacePoint& point, std::span<const Vec3> values) {
  const std::uint32_t* corners = &surface.indices[std::size_t{3} * point.triangle];
  return values[corners[0]] * point.weights.x + values[corners[1]] * point.weights.y + values[corners[2]] * point.weights.z;
}

}  // namespace fur::geometry
