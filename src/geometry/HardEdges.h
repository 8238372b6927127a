// Fur at hard edges. Where faces meet at an angle and each has its own normals, their coats would part and leave a gap as wide
// as the fur is long. Instead, fur near such an edge leans over it, as on a plush cube: all corners at a point share one
// normal, and from there to kEdgeReach on both sides the normals change evenly along the surface (a harmonic map). This
// needs vertices inside large triangles, which are inserted; also along edges whose smooth normals turn by more than
// rays through the coat can follow.
//
// Inserted vertices lie on the triangles, so the shape stays as it is; only the directions of fur change. Normals, texture
// coordinates, charts and animations of a file refer to the mesh as it was.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Mesh.h"

namespace fur::geometry {

// How far from a hard edge fur leans, model units: the default fur's length. Rims narrower than twice that lean all over.
inline constexpr float kEdgeReach = 0.12f;
// The most vertices that are inserted; beyond that normals change in larger steps.
inline constexpr std::size_t kMostInserted = 20'000;

// A vertex between two others of lower number: a value there is a + (b - a) t of theirs.
struct InsertedVertex {
  std::uint32_t a, b;
  float t;
  template <class T>
  T of(const std::vector<T>& values) const {
    return values[a] + (values[b] - values[a]) * t;
  }
};

struct RoundedMesh {
  Mesh mesh;  // positions, uv and indices; the normals are those of the fur. Inserted vertices come last
  std::vector<Vec3> given;  // one a vertex: the normals as the mesh had them
  std::vector<InsertedVertex> inserted;
  bool changed = false;  // false: `mesh` is the mesh as it was, and the rest is empty
  bool sheets = false;   // it has the rim of a sheet
  // For each triangle the triangle of the given mesh on which it lies, and its three corners' barycentric weights there.
  std::vector<std::uint32_t> triangleOf;
  std::vector<Vec3> weights;
};

// `mesh` has unit normals and only triangles with an area.
RoundedMesh roundHardEdges(const Mesh& mesh);

// Interpolates values of the mesh's corners, three a triangle, for the corners of the rounded mesh.
template <class T>
std::vector<T> ofRoundedCorners(const RoundedMesh& rounded, const std::vector<T>& corners) {
  std::vector<T> out;
  out.reserve(rounded.weights.size());
  for (std::size_t i = 0; i < rounded.weights.size(); ++i) {
    const T* of = &corners[3 * std::size_t{rounded.triangleOf[i / 3]}];
    const Vec3& w = rounded.weights[i];
    out.push_back(of[0] * w.x + of[1] * w.y + of[2] * w.z);
  }
  return out;
}

}  // namespace fur::geometry
