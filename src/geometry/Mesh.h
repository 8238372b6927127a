// A plain indexed triangle mesh, as importers and generators give it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::geometry {

// The atlas of a mesh whose vertices may have several places in it.
struct AtlasLayout {
  std::uint32_t chartCount = 0;
  std::vector<std::uint32_t> chartOf;  // one a triangle
  std::vector<Vec2> corners;           // three a triangle

  bool empty() const { return corners.empty(); }
};

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  // empty, or one unit vector a vertex
  std::vector<Vec2> uv;       // empty, or one a vertex; (0, 0) is the first texel of an image (glTF)
  std::vector<Vec2> otherUv{};  // empty, or one a vertex: of pictures that lie by coordinates of their own
  std::vector<Vec2> atlas;    // empty, or one a vertex: what Surface's atlas is to be; isUniqueAtlas() holds for it (AtlasUv.h)
  AtlasLayout layout{};       // empty, or the same of each triangle, before `atlas`
  std::vector<Vec2> furUv;    // empty, or one a vertex: its own coordinates for the fur tile, at any scale
  std::vector<std::uint32_t> indices;  // 3 a triangle, counter-clockwise seen from outside

  std::size_t triangleCount() const { return indices.size() / 3; }
};

struct Bounds {
  Vec3 low{0.0f}, high{0.0f};
};

Bounds bounds(const Mesh& mesh);

// Whether a triangle's area is more than rounding noise, for positions of size 1.
bool hasArea(const Mesh& mesh, std::size_t triangle);

// The transform that fitToUnitSphere() applied.
struct Fit {
  glm::dvec3 centre;
  double scale;
  Vec3 of(const Vec3& point) const { return Vec3((glm::dvec3(point) - centre) * scale); }
};
// Moves the centre of the bounding box to the origin and scales the farthest vertex to distance 1.
Fit fitToUnitSphere(Mesh& mesh);

// Area- and angle-weighted normals. Vertices at the same position share one normal, so that a
// surface split along a UV seam stays smooth.
void computeNormals(Mesh& mesh);

}  // namespace fur::geometry
