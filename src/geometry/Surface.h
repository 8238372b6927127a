// A mesh made ready to carry fur: three texture domains, their gradients, the edges for fins.
//
//   uv     the model's own, for its base colour texture; may overlap or repeat
//   atlas  unique: each surface point has its own texel in [0,1]^2 (wetness, groom). Mesh::layout or atlas if there is one; else the
//          model's uv if they lie in [0,1]^2, no triangles overlap and all have an area there (AtlasUv.h);
//          else packed charts with a gutter of two texels of a 256^2 map (ChartPacking.h)
//   fur    the repeating domain of the fur tile: 1 unit = 1 tile at repeat 1, about 1 model unit along the
//          surface. Its charts (FurCharts.h) are the mesh's furUv if it has them, else as FurMapping says. They
//          overlap (FurOverlap.h), so that no strand is cut at a border: shells are drawn with furIndices,
//          everything else with indices
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/Math.h"
#include "core/Result.h"
#include "geometry/FurClusters.h"
#include "geometry/HardEdges.h"
#include "geometry/Mesh.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Where fur coordinates come from when a mesh brings none. Charts (Charts.h) follow the shape; Cube
// (CubeMapping.h) is Sheppard's. FurDensity.h measures how even they are.
enum class FurMapping { Charts, Cube };

inline constexpr float kAnyThickness = 1e6f;  // model units; where nothing limits it

struct SurfaceVertex {
  Vec3 position;
  Vec3 normal;  // the direction in which fur grows; near hard edges it leans over them (HardEdges.h)
  Vec2 uv;
  Vec2 otherUv{0.0f};  // Mesh::otherUv
  Vec2 atlas;
  Vec2 fur;
  // Surface gradients of the fur coordinates s and t: a step of x along the surface moves the
  // coordinates by (dot(gradS, x), dot(gradT, x)). Both are perpendicular to the normal.
  Vec3 gradS;
  Vec3 gradT;
  // How they change along the surface, the second derivatives of s and t: (ss, st, tt) in the axes of Curvature.h.
  Vec3 hessianS{0.0f};
  Vec3 hessianT{0.0f};
  // The shape operator, how the normal turns along the surface: (S_ss, S_st, S_tt) in the axes of
  // Curvature.h, per model unit; positive where the surface is convex.
  Vec3 curvature{0.0f};
  // How thick a coat can stand here, model units (CoatThickness.h).
  float room = kAnyThickness;
  // Where fur leans over a hard edge: the face's own normal, its parts along those axes.
  Vec2 lean{0.0f};
  // d(atlas)/d(fur), a 2x2 matrix by columns: (du/ds, dv/ds, du/dt, dv/dt). Invertible.
  Vec4 atlasFromFur;
  // The strands drawn here: those whose random number, evenly distributed in 0..1, lies in [x, y). Interpolated
  // over the triangle and then clamped to 0..1; (-1, 2): all strands (FurOverlap.h).
  Vec2 strands{-1.0f, 2.0f};
  std::uint32_t chart = 0;  // of the atlas; 0-based
  std::uint32_t source = 0;  // the mesh's vertex that it copies; from the mesh's vertex count on, an index of Surface::inserted
};

// An edge of the surface and the two faces that meet there (found by position, across uv seams).
struct SurfaceEdge {
  std::uint32_t a, b;        // vertices (of the first face)
  Vec3 faceNormal0;          // unit
  Vec3 faceNormal1;          // unit; on a boundary -faceNormal0, so that it counts as a silhouette from everywhere
  float finStart;            // where this edge starts in the fin map, [0, 1), pseudo-random
  bool betweenFacets = false;  // a hard edge whose first face is flat: its vertex normals are the face's
};

struct Surface {
  // First the surface itself, then copies for fur charts that overlap: position, normal, uv and atlas of a true vertex with
  // the fur coordinates of another chart.
  std::vector<SurfaceVertex> vertices;
  std::size_t trueVertexCount = 0;
  std::vector<std::uint32_t> indices;     // the surface, each triangle once
  std::vector<std::uint32_t> furIndices;  // for shells: the triangles of each fur chart, with copies where charts overlap
  std::vector<std::uint32_t> ownFurIndices;  // the triangles of `indices` in the order of clusters: for shells too far off for overlaps to show
  std::vector<FurCluster> furClusters;       // ranges of both
  std::vector<SurfaceEdge> edges;
  std::uint32_t chartCount = 0;
  bool turned = false;                    // fur leans over a hard edge somewhere
  bool sheets = false;                    // it has the rim of a sheet, whose back is bare skin
  std::vector<InsertedVertex> inserted;   // vertices inserted into the mesh (HardEdges.h)
  std::vector<std::uint32_t> meshIndices; // the mesh's own triangles; the same as `indices` when nothing was inserted

  std::size_t triangleCount() const { return indices.size() / 3; }
};

// The points of vertices, by their positions (geometry/Weld.h).
Weld weldVertices(std::span<const SurfaceVertex> vertices);

// `mesh` has positions in the unit sphere. Missing normals are computed; missing or overlapping uv get charts. Degenerate
// triangles are dropped; fails (bad-file) when none is left. `mapping` is ignored for a mesh with furUv.
Result<Surface> buildSurface(const Mesh& mesh, FurMapping mapping = FurMapping::Charts);

// The same in steps of some milliseconds, so that a page need not wait for all of it.
class SurfaceBuilding {
 public:
  SurfaceBuilding(Mesh mesh, FurMapping mapping);
  SurfaceBuilding(SurfaceBuilding&&) noexcept;
  SurfaceBuilding& operator=(SurfaceBuilding&&) noexcept;
  ~SurfaceBuilding();
  // Whether that was the last. Not to be called after.
  bool step();
  Result<Surface> take();

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

// The surface as it is written to a file: without inserted vertices and copies, with the normals of `mesh`. `vertexOf`: the
// vertex of `surface` for each vertex.
struct OwnSurface {
  Surface surface;
  std::vector<std::uint32_t> vertexOf;
};
OwnSurface ownSurface(const Surface& surface, const Mesh& mesh);

}  // namespace fur::geometry
