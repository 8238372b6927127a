// Changes of a whole groom at once, and grooms from other data. Gutters are left as filled as they were found, or filled.
#pragma once

#include <span>

#include "groom/Groom.h"

namespace fur::groom {

// --- the map ---
void setLength(GroomMap& map, float share);  // everywhere, 0..1
void setType(GroomMap& map, int type);       // 1..kTypes, and no other
void invertLength(GroomMap& map);            // share -> 1 - share
// Every length becomes a share of itself, 1 - amount to 1, by smooth noise in space, so that charts do not
// show. `grain`: size of its patches in model units.
void varyLength(Groom& groom, const GroomSurface& skin, float amount, float grain, std::uint32_t seed);

// --- the comb ---
void combAlong(Groom& groom, const SurfacePoints& points, const Vec3& direction, float amount);  // amount 0..1
void raiseAll(Groom& groom);

// --- paint and mask ---
void paintAll(Groom& groom, std::uint32_t color);  // 0xRRGGBB
void invertMask(GroomMap& mask);
// Brings back what `before` had, by as much as the mask protects it. `before` has maps of the same size.
void keepProtected(Groom& groom, const Groom& before, const GroomSurface& skin);
// The paint with the mask over it in red, for who is grooming.
GroomMap paintUnderMask(const Groom& groom);

// --- from other data ---
// Of red, green and blue.
std::uint8_t brightness(const std::uint8_t* pixel);
// One length (0..1) and one type (1..kTypes) a true vertex, linear between them. Either may be empty: that stays
// as it is.
void paintFromVertices(Groom& groom, const GroomSurface& skin, std::span<const float> lengths, std::span<const int> types);
// An image in the model's own texture coordinates (RGBA8, first row at v = 0), or in the atlas of a model without
// any: its brightness as length, or (Types) red, green and blue as presence of the types 2 to 4. `rgba` has 4 * width *
// height bytes.
void paintFromImage(ImageOf what, Groom& groom, const GroomSurface& skin, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace fur::groom
