// Makes a mesh of faces whose corners index positions, texture coordinates and normals separately, as in .obj and .fo.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/Model.h"

namespace fur::scene {

// Position, texture coordinate and normal, counted from 1; 0 where the corner has none.
using Corner = std::array<std::uint32_t, 3>;

struct CornerLists {
  std::vector<Vec3> positions;
  std::vector<Vec2> texcoords;  // as glTF has them
  std::vector<Vec3> normals;    // of any length
  std::vector<Corner> corners;  // three a triangle, every number within its list
};

struct CornerWeld {
  std::vector<std::uint32_t> vertexOf;  // one a corner, vertices in order of first appearance
  std::vector<std::uint32_t> cornerOf;  // one a vertex: its first corner
  double scale = 1;                     // by which buildMesh() fitted the mesh to the unit sphere
};

// Indices of the corners, stably sorted by their third, then second, then first number. `limits`: the largest value of each
// number. A counting sort, linear in corners and limits.
std::vector<std::uint32_t> sortedCorners(const std::vector<Corner>& corners, const Corner& limits);

// Corners are the same vertex when all three numbers are.
CornerWeld weldCorners(const std::vector<Corner>& corners, const Corner& limits);

// (0, 0) for coordinates so large that a float cannot distinguish neighbouring texels.
Vec2 usableTexcoord(const Vec2& uv);

// Fills the mesh, fitted to the unit sphere, hasTexcoords and bounds. Without normals, edges of more than 60 degrees are hard
// and others smooth. Throws ImportError (too-large).
CornerWeld buildMesh(CornerLists lists, Model& model);

}  // namespace fur::scene
