// How thick a coat of fur stands on a surface, and where the coats of two of its parts meet.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/Surface.h"
#include "geometry/SurfaceQuery.h"
#include "geometry/Weld.h"

namespace fur::geometry {

// Sets SurfaceVertex::room: in a crease a coat is at most 0.65 of the crease's radius thick, as beyond that strands of both sides would
// cross. The radius is that of the curvature, which must be set, and of each edge whose ends lean together. Away from a crease room
// grows with the way to it: strands that stand further off would reach into the other side, and the coat's outside would fold.
// Nor is fur longer than 1.1 times the radius of the body: that which half of the skin, by area, has at least by its largest curvature. Longer
// fur hid what a slender animal is, and its outside had polygons and holes. On any body it may be 0.12 (model units) long.
// `triangles` cover the surface once; `weld` is over all its vertices.
void measureRoom(Surface& surface, const std::vector<std::uint32_t>& triangles, const Weld& weld);

// The thickness of a coat of that fur length at a vertex.
inline float coatThickness(const SurfaceVertex& vertex, float furLength) { return std::min(furLength, vertex.room); }

// A ray that grazes a round part of the coat comes out of it again, by the shape of the skin there. Where another part is near, as
// across the hollow of a ring, it goes on deep in that one's coat instead, whose outside it never crosses. The share of such
// rays: of some vertices, evenly spread, all ways along the outside.
float grazingShare(const Surface& surface, const SurfaceQuery& query, float furLength);

// Where such rays come to, some of them a step. Surface and query must outlive it.
class CrowdedSearch {
 public:
  CrowdedSearch(const Surface& surface, const SurfaceQuery& query, float furLength);
  // Whether all rays have been followed.
  bool step();
  // For each vertex whether it is of a triangle in whose coat one of them is, two or four fur lengths on.
  std::vector<std::uint8_t> take() { return std::move(crowded_); }

 private:
  const Surface* surface_;
  const SurfaceQuery* query_;
  float furLength_;
  std::size_t vertex_ = 0;
  std::vector<std::uint8_t> crowded_;
};

}  // namespace fur::geometry
