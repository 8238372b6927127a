#include "scene/TypeSet.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/NumberText.h"
#include "furgen/Coat.h"
#include "furgen/NearestFill.h"
#include "furgen/Packing.h"
#include "scene/StrandTracing.h"
#include "scene/import/Readers.h"

namespace fur::scene {

namespace {

using furgen::FurVolume;

constexpr int kSize = kTypeSetSize, kLayers = kTypeSetLayers, kFinRows = kTypeSetFinRows;
constexpr std::size_t kLayerTexels = std::size_t{kSize} * kSize, kFinTexels = std::size_t{kSize} * kFinRows;

// A strand is followed as long as it leans by less than this many volume heights a height: 72 degrees.
constexpr float kSteepest = 3.0f;
float reachOf(int layers) { return kSteepest * furgen::kHeightTexels / static_cast<float>(layers) + 1.0f; }

// The three bytes of every texel of the file, of one of its two parts.
using Map = std::vector<std::uint8_t>;

void unpackTexels(const std::uint8_t* from, std::size_t texels, Map& variance, Map& dominance, Map& coverage) {
  variance.resize(texels), dominance.resize(texels), coverage.resize(texels);
  for (std::size_t i = 0; i < texels; ++i, from += 3) variance[i] = from[0], dominance[i] = from[1], coverage[i] = from[2];
}

std::uint8_t* packTexels(const Map& variance, const Map& dominance, const Map& coverage, std::uint8_t* to) {
  for (std::size_t i = 0; i < coverage.size(); ++i) *to++ = variance[i], *to++ = dominance[i], *to++ = coverage[i];
  return to;
}

static_assert(std::endian::native == std::endian::little, "floats are written as they lie in memory");

// The lowest layer shows what stands from the skin to halfway to the next, see furgen/Layers.h.
constexpr float kLowest = 0.75f;

void traceLayers(FurVolume& volume) {
  MapStack maps{kSize, kSize, kLayers, reachOf(kLayers), kLowest, volume.coverage, volume.variance, volume.dominance};
  StrandTrace trace = traceStrands(maps);
  volume.strandCount = trace.strandCount;
  furgen::NearestFill nearest(kSize);
  for (int layer = 0; layer < kLayers; ++layer) nearest.fill(&trace.cutOf[layer * kLayerTexels]);
  const std::size_t texels = trace.cutOf.size();
  volume.strandId.assign(texels, 0);
  volume.tangent.assign(texels * 3, 0);
  volume.offset.assign(texels * 2, 0);
  for (std::size_t i = 0; i < texels; ++i) {
    if (trace.cutOf[i] == 0) {
      volume.tangent[3 * i + 2] = 127;
      continue;
    }
    const StrandCut& cut = trace.cuts[trace.cutOf[i] - 1];
    const auto x = static_cast<float>(i % kSize) + 0.5f, y = static_cast<float>(i / kSize % kSize) + 0.5f;
    volume.strandId[i] = static_cast<std::uint16_t>(std::min(cut.strand, 65535u));
    furgen::packTangent(cut.slope, 1.0f / kLayers, &volume.tangent[3 * i]);
    volume.offset[2 * i] = furgen::packOffset(furgen::torusDelta(cut.axis.x, x, kSize) - cut.shift.x);
    volume.offset[2 * i + 1] = furgen::packOffset(furgen::torusDelta(cut.axis.y, y, kSize) - cut.shift.y);
  }
}

// Seen from the side a row is a layer: the strands rise through the rows.
void traceFin(FurVolume& volume) {
  MapStack maps{kSize, 1, kFinRows, reachOf(kFinRows), 1.0f, volume.finCoverage, volume.finVariance, volume.finDominance};
  StrandTrace trace = traceStrands(maps);
  for (int row = 0; row < kFinRows; ++row) furgen::fillRow(&trace.cutOf[std::size_t{kSize} * row], kSize);
  volume.finTangent.assign(trace.cutOf.size() * 3, 0);
  for (std::size_t i = 0; i < trace.cutOf.size(); ++i) {
    const std::uint32_t cut = trace.cutOf[i];
    const Vec2 way(cut ? trace.cuts[cut - 1].slope.x : 0.0f, 0.0f);
    furgen::packTangent(way, 1.0f / kFinRows, &volume.finTangent[3 * i]);
  }
}

Error bad(std::string text) { return {ErrorId::BadFile, std::move(text)}; }

}  // namespace

Result<FurVolume> readTypeSetFile(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (bytes.size() != kTypeSetBytes)
    return bad(formatted("%.200s: a type set has %zu bytes; this file has %zu", name.c_str(), kTypeSetBytes, bytes.size()));
  float ends[2];
  std::memcpy(ends, &bytes[kTypeSetBytes - sizeof ends], sizeof ends);
  for (int i = 0; i < 2; ++i)
    if (!(ends[i] >= 0.0f && ends[i] <= 1.0f))
      return bad(formatted("%.200s: its %s is %s, not in 0 to 1", name.c_str(), i ? "weight" : "density",
                           shortDecimal(ends[i]).c_str()));
  FurVolume volume;
  volume.size = kSize;
  volume.layers = kLayers;
  volume.finRows = kFinRows;
  volume.density = ends[0];
  volume.weight = ends[1];
  unpackTexels(bytes.data(), kLayers * kLayerTexels, volume.variance, volume.dominance, volume.coverage);
  unpackTexels(&bytes[3 * kLayers * kLayerTexels], kFinTexels, volume.finVariance, volume.finDominance, volume.finCoverage);
  traceLayers(volume);
  traceFin(volume);
  return volume;
}

Result<std::vector<std::uint8_t>> writeTypeSet(const FurVolume& volume) {
  if (volume.size != kSize || volume.layers != kLayers || volume.finRows != kFinRows)
    return bad(formatted("a type set has %d texels a side, %d layers and %d fin rows; this coat has %d, %d and %d", kSize,
                         kLayers, kFinRows, volume.size, volume.layers, volume.finRows));
  std::vector<std::uint8_t> bytes(kTypeSetBytes);
  std::uint8_t* to = packTexels(volume.variance, volume.dominance, volume.coverage, bytes.data());
  to = packTexels(volume.finVariance, volume.finDominance, volume.finCoverage, to);
  const float ends[2] = {volume.density, volume.weight};
  std::memcpy(to, ends, sizeof ends);
  return bytes;
}

}  // namespace fur::scene
