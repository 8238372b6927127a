// Markings of furry animals, made of the place in space, so that they run on across the charts of any model.
#pragma once

#include <cstdint>

#include "groom/Groom.h"

namespace fur::groom {

// Tabby: stripes across the longest way through the model that is level, thinner and broken towards its underside. Spots.
// Rosettes: spots that are open in the middle. Patches: large ones, over less than half of it.
enum class Pattern { Tabby, Spots, Rosettes, Patches };

// How much of the marking there is at a place of the skin, model space: 0 to 1. `size`: of its parts, 1 as is usual on a model of
// radius 1; `along`: the unit axis of stripes.
float patternAt(Pattern pattern, const Vec3& position, const Vec3& normal, const Vec3& along, float size, std::uint32_t seed);

// In place of all paint that there is: the marking in that colour, 0xRRGGBB, on fur of the coat's own.
void paintPattern(Groom& groom, const GroomSurface& skin, Pattern pattern, float size, std::uint32_t color, std::uint32_t seed);

}  // namespace fur::groom
