// Reads glTF accessors; every access is checked against the bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/import/GltfFile.h"

namespace fur::scene {

// The elements as floats, `components` each (1 SCALAR, 2 VEC2, 3 VEC3, 4 VEC4, 16 MAT4), normalized integers as
// KHR_mesh_quantization has it, sparse values in place. Not checked for NaN. At most kMaxVertices elements.
std::vector<float> readFloats(const GltfFile& file, Whole accessor, int components);

// A SCALAR accessor of unsigned integers. At most kMaxIndices.
std::vector<std::uint32_t> readIndices(const GltfFile& file, Whole accessor);

// How many elements the accessor says it has (within kMaxIndices).
std::size_t elementCount(const GltfFile& file, Whole accessor);

inline constexpr std::size_t kMaxIndices = 3 * kMaxVertices;

}  // namespace fur::scene
