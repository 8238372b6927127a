// Lets the edges of a model that changes its shape follow the skin.
#pragma once

#include <span>

#include "render/passes/fin/FinEdges.h"

namespace fur::render {

class MovingEdges {
 public:
  explicit MovingEdges(std::span<const FinEdge> edges);
  // The same edges. Their faces turn with the skin at their ends.
  void follow(const Skin& skin, std::vector<FinEdge>& edges) const;

 private:
  std::vector<Vec4> faceNormals_;  // of an edge's two faces, along the normal across the edge and to its side
};

}  // namespace fur::render
