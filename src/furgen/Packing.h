// How values are stored in the bytes of a fur volume and of the textures made of it.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "furgen/Layers.h"

namespace fur::furgen {

inline std::uint8_t unitByte(float x) { return static_cast<std::uint8_t>(saturate(x) * 255.0f + 0.5f); }

// The unit tangent, times 127, of a step of (x, y) texels and `rise` volume heights. It is flipped to point upwards, as
// shading is the same for both directions; z is at least 1.
void packTangent(const Vec2& way, float rise, std::int8_t* out);

// One component of an offset, texels * 64.
inline std::int16_t packOffset(float texels) {
  return static_cast<std::int16_t>(std::floor(glm::clamp(texels * 64.0f, -32768.0f, 32767.0f) + 0.5f));
}

// A mip level as shaders read it. Coverage has a texture of its own, as the march reads it at every step and the others only
// where it meets a strand.
struct PackedLevel {
  int width = 0, height = 0;
  std::vector<std::uint8_t> coverage;  // R8
  std::vector<std::uint8_t> strand;    // RGBA8: tangent x, tangent y (both * 0.5 + 0.5), variance, dominance
  std::vector<std::uint8_t> offset;    // RG8: 0.5 + the way back to the strand's root in widths of the map
};

// How a coat lies in textures. Each layer has its coverage; where strands hardly change from one to the next, two layers share
// those of the lower one, as none begins above the skin: half the bytes, and less to pack.
struct CoatShape {
  int size = 1, layers = 1, finRows = 1, types = 1;
  bool sharesStrands = false;

  bool hasStrands(int layer) const { return !sharesStrands || layer % 2 == 0; }
  int strandLayer(int layer) const { return sharesStrands ? layer / 2 : layer; }
  int strandLayers() const { return strandLayer(layers - 1) + 1; }
};

// Whether two of its layers can share strands: coils, and curls from so much on, have moved on by a strand's width.
bool sharesStrands(const FurParameters& parameters);

// The maps to pack, see LayerMaps. `offset` may be empty, and all but the coverage: then levels have that alone.
struct MapsToPack {
  std::span<const std::uint8_t> coverage{}, dominance{}, variance{};
  std::span<const std::int8_t> tangent{};
  std::span<const std::int16_t> offset{};

  bool hasStrands() const { return !tangent.empty(); }
};

// Level 0 and its mipmaps down to 1 x 1. A mipmap's texel has the mean coverage (the renderer uses fractional coverage, so fur
// keeps its opacity far away), and the means of the other values weighted by coverage; mean tangents are normalised. Means
// are computed from level 0, without rounding between levels.
std::vector<PackedLevel> packLevels(int width, int height, const MapsToPack& maps);

}  // namespace fur::furgen
