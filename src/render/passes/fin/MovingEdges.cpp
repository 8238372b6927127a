#include "render/passes/fin/MovingEdges.h"

namespace fur::render {

namespace {

// Across an edge: where its two ends' skin faces, and to the side of that.
struct EdgeAxes {
  Vec3 up, side;
  EdgeAxes(const Vec3& a, const Vec3& b, const Vec3& normals) {
    const Vec3 along = normalizeOr(b - a, Vec3(0));
    up = normalizeOr(normals - along * glm::dot(normals, along), normals);
    side = glm::cross(along, up);
  }
};

}  // namespace

MovingEdges::MovingEdges(std::span<const FinEdge> edges) {
  faceNormals_.reserve(edges.size());
  for (const FinEdge& e : edges) {
    const EdgeAxes axes(e.positionA, e.positionB, Vec3(e.normalA + e.normalB));
    const Vec3 first(e.face0), second(e.face1);
    faceNormals_.emplace_back(glm::dot(first, axes.up), glm::dot(first, axes.side), glm::dot(second, axes.up), glm::dot(second, axes.side));
  }
}

void MovingEdges::follow(const Skin& skin, std::vector<FinEdge>& edges) const {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    FinEdge& e = edges[i];
    const auto a = static_cast<std::size_t>(e.positionA.w), b = static_cast<std::size_t>(e.positionB.w);
    const Vec3 &pa = skin.positions[a], &pb = skin.positions[b], &na = skin.normals[a], &nb = skin.normals[b];
    const EdgeAxes axes(pa, pb, na + nb);
    const Vec4& f = faceNormals_[i];
    e.positionA = Vec4(pa, e.positionA.w);
    e.positionB = Vec4(pb, e.positionB.w);
    e.normalA = Vec4(na, e.normalA.w);
    e.normalB = Vec4(nb, e.normalB.w);
    e.face0 = Vec4(axes.up * f.x + axes.side * f.y, e.face0.w);
    e.face1 = Vec4(axes.up * f.z + axes.side * f.w, e.face1.w);
  }
}

}  // namespace fur::render
