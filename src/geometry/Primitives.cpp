#include "geometry/Primitives.h"

#include <cmath>

#include "core/PortableMath.h"

namespace fur::geometry {

namespace {

// Two triangles for every cell of a grid of (columns + 1) x (rows + 1) vertices; with poles, the
// first and last rows are points and their cells one triangle with its tip at vertex x.
void addGrid(Mesh& mesh, int columns, int rows, bool poles) {
  const auto vertex = [columns](int x, int y) { return static_cast<std::uint32_t>(y * (columns + 1) + x); };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const std::uint32_t a = vertex(x, y), b = vertex(x + 1, y), c = vertex(x + 1, y + 1), d = vertex(x, y + 1);
      const bool top = poles && y == 0, bottom = poles && y == rows - 1;
      if (top) {
        mesh.indices.insert(mesh.indices.end(), {a, d, c});
      } else {
        mesh.indices.insert(mesh.indices.end(), {a, d, b});
        if (!bottom) mesh.indices.insert(mesh.indices.end(), {b, d, c});
      }
    }
  }
}

// The angle of step i of n round the circle; the last step is exactly the first, so that the seam closes.
float angleAt(int i, int n) { return 2.0f * kPi * static_cast<float>(i % n) / static_cast<float>(n); }

float fraction(int i, int n) { return static_cast<float>(i) / static_cast<float>(n); }

}  // namespace

Mesh makeSphere(int around, int down) {
  Mesh mesh;
  for (int y = 0; y <= down; ++y) {
    const bool pole = y == 0 || y == down;
    const float polar = kPi * fraction(y, down);
    const float ring = pole ? 0.0f : portableSin(polar);
    const float height = pole ? (y == 0 ? 1.0f : -1.0f) : portableCos(polar);
    for (int x = 0; x <= around; ++x) {
      const float angle = angleAt(x, around);
      const Vec3 p = normalizeOr(Vec3(ring * portableSin(angle), height, ring * portableCos(angle)), Vec3(0, 1, 0));
      mesh.positions.push_back(p);
      mesh.normals.push_back(p);
      // A pole's tips stand in the middle of their cells.
      const float u = pole ? (static_cast<float>(x) + 0.5f) / static_cast<float>(around) : fraction(x, around);
      mesh.uv.push_back(Vec2(glm::min(u, 1.0f), fraction(y, down)));
    }
  }
  addGrid(mesh, around, down, true);
  return mesh;
}

Mesh makeTorus(int around, int across, float tubeRadius) {
  Mesh mesh;
  const float ringRadius = 1.0f - tubeRadius;
  for (int y = 0; y <= across; ++y) {
    const float tube = angleAt(y, across);
    for (int x = 0; x <= around; ++x) {
      const float angle = angleAt(x, around);
      const Vec3 outward(portableSin(angle), 0.0f, portableCos(angle));
      const Vec3 normal = outward * portableCos(tube) - Vec3(0.0f, portableSin(tube), 0.0f);
      mesh.positions.push_back(outward * ringRadius + normal * tubeRadius);
      mesh.normals.push_back(normalizeOr(normal, outward));
      mesh.uv.push_back(Vec2(fraction(x, around), fraction(y, across)));
    }
  }
  addGrid(mesh, around, across, false);
  return mesh;
}

Mesh makePlane(int cells) {
  Mesh mesh;
  const float half = 0.70710678f;  // the corners lie on the unit sphere
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const Vec2 uv(fraction(x, cells), fraction(y, cells));
      mesh.positions.push_back(Vec3((uv.x - 0.5f) * 2.0f * half, 0.0f, (uv.y - 0.5f) * 2.0f * half));
      mesh.normals.push_back(Vec3(0.0f, 1.0f, 0.0f));
      mesh.uv.push_back(uv);
    }
  }
  addGrid(mesh, cells, cells, false);
  return mesh;
}

}  // namespace fur::geometry
