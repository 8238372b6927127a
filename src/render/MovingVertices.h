// The vertices of a model that changes its shape, kept on this side of the GPU: they follow the skin.
#pragma once

#include <span>
#include <vector>

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
  // `tangents`: those of the shape that the vertices have now.
  MovingVertices(std::vector<SkinVertex> vertices, std::span<const Vec3> tangents);
  // Tile coordinates turn with the skin and do not stretch.
  void follow(const Skin& skin);
  std::span<const SkinVertex> vertices() const { return vertices_; }

 private:
  std::vector<SkinVertex> vertices_;
  std::vector<Vec4> gradients_;  // of s and t, along the tangent and across it
};

}  // namespace fur::render
