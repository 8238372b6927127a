// The edges of a surface that fins may stand on, as the GPU takes them.
#pragma once

#include <vector>

#include "geometry/Surface.h"
#include "render/Skin.h"

namespace fur::render {

// A fin instance, in the order of shared/Blocks.h.
struct FinEdge {
  Vec4 positionA, positionB, normalA, normalB, face0, face1, atlas;
  Vec2 room;
};

std::vector<FinEdge> finEdges(const geometry::Surface& surface);

}  // namespace fur::render
