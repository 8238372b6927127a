#include "geometry/FurClusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/Sort.h"
#include "geometry/Surface.h"

namespace fur::geometry {

namespace {

// A triangle as a point: where it is and, at a quarter of that scale, where it faces.
using Point = std::array<float, 6>;
constexpr float kFacingScale = 0.25f;

Vec3 faceNormal(const Surface& surface, std::size_t triangle) {
  const auto at = [&](std::size_t k) { return surface.vertices[surface.indices[3 * triangle + k]].position; };
  return normalizeOr(glm::cross(at(1) - at(0), at(2) - at(0)), Vec3(0, 1, 0));
}

std::vector<Point> trianglePoints(const Surface& surface) {
  std::vector<Point> points(surface.triangleCount());
  for (std::size_t t = 0; t < points.size(); ++t) {
    Vec3 centre(0.0f);
    for (std::size_t k = 0; k < 3; ++k) centre += surface.vertices[surface.indices[3 * t + k]].position / 3.0f;
    const Vec3 facing = faceNormal(surface, t) * kFacingScale;
    points[t] = {centre.x, centre.y, centre.z, facing.x, facing.y, facing.z};
  }
  return points;
}

using Iterator = std::vector<std::uint32_t>::iterator;

// Halves a range along its longest side until it is small enough; appends the ends of the parts.
void split(const std::vector<Point>& points, const Iterator begin, const Iterator end, const Iterator base,
           std::vector<std::size_t>& ends) {
  const auto size = static_cast<std::size_t>(end - begin);
  if (size <= kClusterTriangles) return ends.push_back(static_cast<std::size_t>(end - base));
  Point low = points[*begin], high = low;
  for (Iterator i = begin; i != end; ++i)
    for (std::size_t d = 0; d < 6; ++d)
      low[d] = std::min(low[d], points[*i][d]), high[d] = std::max(high[d], points[*i][d]);
  std::size_t axis = 0;
  for (std::size_t d = 1; d < 6; ++d)
    if (high[d] - low[d] > high[axis] - low[axis]) axis = d;
  const Iterator middle = begin + (end - begin) / 2;
  // Ties by number: the same clusters on every platform.
  sortStably(begin, end, [&](std::uint32_t a, std::uint32_t b) {
    return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
  });
  split(points, begin, middle, base, ends);
  split(points, middle, end, base, ends);
}

FurCluster describe(const Surface& surface, const std::vector<std::uint32_t>& order, std::size_t begin, std::size_t end) {
  Vec3 low(1e9f), high(-1e9f), sum(0.0f);
  for (std::size_t i = begin; i < end; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = surface.vertices[surface.indices[3 * order[i] + k]].position;
      low = glm::min(low, p), high = glm::max(high, p);
    }
    sum += faceNormal(surface, order[i]);
  }
  FurCluster cluster;
  cluster.centre = 0.5f * (low + high);
  cluster.axis = normalizeOr(sum, Vec3(0, 1, 0));
  for (std::size_t i = begin; i < end; ++i) {
    cluster.cosine = std::min(cluster.cosine, glm::dot(cluster.axis, faceNormal(surface, order[i])));
    for (std::size_t k = 0; k < 3; ++k) {
      const SurfaceVertex& v = surface.vertices[surface.indices[3 * order[i] + k]];
      cluster.cosine = std::min(cluster.cosine, glm::dot(cluster.axis, v.normal));
      cluster.radius = std::max(cluster.radius, glm::length(v.position - cluster.centre));
    }
  }
  return cluster;
}

}  // namespace

