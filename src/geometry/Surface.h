// A mesh made ready to carry fur: three texture domains, their gradients, the edges for fins.
//
//   uv     the model's own, for its base colour texture; may overlap or repeat
//   atlas  unique: every surface point has its own texel in [0,1]^2 (wetness, groom). Mesh::atlas, else the model's
//          uv when they lie in [0,1]^2, no two triangles overlap and all have an area there (AtlasUv.h);
//          else packed charts with a gutter of two texels of a 256^2 map (ChartPacking.h)
//   fur    the repeating domain of the fur tile: 1 unit = 1 tile at repeat 1, that is 1 model unit
//          along the surface as nearly as a flat chart allows. Its charts (FurCharts.h) are the mesh's
//          own furUv, else what FurMapping says. They overlap (FurOverlap.h), so that no strand is cut
//          where two of them meet: shells are drawn with furIndices, all else with indices
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"
#include "geometry/FurClusters.h"
#include "geometry/HardEdges.h"
#include "geometry/Mesh.h"

namespace fur::geometry {

// Where fur coordinates come from when a mesh brings none. Charts (Charts.h) follow the shape; Cube
// (CubeMapping.h) is Sheppard's. FurDensity.h measures how even they are.
enum class FurMapping { Charts, Cube };

struct SurfaceVertex {
  Vec3 position;
  Vec3 normal;  // the way the fur grows: near hard edges between those of their faces (HardEdges.h)
  Vec2 uv;
  Vec2 atlas;
  Vec2 fur;
  // Surface gradients of the fur coordinates s and t: a step of x along the surface moves the
  // coordinates by (dot(gradS, x), dot(gradT, x)). Both are perpendicular to the normal.
  Vec3 gradS;
  Vec3 gradT;
  // The shape operator, how the normal turns along the surface: (S_ss, S_st, S_tt) in the axes of
  // Curvature.h, per model unit; positive where the surface is convex.
  Vec3 curvature{0.0f};
  // Where fur leans: the normal of its face along those axes.
  Vec2 lean{0.0f};
  // d(atlas)/d(fur), a 2x2 matrix by columns: (du/ds, dv/ds, du/dt, dv/dt). Invertible.
  Vec4 atlasFromFur;
  // The strands that are drawn here: those whose own number, evenly spread over 0..1, lies in [x, y).
  // Interpolated over the triangle and then clamped to 0..1; (-1, 2) is all of them.
  Vec2 strands{-1.0f, 2.0f};
  std::uint32_t chart = 0;  // of the atlas; 0-based
  std::uint32_t source = 0;  // the vertex of the mesh that it is a copy of, and after those of Surface::inserted
};

// One edge of the surface with the two faces that meet there (found by position, across UV seams).
struct SurfaceEdge {
  std::uint32_t a, b;        // vertices (of the first face)
  Vec3 faceNormal0;          // unit
  Vec3 faceNormal1;          // unit; on a boundary edge -faceNormal0, which makes it a silhouette from everywhere
  float finStart;            // where this edge starts in the fin map, [0, 1), pseudo-random
  bool betweenFacets = false;  // hard, and the first of them is flat: its normals are the face's
};

struct Surface {
  // The surface itself first, then copies for the fur charts that reach over their borders: position,
  // normal, uv and atlas of a true vertex, but another chart's fur coordinates.
  std::vector<SurfaceVertex> vertices;
  std::size_t trueVertexCount = 0;
  std::vector<std::uint32_t> indices;     // the surface, each triangle once
  std::vector<std::uint32_t> furIndices;  // for shells: of every fur chart all triangles that it has strands on
  std::vector<std::uint32_t> ownFurIndices;  // those of indices by clusters: shells so far off that overlaps do not show
  std::vector<FurCluster> furClusters;       // parts of the two
  std::vector<SurfaceEdge> edges;
  std::uint32_t chartCount = 0;
  bool turned = false;                    // somewhere fur leans over a hard edge
  bool sheets = false;                    // somewhere it ends as a sheet does, whose other side is bare skin
  std::vector<InsertedVertex> inserted;   // between vertices of the mesh and each other
  std::vector<std::uint32_t> meshIndices; // the mesh's own triangles, where vertices were inserted; else those of indices

  std::size_t triangleCount() const { return indices.size() / 3; }
};

// `mesh` has positions in the unit sphere; missing normals are computed, missing or overlapping uv
// charted. Degenerate triangles are dropped. Fails (bad-file) when no triangle is left. `mapping` does
// not matter for a mesh with furUv.
Result<Surface> buildSurface(const Mesh& mesh, FurMapping mapping = FurMapping::Charts);

// The surface without what was inserted into the mesh and without copies, as a file is to have it: vertices, with the
// normals that `mesh` gives them, and indices. `vertexOf`: of each, its vertex of `surface`.
struct OwnSurface {
  Surface surface;
  std::vector<std::uint32_t> vertexOf;
};
OwnSurface ownSurface(const Surface& surface, const Mesh& mesh);

}  // namespace fur::geometry
