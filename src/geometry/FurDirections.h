// The directions in which fur grows: the model's normals without what turns to and fro from one vertex to the next.
//
// Normals of scans, and of models with few triangles, differ by some degrees from one vertex to the next. Skin hardly shows it, but
// strands go on from there by their length, which is often that of several triangles: their tips crowd and part, and coats that
// lie looked crimped. Normals are smoothed as Taubin smooths positions (1995, "A Signal Processing Approach to Fair Surface
// Design"): each round towards the mean of the neighbours is followed by one away from it, so that what is longer than about five edges
// stays, and round bodies keep their curvature. Neighbours count by the cotangents of the angles across from them, so that it does
// not matter how triangles are cut, and by how far their normals agree: creases and ridges stay. So do the rims of what is open, and
// directions that lean over hard edges (HardEdges.h) with what is beside them.
//
// Only + - * / and square roots: the same on every platform.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Mesh.h"

namespace fur::geometry {

class FurDirections {
 public:
  // Of a mesh with unit normals. `upright`: one a vertex, the normals without what leans over hard edges; empty where nothing does.
  FurDirections(const Mesh& mesh, const std::vector<Vec3>& upright);
  // One round, of some milliseconds for a large model. Whether that was the last.
  bool step();
  // Unit, one a vertex.
  std::vector<Vec3> directions() const;

 private:
  struct Side {
    std::uint32_t a, b;  // points
    float weight;
  };
  std::vector<std::uint32_t> pointOf_;  // vertices of one position and normal are one point
  std::vector<Side> sides_;             // of all triangles
  std::vector<Vec3> normals_;           // of points, the others are not used
  std::vector<std::uint8_t> stays_;
  int round_ = 0;
};

}  // namespace fur::geometry
