// The wetness mask made ready for the picture: softened where wet fur meets dry fur, and told which chart each texel is of.
//
// Of a chart's texel:  x  the clump centre's u, plus FUR_CHART_STEP * (chart mod FUR_CHART_NUMBERS + 1/2)
//                      y  its v   z  the clump's radius (atlas units)
//                      w  the water held: 0 dry, 1 saturated, more: a film on the strands
// Beside the charts:   (0, 0, 0, -1 - the water next to it)
//
// shaders/es3/common_clump.glsl reads them (maskAt, chartOf, isBeside, filteredWetness); MaskGLTest holds both together.
// Softening is for the eye alone: the mask itself, and so the flow of water, stays as it is.
#pragma once

#include <cstdint>
#include <span>

#include "wet/MaskTexels.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

// What lies under each texel of a mask.
struct MaskAtlas {
  std::span<const std::uint16_t> charts;     // with gutters, so that rays know when they leave a chart (SurfaceWetting)
  std::span<const std::uint32_t> triangles;  // without: gutters say nothing about the water round them (AtlasTexels)
};

// What has to be uploaded when `changed` has: wider than that, as softening looks around. Nothing where nothing has. Not `softened`: the
// water of Algorithm 1 as it is, without a film (setting `printedMask`).
MaskTexels encodeMask(const WetnessMask& mask, const TexelRect& changed, const MaskAtlas& atlas, bool softened = true);

}  // namespace fur::wet
