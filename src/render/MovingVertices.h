// The vertices of a model that changes its shape, kept on this side of the GPU: they follow the skin.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/Curvature.h"
#include "render/Skin.h"

namespace fur::render {

// What of a vertex goes along with the skin; as shared/Blocks.h lists the attributes.
struct SkinVertex {
  Vec4 position, normal, gradS;
  Vec3 gradT;
};
static_assert(sizeof(SkinVertex) == 15 * sizeof(float));

class MovingVertices {
 public:
  // `tangents`: those of the shape that the vertices have now. `triangles`: three vertices each.
  MovingVertices(std::vector<SkinVertex> vertices, std::span<const Vec3> tangents, std::span<const std::uint32_t> triangles);
  // Tile coordinates turn with the skin and do not stretch. Where the skin bends outwards, as at knees, it curves more; where it folds
  // it curves as it did, or strands of both sides would cross.
  void follow(const Skin& skin);
  std::span<const SkinVertex> vertices() const { return vertices_; }

 private:
  std::vector<SkinVertex> vertices_;
  std::vector<Vec4> gradients_;  // of s and t, along the tangent and across it
  geometry::MovingCurvature curvature_;
  std::vector<Vec3> first_, firstMoving_;  // curvature at first: as the surface has it; by curvature_
};

}  // namespace fur::render
