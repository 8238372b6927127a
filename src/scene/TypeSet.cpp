#include "scene/TypeSet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "furgen/Coat.h"
#include "furgen/NearestFill.h"
#include "furgen/Packing.h"
#include "scene/StrandTracing.h"

namespace fur::scene {

namespace {

using furgen::FurVolume;

constexpr int kSize = kTypeSetSize, kLayers = kTypeSetLayers, kFinRows = kTypeSetFinRows;
constexpr std::size_t kLayerTexels = std::size_t{kSize} * kSize;

// A strand is followed as long as it leans by less than this many volume heights a height: 72 degrees.
constexpr float kSteepest = 3.0f;
float reachOf(int layers) { return kSteepest * furgen::kHeightTexels / static_cast<float>(layers) + 1.0f; }

struct Maps {
  std::vector<std::uint8_t> coverage, dominance, variance;
};

Maps splitTexels(std::span<const std::uint8_t> bytes) {
  Maps maps;
  for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
    maps.variance.push_back(bytes[i]);
    maps.dominance.push_back(bytes[i + 1]);
    maps.coverage.push_back(bytes[i + 2]);
  }
  return maps;
}

void appendTexels(std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& coverage,
                  const std::vector<std::uint8_t>& dominance, const std::vector<std::uint8_t>& variance) {
  for (std::size_t i = 0; i < coverage.size(); ++i) bytes.insert(bytes.end(), {variance[i], dominance[i], coverage[i]});
}

float floatAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= std::uint32_t{bytes[at + i]} << (8 * i);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void appendFloat(std::vector<std::uint8_t>& bytes, float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
}

std::int16_t packOffset(float texels) {
  return static_cast<std::int16_t>(std::floor(glm::clamp(texels * 64.0f, -32768.0f, 32767.0f) + 0.5f));
}

void traceLayers(FurVolume& volume) {
  MapStack maps{kSize, kSize, kLayers, reachOf(kLayers), volume.coverage, volume.variance, volume.dominance};
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
    volume.offset[2 * i] = packOffset(furgen::torusDelta(cut.axis.x, x, kSize) - cut.shift.x);
    volume.offset[2 * i + 1] = packOffset(furgen::torusDelta(cut.axis.y, y, kSize) - cut.shift.y);
  }
}

// Empty texels of a row take the nearest cut in it, round the tile.
void fillRow(std::uint32_t* row) {
  const std::vector<std::uint32_t> drawn(row, row + kSize);
  if (std::all_of(drawn.begin(), drawn.end(), [](std::uint32_t cut) { return cut == 0; })) return;
  for (int x = 0; x < kSize; ++x)
    for (int d = 1; row[x] == 0; ++d) {
      const std::uint32_t right = drawn[static_cast<std::size_t>((x + d) & (kSize - 1))];
      row[x] = right ? right : drawn[static_cast<std::size_t>((x - d) & (kSize - 1))];
    }
}

// Seen from the side a row is a layer: the strands rise through the rows.
void traceFin(FurVolume& volume) {
  MapStack maps{kSize, 1, kFinRows, reachOf(kFinRows), volume.finCoverage, volume.finVariance, volume.finDominance};
  StrandTrace trace = traceStrands(maps);
  for (int row = 0; row < kFinRows; ++row) fillRow(&trace.cutOf[std::size_t{kSize} * row]);
  volume.finTangent.assign(trace.cutOf.size() * 3, 0);
  for (std::size_t i = 0; i < trace.cutOf.size(); ++i) {
    const std::uint32_t cut = trace.cutOf[i];
    const Vec2 way(cut ? trace.cuts[cut - 1].slope.x : 0.0f, 0.0f);
    furgen::packTangent(way, 1.0f / kFinRows, &volume.finTangent[3 * i]);
  }
}

Error bad(const std::string& what) { return {ErrorId::BadFile, what}; }

}  // namespace

Result<FurVolume> readTypeSet(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (bytes.size() != kTypeSetBytes) {
    return bad(name + ": a type set has " + std::to_string(kTypeSetBytes) + " bytes; this file has " +
               std::to_string(bytes.size()));
  }
  FurVolume volume;
  volume.size = kSize;
  volume.layers = kLayers;
  volume.finRows = kFinRows;
  volume.density = floatAt(bytes, kTypeSetBytes - 8);
  volume.weight = floatAt(bytes, kTypeSetBytes - 4);
  for (const auto& [what, value] : {std::pair{"density", volume.density}, std::pair{"weight", volume.weight}})
    if (!(value >= 0.0f && value <= 1.0f)) return bad(name + ": its " + what + " is " + std::to_string(value) + ", not in 0 to 1");
  const std::size_t layerBytes = 3 * kLayers * kLayerTexels;
  Maps layers = splitTexels(bytes.first(layerBytes));
  volume.coverage = std::move(layers.coverage);
  volume.dominance = std::move(layers.dominance);
  volume.variance = std::move(layers.variance);
  Maps fin = splitTexels(bytes.subspan(layerBytes, 3 * kFinRows * kSize));
  volume.finCoverage = std::move(fin.coverage);
  volume.finDominance = std::move(fin.dominance);
  volume.finVariance = std::move(fin.variance);
  traceLayers(volume);
  traceFin(volume);
  return volume;
}

Result<std::vector<std::uint8_t>> writeTypeSet(const FurVolume& volume) {
  if (volume.size != kSize || volume.layers != kLayers || volume.finRows != kFinRows) {
    const auto shape = [](int size, int layers, int rows) {
      return std::to_string(size) + " texels a side, " + std::to_string(layers) + " layers and " + std::to_string(rows) + " fin rows";
    };
    return bad("a type set holds " + shape(kSize, kLayers, kFinRows) + "; this coat has " +
               shape(volume.size, volume.layers, volume.finRows));
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kTypeSetBytes);
  appendTexels(bytes, volume.coverage, volume.dominance, volume.variance);
  appendTexels(bytes, volume.finCoverage, volume.finDominance, volume.finVariance);
  appendFloat(bytes, volume.density);
  appendFloat(bytes, volume.weight);
  return bytes;
}

}  // namespace fur::scene
