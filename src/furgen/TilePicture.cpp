#include "furgen/TilePicture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fur::furgen {

namespace {

// What an uncovered texel keeps of its brightness, in 256ths.
constexpr unsigned kEmptyShare = 77;
// An offset of this share of the tile has half the brightness: small ones must already show.
constexpr float kHalfBrightShare = 1.0f / 96.0f;

struct Rgb {
  std::uint8_t r, g, b;
};

std::uint8_t toByte(float value) { return static_cast<std::uint8_t>(saturate(value) * 255.0f + 0.5f); }
Rgb toRgb(const Vec3& color) { return {toByte(color.x), toByte(color.y), toByte(color.z)}; }
Rgb grey(std::uint8_t value) { return {value, value, value}; }

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

// -127..127 of 127 as 0..255.
std::uint8_t component(std::int8_t value) { return static_cast<std::uint8_t>(((value + 127) * 255 + 127) / 254); }

Rgb offsetColor(const std::int16_t* offset, int size) {
  const Vec2 texels = Vec2(offset[0], offset[1]) / 64.0f;
  const float length = glm::length(texels);
  return toRgb(hueColor(std::atan2(texels.y, texels.x) / (2 * kPi), 0.85f,
                        length / (length + static_cast<float>(size) * kHalfBrightShare)));
}

// A colour for each id that there is. Steps of the golden ratio: strands that follow each other are far apart in hue.
std::vector<Rgb> strandColors(const std::vector<std::uint16_t>& ids) {
  std::vector<Rgb> colors(1u + (ids.empty() ? 0u : *std::max_element(ids.begin(), ids.end())));
  for (std::size_t id = 1; id < colors.size(); ++id)
    colors[id] = toRgb(hueColor(static_cast<float>(id) * 0.61803399f, 0.4f + 0.15f * static_cast<float>(id % 4), 0.95f));
  return colors;
}

// Calls color(texel) for every texel; with `cover`, empty ones are darkened.
template <class Color>
TilePicture paint(int width, int height, const std::vector<std::uint8_t>* cover, Color&& color) {
  TilePicture out{width, height, {}};
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  out.rgba.resize(count * 4);
  for (std::size_t i = 0; i < count; ++i) {
    // 256ths of the brightness that stay.
    const unsigned share = cover ? kEmptyShare + ((256u - kEmptyShare) * (*cover)[i] + 127u) / 255u : 256u;
    const Rgb shown = color(i);
    std::uint8_t* texel = &out.rgba[i * 4];
    texel[0] = static_cast<std::uint8_t>((shown.r * share) >> 8u);
    texel[1] = static_cast<std::uint8_t>((shown.g * share) >> 8u);
    texel[2] = static_cast<std::uint8_t>((shown.b * share) >> 8u);
    texel[3] = 255;
  }
  return out;
}

// The channels that a layer and a fin map have in common.
template <class Maps>
TilePicture commonPicture(const Maps& maps, int width, int height, TileChannel channel) {
  const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  FUR_ASSERT(maps.coverage.size() == texels, "furgen::pictureOf()", "maps of the given size", maps.coverage.size());
  if (channel == TileChannel::Dominance) {
    std::array<Rgb, 256> scale{};
    for (int value = 128; value < 256; ++value) scale[value] = toRgb(scaleColor(static_cast<float>(value - 128) / 127.0f));
    return paint(width, height, &maps.coverage, [&](std::size_t i) { return scale[maps.dominance[i]]; });
  }
  if (channel == TileChannel::Variance)
    return paint(width, height, &maps.coverage, [&](std::size_t i) { return grey(maps.variance[i]); });
  if (channel == TileChannel::Tangent)
    return paint(width, height, &maps.coverage, [&](std::size_t i) {
      const std::int8_t* t = &maps.tangent[i * 3];
      return Rgb{component(t[0]), component(t[1]), component(t[2])};
    });
  return paint(width, height, nullptr, [&](std::size_t i) { return grey(maps.coverage[i]); });
}

}  // namespace

TilePicture pictureOf(const LayerMaps& layer, int size, TileChannel channel) {
  if (channel == TileChannel::Offset)
    return paint(size, size, &layer.coverage, [&](std::size_t i) { return offsetColor(&layer.offset[i * 2], size); });
  if (channel == TileChannel::Strand) {
    const std::vector<Rgb> colors = strandColors(layer.strandId);
    return paint(size, size, &layer.coverage, [&](std::size_t i) { return colors[layer.strandId[i]]; });
  }
  return commonPicture(layer, size, size, channel);
}

TilePicture pictureOf(const FinMaps& fin, int size, TileChannel channel) {
  return commonPicture(fin, size, fin.rows, channel);
}

}  // namespace fur::furgen
