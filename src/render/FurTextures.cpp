#include "render/FurTextures.h"

#include <algorithm>
#include <utility>

#include "furgen/Streaks.h"
#include "shared/Blocks.h"

namespace fur::render {

namespace {

using gl::TexelFormat;

// Streaks begin at this level of the strands' mipmaps: finer ones would be blurred out again.
constexpr int kStreaked = 2;

// Repeats; the height of a fin is clamped by its look-up.
gl::Texture mapOf(TexelFormat format, int width, int height, int layers) {
  return gl::Texture({format, width, height, layers, gl::Filter::Mipmapped, true}, {});
}

}  // namespace

std::size_t FurTextures::Coat::bytes() const {
  return coverage.bytes() + strand.bytes() + offset.bytes() + finCoverage.bytes() + finStrand.bytes() + streaks.bytes();
}

std::size_t FurTextures::bytes() const {
  return shown_->bytes() / static_cast<std::size_t>(shown_.use_count()) + (next_ ? next_->bytes() : 0);
}

std::shared_ptr<FurTextures::Coat> FurTextures::emptyCoat(const furgen::CoatShape& shape) {
  auto coat = std::make_shared<Coat>();
  coat->shape = shape;
  coat->coverage = mapOf(TexelFormat::R8, shape.size, shape.size, shape.layers * shape.types);
  coat->strand = mapOf(TexelFormat::RGBA8, shape.size, shape.size, shape.strandLayers() * shape.types);
  coat->offset = mapOf(TexelFormat::RG8, shape.size, shape.size, shape.strandLayers() * shape.types);
  coat->finCoverage = mapOf(TexelFormat::R8, shape.size, shape.finRows, shape.types);
  coat->finStrand = mapOf(TexelFormat::RGBA8, shape.size, shape.finRows, shape.types);
  return coat;
}

void FurTextures::begin(const furgen::CoatShape& shape) {
  next_.reset();  // first: there is room for one
  next_ = emptyCoat(shape);
}

void FurTextures::showTexel(float density) {
  shown_ = emptyCoat({});
  shown_->densities[0] = density;
  ++revision_;
}

std::size_t FurTextures::setLayer(int type, int layer, std::span<const furgen::PackedLevel> levels) {
  std::size_t uploaded = 0;
  const furgen::CoatShape& shape = next_->shape;
  const int ofStrands = type * shape.strandLayers() + shape.strandLayer(layer);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int level = static_cast<int>(i);
    next_->coverage.updateLevel(level, type * shape.layers + layer, gl::bytesOf(levels[i].coverage));
    uploaded += levels[i].coverage.size() + levels[i].strand.size() + levels[i].offset.size();
    if (!shape.hasStrands(layer)) continue;
    next_->strand.updateLevel(level, ofStrands, gl::bytesOf(levels[i].strand));
    next_->offset.updateLevel(level, ofStrands, gl::bytesOf(levels[i].offset));
    if (shape.strandLayer(layer) == shape.strandLayer(shape.layers / 2) && level >= kStreaked) next_->streaked.push_back(levels[i]);
  }
  return uploaded;
}

std::size_t FurTextures::setFin(int type, std::span<const furgen::PackedLevel> levels) {
  std::size_t uploaded = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    next_->finCoverage.updateLevel(static_cast<int>(i), type, gl::bytesOf(levels[i].coverage));
    next_->finStrand.updateLevel(static_cast<int>(i), type, gl::bytesOf(levels[i].strand));
    uploaded += levels[i].coverage.size() + levels[i].strand.size();
  }
  return uploaded;
}

void FurTextures::show(std::span<const float> densities) {
  std::copy_n(densities.begin(), std::min(densities.size(), next_->densities.size()), next_->densities.begin());
  show(std::exchange(next_, nullptr));
}

void FurTextures::show(std::shared_ptr<Coat> coat) {
  shown_ = std::move(coat);
  next_.reset();
  ++revision_;
}

float FurTextures::density() const { return *std::max_element(shown_->densities.begin(), shown_->densities.end()); }

void FurTextures::Coat::makeStreaks() {
  if (streaked.empty()) return;
  constexpr int kTurns = static_cast<int>(FUR_STREAK_TURNS);
  const int size = streaked.front().width;
  streaks = mapOf(TexelFormat::RGBA8, size, size, kTurns * finStrand.shape().layers);
  int level = 0, type = -1;
  for (const furgen::PackedLevel& packed : streaked) {
    level = packed.width == size ? 0 : level + 1;
    type += level == 0;
    for (int turn = 0; turn < kTurns; ++turn)
      streaks.updateLevel(level, type * kTurns + turn,
                          gl::bytesOf(furgen::streaks(packed.strand, packed.width, static_cast<float>(turn) / kTurns)));
  }
}

void FurTextures::bind(bool wet) {
  if (wet && shown_->streaks.bytes() == 0) shown_->makeStreaks();
  shown_->streaks.bind(FUR_UNIT_STREAKS);
  shown_->coverage.bind(FUR_UNIT_COVERAGE);
  shown_->strand.bind(FUR_UNIT_STRAND);
  shown_->offset.bind(FUR_UNIT_OFFSET);
  shown_->finCoverage.bind(FUR_UNIT_FIN_COVERAGE);
  shown_->finStrand.bind(FUR_UNIT_FIN_STRAND);
}

}  // namespace fur::render
