#include "app/stages/CoatStage.h"

#include <algorithm>

#include "core/NumberText.h"
#include "furgen/Packing.h"
#include "groom/Groom.h"
#include "settings/FurTypes.h"

namespace fur::app {

namespace {

constexpr std::size_t kMostBytes = 192u << 20, kTexelBytes = 7;  // FurTextures
// Strands that a step tries for: the densest coat takes about 50 microseconds for each in a browser.
constexpr int kStrandsAStep = 64;
// What growing takes of the whole, roughly.
constexpr float kGrowingShare = 0.4f;

using settings::Settings;
using furgen::FurParameters;

struct Link {
  float settings::Values::*setting;
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

furgen::FinMaps finOf(const furgen::FurVolume& v) { return {v.finRows, v.finCoverage, v.finDominance, v.finVariance, v.finTangent}; }

}  // namespace

furgen::FurParameters coatParametersOf(const Settings& settings, int type) {
  const Settings s = settings::typeCoat(settings, type);
  furgen::FurParameters p;
  for (const Link& link : kLinks) p.*link.parameter = s.*link.setting;
  p.size = 64 << s.tileSize;
  p.layers = s.layers;
  p.seed = static_cast<std::uint32_t>(s.seed + type);
  return p;
}

CoatParameters coatParameters(const Settings& settings, unsigned types, Warnings* warnings) {
  CoatParameters all;
  for (int type = 0; type < groom::kTypes; ++type) all.push_back(types >> type & 1 ? coatParametersOf(settings, type) : furgen::FurParameters{.density = 0});
  while (all.size() > 1 && all.back().density <= 0) all.pop_back();
  const std::size_t layerBytes = static_cast<std::size_t>(all[0].size) * all[0].size * kTexelBytes * all.size() * 4 / 3;
  const int most = static_cast<int>(kMostBytes / layerBytes);
  if (settings.layers > most) {
    if (warnings)
      warnings->push_back("A tile of " + decimal(all[0].size) + " texels is kept to " + decimal(most) + " layers of the " +
                          decimal(settings.layers) + " asked for: more would take over 192 MiB");
    for (furgen::FurParameters& p : all) p.layers = most;
  }
  return all;
}

bool differOnlyInCoat(const Settings& a, Settings b) {
  for (const Link& link : kLinks) b.*link.setting = a.*link.setting;
  b.tileSize = a.tileSize;
  b.layers = a.layers;
  b.seed = a.seed;
  b.type2 = a.type2, b.type3 = a.type3, b.type4 = a.type4;
  for (std::size_t i = 0; i < b.ownTypes.size(); ++i)
    for (const Link& link : kLinks) b.ownTypes[i].*link.setting = a.ownTypes[i].*link.setting;
  return a == b;
}

// --- DrawnCoat ---

DrawnCoat::DrawnCoat(std::shared_ptr<const furgen::Coat> grown, std::vector<float> coverage)
    : grown_(std::move(grown)), coverage_(std::move(coverage)) {}

DrawnCoat::DrawnCoat(GivenCoat volume, std::vector<float> coverage)
    : volume_(std::move(volume)), coverage_(std::move(coverage)) {}

int DrawnCoat::layers() const { return static_cast<int>(coverage_.size()); }
int DrawnCoat::size() const { return volume_ ? volume_->size : grown_ ? grown_->parameters.size : 0; }
int DrawnCoat::strandCount() const { return volume_ ? volume_->strandCount : grown_ ? static_cast<int>(grown_->strands.size()) : 0; }
float DrawnCoat::weight() const { return volume_ ? volume_->weight : grown_ ? grown_->weight : 0; }

furgen::TilePicture DrawnCoat::tilePicture(int layer, furgen::TileChannel channel) const {
  if (layers() == 0) return {};
  layer = std::clamp(layer, 0, layers() - 1);
  if (volume_) return furgen::pictureOf(layerOf(*volume_, layer), size(), channel);
  furgen::LayerMaps maps;
  furgen::LayerPainter(*grown_).paint(layer, layers(), maps);
  return furgen::pictureOf(maps, size(), channel);
}

furgen::TilePicture DrawnCoat::finPicture(furgen::TileChannel channel) const {
  if (layers() == 0) return {};
  if (!volume_) return furgen::pictureOf(furgen::paintFin(*grown_, furgen::finRows(layers())), size(), channel);
  return furgen::pictureOf(finOf(*volume_), size(), channel);
}

// --- CoatGrowth ---

CoatGrowth::CoatGrowth(CoatParameters types, GivenCoats given, Strands strands)
    : types_(std::move(types)), given_(std::move(given)), strands_(std::move(strands)) {
  strands_.resize(types_.size());
  for (std::size_t type = 0; type < given_.size(); ++type)
    if (type > 0 && (type >= types_.size() || types_[type].density <= 0)) given_[type] = nullptr;  // it is nowhere
  for (FurParameters& p : types_) {
    for (const GivenCoat& one : given_)
      if (one) p.size = one->size, p.layers = one->layers;
    p = furgen::clampedParameters(p);
  }
  beginType();
}

void CoatGrowth::beginType() {
  grower_.reset();
  if (!given() && !strands_[type()]) grower_.emplace(types_[type()]);
  stage_ = Stage::Grow;
}

bool CoatGrowth::step(CoatReceiver& receiver) {
  const FurParameters& p = types_[type()];
  const int type = static_cast<int>(this->type()), layer = static_cast<int>(coverage_.size());
  switch (stage_) {
    case Stage::Grow:
      if (!given()) {
        if (grower_ && !grower_->step(kStrandsAStep)) return false;
        if (grower_) strands_[this->type()] = std::make_shared<const furgen::Coat>(grower_->take());
        painter_.emplace(*strands_[this->type()]);
      }
      stage_ = Stage::Fin;
      return false;
    case Stage::Fin: {
      const int rows = given() ? given()->finRows : furgen::finRows(p.layers);
      if (type == 0) {
        const bool grown = std::none_of(given_.begin(), given_.end(), [](const GivenCoat& one) { return one != nullptr; });
        shape_ = {p.size, p.layers, rows, static_cast<int>(types_.size()), grown && std::all_of(types_.begin(), types_.end(), furgen::sharesStrands)};
        receiver.begin(shape_);
      }
      stage_ = Stage::Paint;
      if (!hasFins_) return false;
      const furgen::FinMaps fin = given() ? finOf(*given()) : furgen::paintFin(*strands_[this->type()], rows);
      receiver.setFin(type, furgen::packLevels(p.size, rows, {fin.coverage, fin.dominance, fin.variance, fin.tangent, {}}));
      return false;
    }
    case Stage::Paint:
      if (given()) maps_ = layerOf(*given(), layer);
      else if (!painter_->step(layer, p.layers, maps_)) return false;
      stage_ = Stage::Upload;
      return false;
    case Stage::Upload: break;
  }
  coverage_.push_back(furgen::meanCover(maps_.coverage));
  furgen::MapsToPack maps{maps_.coverage};
  if (shape_.hasStrands(layer)) maps = {maps_.coverage, maps_.dominance, maps_.variance, maps_.tangent, maps_.offset};
  receiver.setLayer(type, layer, furgen::packLevels(p.size, p.size, maps));
  stage_ = Stage::Paint;
  return layer + 1 == p.layers && finishType(receiver);
}

bool CoatGrowth::finishType(CoatReceiver& receiver) {
  // Of the layer where strands stand closest: coils are dense above a bare skin. A type set says it; 0 would be bald.
  const float densest = *std::max_element(coverage_.begin(), coverage_.end());
  const float density = given() && densest > 0 ? std::max(given()->density, 1e-3f) : densest;
  painter_.reset();
  weights_.push_back(given() ? given()->weight : strands_[type()]->weight);
  if (type() == 0) first_ = given() ? DrawnCoat(given(), std::move(coverage_)) : DrawnCoat(strands_[type()], std::move(coverage_));
  densities_.push_back(density);
  coverage_.clear();
  while (type() < types_.size() && types_[type()].density <= 0) densities_.push_back(0), weights_.push_back(0);
  if (type() == types_.size()) {
    receiver.show(densities_);
    return true;
  }
  beginType();
  return false;
}

float CoatGrowth::progress() const {
  const auto layers = static_cast<float>(types_[0].layers);
  const float part = stage_ == Stage::Grow && grower_ ? kGrowingShare * grower_->progress()
                                                      : kGrowingShare + (1 - kGrowingShare) * static_cast<float>(coverage_.size()) / layers;
  return (static_cast<float>(type()) + part) / static_cast<float>(types_.size());
}

}  // namespace fur::app
