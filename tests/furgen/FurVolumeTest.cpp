#include "furgen/FurVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "furgen/Strands.h"

namespace fur::furgen {
namespace {

FurParameters smallCoat() {
  FurParameters p;
  p.size = 128;
  p.layers = 16;
  return p;
}

double layerCover(const FurVolume& v, int layer) {
  const std::size_t texels = static_cast<std::size_t>(v.size) * v.size;
  double sum = 0;
  for (std::size_t i = 0; i < texels; ++i) sum += v.coverage[layer * texels + i];
  return sum / (255.0 * static_cast<double>(texels));
}

std::uint64_t fnv(const void* data, std::size_t bytes, std::uint64_t hash = 1469598103934665603ull) {
  const auto* p = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < bytes; ++i) hash = (hash ^ p[i]) * 1099511628211ull;
  return hash;
}

std::uint64_t hashOf(const FurVolume& v) {
  return fnv(v.tangent.data(), v.tangent.size(), fnv(v.coverage.data(), v.coverage.size()));
}

TEST(FurVolume, CoversMoreWithDensity) {
  double last = -1;
  for (const float density : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    FurParameters p = smallCoat();
    p.density = density;
    const double cover = layerCover(generateFur(p), 0);
    EXPECT_GT(cover, last);
    last = cover;
  }
}

TEST(FurVolume, CoversMoreWithThickness) {
  double last = 0;
  for (const float thickness : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    FurParameters p = smallCoat();
    p.size = 256;
    p.curl = 0;
    p.thickness = thickness;
    const double cover = layerCover(generateFur(p), 0);
    EXPECT_GT(cover, last) << thickness;
    last = cover;
  }
}

TEST(FurVolume, CoversHalfTheSkinAtItsDensest) {
  FurParameters p;
  p.density = p.thickness = 1;
  p.curl = 0;
  EXPECT_GE(generateFur(p).density, 0.48f);
}

TEST(FurVolume, OfStraightStrandsNeverThickensWithHeight) {
  FurParameters p = smallCoat();
  p.curl = 0;
  const FurVolume v = generateFur(p);
  const std::size_t texels = static_cast<std::size_t>(v.size) * v.size;
  for (std::size_t i = texels; i < v.coverage.size(); ++i) ASSERT_LE(v.coverage[i], v.coverage[i - texels]);
}

TEST(FurVolume, CoversTheAreaOfItsDiscsWhereverTheyFallBetweenTexels) {
  // One strand a seed, of 3 texels at the skin down to 0.7 at the tip.
  FurParameters p = smallCoat();
  p.density = 1e-6f;
  p.curl = 0;
  p.lengthVariation = 0;
  p.layers = 4;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    p.seed = seed;
    const auto strands = growStrands(p);
    const FurVolume v = generateFur(p);
    ASSERT_EQ(v.strandCount, 1);
    for (int layer = 0; layer < 4; ++layer) {
      const double r = strandRadius(strands[0], layerHeight(layer, 4));
      const double area = kPi * r * r;
      // Sampling a disc of under two texels at texel centres is off by up to a tenth.
      EXPECT_NEAR(layerCover(v, layer) * v.size * v.size, area, 0.1 * area);
    }
  }
}

TEST(FurVolume, TilesWithoutASeam) {
  // Were strands cut off at the border, neighbours across it would differ more than neighbours inside.
  FurParameters p;
  p.curl = 0.5f;
  const FurVolume v = generateFur(p);
  const auto step = [&](int x0, int x1) {
    double sum = 0;
    for (int layer = 0; layer < v.layers; ++layer)
      for (int y = 0; y < v.size; ++y) {
        const std::size_t row = (static_cast<std::size_t>(layer) * v.size + y) * v.size;
        sum += std::abs(int{v.coverage[row + x0]} - int{v.coverage[row + x1]});
      }
    return sum;
  };
  double inside = 0;
  for (int x = 0; x + 1 < v.size; ++x) inside = std::max(inside, step(x, x + 1));
  EXPECT_LE(step(v.size - 1, 0), inside);
}

TEST(FurVolume, HasUnitTangentsThatPointUp) {
  FurParameters p = smallCoat();
  p.curl = 1;
  const FurVolume v = generateFur(p);
  for (std::size_t i = 0; i < v.coverage.size(); ++i) {
    const Vec3 t(v.tangent[i * 3], v.tangent[i * 3 + 1], v.tangent[i * 3 + 2]);
    ASSERT_GT(t.z, 0.0f);
    ASSERT_NEAR(glm::length(t) / 127.0f, 1.0f, 0.01f);  // rounding of three components to 1/127
  }
}

TEST(FurVolume, HasOffsetsThatLeadBackToTheRoot) {
  FurParameters p = smallCoat();
  p.curl = 1;
  p.clump = 0.5f;
  const auto strands = growStrands(p);
  const FurVolume v = generateFur(p);
  const float size = static_cast<float>(v.size);
  for (int layer = 0; layer < v.layers; ++layer)
    for (int y = 0; y < v.size; ++y)
      for (int x = 0; x < v.size; ++x) {
        const std::size_t i = (static_cast<std::size_t>(layer) * v.size + y) * v.size + x;
        if (v.strandId[i] == 0) continue;
        const Vec2 root = strands[v.strandId[i] - 1u].root;
        const Vec2 back(x + 0.5f + v.offset[i * 2] / 64.0f, y + 0.5f + v.offset[i * 2 + 1] / 64.0f);
        // Half of the offset's step of 1/64 texel, and single precision.
        ASSERT_NEAR(torusDelta(back.x, root.x, size), 0.0f, 0.009f);
        ASSERT_NEAR(torusDelta(back.y, root.y, size), 0.0f, 0.009f);
      }
}

