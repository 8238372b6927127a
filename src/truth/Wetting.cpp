#include "truth/Wetting.h"

#include <algorithm>
#include <cmath>

#include "furgen/LockCentres.h"
#include "wet/Clump.h"

namespace fur::truth {

namespace {

// A clump's centre is a few triangles from a strand.
constexpr int kCentreSteps = 4;
constexpr int kLockTexels = static_cast<int>(FUR_LOCKS_ACROSS * FUR_LOCK_TEXELS);
constexpr float kAtCentre = 1e-6f, kFarthestCentre = 16.0f;  // atlas units

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
    : map_(map), mask_(mask), coat_(coat), lockCentres_(furgen::lockCentres(kLockTexels, static_cast<int>(FUR_LOCKS_ACROSS))),
      locksPerTile_(wet::locksInClump(wet::shortnessOf(coat.furLength, coat.clumpRadius)) / std::max(coat.clumpRadius * coat.tilesPerUnit, 1e-6f)) {
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

// As lockCentreNear() in common_locks.glsl.
glm::dvec2 Wetting::lockOf(const glm::dvec2& tile) const {
  const glm::dvec2 texel = glm::floor(tile * locksPerTile_ * double{FUR_LOCK_TEXELS});
  const auto repeated = [](double x) { return static_cast<std::size_t>(static_cast<std::int64_t>(x) & (kLockTexels - 1)); };
  const std::array<std::uint8_t, 2>& way = lockCentres_[repeated(texel.y) * kLockTexels + repeated(texel.x)];
  return ((texel + 0.5) / double{FUR_LOCK_TEXELS} + 4.0 * (glm::dvec2(way[0], way[1]) / 255.0 - 0.5)) / locksPerTile_;
}

std::optional<Wetting::Strand> Wetting::at(const Root& root) const {
  const Vec2 atlas = map_.atlas(root.spot);
  Vec4 texel = texelAt(mask_, atlas);
  const float lying = wet::lyingOf(texel), clumpRadius = wet::radiusOf(texel);
  Strand strand;
  strand.root = strand.centre = root.tile;
  strand.lock = lockOf(root.tile);
  Wetness& water = strand.water;
  water.held = waterOf(texel);
  if (water.held <= 0) return std::nullopt;
  const float rho = std::min(water.held, 1.0f);
  const float shortness = wet::shortnessOf(coat_.furLength, coat_.clumpRadius);
  water.shortness = shortness;
  water.soaked = wet::sheetOf(water.held, shortness);
  water.sheet = wet::nearSheet(wet::clumpsClosed(water.held, water.soaked, shortness), shortness);
  // Of the dry strand's tip, along the skin.
  const Vec3 normal = map_.normal(root.spot), tip = (map_.point(root.spot, 1) - map_.point(root.spot, 0)) / coat_.furLength;
  const Vec3 aside = tip - normal * glm::dot(tip, normal);
  const float much = glm::length(aside), lies = wet::wetLean(much, lying, wet::sheetOf(lying, shortness));
  strand.top = wet::wetTop(wet::upright(rho, water.soaked), much, lies, water.soaked);
  if (much > 1e-6f) strand.lean = map_.tileStep(root.spot, aside * (lies / much * coat_.furLength));
  strand.tufts = wet::tuftsOf(water.held, coat_.furLength, coat_.clumpRadius);
  texel.x -= static_cast<float>(FUR_CHART_STEP) * (std::floor(texel.x / static_cast<float>(FUR_CHART_STEP)) + 0.5f);
  const Vec2 centre(texel);
  if (texel.w <= 0 || !(clumpRadius > 0) || glm::length(centre - atlas) > kFarthestCentre) return strand;
  const glm::dvec2 at = centreOf(root, centre);
  const Vec3 way = map_.point(root.spot, 0) - map_.point(map_.find(root.spot.triangle, at), 0);
  const float radius = clumpRadius * map_.unitsPerAtlas(root.spot.triangle), apart = glm::length(way);
  if (!std::isfinite(apart + radius) || !(radius > 0)) return strand;
  strand.centre = at;
  water.chance = wet::chanceOfClump(centre);
  strand.drawn = wet::clumpingWetness(rho, std::max(radius, apart) / coat_.furLength, water.chance);
  strand.shorter = wet::rimTaper(water.soaked, water.sheet, apart * apart / (radius * radius));
  water.outward = (1 - shortness * (1 - strand.tufts)) * (way - normal * glm::dot(way, normal)) / std::max(radius, apart);
  return strand;
}

float Wetting::pullAt(const Strand& strand, float h) const {
  // The profile begins at the lowest layer.
  const float lowest = 1 / std::max(coat_.layers, 1.0f), foot = std::min(h / lowest, 1.0f);
  return foot * wet::clumpPull(h, coat_.clumpShape, coat_.layers, strand.drawn, strand.water.sheet);
}

glm::dvec2 Wetting::tileAt(const Strand& strand, const glm::dvec2& dry, float h) const {
  const float lock = wet::lockPull(h, strand.drawn, wet::lockSheet(strand.water.sheet, strand.water.shortness));
  const float tuft = wet::tuftPull(h, strand.tufts, Vec2(strand.lock * locksPerTile_));
  const glm::dvec2 inLock = dry - double{std::max(lock, tuft)} * (strand.root - strand.lock);
  return inLock - double{pullAt(strand, h)} * (inLock - strand.centre) + strand.lean * double{h};
}

}  // namespace fur::truth
