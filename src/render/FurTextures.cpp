#include "render/FurTextures.h"

#include <utility>

#include "shared/Blocks.h"

namespace fur::render {

namespace {

using gl::TexelFormat;

// Repeats; the height of a fin is clamped by its look-up.
gl::Texture mapOf(TexelFormat format, int width, int height, int layers) {
  return gl::Texture({format, width, height, layers, gl::Filter::Mipmapped, true}, {});
}

}  // namespace

std::size_t FurTextures::Set::bytes() const {
  return coverage.bytes() + strand.bytes() + offset.bytes() + finCoverage.bytes() + finStrand.bytes();
}

void FurTextures::begin(int size, int layers, int finRows, int types) {
  nextLayers_ = layers;
  const int all = layers * types;
  next_ = {mapOf(TexelFormat::R8, size, size, all), mapOf(TexelFormat::RGBA8, size, size, all),
           mapOf(TexelFormat::RG8, size, size, all), mapOf(TexelFormat::R8, size, finRows, types),
           mapOf(TexelFormat::RGBA8, size, finRows, types)};
}

void FurTextures::setLayer(int type, int layer, std::span<const furgen::PackedLevel> levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int level = static_cast<int>(i), at = type * nextLayers_ + layer;
    next_.coverage.updateLevel(level, at, gl::bytesOf(levels[i].coverage));
    next_.strand.updateLevel(level, at, gl::bytesOf(levels[i].strand));
    next_.offset.updateLevel(level, at, gl::bytesOf(levels[i].offset));
  }
}

void FurTextures::setFin(int type, std::span<const furgen::PackedLevel> levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    next_.finCoverage.updateLevel(static_cast<int>(i), type, gl::bytesOf(levels[i].coverage));
    next_.finStrand.updateLevel(static_cast<int>(i), type, gl::bytesOf(levels[i].strand));
  }
}

void FurTextures::show() {
  shown_ = std::exchange(next_, {});
  layers_ = nextLayers_;
}

void FurTextures::bind() const {
  shown_.coverage.bind(FUR_UNIT_COVERAGE);
  shown_.strand.bind(FUR_UNIT_STRAND);
  shown_.offset.bind(FUR_UNIT_OFFSET);
  shown_.finCoverage.bind(FUR_UNIT_FIN_COVERAGE);
  shown_.finStrand.bind(FUR_UNIT_FIN_STRAND);
}

}  // namespace fur::render
