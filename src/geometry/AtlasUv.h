// Whether a mesh's own uv can serve as its atlas.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Mesh.h"

namespace fur::geometry {

// Unique: every uv in [0,1]^2, no two triangles of `indices` overlap by more than a tenth of a texel
// of a 1024^2 map, and at most a thousandth of the surface's area has no area in uv.
bool isUniqueAtlas(const Mesh& mesh, const std::vector<std::uint32_t>& indices);

// The island of every triangle, 0-based in order of first appearance: triangles are of one island when
// they share an edge with the same uv on both sides. `across` as neighboursAcrossSides gives it.
std::vector<std::uint32_t> uvIslands(const std::vector<Vec3>& positions, const std::vector<Vec2>& uv,
                                     const std::vector<std::uint32_t>& indices,
                                     const std::vector<std::uint32_t>& across, std::uint32_t& count);

}  // namespace fur::geometry
