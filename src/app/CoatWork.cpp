#include "app/CoatWork.h"

#include <algorithm>

#include "furgen/Packing.h"

namespace fur::app {

namespace {

constexpr std::size_t kMaxTileBytes = 192u << 20;
// Strands that a step tries for: the densest coat takes about 50 microseconds for each in a browser.
constexpr int kStrandsAStep = 64;
// What growing takes of the whole, roughly.
constexpr float kGrowingShare = 0.4f;

using settings::Settings;
using furgen::FurParameters;

struct Link {
  float Settings::*setting;
  float FurParameters::*parameter;
};
constexpr Link kLinks[] = {
    {&Settings::density, &FurParameters::density},
    {&Settings::thickness, &FurParameters::thickness},
    {&Settings::taper, &FurParameters::taper},
    {&Settings::lengthVariation, &FurParameters::lengthVariation},
    {&Settings::curl, &FurParameters::curl},
    {&Settings::wave, &FurParameters::wave},
    {&Settings::coil, &FurParameters::coil},
    {&Settings::frizz, &FurParameters::frizz},
    {&Settings::clump, &FurParameters::clump},
    {&Settings::lockSize, &FurParameters::lockSize},
    {&Settings::roll, &FurParameters::roll},
    {&Settings::stray, &FurParameters::stray},
    {&Settings::tipBreak, &FurParameters::tipBreak},
    {&Settings::undercoat, &FurParameters::undercoat},
    {&Settings::undercoatLength, &FurParameters::undercoatLength},
};

furgen::LayerMaps layerOf(const furgen::FurVolume& v, int layer) {
  const std::size_t texels = static_cast<std::size_t>(v.size) * v.size, first = texels * static_cast<std::size_t>(layer);
  const auto part = [&](const auto& all, std::size_t channels) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first * channels);
    return std::vector(begin, begin + static_cast<std::ptrdiff_t>(texels * channels));
  };
  return {part(v.coverage, 1), part(v.dominance, 1), part(v.variance, 1), part(v.tangent, 3), part(v.offset, 2), part(v.strandId, 1)};
}

}  // namespace

furgen::FurParameters furParameters(const settings::Settings& s, Warnings* warnings) {
  furgen::FurParameters p;
  for (const Link& link : kLinks) p.*link.parameter = s.*link.setting;
  p.size = 64 << s.tileSize;
  p.layers = s.layers;
  p.seed = static_cast<std::uint32_t>(s.seed);
  const std::size_t layerBytes = static_cast<std::size_t>(p.size) * p.size * 4 * 4 / 3;
  const int most = static_cast<int>(kMaxTileBytes / layerBytes);
  if (p.layers > most) {
    if (warnings)
      warnings->push_back("A tile of " + std::to_string(p.size) + " texels is kept to " + std::to_string(most) + " layers of the " +
                          std::to_string(p.layers) + " asked for: more would take over 192 MiB");
    p.layers = most;
  }
  return p;
}

bool differOnlyInCoat(const Settings& a, Settings b) {
  for (const Link& link : kLinks) b.*link.setting = a.*link.setting;
  b.tileSize = a.tileSize;
  b.layers = a.layers;
  b.seed = a.seed;
  return a == b;
}

// --- DrawnCoat ---

DrawnCoat::DrawnCoat(furgen::Coat grown, std::vector<float> coverage)
    : grown_(std::move(grown)), coverage_(std::move(coverage)) {}

DrawnCoat::DrawnCoat(furgen::FurVolume volume) : volume_(std::move(volume)) {
  const std::size_t texels = static_cast<std::size_t>(volume_->size) * volume_->size;
  for (int layer = 0; layer < volume_->layers; ++layer)
    coverage_.push_back(furgen::meanCover(std::span(volume_->coverage).subspan(texels * static_cast<std::size_t>(layer), texels)));
}

int DrawnCoat::layers() const { return static_cast<int>(coverage_.size()); }
int DrawnCoat::size() const { return volume_ ? volume_->size : grown_.parameters.size; }
int DrawnCoat::strandCount() const {
  return volume_ ? volume_->strandCount : static_cast<int>(grown_.strands.size());
}
float DrawnCoat::weight() const { return volume_ ? volume_->weight : grown_.weight; }

furgen::TilePicture DrawnCoat::tilePicture(int layer, furgen::TileChannel channel) const {
  if (layers() == 0) return {};
  layer = std::clamp(layer, 0, layers() - 1);
  if (volume_) return furgen::pictureOf(layerOf(*volume_, layer), size(), channel);
  furgen::LayerMaps maps;
  furgen::LayerPainter(grown_).paint(layer, layers(), maps);
  return furgen::pictureOf(maps, size(), channel);
}

furgen::TilePicture DrawnCoat::finPicture(furgen::TileChannel channel) const {
  if (layers() == 0) return {};
  if (!volume_) return furgen::pictureOf(furgen::paintFin(grown_, furgen::finRows(layers())), size(), channel);
  const furgen::FurVolume& v = *volume_;
  return furgen::pictureOf(furgen::FinMaps{v.finRows, v.finCoverage, v.finDominance, v.finVariance, v.finTangent}, size(), channel);
}

// --- CoatWork ---

CoatWork::CoatWork(const furgen::FurParameters& parameters)
    : parameters_(furgen::clampedParameters(parameters)), grower_(parameters_) {}

bool CoatWork::step(render::Renderer& renderer) {
  if (!coat_) {
    if (!grower_.step(kStrandsAStep)) return false;
    coat_ = std::make_unique<furgen::Coat>(grower_.take());
    painter_.emplace(*coat_);
    const int rows = furgen::finRows(parameters_.layers);
    renderer.beginFur(parameters_.size, parameters_.layers, rows);
    const furgen::FinMaps fin = furgen::paintFin(*coat_, rows);
    renderer.setFinMap(furgen::packLevels(parameters_.size, rows, fin.coverage, fin.tangent, fin.variance));
    return false;
  }
  if (!painted_) {
    painted_ = painter_->step(nextLayer_, parameters_.layers, maps_);
    return false;
  }
  painted_ = false;
  coverage_.push_back(furgen::meanCover(maps_.coverage));
  renderer.setFurLayer(nextLayer_, furgen::packLevels(parameters_.size, parameters_.size, maps_.coverage, maps_.tangent, maps_.variance));
  if (++nextLayer_ < parameters_.layers) return false;
  // Of the layer where strands stand closest: coils are dense above a bare skin.
  renderer.showFur(*std::max_element(coverage_.begin(), coverage_.end()));
  return true;
}

float CoatWork::progress() const {
  if (!coat_) return kGrowingShare * grower_.progress();
  return kGrowingShare + (1 - kGrowingShare) * static_cast<float>(nextLayer_) / static_cast<float>(parameters_.layers);
}

DrawnCoat CoatWork::take() {
  painter_.reset();
  return DrawnCoat(std::move(*coat_), std::move(coverage_));
}

}  // namespace fur::app
