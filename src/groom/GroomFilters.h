// Changes of the whole groom at once, and grooms made from other data.
#pragma once

#include <span>

#include "groom/Groom.h"

namespace fur::groom {

// --- the map ---
void setLength(GroomMap& map, float share);  // everywhere, 0..1
void setType(GroomMap& map, int type);       // 1..kTypes, and no other
void invertLength(GroomMap& map);            // share -> 1 - share
// Multiplies lengths by a smooth noise in space between 1 - amount and 1. `grain`: size of its patches in model units.
void varyLength(Groom& groom, const GroomSurface& skin, float amount, float grain, std::uint32_t seed);

// --- the comb ---
// `lie`: as GroomSurface has it.
void combAlong(Groom& groom, const SurfacePoints& points, const Vec3& direction, float amount, std::span<const Vec3> lie = {});  // amount 0..1
void raiseAll(Groom& groom, std::span<const Vec3> lie = {});
void letLie(Groom& groom);  // as if nobody had combed it

// --- paint and mask ---
void paintAll(Groom& groom, std::uint32_t color);  // 0xRRGGBB
void invertMask(GroomMap& mask);
// Restores the groom to `before` by as much as the mask protects it. `before` has maps of the same size.
void keepProtected(Groom& groom, const Groom& before, const GroomSurface& skin);
// The paint with the mask over it in red, for display.
GroomMap paintUnderMask(const Groom& groom);

// --- from other data ---
// Of a pixel's red, green and blue.
std::uint8_t brightness(const std::uint8_t* pixel);
// A length (0..1) and a type (1..kTypes) for each true vertex, interpolated between them. Either may be empty, and is then
// left as it is.
void paintFromVertices(Groom& groom, const GroomSurface& skin, std::span<const float> lengths, std::span<const int> types);
// An image (RGBA8, first row at v = 0, 4 * width * height bytes) in the model's texture coordinates, or in the atlas if it has
// none. Length: its brightness; Types: red, green and blue are the presence of the types 2 to 4.
void paintFromImage(ImageOf what, Groom& groom, const GroomSurface& skin, int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace fur::groom
