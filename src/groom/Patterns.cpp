#include "groom/Patterns.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "groom/Noise.h"

namespace fur::groom {

namespace {

constexpr float kLeastPattern = 0.1f, kMostPattern = 10;

float smoothBetween(float low, float high, float x) {
  const float t = saturate((x - low) / (high - low));
  return t * t * (3 - 2 * t);
}

// Two octaves, -1..1.
float warp(const Vec3& at, std::uint32_t seed) { return (noiseAt(at, seed) * 2 + noiseAt(at * 2.1f, seed + 1) - 1.5f) / 1.5f; }

// The nearest of points that chance has put into cells of space, one each: how far it is, and a number of its own, 0..1.
struct NearPoint {
  float distance = 9, own = 0;
};
NearPoint nearPoint(const Vec3& at, std::uint32_t seed) {
  const Vec3 base = glm::floor(at);
  NearPoint best;
  for (int i = 0; i < 27; ++i) {
    const Vec3 cell = base + Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y), z = static_cast<int>(cell.z);
    const Vec3 point = cell + 0.15f + 0.7f * Vec3(cellValue(x, y, z, seed), cellValue(x, y, z, seed + 1), cellValue(x, y, z, seed + 2));
    const float distance = glm::length(at - point);
    if (distance < best.distance) best = {distance, cellValue(x, y, z, seed + 3)};
  }
  return best;
}

float tabby(const Vec3& at, const Vec3& normal, const Vec3& along, float size, std::uint32_t seed) {
  constexpr float kWavesPerUnit = 4.2f;
  const float phase = glm::dot(at, along) * kWavesPerUnit / size + 0.55f * warp(at * (1.6f / size), seed) + 0.22f * warp(at * (4.5f / size), seed + 7);
  const float wave = portableCos(2 * kPi * phase);
  // Thinner below, and broken where noise is low.
  const float edge = 0.25f + 0.35f * smoothBetween(0.1f, -0.8f, normal.y) + 0.35f * smoothBetween(0.5f, 0.25f, noiseAt(at * (2.6f / size), seed + 13));
  return smoothBetween(edge - 0.22f, edge + 0.22f, wave) * (0.55f + 0.45f * smoothBetween(-0.95f, -0.3f, normal.y));
}

// Of cells that far apart.
float spots(const Vec3& at, float size, std::uint32_t seed) {
  constexpr float kSpotsPerUnit = 4.5f;
  const Vec3 scaled = at * (kSpotsPerUnit / size);
  const NearPoint near = nearPoint(scaled + 0.22f * Vec3(warp(scaled, seed + 5), warp(scaled, seed + 6), warp(scaled, seed + 8)), seed);
  const float radius = 0.27f + 0.14f * near.own;
  return smoothBetween(radius + 0.05f, radius - 0.05f, near.distance);
}

float rosettes(const Vec3& at, float size, std::uint32_t seed) {
  constexpr float kPerUnit = 4.2f;
  const Vec3 scaled = at * (kPerUnit / size);
  const NearPoint near = nearPoint(scaled + 0.2f * Vec3(warp(scaled, seed + 5), warp(scaled, seed + 6), warp(scaled, seed + 8)), seed);
  const float radius = 0.31f + 0.1f * near.own, ring = std::abs(near.distance - radius);
  // Rings have gaps.
  const float whole = smoothBetween(0.32f, 0.44f, noiseAt(scaled * 2.6f, seed + 11));
  return whole * smoothBetween(0.12f, 0.06f, ring);
}

float patches(const Vec3& at, float size, std::uint32_t seed) {
  constexpr float kPerUnit = 1.9f;
  const Vec3 scaled = at * (kPerUnit / size);
  const float field = noiseAt(scaled, seed) + 0.22f * warp(scaled * 2.3f, seed + 3) + 0.05f * warp(scaled * 9.0f, seed + 4);
  return smoothBetween(0.54f, 0.58f, field);
}

// The level axis along which the model is longest.
Vec3 lengthwise(const geometry::Surface& surface) {
  Vec3 low(1e9f), high(-1e9f);
  for (const geometry::SurfaceVertex& vertex : surface.vertices) low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
  const Vec3 extent = high - low;
  // A little longer counts as round: those look best from the front.
  return extent.z > 1.15f * extent.x ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
}

}  // namespace

float patternAt(Pattern pattern, const Vec3& position, const Vec3& normal, const Vec3& along, float size, std::uint32_t seed) {
  const float within = std::clamp(size, kLeastPattern, kMostPattern);
  switch (pattern) {
    case Pattern::Tabby: return tabby(position, normal, along, within, seed);
    case Pattern::Spots: return spots(position, within, seed);
    case Pattern::Rosettes: return rosettes(position, within, seed);
    case Pattern::Patches: return patches(position, within, seed);
  }
  return 0;
}

void paintPattern(Groom& groom, const GroomSurface& skin, Pattern pattern, float size, std::uint32_t color, std::uint32_t seed) {
  const Vec3 along = lengthwise(skin.surface);
  const auto channel = [color](unsigned shift) { return static_cast<std::uint8_t>(color >> shift); };
  GroomMap& paint = groom.paint;
  paint = GroomMap(groom.map.size(), GroomMap::kBlank);
  for (std::uint32_t t = 0; t < skin.surface.triangleCount(); ++t)
    skin.atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const geometry::SurfacePoint at{t, weights, 0.0f};
      const float share = patternAt(pattern, positionAt(skin.surface, at), normalAt(skin.surface, at), along, size, seed);
      paint.set(texel, {channel(16), channel(8), channel(0), static_cast<std::uint8_t>(share * 255 + 0.5f)});
    });
  paint.fillGutter(skin.atlas, {0, 0, paint.size(), paint.size()});
}

}  // namespace fur::groom
