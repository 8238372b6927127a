// Makes fur charts overlap, so that no seam shows where two of them meet (after lapped textures: Praun,
// Finkelstein, Hoppe 2000, which Lengyel et al. 2001 used for shells).
//
// Each chart extends across its border into charts of higher index, up to kReach along the surface: it gets copies of
// their triangles there, unfolded into its own plane. In this zone each strand belongs to one chart, chosen by the strand's
// random number in 0..1. With d_j the distance to chart j and
//   g_j = 1 - d_j / kReach                (0 or less beyond the zone, 1 on j and its border)
//   F_k = max of g_0 .. g_k
// chart k shows the strands with numbers from F_(k-1) to F_k, clamped to 0..1 (SurfaceVertex::strands). The intervals of all
// charts at a point together cover 0..1 once, so the density of strands stays the same. The reference (src/truth) compares
// strands' numbers with the interval; shells, whose rays cross a whole zone, give each chart that share of every pixel.
//
// Two exceptions keep hard borders: a chart that the zones of its neighbours would cover more than once (a cube's face of
// two triangles), and all charts from the one on with which there would be kMostCopies times as many copies as triangles (a
// surface in thousands of pieces).
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Twice the distance between strands at the default density and repeat (0.008). The smallest at which no border is
// visible in pictures of bunny, sphere and torus, dry and wet. 6 % of the bunny is then shaded twice; at 0.03, 12 %.
inline constexpr float kReach = 0.015f;
inline constexpr std::size_t kMostCopies = 4;

// Appends the copies to `vertices`, sets `strands` of all vertices and makes furIndices. `chartOf`: the fur chart of each
// triangle; `weld`: over the vertices, none of them a copy yet.
struct FurOverlap {
  std::vector<std::uint32_t> chartOfVertex;  // fur charts
  std::vector<std::uint32_t> triangleOf;  // one a triangle of furIndices: the triangle of indices that it lies on
  std::size_t firstCopy = 0;  // the first triangle of furIndices that is a copy
};
FurOverlap overlapFurCharts(Surface& surface, const std::vector<std::uint32_t>& chartOf, std::uint32_t chartCount,
                            const Weld& weld);

}  // namespace fur::geometry
