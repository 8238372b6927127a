// Faces whose corners refer to positions, texture coordinates and normals by separate numbers, as in .obj
// and .fo, become a mesh whose vertices hold one of each.
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
  std::vector<std::uint32_t> cornerOf;  // one a vertex: the first corner that is it
};

// Indices of the corners, sorted by their third, then second, then first number; equals stay in order.
// `limits`: no number is above its own. Linear in corners and limits, for it sorts by counting.
std::vector<std::uint32_t> sortedCorners(const std::vector<Corner>& corners, const Corner& limits);

// Corners are the same vertex when all three numbers are.
CornerWeld weldCorners(const std::vector<Corner>& corners, const Corner& limits);

// (0, 0) in place of coordinates so large that a float no longer tells neighbouring texels apart.
Vec2 usableTexcoord(const Vec2& uv);

// Fills the mesh, fitted to the unit sphere, hasTexcoords and bounds. Without any normals it is smooth but where faces meet at
// more than 60 degrees. Throws ImportError (too-large).
CornerWeld buildMesh(CornerLists lists, Model& model);

}  // namespace fur::scene
