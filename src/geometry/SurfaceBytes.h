// A surface as bytes, for another program of the same build with the same mesh: making it takes most of the time that
// loading a large model does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/Surface.h"

namespace fur::geometry {

std::vector<std::uint8_t> surfaceBytes(const Surface& surface);
// Nothing unless all of it is there, its indices lead to its vertices and these to the mesh's.
std::optional<Surface> surfaceFromBytes(std::span<const std::uint8_t> bytes, const Mesh& mesh);

}  // namespace fur::geometry
