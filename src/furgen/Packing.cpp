#include "furgen/Packing.h"

#include <algorithm>
#include <cmath>

namespace fur::furgen {

namespace {

// Sums over the texels of level 0: coverage, the weight of what lies there, and what it weighs.
struct Sum {
  float cover = 0, weight = 0, variance = 0, dominance = 0;
  Vec3 tangent{0};
  Vec2 offset{0};

  Sum& operator+=(const Sum& o) {
    cover += o.cover, weight += o.weight, variance += o.variance, dominance += o.dominance;
    tangent += o.tangent, offset += o.offset;
    return *this;
  }
};

// Two by two texels become one; a side of one texel stays.
std::vector<Sum> halved(const std::vector<Sum>& sums, int width, int height) {
  const int nextWidth = std::max(width / 2, 1), nextHeight = std::max(height / 2, 1);
  std::vector<Sum> out(static_cast<std::size_t>(nextWidth) * nextHeight);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      out[static_cast<std::size_t>(std::min(y / 2, nextHeight - 1)) * nextWidth + std::min(x / 2, nextWidth - 1)] +=
          sums[static_cast<std::size_t>(y) * width + x];
  return out;
}

std::uint8_t meanByte(float sum, float weight) { return static_cast<std::uint8_t>(sum / weight + 0.5f); }

// `texels` of level 0 to one of these; `offsetScale`: from offsets to widths of the map.
PackedLevel packSums(const std::vector<Sum>& sums, int width, int height, float texels, float offsetScale) {
  PackedLevel level{width, height, {}, {}, {}};
  level.coverage.reserve(sums.size()), level.strand.reserve(sums.size() * 4), level.offset.reserve(sums.size() * 2);
  for (const Sum& s : sums) {
    const Vec3 t = texels > 1 ? normalizeOr(s.tangent, Vec3(0, 0, 1)) : s.tangent / (127.0f * s.weight);
    level.coverage.push_back(meanByte(s.cover, texels));
    for (const std::uint8_t byte : {unitByte(t.x * 0.5f + 0.5f), unitByte(t.y * 0.5f + 0.5f),
                                    meanByte(s.variance, s.weight), meanByte(s.dominance, s.weight)})
      level.strand.push_back(byte);
    const Vec2 offset = s.offset * (offsetScale / s.weight) + 0.5f;
    level.offset.push_back(unitByte(offset.x)), level.offset.push_back(unitByte(offset.y));
  }
  return level;
}

}  // namespace

std::vector<PackedLevel> packLevels(int width, int height, const MapsToPack& maps) {
  std::vector<Sum> sums(maps.coverage.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    // The nearest strand of an empty texel counts a little, so that every mean is of something.
    const float cover = maps.coverage[i], weight = cover + 1.0f;
    const std::int8_t* t = &maps.tangent[i * 3];
    sums[i] = {cover, weight, weight * static_cast<float>(maps.variance[i]), weight * static_cast<float>(maps.dominance[i]),
               weight * Vec3(t[0], t[1], t[2]),
               maps.offset.empty() ? Vec2(0) : weight * Vec2(maps.offset[i * 2], maps.offset[i * 2 + 1])};
  }
  const float offsetScale = 1.0f / (64.0f * static_cast<float>(width));
  std::vector<PackedLevel> levels{packSums(sums, width, height, 1, offsetScale)};
  float texels = 1;
  while (width > 1 || height > 1) {
    sums = halved(sums, width, height);
    texels *= static_cast<float>((width > 1 ? 2 : 1) * (height > 1 ? 2 : 1));
    width = std::max(width / 2, 1), height = std::max(height / 2, 1);
    levels.push_back(packSums(sums, width, height, texels, offsetScale));
  }
  return levels;
}

}  // namespace fur::furgen
