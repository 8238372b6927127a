#include "render/MovingVertices.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fur::render {

namespace {

std::vector<Vec3> positionsOf(std::span<const SkinVertex> vertices) {
  std::vector<Vec3> positions;
  positions.reserve(vertices.size());
  for (const SkinVertex& v : vertices) positions.emplace_back(v.position);
  return positions;
}

Vec3 curvatureOf(const SkinVertex& v) { return {v.position.w, v.normal.w, v.gradS.w}; }

// Along the vertex's axes, as shell_skin.glsl has them.
Vec3 curvatureAt(const geometry::MovingCurvature& curvature, std::size_t vertex, const SkinVertex& v) {
  const Vec3 s = normalizeOr(Vec3(v.gradS), Vec3(1, 0, 0));
  return curvature.along(static_cast<std::uint32_t>(vertex), s, glm::cross(Vec3(v.normal), s));
}

// What of a change bends the skin outwards: its principal parts that are above 0.
Vec3 outwards(const Vec3& change) {
  const float mean = 0.5f * (change.x + change.z), aside = 0.5f * (change.x - change.z), half = std::sqrt(aside * aside + change.y * change.y);
  const float high = std::max(mean + half, 0.0f), low = std::max(mean - half, 0.0f), share = 0.5f * (high - low) / std::max(half, 1e-6f);
  return Vec3(1, 0, 1) * (0.5f * (high + low)) + share * Vec3(aside, change.y, -aside);
}

}  // namespace

MovingVertices::MovingVertices(std::vector<SkinVertex> vertices, std::span<const Vec3> tangents, std::span<const std::uint32_t> triangles)
    : vertices_(std::move(vertices)), curvature_(triangles, positionsOf(vertices_)) {
  std::vector<Vec3> normals;
  gradients_.reserve(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const SkinVertex& v = vertices_[i];
    const Vec3 aside = glm::cross(Vec3(v.normal), tangents[i]), s(v.gradS);
    gradients_.emplace_back(glm::dot(s, tangents[i]), glm::dot(s, aside), glm::dot(v.gradT, tangents[i]), glm::dot(v.gradT, aside));
    normals.emplace_back(v.normal);
  }
  curvature_.update(positionsOf(vertices_), normals);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    first_.push_back(curvatureOf(vertices_[i]));
    firstMoving_.push_back(curvatureAt(curvature_, i, vertices_[i]));
  }
}

void MovingVertices::follow(const Skin& skin) {
  curvature_.update(skin.positions, skin.normals);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vec3 &p = skin.positions[i], &n = skin.normals[i], &t = skin.tangents[i], aside = glm::cross(n, t);
    const Vec4& g = gradients_[i];
    SkinVertex& v = vertices_[i];
    v.normal = Vec4(n, 0);
    v.gradS = Vec4(t * g.x + aside * g.y, 0);
    const Vec3 curvature = first_[i] + outwards(curvatureAt(curvature_, i, v) - firstMoving_[i]);
    v.position = Vec4(p, curvature.x);
    v.normal.w = curvature.y;
    v.gradS.w = curvature.z;
    v.gradT = t * g.z + aside * g.w;
  }
}

}  // namespace fur::render