TEST(FurVolume, KeepsDominanceAndVarianceOfAStrandAlongItsLength) {
  const FurVolume v = generateFur(smallCoat());
  std::vector<int> dominance(v.strandCount + 1, -1), variance(v.strandCount + 1, -1);
  for (std::size_t i = 0; i < v.coverage.size(); ++i) {
    const std::uint16_t id = v.strandId[i];
    ASSERT_LE(id, v.strandCount);
    if (id == 0) continue;
    if (dominance[id] < 0) dominance[id] = v.dominance[i], variance[id] = v.variance[i];
    ASSERT_EQ(dominance[id], v.dominance[i]);
    ASSERT_EQ(variance[id], v.variance[i]);
    ASSERT_GE(v.dominance[i], 128);
  }
}

TEST(FurVolume, IsTheSameForTheSameSeedOnEveryPlatform) {
  FurParameters p = smallCoat();
  p.curl = 0.6f;
  p.clump = 0.4f;
  const FurVolume v = generateFur(p);
  EXPECT_EQ(hashOf(v), hashOf(generateFur(p)));
  // Native (gcc, x86-64) and wasm both gave this when it was written; a change of the generator changes it.
  EXPECT_EQ(hashOf(v), 0x431515ff8965519dull);
  p.seed = 2;
  EXPECT_NE(hashOf(generateFur(p)), hashOf(v));
}

TEST(FurVolume, IsValidInEveryCornerOfTheParameters) {
  for (int corner = 0; corner < 64; ++corner) {
    const auto bit = [&](int k) { return static_cast<float>((corner >> k) & 1); };
    FurParameters p;
    p.size = 64;
    p.layers = 8;
    p.density = bit(0), p.thickness = bit(1), p.lengthVariation = bit(2);
    p.length = bit(3), p.curl = bit(4), p.clump = bit(5);
    const FurVolume v = generateFur(p);
    const std::size_t texels = 8 * 64 * 64;
    ASSERT_EQ(v.coverage.size(), texels);
    ASSERT_EQ(v.tangent.size(), texels * 3);
    ASSERT_EQ(v.offset.size(), texels * 2);
    ASSERT_EQ(packLayers(v).size(), texels * 4);
    ASSERT_EQ(packFin(v).size(), static_cast<std::size_t>(v.finRows) * 64 * 4);
    EXPECT_EQ(v.strandCount > 0, p.density > 0) << corner;
    EXPECT_EQ(v.density > 0, p.density > 0) << corner;
    EXPECT_GE(v.weight, 0.0f);
    EXPECT_LE(v.weight, 1.0f);
  }
}

TEST(FurVolume, ClampsWhatIsOutOfRange) {
  FurParameters p;
  p.size = 100;
  p.layers = 1;
  p.density = 7;
  p.curl = std::nanf("");
  p.thickness = -1;
  const FurVolume v = generateFur(p);
  EXPECT_EQ(v.size, 64);
  EXPECT_EQ(v.layers, 4);
  EXPECT_GT(v.strandCount, 0);
}

TEST(FurVolume, HasAFinMapThatThinsUpwardsAndTiles) {
  FurParameters p;
  p.curl = 0;
  p.lengthVariation = 0.5f;
  const FurVolume v = generateFur(p);
  ASSERT_GE(v.finRows, 64);
  const auto row = [&](int r) {
    double sum = 0;
    for (int x = 0; x < v.size; ++x) sum += v.finCoverage[static_cast<std::size_t>(r) * v.size + x];
    return sum;
  };
  EXPECT_GT(row(0), 0.0);
  for (int r = 1; r < v.finRows; ++r) EXPECT_LE(row(r), row(r - 1) + v.size * 0.5);  // half a step of rounding
}

TEST(FurVolume, GrowsHeavierWithLengthAndDensity) {
  FurParameters p = smallCoat();
  const float standard = generateFur(p).weight;
  p.length = 0.5f;
  EXPECT_LT(generateFur(p).weight, standard);
  p = smallCoat();
  p.density = 0.3f;
  EXPECT_LT(generateFur(p).weight, standard);
}

TEST(PackLayers, HoldsCoverageTangentAndVariance) {
  const FurVolume v = generateFur(smallCoat());
  const auto packed = packLayers(v);
  for (std::size_t i = 0; i < v.coverage.size(); i += 97) {
    EXPECT_EQ(packed[i * 4], v.coverage[i]);
    EXPECT_EQ(packed[i * 4 + 3], v.variance[i]);
    // Half a step of 1/255 doubled, the stored tangent being exact to 1/127.
    EXPECT_NEAR(packed[i * 4 + 1] / 255.0 * 2 - 1, v.tangent[i * 3] / 127.0, 0.0041);
    EXPECT_NEAR(packed[i * 4 + 2] / 255.0 * 2 - 1, v.tangent[i * 3 + 1] / 127.0, 0.0041);
  }
}

}  // namespace
}  // namespace fur::furgen
