#include "render/MovingSurface.h"

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

MovingSurface::MovingSurface(std::vector<SkinVertex> vertices, std::span<const Vec3> tangents, std::span<const FinEdge> edges)
    : vertices_(std::move(vertices)) {
  gradients_.reserve(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const SkinVertex& v = vertices_[i];
    const Vec3 aside = glm::cross(Vec3(v.normal), tangents[i]), s(v.gradS);
    gradients_.emplace_back(glm::dot(s, tangents[i]), glm::dot(s, aside), glm::dot(v.gradT, tangents[i]), glm::dot(v.gradT, aside));
  }
  faceNormals_.reserve(edges.size());
  for (const FinEdge& e : edges) {
    const EdgeAxes axes(e.positionA, e.positionB, Vec3(e.normalA + e.normalB));
    const Vec3 first(e.face0), second(e.face1);
    faceNormals_.emplace_back(glm::dot(first, axes.up), glm::dot(first, axes.side), glm::dot(second, axes.up), glm::dot(second, axes.side));
  }
}

void MovingSurface::follow(const Skin& skin, std::vector<FinEdge>& edges) {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vec3 &p = skin.positions[i], &n = skin.normals[i], &t = skin.tangents[i], aside = glm::cross(n, t);
    const Vec4& g = gradients_[i];
    SkinVertex& v = vertices_[i];
    v.position = Vec4(p, v.position.w);
    v.normal = Vec4(n, v.normal.w);
    v.gradS = Vec4(t * g.x + aside * g.y, v.gradS.w);
    v.gradT = t * g.z + aside * g.w;
  }
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
