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
// The cosine between neighbours from which on they count for nothing: 32 degrees.
constexpr float kAgrees = 0.85f;
constexpr float kMostCotangent = 4;  // of slivers

float cotangentAt(const Vec3& corner, const Vec3& a, const Vec3& b) {
  const Vec3 to = a - corner, way = b - corner, across = glm::cross(to, way);
  return std::clamp(glm::dot(to, way) / std::sqrt(glm::dot(across, across)), 0.0f, kMostCotangent);
}

}  // namespace

FurDirections::FurDirections(const Mesh& mesh, const std::vector<Vec3>& upright) {
  const Weld places = weldPositions(mesh.positions), ways = weldPositions(mesh.normals);
  Numbering points;
  std::vector<bool> leans;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    pointOf_.push_back(points.of(std::uint64_t{places.idOf[i]} << 32 | ways.idOf[i]));
    if (pointOf_.back() == normals_.size()) normals_.push_back(mesh.normals[i]), leans.push_back(false);
    if (!upright.empty() && upright[i] != mesh.normals[i]) leans[pointOf_.back()] = true;
  }
  stays_ = leans;
  const auto across = neighboursAcrossSides(sortedSides(mesh.indices, places), mesh.triangleCount());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t first = i - i % 3;
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[first + (i + 1) % 3], c = mesh.indices[first + (i + 2) % 3];
    sides_.push_back({pointOf_[a], pointOf_[b], cotangentAt(mesh.positions[c], mesh.positions[a], mesh.positions[b])});
    if (across[i] == kNoTriangle || leans[pointOf_[a]] || leans[pointOf_[b]]) stays_[pointOf_[a]] = stays_[pointOf_[b]] = true;
  }
}

bool FurDirections::step() {
  std::vector<Vec3> ways(normals_.size(), Vec3(0));
  std::vector<float> weights(normals_.size(), 0.0f);
  for (const Side& side : sides_) {
    const Vec3 &a = normals_[side.a], &b = normals_[side.b];
    const float weight = side.weight * std::max(glm::dot(a, b) - kAgrees, 0.0f);
    const Vec3 way = (b - a) * weight;
    ways[side.a] += way, ways[side.b] -= way;
    weights[side.a] += weight, weights[side.b] += weight;
  }
  const float share = round_ % 2 == 0 ? kTowardsMean : kAwayFromMean;
  for (std::size_t i = 0; i < normals_.size(); ++i)
    if (weights[i] > 0.0f && !stays_[i]) normals_[i] = normalizeOr(normals_[i] + ways[i] * (share / weights[i]), normals_[i]);
  return ++round_ == kDirectionRounds;
}

std::vector<Vec3> FurDirections::take() {
  std::vector<Vec3> out;
  out.reserve(pointOf_.size());
  for (const std::uint32_t point : pointOf_) out.push_back(normals_[point]);
  return out;
}

}  // namespace fur::geometry
