#include "truth/Wetting.h"

#include <algorithm>
#include <cmath>

#include "furgen/LockCentres.h"
#include "wet/Clump.h"

namespace fur::truth {

namespace {

// A clump's centre is a few triangles from a strand.
constexpr int kCentreSteps = 4;
constexpr float kAtCentre = 1e-6f, kFarthestCentre = 16.0f;  // atlas units
constexpr int kLockMap = static_cast<int>(FUR_LOCKS_ACROSS * FUR_LOCK_TEXELS);

Vec4 texelAt(const wet::MaskTexels& mask, const Vec2& atlas) {
  const auto index = [&](float x) { return static_cast<std::size_t>(glm::clamp(x * static_cast<float>(mask.size), 0.0f, static_cast<float>(mask.size) - 1)); };
  if (!(std::isfinite(atlas.x) && std::isfinite(atlas.y))) return Vec4(0);
  const Vec4 texel = mask.texels[index(atlas.y) * static_cast<std::size_t>(mask.size) + index(atlas.x)];
  return std::isfinite(texel.x + texel.y + texel.z + texel.w) ? texel : Vec4(0);
}

// Beside the charts texels have -1 less the water next to them.
float waterOf(const Vec4& texel) { return glm::clamp(texel.w < 0 ? -1 - texel.w : texel.w, 0.0f, 2.0f); }

}  // namespace

float wetnessAt(const wet::MaskTexels& mask, const Vec2& atlas) { return waterOf(texelAt(mask, atlas)); }

Wetting::Wetting(const FurMap& map, const wet::MaskTexels& mask, const render::shared::FurBlock& coat)
    : map_(map), mask_(mask), coat_(coat), locks_(furgen::lockCentres(kLockMap, static_cast<int>(FUR_LOCKS_ACROSS))) {
  FUR_ASSERT(mask.texels.size() == static_cast<std::size_t>(mask.size) * static_cast<std::size_t>(mask.size), "Wetting::Wetting()", "a whole mask",
             mask.texels.size());
}

// The tile coordinates of an atlas point: over the triangles of the chart and, where that ends, straight on.
glm::dvec2 Wetting::centreOf(const Root& root, const Vec2& centre) const {
  glm::dvec2 tile = root.tile;
  ChartPoint spot = root.spot;
  for (int i = 0; i < kCentreSteps; ++i) {
    const Vec2 rest = centre - map_.atlas(spot);
    if (glm::dot(rest, rest) < kAtCentre * kAtCentre) break;
    tile += map_.tileFromAtlas(spot.triangle, rest);
    const ChartPoint next = map_.find(spot.triangle, tile);
    if (map_.chart(next) != map_.chart(root.spot)) break;
    spot = next;
  }
  return tile;
}

// Which lock of a sheet the strand belongs to: the one that comes from furthest of those that lie over its root.
void Wetting::lieDown(const Root& root, float lies, Strand& strand) const {
  const float furLengths = map_.scale(root.spot, 0) / coat_.furLength;
  if (!(lies > 0 && furLengths > 0 && glm::length(strand.lean) > 0)) return;
  const float width = std::max(static_cast<float>(FUR_LOCK_WIDTH) / furLengths, static_cast<float>(FUR_LEAST_LOCK) * coat_.clumpRadius * coat_.tilesPerUnit);
  const float size = -std::log2(width), large = std::floor(size);
  // Of the two sizes each strand has one.
  const bool isSmall = root.number < size - large;
  const float cells = std::exp2(large + (isSmall ? 1.0f : 0.0f));
  const float length = (isSmall ? 0.7f : 1.0f) * std::max(0.85f, static_cast<float>(FUR_LOCK_LENGTH) * width * furLengths);
  const Vec2 at = Vec2(root.tile * static_cast<double>(cells)), lean = Vec2(strand.lean) * cells, way = lean * (length / lies);
  for (int i = 0; i < FUR_LOCK_LOOKS; ++i) {
    const Vec2 texel = glm::floor((at - way * ((static_cast<float>(i) + 0.5f) / FUR_LOCK_LOOKS)) * static_cast<float>(FUR_LOCK_TEXELS));
    const auto wrapped = [](float x) { return static_cast<std::size_t>(x - kLockMap * std::floor(x / kLockMap)); };
    const auto& stored = locks_[wrapped(texel.y) * kLockMap + wrapped(texel.x)];
    const Vec2 centre = (texel + 0.5f) / static_cast<float>(FUR_LOCK_TEXELS) + 4.0f * (Vec2(stored[0], stored[1]) / 255.0f - 0.5f);
    // No two are alike, as locksAt() of shell_wet.glsl has them.
    const Vec2 chances = glm::fract(glm::dot(glm::floor(centre), Vec2(0.7548777f, 0.5698403f)) + Vec2(0.31f, 0.31f * 7.3f + 3.1f * centre.x));
    const Vec2 own = way * (0.6f + 0.6f * chances.x) + Vec2(-way.y, way.x) * (0.3f * (chances.y - 0.5f));
    const float halfWidth = static_cast<float>(FUR_LOCK_HALF_WIDTH) * (0.75f + 0.5f * chances.y);
    const Vec2 on = wet::onLock(at - centre, own, halfWidth);
    if (on.x <= strand.along || on.x >= 1 || std::abs(on.y) >= 1) continue;
    strand.along = on.x;
    strand.aside = on.y;
    strand.across = glm::dvec2(Vec2(-own.y, own.x) / glm::length(own));
    strand.halfWidth = halfWidth / cells;
    strand.reach = lies / length * glm::length(way) / glm::length(own);
    const float rises = (1 - on.y * on.y) * std::min(0.35f + 2 * on.x, 1.0f);
    strand.water.lock = {on.y, rises, std::min(2 * rises, 1.0f) * (chances.x - 0.5f)};
    const ChartPoint beside = map_.find(root.spot.triangle, root.tile + strand.across * 1e-2);
    strand.water.beside = normalizeOr(map_.point(beside, 0) - map_.point(root.spot, 0), Vec3(0));
  }
}

std::optional<Wetting::Strand> Wetting::at(const Root& root) const {
  const Vec2 atlas = map_.atlas(root.spot);
  Vec4 texel = texelAt(mask_, atlas);
  Strand strand;
  strand.root = strand.centre = root.tile;
  Wetness& water = strand.water;
  water.held = waterOf(texel);
  if (water.held <= 0) return std::nullopt;
  const float rho = std::min(water.held, 1.0f);
  water.sheet = wet::sheetOf(water.held, wet::shortnessOf(coat_.furLength, coat_.clumpRadius));
  strand.upright = wet::upright(rho, water.sheet);
  // Of the dry strand's tip, along the skin.
  const Vec3 normal = map_.normal(root.spot), tip = (map_.point(root.spot, 1) - map_.point(root.spot, 0)) / coat_.furLength;
  const Vec3 aside = tip - normal * glm::dot(tip, normal);
  const float much = glm::length(aside), lies = wet::wetLean(much, rho, water.sheet);
  if (much > 1e-6f) strand.lean = map_.tileStep(root.spot, aside * (lies / much * coat_.furLength));
  if (water.sheet > 0) lieDown(root, lies, strand);
  texel.x -= static_cast<float>(FUR_CHART_STEP) * (std::floor(texel.x / static_cast<float>(FUR_CHART_STEP)) + 0.5f);
  const Vec2 centre(texel);
  if (texel.w <= 0 || !(texel.z > 0) || glm::length(centre - atlas) > kFarthestCentre) return strand;
  const glm::dvec2 at = centreOf(root, centre);
  const Vec3 way = map_.point(root.spot, 0) - map_.point(map_.find(root.spot.triangle, at), 0);
  const float radius = texel.z * map_.unitsPerAtlas(root.spot.triangle), apart = glm::length(way);
  if (!std::isfinite(apart + radius) || !(radius > 0)) return strand;
  strand.centre = at;
  strand.drawn = wet::clumpingWetness(rho, std::max(radius, apart) / coat_.furLength);
  water.outward = (way - normal * glm::dot(way, normal)) / std::max(radius, apart);
  return strand;
}

float Wetting::pullAt(const Strand& strand, float h) const {
  // The profile begins at the lowest layer.
  const float lowest = 1 / std::max(coat_.layers, 1.0f), foot = std::min(h / lowest, 1.0f);
  return foot * wet::clumpPull(h, coat_.clumpShape, coat_.layers, strand.drawn, strand.water.sheet);
}

glm::dvec2 Wetting::tileAt(const Strand& strand, const glm::dvec2& dry, float h) const {
  const double s = pullAt(strand, h);
  glm::dvec2 tile = dry - s * (dry - strand.centre) + strand.lean * static_cast<double>(h);
  if (strand.reach > 0) {
    const auto half = [&](float along) { return std::max((1 - along) * (1 + 0.8f * along), 0.0f); };
    const float narrows = half(std::min(strand.along + strand.reach * h, 1.0f)) - half(strand.along);
    tile += strand.across * static_cast<double>(strand.water.sheet * strand.halfWidth * strand.aside * narrows);
  }
  return tile;
}

}  // namespace fur::truth
