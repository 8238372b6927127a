// The skin of a model that changes its shape, as it is now.
#pragma once

#include <span>

#include "core/Math.h"

namespace fur::render {

// One of each a vertex of the surface, normals and tangents unit and across each other.
struct Skin {
  std::span<const Vec3> positions, normals, tangents;
};

}  // namespace fur::render
