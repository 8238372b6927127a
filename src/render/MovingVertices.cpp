#include "render/MovingVertices.h"

#include <utility>

namespace fur::render {

MovingVertices::MovingVertices(std::vector<SkinVertex> vertices, std::span<const Vec3> tangents) : vertices_(std::move(vertices)) {
  gradients_.reserve(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const SkinVertex& v = vertices_[i];
    const Vec3 aside = glm::cross(Vec3(v.normal), tangents[i]), s(v.gradS);
    gradients_.emplace_back(glm::dot(s, tangents[i]), glm::dot(s, aside), glm::dot(v.gradT, tangents[i]), glm::dot(v.gradT, aside));
  }
}

void MovingVertices::follow(const Skin& skin) {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vec3 &p = skin.positions[i], &n = skin.normals[i], &t = skin.tangents[i], aside = glm::cross(n, t);
    const Vec4& g = gradients_[i];
    SkinVertex& v = vertices_[i];
    v.position = Vec4(p, v.position.w);
    v.normal = Vec4(n, v.normal.w);
    v.gradS = Vec4(t * g.x + aside * g.y, v.gradS.w);
    v.gradT = t * g.z + aside * g.w;
  }
}

}  // namespace fur::render
