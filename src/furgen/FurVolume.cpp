#include "furgen/FurVolume.h"

#include <algorithm>

#include "furgen/Layers.h"

namespace fur::furgen {

namespace {

constexpr int kFinRows = 64;

template <class T>
void append(std::vector<T>& all, const std::vector<T>& layer) {
  all.insert(all.end(), layer.begin(), layer.end());
}

void reserveLayers(FurVolume& volume) {
  const std::size_t texels = static_cast<std::size_t>(volume.layers) * volume.size * volume.size;
  volume.coverage.reserve(texels), volume.dominance.reserve(texels), volume.variance.reserve(texels);
  volume.tangent.reserve(texels * 3), volume.offset.reserve(texels * 2), volume.strandId.reserve(texels);
}

}  // namespace

float meanCover(std::span<const std::uint8_t> coverage) {
  std::uint32_t sum = 0;
  for (const std::uint8_t c : coverage) sum += c;
  return static_cast<float>(sum) / (255.0f * static_cast<float>(coverage.size()));
}

int finRows(int layers) { return std::max(kFinRows, layers); }

FurVolume volumeOf(const Coat& coat, int layers) {
  FurVolume volume;
  volume.size = coat.parameters.size;
  volume.layers = layers;
  volume.strandCount = static_cast<int>(coat.strands.size());
  volume.weight = coat.weight;
  reserveLayers(volume);
  LayerPainter painter(coat);
  LayerMaps maps;
  for (int layer = 0; layer < layers; ++layer) {
    painter.paint(layer, layers, maps);
    if (layer == 0) volume.density = meanCover(maps.coverage);
    append(volume.coverage, maps.coverage);
    append(volume.dominance, maps.dominance);
    append(volume.variance, maps.variance);
    append(volume.tangent, maps.tangent);
    append(volume.offset, maps.offset);
    append(volume.strandId, maps.strandId);
  }
  FinMaps fin = paintFin(coat, finRows(layers));
  volume.finRows = fin.rows;
  volume.finCoverage = std::move(fin.coverage);
  volume.finDominance = std::move(fin.dominance);
  volume.finVariance = std::move(fin.variance);
  volume.finTangent = std::move(fin.tangent);
  return volume;
}

FurVolume generateFur(const FurParameters& given) {
  const Coat coat = growCoat(given);
  return volumeOf(coat, coat.parameters.layers);
}

}  // namespace fur::furgen
