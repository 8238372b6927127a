// Patches of the surface that shells are drawn by: small, compact, facing one way, so that a renderer can put
// them in order from near to far and leave out those that face away.
#pragma once

#include <cstdint>
#include <vector>

#include "core/Math.h"

namespace fur::geometry {

struct Surface;

struct FurCluster {
  std::uint32_t first = 0, count = 0;        // in Surface::furIndices, three a triangle
  std::uint32_t ownFirst = 0, ownCount = 0;  // in Surface::ownFurIndices: without copies of other charts
  Vec3 centre{0.0f};
  float radius = 0.0f;
  // All triangle and vertex normals lie within the angle of the axis; cosine 0 or less: they face every way.
  Vec3 axis{0, 1, 0};
  float cosine = 1.0f;
};

// Triangles that a cluster has at most, copies (FurOverlap.h) not counted. Fewer are put in better order, more are quicker to sort.
inline constexpr std::size_t kClusterTriangles = 32;

// Reorders surface.furIndices so that every cluster is one run of it, does the same in surface.ownFurIndices, and
// returns the clusters. A copy goes with
// the triangle that it lies on, after it and after the copies of higher charts: blended in this order each
// chart comes to its share (SurfaceVertex::strands). `triangleOf` and `chartOf` say for every triangle of
// furIndices on which triangle of surface.indices it lies and to which fur chart it belongs.
std::vector<FurCluster> makeFurClusters(Surface& surface, const std::vector<std::uint32_t>& triangleOf,
                                        const std::vector<std::uint32_t>& chartOf);

// What shells are drawn on: a surface's furIndices, ownFurIndices and furClusters, or what is left of them.
struct FurPatches {
  std::vector<std::uint32_t> indices, ownIndices;
  std::vector<FurCluster> clusters;
};
// `indices` and `ownIndices`: those of the surface's furIndices and ownFurIndices, in their order, that are left.
FurPatches remainingPatches(const Surface& surface, std::vector<std::uint32_t> indices, std::vector<std::uint32_t> ownIndices);

// Indices of the clusters that an eye may see fur of, near ones first. `reach`: how far fur stands off the skin.
// Model space.
std::vector<std::uint32_t> clustersNearToFar(const std::vector<FurCluster>& clusters, const Vec3& eye, float reach);

}  // namespace fur::geometry
