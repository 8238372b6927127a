#include "scene/TypeSet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "core/Random.h"

namespace fur::scene {
namespace {

using furgen::FurVolume;
using ByteVector = std::vector<std::uint8_t>;

constexpr std::size_t kTexels = 256 * 256, kFinStart = 16 * kTexels * 3, kDensityAt = kFinStart + 64 * 256 * 3;

FurVolume coat(float curl) {
  furgen::FurParameters p;
  p.curl = curl;
  return furgen::generateFur(p);
}

ByteVector written(const FurVolume& volume) {
  const auto bytes = writeTypeSet(volume);
  EXPECT_TRUE(bytes) << bytes.error().message;
  return bytes ? bytes.value() : ByteVector{};
}

FurVolume read(const ByteVector& bytes) {
  const auto volume = readTypeSet(bytes, "fox.fts");
  EXPECT_TRUE(volume) << volume.error().message;
  return volume ? volume.value() : FurVolume{};
}

void setFloat(ByteVector& bytes, std::size_t at, float value) {
  std::memcpy(&bytes[at], &value, sizeof value);  // every machine that this runs on is little-endian
}

// The value that the given share of them does not exceed.
float quantile(std::vector<float> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

TEST(TypeSet, HasTheLayoutOfThePaper) {
  const FurVolume v = coat(0.25f);
  const ByteVector bytes = written(v);
  ASSERT_EQ(bytes.size(), 3'194'888u);
  // Layer 3, row 5, column 7; fin row 9, column 11.
  const std::size_t texel = (3 * 256 + 5) * 256 + 7, finTexel = 9 * 256 + 11;
  EXPECT_EQ(bytes[3 * texel], v.variance[texel]);
  EXPECT_EQ(bytes[3 * texel + 1], v.dominance[texel]);
  EXPECT_EQ(bytes[3 * texel + 2], v.coverage[texel]);
  EXPECT_EQ(bytes[kFinStart + 3 * finTexel], v.finVariance[finTexel]);
  EXPECT_EQ(bytes[kFinStart + 3 * finTexel + 1], v.finDominance[finTexel]);
  EXPECT_EQ(bytes[kFinStart + 3 * finTexel + 2], v.finCoverage[finTexel]);
  ByteVector floats(8);
  setFloat(floats, 0, v.density);
  setFloat(floats, 4, v.weight);
  EXPECT_TRUE(std::equal(floats.begin(), floats.end(), bytes.begin() + kDensityAt));
}

TEST(TypeSet, KeepsEveryByteOfItsMaps) {
  for (const float curl : {0.0f, 0.25f, 1.0f}) {
    const FurVolume v = coat(curl);
    const ByteVector bytes = written(v);
    const FurVolume again = read(bytes);
    EXPECT_EQ(again.coverage, v.coverage);
    EXPECT_EQ(again.dominance, v.dominance);
    EXPECT_EQ(again.variance, v.variance);
    EXPECT_EQ(again.finCoverage, v.finCoverage);
    EXPECT_EQ(again.finDominance, v.finDominance);
    EXPECT_EQ(again.finVariance, v.finVariance);
    EXPECT_EQ(again.density, v.density);
    EXPECT_EQ(again.weight, v.weight);
    EXPECT_EQ(written(again), bytes);
  }
}

TEST(TypeSet, KeepsDominanceBelowOurScale) {
  ByteVector bytes = written(coat(0.0f));
  bytes[1] = 51;  // Sheppard's first strand
  EXPECT_EQ(written(read(bytes)), bytes);
}

TEST(TypeSet, TellsTheStrandsApart) {
  const FurVolume v = coat(0.25f), again = read(written(v));
  std::map<std::uint32_t, std::uint32_t> idOf, strandOf;
  std::size_t covered = 0, agree = 0;
  for (std::size_t i = 0; i < v.coverage.size(); ++i) {
    if (v.coverage[i] == 0) continue;
    ++covered;
    const std::uint32_t id = idOf.emplace(v.strandId[i], again.strandId[i]).first->second;
    const std::uint32_t strand = strandOf.emplace(again.strandId[i], v.strandId[i]).first->second;
    agree += id == again.strandId[i] && strand == v.strandId[i];
  }
  // Two strands in a few thousand may share both values and stand close by.
  EXPECT_GE(static_cast<double>(agree), 0.999 * static_cast<double>(covered));
  EXPECT_NEAR(again.strandCount, v.strandCount, 0.005 * v.strandCount);
}

TEST(TypeSet, FindsTangentsAndRootsAgain) {
  const FurVolume v = coat(0.25f), again = read(written(v));
  std::vector<float> angle, astray;
  for (std::size_t i = 0; i < v.coverage.size(); ++i) {
    if (v.coverage[i] == 0) continue;
    const auto tangent = [&](const FurVolume& of) {
      return glm::normalize(Vec3(of.tangent[3 * i], of.tangent[3 * i + 1], of.tangent[3 * i + 2]));
    };
    angle.push_back(glm::degrees(std::acos(std::min(glm::dot(tangent(v), tangent(again)), 1.0f))));
    const Vec2 miss(v.offset[2 * i] - again.offset[2 * i], v.offset[2 * i + 1] - again.offset[2 * i + 1]);
    astray.push_back(glm::length(miss) / 64.0f);
  }
  // The middle of a disc of texels is known to some hundredths of a texel and layers are 5.3 texels apart,
  // which is half a degree, as is a step of the stored tangent; where a strand curves or begins the slope is
  // a mean over two layers.
  EXPECT_LT(quantile(angle, 0.5), 1.0f);
  EXPECT_LT(quantile(angle, 0.9), 2.0f);
  // Below the first layer a strand is taken to run on as it began.
  EXPECT_LT(quantile(astray, 0.5), 0.2f);
  EXPECT_LT(quantile(astray, 0.99), 0.7f);
}

TEST(TypeSet, GivesEmptyTexelsTheNearestStrandOfTheirLayer) {
  const FurVolume v = read(written(coat(0.25f)));
  Random random(3);
  for (int k = 0; k < 200; ++k) {
    const int layer = static_cast<int>(random.next() % 16), x = static_cast<int>(random.next() % 256),
              y = static_cast<int>(random.next() % 256);
    const auto at = [&](int column, int row) { return (std::size_t(layer) * 256 + (row & 255)) * 256 + (column & 255); };
    int nearest = std::numeric_limits<int>::max();
    std::vector<std::uint32_t> owners;
    for (int dy = -24; dy <= 24; ++dy)
      for (int dx = -24; dx <= 24; ++dx) {
        const std::size_t texel = at(x + dx, y + dy);
        if (v.coverage[texel] == 0 || dx * dx + dy * dy > nearest) continue;
        if (dx * dx + dy * dy < nearest) owners.clear();
        nearest = dx * dx + dy * dy;
        owners.push_back(v.strandId[texel]);
      }
    if (nearest > 24 * 24) continue;
    EXPECT_NE(std::find(owners.begin(), owners.end(), v.strandId[at(x, y)]), owners.end());
  }
}

TEST(TypeSet, RefusesFilesOfAnotherLength) {
  ByteVector bytes = written(coat(0.0f));
  bytes.push_back(0);
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kDensityAt, bytes.size() - 2, bytes.size()}) {
    const auto volume = readTypeSet(std::span(bytes).first(size), "fox.fts");
    ASSERT_FALSE(volume) << size;
    EXPECT_EQ(volume.error().id, ErrorId::BadFile);
    EXPECT_EQ(volume.error().message, "fox.fts: a type set has 3194888 bytes; this file has " + std::to_string(size));
  }
}

TEST(TypeSet, RefusesADensityOrWeightThatIsNone) {
  const ByteVector good = written(coat(0.0f));
  for (const float value : {NAN, INFINITY, -INFINITY, -0.001f, 1.001f, 3e38f})
    for (const bool weight : {false, true}) {
      ByteVector bytes = good;
      setFloat(bytes, kDensityAt + (weight ? 4 : 0), value);
      const auto volume = readTypeSet(bytes, "fox.fts");
      ASSERT_FALSE(volume) << value;
      EXPECT_EQ(volume.error().id, ErrorId::BadFile);
      EXPECT_EQ(volume.error().message.rfind(weight ? "fox.fts: its weight is " : "fox.fts: its density is ", 0), 0u);
      EXPECT_NE(volume.error().message.find("0 to 1"), std::string::npos);
    }
}

TEST(TypeSet, OfAnotherShapeIsNotWritten) {
  furgen::FurParameters p;
  p.size = 128;
  const auto small = writeTypeSet(furgen::generateFur(p));
  ASSERT_FALSE(small);
  EXPECT_NE(small.error().message.find("128"), std::string::npos);
  p = {};
  p.layers = 32;
  EXPECT_FALSE(writeTypeSet(furgen::generateFur(p)));
}

TEST(TypeSet, IsReadWhateverItHolds) {
  ByteVector bytes(kTypeSetBytes, 0);  // the two floats stay 0
  const auto expectRead = [&](const char* what) {
    const FurVolume v = read(bytes);
    EXPECT_EQ(written(v), bytes) << what;
    for (std::size_t i = 2; i < v.tangent.size(); i += 3) ASSERT_GE(v.tangent[i], 1) << what;
    for (const std::uint32_t id : v.strandId) ASSERT_LE(id, static_cast<std::uint32_t>(v.strandCount)) << what;
  };
  expectRead("nothing");
  std::fill(bytes.begin(), bytes.begin() + kDensityAt, 255);
  expectRead("one strand everywhere");
  Random random(1);
  std::generate(bytes.begin(), bytes.begin() + kDensityAt, [&] { return static_cast<std::uint8_t>(random.next()); });
  expectRead("noise");
  // As many separate texels with the same values as there can be, never above one another.
  std::fill(bytes.begin(), bytes.end(), 0);
  for (std::size_t layer = 0; layer < 16; ++layer)
    for (std::size_t y = layer % 3; y < 255; y += 3)
      for (std::size_t x = layer % 2; x < 255; x += 3) bytes[3 * ((layer * 256 + y) * 256 + x) + 2] = 255;
  expectRead("dots");
}

}  // namespace
}  // namespace fur::scene
