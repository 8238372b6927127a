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

Sum sumAt(const MapsToPack& maps, std::size_t i) {
  // The nearest strand of an empty texel counts a little, so that every mean is of something.
  const float cover = maps.coverage[i], weight = cover + 1.0f;
  if (!maps.hasStrands()) return {cover, weight, 0, 0, Vec3(0), Vec2(0)};
  const std::int8_t* t = &maps.tangent[i * 3];
  return {cover, weight, weight * static_cast<float>(maps.variance[i]), weight * static_cast<float>(maps.dominance[i]),
          weight * Vec3(t[0], t[1], t[2]),
          maps.offset.empty() ? Vec2(0) : weight * Vec2(maps.offset[i * 2], maps.offset[i * 2 + 1])};
}

// Two by two texels become one; a side of one texel stays. `at(i)`: the sum of texel i.
template <class At>
std::vector<Sum> halved(const At& at, int width, int height) {
  const int nextWidth = std::max(width / 2, 1), nextHeight = std::max(height / 2, 1);
  std::vector<Sum> out(static_cast<std::size_t>(nextWidth) * nextHeight);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      out[static_cast<std::size_t>(std::min(y / 2, nextHeight - 1)) * nextWidth + std::min(x / 2, nextWidth - 1)] +=
          at(static_cast<std::size_t>(y) * width + x);
  return out;
}

PackedLevel emptyLevel(int width, int height, bool strands) {
  const std::size_t texels = static_cast<std::size_t>(width) * height, ofStrands = strands ? texels : 0;
  return {width, height, std::vector<std::uint8_t>(texels), std::vector<std::uint8_t>(4 * ofStrands), std::vector<std::uint8_t>(2 * ofStrands)};
}

std::uint8_t meanByte(float sum, float weight) { return static_cast<std::uint8_t>(sum / weight + 0.5f); }

// The texels themselves. `offsetScale`: from offsets to widths of the map.
PackedLevel packTexels(const MapsToPack& maps, int width, int height, float offsetScale) {
  PackedLevel level = emptyLevel(width, height, maps.hasStrands());
  std::copy(maps.coverage.begin(), maps.coverage.end(), level.coverage.begin());
  if (!maps.hasStrands()) return level;
  std::uint8_t tangentByte[256];
  for (int t = -128; t < 128; ++t) tangentByte[static_cast<std::uint8_t>(t)] = unitByte(static_cast<float>(t) / 127.0f * 0.5f + 0.5f);
  for (std::size_t i = 0; i < maps.coverage.size(); ++i) {
    std::uint8_t* strand = &level.strand[4 * i];
    strand[0] = tangentByte[static_cast<std::uint8_t>(maps.tangent[3 * i])];
    strand[1] = tangentByte[static_cast<std::uint8_t>(maps.tangent[3 * i + 1])];
    strand[2] = maps.variance[i], strand[3] = maps.dominance[i];
  }
  for (std::size_t i = 0; i < level.offset.size(); ++i)
    level.offset[i] = unitByte(maps.offset.empty() ? 0.5f : static_cast<float>(maps.offset[i]) * offsetScale + 0.5f);
  return level;
}

// `texels` of level 0 to one of these.
PackedLevel packSums(const std::vector<Sum>& sums, int width, int height, float texels, float offsetScale, bool strands) {
  PackedLevel level = emptyLevel(width, height, strands);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Sum& s = sums[i];
    level.coverage[i] = meanByte(s.cover, texels);
    if (!strands) continue;
    const Vec3 t = normalizeOr(s.tangent, Vec3(0, 0, 1));
    std::uint8_t* strand = &level.strand[4 * i];
    strand[0] = unitByte(t.x * 0.5f + 0.5f), strand[1] = unitByte(t.y * 0.5f + 0.5f);
    strand[2] = meanByte(s.variance, s.weight), strand[3] = meanByte(s.dominance, s.weight);
    const Vec2 offset = s.offset * (offsetScale / s.weight) + 0.5f;
    level.offset[2 * i] = unitByte(offset.x), level.offset[2 * i + 1] = unitByte(offset.y);
  }
  return level;
}

}  // namespace

bool sharesStrands(const FurParameters& parameters) { return parameters.coil <= 0 && parameters.curl <= 0.5f; }

std::vector<PackedLevel> packLevels(int width, int height, const MapsToPack& maps) {
  const float offsetScale = 1.0f / (64.0f * static_cast<float>(width));
  std::vector<PackedLevel> levels{packTexels(maps, width, height, offsetScale)};
  std::vector<Sum> sums;
  float texels = 1;
  while (width > 1 || height > 1) {
    sums = levels.size() == 1 ? halved([&](std::size_t i) { return sumAt(maps, i); }, width, height)
                              : halved([&](std::size_t i) -> const Sum& { return sums[i]; }, width, height);
    texels *= static_cast<float>((width > 1 ? 2 : 1) * (height > 1 ? 2 : 1));
    width = std::max(width / 2, 1), height = std::max(height / 2, 1);
    levels.push_back(packSums(sums, width, height, texels, offsetScale, maps.hasStrands()));
  }
  return levels;
}

}  // namespace fur::furgen
