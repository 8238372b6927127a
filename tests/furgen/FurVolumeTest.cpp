#include "furgen/FurVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/Fnv1a.h"
#include "furgen/Layers.h"
#include "furgen/Packing.h"
#include "tests/OnEveryPlatform.h"

namespace fur::furgen {
namespace {

FurParameters smallVolume() {
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

std::uint64_t hashOf(const FurVolume& v) {
  Fnv1a hash;
  hash.addAll(v.coverage), hash.addAll(v.dominance), hash.addAll(v.variance), hash.addAll(v.tangent), hash.addAll(v.offset), hash.addAll(v.strandId);
  hash.addAll(v.finCoverage), hash.addAll(v.finDominance), hash.addAll(v.finVariance), hash.addAll(v.finTangent);
  return hash.value();
}

TEST(FurVolume, CoversMoreWithDensity) {
  double last = -1;
  for (const float density : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    FurParameters p = smallVolume();
    p.density = density;
    const double cover = layerCover(generateFur(p), 0);
    EXPECT_GT(cover, last);
    last = cover;
  }
}

TEST(FurVolume, CoversMoreWithThickness) {
  double last = 0;
  for (const float thickness : {0.0f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    FurParameters p = smallVolume();
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
  FurParameters p = smallVolume();
  p.curl = 0;
  const FurVolume v = generateFur(p);
  const std::size_t texels = static_cast<std::size_t>(v.size) * v.size;
  for (std::size_t i = texels; i < v.coverage.size(); ++i) ASSERT_LE(v.coverage[i], v.coverage[i - texels]);
}

TEST(FurVolume, CoversTheAreaOfItsStrandWhereverItStandsAndHoweverItLeans) {
  // One strand of one piece, of 3 texels down to less than one.
  for (const float radius : {3.0f, 1.2f, 0.4f, 0.15f})
    for (const float lean : {0.0f, 2.0f, 30.0f})
      for (int k = 0; k < 8; ++k) {
        Coat coat;
        coat.parameters.size = 64;
        const float angle = 0.8f * static_cast<float>(k);
        const Vec2 way = lean * Vec2(std::cos(angle), std::sin(angle));
        coat.nodes = {{Vec2(0), 0, radius}, {way, 1.0f / 32, radius}};
        coat.strands = {{{31.3f + 0.13f * static_cast<float>(k), 60.7f}, 1.0f / 32, 1, 0.5f, 0, 2}};
        LayerPainter painter(coat);
        LayerMaps maps;
        painter.paint(0, 32, maps);
        const double area = kPi * radius * radius + 2 * radius * lean;
        // Sampling at texel centres is off by up to a tenth, and so is a byte for what covers little.
        EXPECT_NEAR(meanCover(maps.coverage) * 64 * 64, area, 0.1 * area + 0.05) << radius << ' ' << lean;
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
  FurParameters p = smallVolume();
  p.curl = 1;
  const FurVolume v = generateFur(p);
  for (std::size_t i = 0; i < v.coverage.size(); ++i) {
    const Vec3 t(v.tangent[i * 3], v.tangent[i * 3 + 1], v.tangent[i * 3 + 2]);
    ASSERT_GT(t.z, 0.0f);
    ASSERT_NEAR(glm::length(t) / 127.0f, 1.0f, 0.01f);  // rounding of three components to 1/127
  }
}

TEST(FurVolume, HasOffsetsThatLeadBackToTheRoot) {
  for (const float coil : {0.0f, 0.8f}) {
    FurParameters p = smallVolume();
    p.curl = 1;
    p.clump = 0.5f;
    p.wave = 1;
    p.coil = coil;
    const Coat coat = growCoat(p);
    const FurVolume v = volumeOf(coat, p.layers);
    const float size = static_cast<float>(v.size);
    for (int layer = 0; layer < v.layers; ++layer)
      for (int y = 0; y < v.size; ++y)
        for (int x = 0; x < v.size; ++x) {
          const std::size_t i = (static_cast<std::size_t>(layer) * v.size + y) * v.size + x;
          if (v.strandId[i] == 0) continue;
          const Vec2 root = coat.strands[v.strandId[i] - 1u].root;
          const Vec2 back(x + 0.5f + v.offset[i * 2] / 64.0f, y + 0.5f + v.offset[i * 2 + 1] / 64.0f);
          // Half of the offset's step of 1/64 texel, and single precision.
          ASSERT_NEAR(torusDelta(back.x, root.x, size), 0.0f, 0.009f);
          ASSERT_NEAR(torusDelta(back.y, root.y, size), 0.0f, 0.009f);
        }
  }
}

TEST(FurVolume, GivesEveryEmptyTexelItsTrueNearestStrand) {
  FurParameters p;
  p.size = 64;
  p.density = 0.3f;
  p.curl = 0.6f;
  const FurVolume v = generateFur(p);
  const int size = v.size;
  for (const int layer : {0, 9, 15}) {
    const std::size_t first = static_cast<std::size_t>(layer) * size * size;
    for (int i = 0; i < size * size; ++i) {
      int best = 1 << 30, taken = 1 << 30;
      for (int j = 0; j < size * size; ++j) {
        if (v.coverage[first + j] == 0) continue;
        int dx = std::abs(i % size - j % size), dy = std::abs(i / size - j / size);
        dx = std::min(dx, size - dx), dy = std::min(dy, size - dy);
        best = std::min(best, dx * dx + dy * dy);
        if (v.strandId[first + j] == v.strandId[first + i]) taken = std::min(taken, dx * dx + dy * dy);
      }
      // Texels covered by less than 1/510 have their strand but round to nothing, and so count as nearest.
      if (taken > best) ASSERT_LE(taken, best + 2 * static_cast<int>(std::sqrt(static_cast<float>(best))) + 2) << i;
    }
  }
}

TEST(FurVolume, KeepsDominanceAndVarianceOfAStrandAlongItsLength) {
  const FurVolume v = generateFur(smallVolume());
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

TEST(FurVolume, OfASeedIsTheSameOnEveryPlatform) {
  FurParameters locks = smallVolume();
  locks.curl = 0.6f;
  locks.wave = locks.clump = locks.roll = locks.frizz = locks.tipBreak = 0.4f;
  locks.undercoat = 0.7f;
  FurParameters coils = smallVolume();
  coils.coil = 0.6f;
  const FurVolume v = generateFur(locks);
  EXPECT_EQ(hashOf(v), hashOf(generateFur(locks)));
  test::printOnEveryPlatform("coat of locks", hashOf(v));
  test::printOnEveryPlatform("coat of coils", hashOf(generateFur(coils)));
  locks.seed = 2;
  EXPECT_NE(hashOf(generateFur(locks)), hashOf(v));
}

TEST(FurVolume, IsValidInEveryCornerOfTheParameters) {
  constexpr float FurParameters::*kAxes[] = {
      &FurParameters::density, &FurParameters::thickness, &FurParameters::taper, &FurParameters::lengthVariation,
      &FurParameters::length, &FurParameters::curl, &FurParameters::wave, &FurParameters::coil, &FurParameters::frizz,
      &FurParameters::clump, &FurParameters::lockSize, &FurParameters::roll, &FurParameters::stray,
      &FurParameters::tipBreak, &FurParameters::undercoat, &FurParameters::undercoatLength};
  constexpr int kCount = static_cast<int>(std::size(kAxes));
  // Every corner at 64 texels and 4 layers would take a minute; a fixed hundredth of them, and all those of
  // one parameter against the rest.
  for (unsigned corner = 0; corner < 1u << kCount; ++corner) {
    const bool oneAgainstTheRest = std::has_single_bit(corner) || std::has_single_bit(~corner & ((1u << kCount) - 1));
    if (corner * 2654435761u >> 24 > 2 && !oneAgainstTheRest) continue;
    FurParameters p;
    p.size = 64;
    p.layers = 8;
    for (int axis = 0; axis < kCount; ++axis) p.*kAxes[axis] = static_cast<float>((corner >> axis) & 1u);
    const FurVolume v = generateFur(p);
    const std::size_t texels = 8 * 64 * 64;
    ASSERT_EQ(v.coverage.size(), texels);
    ASSERT_EQ(v.tangent.size(), texels * 3);
    ASSERT_EQ(v.offset.size(), texels * 2);
    ASSERT_EQ(v.finCoverage.size(), static_cast<std::size_t>(v.finRows) * 64);
    ASSERT_EQ(v.finDominance.size(), v.finCoverage.size());
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
  FurParameters p = smallVolume();
  const float standard = generateFur(p).weight;
  p.length = 0.5f;
  EXPECT_LT(generateFur(p).weight, standard);
  p = smallVolume();
  p.density = 0.3f;
  EXPECT_LT(generateFur(p).weight, standard);
}

TEST(FurVolume, ThatFoldsBackHasSeveralStretchesOfOneStrandOnALayer) {
  // A coil crosses a height up to five times: more discs than strands.
  FurParameters p = smallVolume();
  p.coil = 1;
  p.density = 0.05f;
  const FurVolume v = generateFur(p);
  int parts = 0, texels = 0;
  for (int y = 0; y < v.size; ++y)
    for (int x = 0; x < v.size; ++x) {
      const std::size_t layer = static_cast<std::size_t>(8) * v.size * v.size;
      const bool here = v.coverage[layer + static_cast<std::size_t>(y) * v.size + x] > 128;
      const bool left = v.coverage[layer + static_cast<std::size_t>(y) * v.size + ((x + v.size - 1) & (v.size - 1))] > 128;
      const bool above = v.coverage[layer + static_cast<std::size_t>((y + v.size - 1) & (v.size - 1)) * v.size + x] > 128;
      texels += here;
      parts += here && !left && !above;
    }
  EXPECT_GT(parts, v.strandCount);
  EXPECT_GT(texels, 0);
}

}  // namespace
}  // namespace fur::furgen
