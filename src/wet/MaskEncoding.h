// The wetness mask made ready for the picture: softened where wet fur meets dry fur, and told which chart each texel is of.
//
// Of a chart's texel:  x  the clump centre's u, plus FUR_CHART_STEP * (chart mod FUR_CHART_NUMBERS + 1/2)
//                      y  its v; both no further from the texel than the clump reaches. In gutters plus FUR_BORDER_STEP times the number
//                         of the border beyond which a chart goes on (ChartBorders.h), 0: none is known
//                      z  the clump's radius (atlas units, below FUR_LYING_STEP), plus FUR_LYING_STEP times the water by which fur lies
//                         down there, 0..1, in FUR_LYING_STEPS steps: the wide mean of WaterAround. By its own water each clump would lie
//                         another way than the next, and strands would wave
//                      w  the water held: 0 dry, 1 saturated, more: a film on the strands
// Beside the charts:   (0, 0, the same, -1 - the water next to it)
//
// shaders/es3/common_clump.glsl reads them (maskAt, chartOf, isBeside, filteredWater); MaskGLTest holds both together.
// Softening is for the eye alone: the mask itself, and so the flow of water, stays as it is.
#pragma once

#include <cstdint>
#include <span>

#include "wet/ChartBorders.h"
#include "wet/MaskTexels.h"
#include "wet/WaterAround.h"
#include "wet/WetnessMask.h"

namespace fur::wet {

// The texels of a rectangle. `charts`: one a texel of the mask, gutters among them, so that rays know when they leave one
// (SurfaceWetting). Without `around`: the water of Algorithm 1 as it is, without a film (setting `printedMask`); without `borders` gutters lead
// nowhere.
MaskTexels encodeMask(const WetnessMask& mask, const TexelRect& rect, std::span<const std::uint16_t> charts, const WaterAround* around, const ChartBorders* borders = nullptr);

}  // namespace fur::wet
