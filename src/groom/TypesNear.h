// Which fur types, and whether several lengths, lie near a point of the atlas: what a ray through the coat may meet before it has
// looked. Most meet fur of one type and length, and then need not ask the map at every step.
//
// Levels of square cells, the finest of about two texels, each with half the cells of the one before along a side, down to one. What a
// cell says holds for it and for all eight round it, so for everything within a cell's side of any point in it; it never misses
// any, and counts nothing that lies outside all charts.
#pragma once

#include <cstdint>
#include <vector>

#include "groom/Groom.h"

namespace fur::groom {

// Bits of a cell: 1, 2, 4 and 8 for each type that is present, and this where lengths differ.
inline constexpr std::uint8_t kLengthsDiffer = 16;

// Cells along a side of the finest level: a power of two.
int nearCells(int mapSize);
// One a level, row-major. Where a cell knows of no chart it has all bits.
std::vector<std::vector<std::uint8_t>> typesNear(const GroomMap& map, const geometry::AtlasTexels& atlas);

}  // namespace fur::groom
