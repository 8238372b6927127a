// A mesh made ready to carry fur: three texture domains, their gradients, the edges for fins.
//
//   uv     the model's own, for its base colour texture; may overlap or repeat
//   atlas  unique: every surface point has its own texel in [0,1]^2 (wetness, groom). The model's
//          uv when they lie in [0,1]^2, no two triangles overlap and all have an area there (AtlasUv.h);
//          else packed charts with a gutter of two texels of a 256^2 map (ChartPacking.h)
//   fur    the repeating domain of the fur tile: 1 unit = 1 tile at repeat 1, that is 1 model unit
//          along the surface as nearly as a flat chart allows. These are the charts of Charts.h, also
//          where the atlas is the model's own: unlike the faces of a cube they follow the shape, no slope
//          starts beyond 75 degrees, and with a charted atlas atlasFromFur is one constant a chart
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"
#include "geometry/Mesh.h"

namespace fur::geometry {

struct SurfaceVertex {
  Vec3 position;
  Vec3 normal;
  Vec2 uv;
  Vec2 atlas;
  Vec2 fur;
  // Surface gradients of the fur coordinates s and t: a step of x along the surface moves the
  // coordinates by (dot(gradS, x), dot(gradT, x)). Both are perpendicular to the normal.
  Vec3 gradS;
  Vec3 gradT;
  // d(atlas)/d(fur), a 2x2 matrix by columns: (du/ds, dv/ds, du/dt, dv/dt). Invertible.
  Vec4 atlasFromFur;
  std::uint32_t chart = 0;  // of the atlas; 0-based
};

// One edge of the surface with the two faces that meet there (found by position, across UV seams).
struct SurfaceEdge {
  std::uint32_t a, b;        // vertices (of the first face)
  Vec3 faceNormal0;          // unit
  Vec3 faceNormal1;          // unit; on a boundary edge -faceNormal0, which makes it a silhouette from everywhere
  float finStart;            // where this edge starts in the fin map, [0, 1), pseudo-random
};

struct Surface {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<SurfaceEdge> edges;
  std::uint32_t chartCount = 0;

  std::size_t triangleCount() const { return indices.size() / 3; }
};

// `mesh` has positions in the unit sphere; missing normals are computed, missing or overlapping uv
// charted. Degenerate triangles are dropped. Fails (bad-file) when no triangle is left.
Result<Surface> buildSurface(const Mesh& mesh);

}  // namespace fur::geometry
