#include "scene/BoneBodies.h"

#include <algorithm>
#include <cmath>

#include "core/Sort.h"
#include "scene/Pose.h"

namespace fur::scene {

namespace {

constexpr std::size_t kFewVertices = 8;  // are a tooth or an eye: no shape for them
constexpr float kEnds = 0.04f;           // of the vertices, beyond each end
constexpr float kLeastRadius = 0.01f;    // model units

// The mesh's vertices by the node that holds them most.
std::vector<std::vector<Vec3>> heldBy(const Rig& rig, std::span<const Vec3> positions) {
  std::vector<std::vector<Vec3>> held(rig.nodes.size());
  for (const Rig::Part& part : rig.parts)
    for (std::size_t i = part.firstVertex; i < std::size_t{part.firstVertex} + part.vertices; ++i) {
      std::size_t node = part.node;
      if (part.skin >= 0) {
        int most = 0;
        for (int k = 1; k < 4; ++k)
          if (rig.weights[i][k] > rig.weights[i][most]) most = k;
        node = rig.skins[static_cast<std::size_t>(part.skin)].joints[rig.joints[i][static_cast<std::size_t>(most)]];
      }
      held[node].push_back(positions[i]);
    }
  return held;
}

// Of the numbers, the one that this share of them lies below.
float percentile(std::vector<float>& numbers, float share) {
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(share * static_cast<float>(numbers.size() - 1) + 0.5f);
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at;
}

// The way in which points lie farthest apart, by powers of their covariance.
Vec3 longestWay(std::span<const Vec3> points, const Vec3& middle) {
  Mat3 covariance(0);
  for (const Vec3& p : points) covariance += glm::outerProduct(p - middle, p - middle);
  Vec3 way = normalizeOr(Vec3(covariance[0][0], covariance[1][1], covariance[2][2]), Vec3(0, 1, 0));
  for (int i = 0; i < 32; ++i) way = normalizeOr(covariance * way, way);
  return way;
}

hair::Body capsuleRound(std::span<const Vec3> points, const Vec3& along) {
  Vec3 middle(0);
  for (const Vec3& p : points) middle += p / static_cast<float>(points.size());
  const Vec3 axis = normalizeOr(along, longestWay(points, middle));
  std::vector<float> heights, distances;
  for (const Vec3& p : points) {
    heights.push_back(glm::dot(p - middle, axis));
    distances.push_back(glm::length(p - middle - axis * heights.back()));
  }
  const float radius = std::max(percentile(distances, 0.5f), kLeastRadius);
  float low = percentile(heights, kEnds) + radius, high = percentile(heights, 1 - kEnds) - radius;
  if (low > high) low = high = 0.5f * (low + high);
  return {middle + axis * low, middle + axis * high, radius};
}

float volumeOf(const hair::Body& body) { return body.radius * body.radius * (glm::length(body.b - body.a) + body.radius); }

}  // namespace

std::vector<hair::Body> fitBodies(const Rig& rig) {
  const Pose rest(rig);
  const std::vector<std::vector<Vec3>> held = heldBy(rig, rest.positions());
  // From each node on to the middle of those that follow it and hold something.
  std::vector<Vec3> onward(rig.nodes.size(), Vec3(0));
  for (std::size_t node = 0; node < held.size(); ++node)
    if (const int parent = rig.nodes[node].parent; parent >= 0 && !held[node].empty())
      onward[static_cast<std::size_t>(parent)] += Vec3(rest.transform(node)[3] - rest.transform(static_cast<std::size_t>(parent))[3]);
  std::vector<hair::Body> bodies;
  for (std::size_t node = 0; node < held.size(); ++node) {
    if (held[node].size() < kFewVertices) continue;
    hair::Body body = capsuleRound(held[node], onward[node]);
    body.bone = static_cast<std::int32_t>(node);
    const Vec3 sum = body.a + body.b;
    if (std::isfinite(sum.x + sum.y + sum.z + body.radius)) bodies.push_back(body);
  }
  sortStably(bodies.begin(), bodies.end(), [](const hair::Body& a, const hair::Body& b) { return volumeOf(a) > volumeOf(b); });
  if (bodies.size() > hair::kMostBodies) bodies.resize(hair::kMostBodies);
  return bodies;
}

}  // namespace fur::scene
