// Lets fur charts overlap, so that no border shows where two of them meet (after lapped
// textures: Praun, Finkelstein, Hoppe 2000, which Lengyel et al. 2001 used for shells).
//
// Each chart reaches over its border into charts of higher index, up to kReach along the surface: it
// gets copies of their triangles there, unfolded into its own plane. In this zone every strand belongs
// whole to one chart, by a number of its own that is evenly spread over 0..1. With d_j the distance to
// chart j and
//   g_j = 1 - d_j / kReach                (0 or less beyond the zone, 1 on j and its border)
//   F_k = max of g_0 .. g_k
// chart k shows the strands from F_(k-1) to F_k, clamped to 0..1 (SurfaceVertex::strands). One chart's
// upper end is the next one's lower end, and the chart that owns the triangle ends at 1: at every point the
// charts' intervals together are 0..1, each number once. So as many strands stand there as elsewhere. A picture of
// strands (src/truth) takes their numbers; shells, whose rays go further than a zone is wide, give each chart a share as
// large of every pixel.
//
// No room: a chart of some size whose neighbours' zones would cover it more than once over (a cube's
// face of two triangles) keeps hard borders, nobody reaches into it. So do all charts from the one on
// with which copies would outnumber the triangles kMostCopies times (a surface in thousands of scraps).
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Two strands' distance at the default density and repeat (0.008). Judged by pictures: from here on no
// border is found on bunny, sphere and torus, dry or wet. The bunny shades 6 % of its surface twice, at 0.03
// it would be 12 %.
inline constexpr float kReach = 0.015f;
inline constexpr std::size_t kMostCopies = 4;

// Appends the copies to `vertices`, sets `strands` of all of them and makes furIndices. `chartOf` has the
// fur chart of every triangle, `weld` is over the vertices (all of them true ones). Returns the fur
// chart of every vertex, the triangles that furIndices lie on, and where the copied triangles start in furIndices.
struct FurOverlap {
  std::vector<std::uint32_t> chartOfVertex;
  std::vector<std::uint32_t> triangleOf;  // one a triangle of furIndices: the triangle of indices that it lies on
  std::size_t firstCopy = 0;
};
FurOverlap overlapFurCharts(Surface& surface, const std::vector<std::uint32_t>& chartOf, std::uint32_t chartCount,
                            const Weld& weld);

}  // namespace fur::geometry
