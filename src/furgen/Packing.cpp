#include "furgen/Packing.h"

#include <algorithm>
#include <cmath>

namespace fur::furgen {

namespace {

// Sums over the texels of level 0: coverage, the weight of what lies there, and what it weighs.
struct Sum {
  float cover = 0, weight = 0, variance = 0;
  Vec3 tangent{0};

  Sum& operator+=(const Sum& o) {
    cover += o.cover, weight += o.weight, variance += o.variance, tangent += o.tangent;
    return *this;
  }
};

std::uint8_t tangentByte(float t) { return unitByte(t * 0.5f + 0.5f); }

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

PackedLevel packSums(const std::vector<Sum>& sums, int width, int height, float texels) {
  PackedLevel level{width, height, std::vector<std::uint8_t>(sums.size() * 4)};
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Sum& s = sums[i];
    const Vec3 t = normalizeOr(s.tangent, Vec3(0, 0, 1));
    std::uint8_t* out = &level.rgba[i * 4];
    out[0] = static_cast<std::uint8_t>(s.cover / texels + 0.5f);
    out[1] = tangentByte(t.x);
    out[2] = tangentByte(t.y);
    out[3] = static_cast<std::uint8_t>(s.variance / s.weight + 0.5f);
  }
  return level;
}

}  // namespace

std::vector<PackedLevel> packLevels(int width, int height, std::span<const std::uint8_t> coverage,
                                    std::span<const std::int8_t> tangent, std::span<const std::uint8_t> variance) {
  std::vector<PackedLevel> levels(1);
  PackedLevel& first = levels[0];
  first = {width, height, std::vector<std::uint8_t>(coverage.size() * 4)};
  std::vector<Sum> sums(coverage.size());
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const Vec3 t(tangent[i * 3], tangent[i * 3 + 1], tangent[i * 3 + 2]);
    std::uint8_t* out = &first.rgba[i * 4];
    out[0] = coverage[i];
    out[1] = tangentByte(t.x / 127.0f);
    out[2] = tangentByte(t.y / 127.0f);
    out[3] = variance[i];
    // The nearest strand of an empty texel counts a little, so that every mean is of something.
    const float weight = static_cast<float>(coverage[i]) + 1.0f;
    sums[i] = {static_cast<float>(coverage[i]), weight, weight * static_cast<float>(variance[i]), t * weight};
  }
  float texels = 1;
  while (width > 1 || height > 1) {
    sums = halved(sums, width, height);
    texels *= static_cast<float>((width > 1 ? 2 : 1) * (height > 1 ? 2 : 1));
    width = std::max(width / 2, 1), height = std::max(height / 2, 1);
    levels.push_back(packSums(sums, width, height, texels));
  }
  return levels;
}

}  // namespace fur::furgen
