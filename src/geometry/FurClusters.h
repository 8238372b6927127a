// Clusters of triangles for drawing shells: small, compact and facing one way, so that the renderer can draw them from
// near to far and cull those that face away.
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
  // The cone of all triangle and vertex normals: its axis and the cosine of its angle; 0 or less: no culling.
  Vec3 axis{0, 1, 0};
  float cosine = 1.0f;
};

// The most triangles in a cluster, without copies (FurOverlap.h). Smaller clusters are ordered better, larger ones sort faster.
inline constexpr std::size_t kClusterTriangles = 32;

// Reorders surface.furIndices and surface.ownFurIndices so that each cluster is one range of both, and returns the clusters.
// A copy follows the triangle on which it lies and the copies of higher charts on it: drawn in this order each chart
// gets its share (SurfaceVertex::strands). `triangleOf` and `chartOf`, for each triangle of furIndices: the triangle
// of surface.indices on which it lies, and its fur chart.
std::vector<FurCluster> makeFurClusters(Surface& surface, const std::vector<std::uint32_t>& triangleOf,
                                        const std::vector<std::uint32_t>& chartOf);

// What shells are drawn from: a surface's furIndices, ownFurIndices and furClusters, or a part of them.
struct FurPatches {
  std::vector<std::uint32_t> indices, ownIndices;
  std::vector<FurCluster> clusters;
};
// Clusters for a part of the surface: `indices` and `ownIndices` are subsets of furIndices and ownFurIndices in their order.
FurPatches remainingPatches(const Surface& surface, std::vector<std::uint32_t> indices, std::vector<std::uint32_t> ownIndices);

// The clusters whose fur may be visible from the eye, near ones first. `reach`: thickness of the coat. Model space.
std::vector<std::uint32_t> clustersNearToFar(const std::vector<FurCluster>& clusters, const Vec3& eye, float reach);

}  // namespace fur::geometry
