// Fur round hard edges. Where faces meet at an angle and each has its own normals, the outsides of their coats part:
// between them would be a gap, as wide as the fur is long. As on an animal's rim, or a plush cube, fur near such an edge
// leans over it instead: all corners that meet at a point share one normal, and from there to kEdgeReach on either side
// normals turn evenly along the surface (a harmonic map), which needs vertices there. Faces of large triangles get
// them, and so do edges along which smooth normals turn by more than rays through the coat can follow.
//
// Points inserted lie on the triangles, whose shape stays as it is. Only directions of fur change: what a file says of
// normals, texture coordinates, charts and motion holds for the mesh that it has.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Mesh.h"

namespace fur::geometry {

// How far from a hard edge fur leans, model units: the default fur's length. Rims narrower than twice that lean all over.
inline constexpr float kEdgeReach = 0.12f;
// More vertices are not inserted: what is left lies in larger steps.
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
  Mesh mesh;  // positions, uv and indices; normals are those of the fur. Vertices inserted come last
  std::vector<Vec3> given;  // one a vertex: the normals of its faces
  std::vector<InsertedVertex> inserted;
  bool changed = false;  // else it is the mesh as it was, and the rest is empty
  bool sheets = false;   // it has the rim of a sheet
  // One a triangle: that of the given mesh on which it lies; and three: where its corners are in that.
  std::vector<std::uint32_t> triangleOf;
  std::vector<Vec3> weights;
};

// `mesh` has unit normals and only triangles with an area.
RoundedMesh roundHardEdges(const Mesh& mesh);

// Values of corners, three a triangle of the mesh, as those of the rounded one.
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