std::vector<FurCluster> makeFurClusters(Surface& surface, const std::vector<std::uint32_t>& triangleOf,
                                        const std::vector<std::uint32_t>& chartOf) {
  const std::vector<Point> points = trianglePoints(surface);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<std::size_t> ends;
  split(points, order.begin(), order.end(), order.begin(), ends);

  std::vector<std::uint32_t> clusterOf(points.size());
  std::vector<FurCluster> clusters;
  for (std::size_t c = 0, begin = 0; c < ends.size(); begin = ends[c++]) {
    for (std::size_t i = begin; i < ends[c]; ++i) clusterOf[order[i]] = static_cast<std::uint32_t>(c);
    clusters.push_back(describe(surface, order, begin, ends[c]));
  }

  std::vector<std::uint32_t> drawn(triangleOf.size());
  std::iota(drawn.begin(), drawn.end(), 0u);
  sortStably(drawn.begin(), drawn.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t t) {
      const bool copy = surface.furIndices[3 * t] >= surface.trueVertexCount;
      return std::tuple(clusterOf[triangleOf[t]], copy, copy ? ~chartOf[t] : 0u);
    };
    return key(a) < key(b);
  });
  std::vector<std::uint32_t> indices;
  indices.reserve(surface.furIndices.size());
  for (const std::uint32_t t : drawn) {
    FurCluster& cluster = clusters[clusterOf[triangleOf[t]]];
    if (cluster.count == 0) cluster.first = static_cast<std::uint32_t>(indices.size());
    cluster.count += 3;
    for (std::size_t k = 0; k < 3; ++k) indices.push_back(surface.furIndices[3 * t + k]);
  }
  surface.furIndices = std::move(indices);

  std::vector<std::uint32_t> own;
  own.reserve(surface.indices.size());
  for (const std::uint32_t t : order) {
    FurCluster& cluster = clusters[clusterOf[t]];
    if (cluster.ownCount == 0) cluster.ownFirst = static_cast<std::uint32_t>(own.size());
    cluster.ownCount += 3;
    for (std::size_t k = 0; k < 3; ++k) own.push_back(surface.indices[3 * t + k]);
  }
  surface.ownFurIndices = std::move(own);
  return clusters;
}

namespace {

// How many of all[first, first + count) come next in `left`, from `at` on, which moves on.
std::uint32_t countLeft(const std::vector<std::uint32_t>& all, std::uint32_t first, std::uint32_t count,
                        const std::vector<std::uint32_t>& left, std::size_t& at) {
  const std::size_t begin = at;
  for (std::uint32_t i = first; i < first + count && at + 2 < left.size(); i += 3)
    if (std::equal(all.begin() + i, all.begin() + i + 3, left.begin() + static_cast<std::ptrdiff_t>(at))) at += 3;
  return static_cast<std::uint32_t>(at - begin);
}

}  // namespace

FurPatches remainingPatches(const Surface& surface, std::vector<std::uint32_t> indices, std::vector<std::uint32_t> ownIndices) {
  FurPatches patches{std::move(indices), std::move(ownIndices), {}};
  std::size_t at = 0, ownAt = 0;
  for (FurCluster cluster : surface.furClusters) {
    const auto first = static_cast<std::uint32_t>(at), ownFirst = static_cast<std::uint32_t>(ownAt);
    cluster.count = countLeft(surface.furIndices, cluster.first, cluster.count, patches.indices, at);
    cluster.ownCount = countLeft(surface.ownFurIndices, cluster.ownFirst, cluster.ownCount, patches.ownIndices, ownAt);
    cluster.first = first, cluster.ownFirst = ownFirst;
    if (cluster.count > 0 || cluster.ownCount > 0) patches.clusters.push_back(cluster);
  }
  return patches;
}

std::vector<std::uint32_t> clustersNearToFar(const std::vector<FurCluster>& clusters, const Vec3& eye, float reach) {
  // Bent fur may turn towards the eye a little more than its skin.
  constexpr float kSlack = 0.3f;
  std::vector<std::pair<float, std::uint32_t>> seen;
  seen.reserve(clusters.size());
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const FurCluster& c = clusters[i];
    const Vec3 toEye = eye - c.centre;
    const float distance = glm::length(toEye);
    const float sine = c.cosine > 0.0f ? std::sqrt(std::max(0.0f, 1.0f - c.cosine * c.cosine)) : 1.0f;
    const bool away = glm::dot(toEye, c.axis) < -distance * std::min(sine + kSlack, 1.0f) - c.radius - reach;
    if (!away) seen.emplace_back(distance, static_cast<std::uint32_t>(i));
  }
  sortStably(seen.begin(), seen.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  });
  std::vector<std::uint32_t> order(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) order[i] = seen[i].second;
  return order;
}

}  // namespace fur::geometry
