#include "geometry/FurDirections.h"

#include <algorithm>
#include <cmath>

#include "core/Numbering.h"
#include "geometry/Adjacency.h"
#include "geometry/Weld.h"

namespace fur::geometry {

namespace {

constexpr int kDirectionRounds = 12;
// Of the way to the neighbours' mean, in turns: towards it and, a little further, away from it.
constexpr float kTowardsMean = 0.6f, kAwayFromMean = -0.63f;
// The cosine between neighbours from which on they count for nothing: 26 degrees.
constexpr float kAgrees = 0.9f;
constexpr float kMostCotangent = 4;  // of slivers
constexpr std::uint8_t kStays = 1, kLeans = 3;

float cotangentAt(const Vec3& corner, const Vec3& a, const Vec3& b) {
  const Vec3 to = a - corner, way = b - corner, across = glm::cross(to, way);
  return std::clamp(glm::dot(to, way) / std::sqrt(glm::dot(across, across)), 0.0f, kMostCotangent);
}

}  // namespace

FurDirections::FurDirections(const Mesh& mesh, const std::vector<Vec3>& upright)
    : pointOf_(mesh.normals.size()), sides_(mesh.indices.size()), normals_(mesh.normals.size()), stays_(mesh.normals.size()) {
  const Weld places = weldPositions(mesh.positions), ways = weldPositions(mesh.normals);
  Numbering points;
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const std::uint32_t point = pointOf_[i] = points.of(std::uint64_t{places.idOf[i]} << 32 | ways.idOf[i]);
    normals_[point] = mesh.normals[i];
    if (!upright.empty() && upright[i] != mesh.normals[i]) stays_[point] = kLeans;
  }
  const auto across = neighboursAcrossSides(sortedSides(mesh.indices, places), mesh.triangleCount());
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1, last = i % 3 == 0 ? i + 2 : i - 1;
    const std::uint32_t a = pointOf_[mesh.indices[i]], b = pointOf_[mesh.indices[next]];
    sides_[i] = {a, b, cotangentAt(mesh.positions[mesh.indices[last]], mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[next]])};
    if (across[i] == kNoTriangle || stays_[a] == kLeans || stays_[b] == kLeans) stays_[a] |= kStays, stays_[b] |= kStays;
  }
}

bool FurDirections::step() {
  std::vector<Vec4> sums(normals_.size(), Vec4(0));  // of weighted ways, and of weights
  for (const Side& side : sides_) {
    const Vec3 &a = normals_[side.a], &b = normals_[side.b];
    const float agreement = std::max(glm::dot(a, b) - kAgrees, 0.0f) / (1 - kAgrees);
    const Vec3 way = (b - a) * (side.weight * agreement);
    sums[side.a] += Vec4(way, side.weight);
    sums[side.b] += Vec4(-way, side.weight);
  }
  const float share = round_ % 2 == 0 ? kTowardsMean : kAwayFromMean;
  for (std::size_t i = 0; i < normals_.size(); ++i)
    if (sums[i].w > 0.0f && !stays_[i]) normals_[i] = normalizeOr(normals_[i] + Vec3(sums[i]) * (share / sums[i].w), normals_[i]);
  return ++round_ == kDirectionRounds;
}

std::vector<Vec3> FurDirections::directions() const {
  std::vector<Vec3> out(pointOf_.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = normals_[pointOf_[i]];
  return out;
}

}  // namespace fur::geometry
