// The numbers that the shaders are given, worked out of a frame: the one place for whoever draws the same picture.
#pragma once

#include <array>

#include "furgen/Packing.h"
#include "render/Frame.h"
#include "shared/Blocks.h"

namespace fur::render {

// World space, unit, towards the key light.
Vec3 lightDirection(const Frame& frame);
// Whether strands are so large that one cut at a chart's border can be seen.
bool chartsOverlap(const Frame& frame);

shared::FrameBlock frameBlock(const Frame& frame);
// One a fur type: the share of its densest layer that strands cover; 0: bald, or not there.
using FurDensities = std::array<float, FUR_TYPES>;
// And the layer of its colour map (SurfaceMaps), -1: none.
using TypePictures = std::array<int, FUR_TYPES + 1>;  // the last: of the skin
inline constexpr TypePictures kNoPictures{-1, -1, -1, -1, -1};

// A tile of that many texels along a side and that many layers for each type.
shared::FurBlock furBlock(const Frame& frame, const furgen::CoatShape& shape, const FurDensities& densities, int maskSize,
                          const TypePictures& pictures = kNoPictures);

}  // namespace fur::render
