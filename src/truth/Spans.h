// The samples of a grid that a flat shape covers. Samples are at whole numbers and a half.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/Math.h"

namespace fur::truth {

// A window of the grid: [x0, x1) x [y0, y1).
struct Window {
  int x0, y0, x1, y1;
};

struct Disc {
  Vec2 centre;   // samples
  float radius;  // samples
  float depth;
};

// The tapered tube between two discs, as a flat shape: calls found(x, y, t) for each sample within the radius at the nearest
// point of the axis, t in 0..1 along it.
template <class Found>
void sweep(const Disc& a, const Disc& b, const Window& window, const Found& found) {
  const float widest = std::max(a.radius, b.radius);
  const Vec2 way = b.centre - a.centre;
  const float squared = glm::dot(way, way), length = std::sqrt(squared);
  const Vec2 low = glm::min(a.centre, b.centre) - widest, high = glm::max(a.centre, b.centre) + widest;
  const int y0 = std::max(window.y0, static_cast<int>(std::ceil(low.y - 0.5f)));
  const int y1 = std::min(window.y1, static_cast<int>(std::floor(high.y - 0.5f)) + 1);
  const bool tilted = std::abs(way.y) > 1e-3f * length;
  for (int y = y0; y < y1; ++y) {
    const float py = static_cast<float>(y) + 0.5f - a.centre.y;
    float left = low.x, right = high.x;
    if (tilted) {  // the part of the row that is near enough to the infinite axis
      const float middle = a.centre.x + py * way.x / way.y, half = widest * length / std::abs(way.y);
      left = std::max(left, middle - half), right = std::min(right, middle + half);
    }
    const int x0 = std::max(window.x0, static_cast<int>(std::ceil(left - 0.5f)));
    const int x1 = std::min(window.x1, static_cast<int>(std::floor(right - 0.5f)) + 1);
    for (int x = x0; x < x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f - a.centre.x;
      const float t = squared > 0 ? saturate((px * way.x + py * way.y) / squared) : 0.0f;
      const float dx = px - t * way.x, dy = py - t * way.y, radius = a.radius + (b.radius - a.radius) * t;
      if (dx * dx + dy * dy <= radius * radius) found(x, y, t);
    }
  }
}

// Calls found(x, y, barycentric weights) for the samples in a triangle of either winding. A sample on an edge that two
// triangles share may be found by both.
template <class Found>
void fillTriangle(const Vec3 (&c)[3], const Window& window, const Found& found) {
  const auto cross = [](const Vec3& a, const Vec3& b, float x, float y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); };
  const float area = cross(c[0], c[1], c[2].x, c[2].y);
  if (area == 0) return;
  const Vec3 low = glm::min(glm::min(c[0], c[1]), c[2]), high = glm::max(glm::max(c[0], c[1]), c[2]);
  const int y0 = std::max(window.y0, static_cast<int>(std::ceil(low.y - 0.5f)));
  const int y1 = std::min(window.y1, static_cast<int>(std::floor(high.y - 0.5f)) + 1);
  const int x0 = std::max(window.x0, static_cast<int>(std::ceil(low.x - 0.5f)));
  const int x1 = std::min(window.x1, static_cast<int>(std::floor(high.x - 0.5f)) + 1);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
      const Vec3 w = Vec3(cross(c[1], c[2], px, py), cross(c[2], c[0], px, py), cross(c[0], c[1], px, py)) / area;
      if (w.x >= 0 && w.y >= 0 && w.z >= 0) found(x, y, w);
    }
}

}  // namespace fur::truth
