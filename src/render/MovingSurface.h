// What the GPU has of a surface, kept here for a model that changes its shape: its vertices and fin edges follow the skin.
#pragma once

#include <span>
#include <vector>

#include "geometry/Surface.h"

namespace fur::render {

// What of a vertex goes along with the skin, and what stays; as shared/Blocks.h lists the attributes.
struct SkinVertex {
  Vec4 position, normal, gradS;
  Vec3 gradT;
};
struct FurVertex {
  Vec4 uvAtlas, fur, atlasFromFur;
  Vec4 around;
  Vec2 lean;
};
static_assert(sizeof(SkinVertex) == 15 * sizeof(float) && sizeof(FurVertex) == 18 * sizeof(float));

// A fin instance, in the order of shared/Blocks.h.
struct FinEdge {
  Vec4 positionA, positionB, normalA, normalB, face0, face1, atlas;
};

// The skin now: one of each a vertex of the surface, normals and tangents unit and across each other.
struct Skin {
  std::span<const Vec3> positions, normals, tangents;
};

class MovingSurface {
 public:
  // `tangents`: those of the shape that vertices and edges have now.
  MovingSurface(std::vector<SkinVertex> vertices, std::span<const Vec3> tangents, std::span<const FinEdge> edges);
  // Takes the vertices along, and those edges. Tile coordinates turn with the skin and do not stretch.
  void follow(const Skin& skin, std::vector<FinEdge>& edges);
  std::span<const SkinVertex> vertices() const { return vertices_; }

 private:
  std::vector<SkinVertex> vertices_;
  std::vector<Vec4> gradients_;    // of s and t, along the tangent and across it
  std::vector<Vec4> faceNormals_;  // of an edge's two faces, along the normal across the edge and to its side
};

}  // namespace fur::render
