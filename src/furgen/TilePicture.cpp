#include "furgen/TilePicture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fur::furgen {

namespace {

// What an uncovered texel keeps of its brightness.
constexpr float kEmptyShare = 0.3f;
// An offset of this share of the tile has half the brightness: small ones must already show.
constexpr float kHalfBrightShare = 1.0f / 96.0f;

std::uint8_t toByte(float value) { return static_cast<std::uint8_t>(saturate(value) * 255.0f + 0.5f); }

Vec3 grey(std::uint8_t value) { return Vec3(static_cast<float>(value) / 255.0f); }

// Hue in turns.
Vec3 hueColor(float hue, float saturation, float brightness) {
  const auto channel = [&](float shift) {
    const float t = hue + shift - std::floor(hue + shift);
    return saturate(std::fabs(6 * t - 3) - 1);
  };
  const Vec3 pure(channel(0), channel(2.0f / 3), channel(1.0f / 3));
  return brightness * (Vec3(1 - saturation) + saturation * pure);
}

// From dark blue over green to yellow: brightness rises all the way, so that it also reads without colour.
Vec3 scaleColor(float t) {
  constexpr std::array<Vec3, 4> kStops = {Vec3(0.16f, 0.17f, 0.45f), Vec3(0.10f, 0.47f, 0.54f),
                                          Vec3(0.40f, 0.74f, 0.37f), Vec3(0.98f, 0.91f, 0.30f)};
  const float at = saturate(t) * (kStops.size() - 1);
  const auto left = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  return glm::mix(kStops[left], kStops[left + 1], at - static_cast<float>(left));
}

Vec3 tangentColor(const std::int8_t* tangent) {
  return Vec3(tangent[0], tangent[1], tangent[2]) / 127.0f * 0.5f + 0.5f;
}

Vec3 offsetColor(const std::int16_t* offset, int size) {
  const Vec2 texels = Vec2(offset[0], offset[1]) / 64.0f;
  const float length = glm::length(texels);
  return hueColor(std::atan2(texels.y, texels.x) / (2 * kPi), 0.85f,
                  length / (length + static_cast<float>(size) * kHalfBrightShare));
}

Vec3 strandColor(std::uint16_t id) {
  if (id == 0) return Vec3(0);
  // Steps of the golden ratio: strands that follow each other are far apart in hue.
  const float turns = static_cast<float>(id) * 0.61803399f;
  return hueColor(turns, 0.4f + 0.15f * static_cast<float>(id % 4), 0.95f);
}

// Calls color(texel) for every texel; with `cover`, empty ones are darkened.
template <class Color>
TilePicture paint(int width, int height, const std::vector<std::uint8_t>* cover, Color&& color) {
  TilePicture out{width, height, {}};
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  out.rgba.resize(count * 4);
  for (std::size_t i = 0; i < count; ++i) {
    const float covered = cover ? static_cast<float>((*cover)[i]) / 255.0f : 1.0f;
    const Vec3 shown = color(i) * glm::mix(kEmptyShare, 1.0f, covered);
    for (int k = 0; k < 3; ++k) out.rgba[i * 4 + k] = toByte(shown[k]);
    out.rgba[i * 4 + 3] = 255;
  }
  return out;
}

// The channels that a layer and a fin map have in common.
template <class Maps>
TilePicture commonPicture(const Maps& maps, int width, int height, TileChannel channel) {
  const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  FUR_ASSERT(maps.coverage.size() == texels, "furgen::pictureOf()", "maps of the given size", maps.coverage.size());
  switch (channel) {
    case TileChannel::Dominance:
      return paint(width, height, &maps.coverage, [&](std::size_t i) {
        return scaleColor((static_cast<float>(maps.dominance[i]) - 128) / 127.0f);
      });
    case TileChannel::Variance:
      return paint(width, height, &maps.coverage, [&](std::size_t i) { return grey(maps.variance[i]); });
    case TileChannel::Tangent:
      return paint(width, height, &maps.coverage, [&](std::size_t i) { return tangentColor(&maps.tangent[i * 3]); });
    default:
      return paint(width, height, nullptr, [&](std::size_t i) { return grey(maps.coverage[i]); });
  }
}

}  // namespace

TilePicture pictureOf(const LayerMaps& layer, int size, TileChannel channel) {
  if (channel == TileChannel::Offset)
    return paint(size, size, &layer.coverage, [&](std::size_t i) { return offsetColor(&layer.offset[i * 2], size); });
  if (channel == TileChannel::Strand)
    return paint(size, size, &layer.coverage, [&](std::size_t i) { return strandColor(layer.strandId[i]); });
  return commonPicture(layer, size, size, channel);
}

TilePicture pictureOf(const FinMaps& fin, int size, TileChannel channel) {
  return commonPicture(fin, size, fin.rows, channel);
}

}  // namespace fur::furgen
