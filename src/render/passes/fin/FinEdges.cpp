#include "render/passes/fin/FinEdges.h"

#include "geometry/Curvature.h"

namespace fur::render {

namespace {

// From this angle between its two faces on an edge is sharp.
constexpr float kSharpCosine = 0.77f;
constexpr float kLeaningCosine = 0.9f;

float curvatureAcross(const geometry::SurfaceEdge& e, const geometry::SurfaceVertex& a, const geometry::SurfaceVertex& b, bool turned) {
  // Where fur leans over the edge it curves as much as the fur does, however sharp the skin is.
  const bool leans = turned && glm::dot(e.faceNormal0, a.normal) < kLeaningCosine;
  if (glm::dot(e.faceNormal0, e.faceNormal1) < kSharpCosine && !leans) return -1.0f;
  if (e.betweenFacets && !leans) return 0.0f;
  float sum = 0.0f;
  for (const auto* v : {&a, &b}) {
    Vec3 s, t;
    geometry::tangentAxes(*v, s, t);
    const Vec3 across = normalizeOr(glm::cross(v->normal, b.position - a.position), s);
    const Vec2 d(glm::dot(s, across), glm::dot(t, across));
    sum += 0.5f * (v->curvature.x * d.x * d.x + 2.0f * v->curvature.y * d.x * d.y + v->curvature.z * d.y * d.y);
  }
  return sum;
}

}  // namespace

std::vector<FinEdge> finEdges(const geometry::Surface& surface) {
  std::vector<FinEdge> out;
  out.reserve(surface.edges.size());
  for (const auto& e : surface.edges) {
    const auto& a = surface.vertices[e.a];
    const auto& b = surface.vertices[e.b];
    const Vec2 uv = 0.5f * (a.uv + b.uv);
    out.push_back({Vec4(a.position, static_cast<float>(e.a)), Vec4(b.position, static_cast<float>(e.b)),
                   Vec4(a.normal, e.finStart), Vec4(b.normal, curvatureAcross(e, a, b, surface.turned)), Vec4(e.faceNormal0, uv.x), Vec4(e.faceNormal1, uv.y),
                   Vec4(a.atlas, b.atlas), Vec2(a.room, b.room)});
  }
  return out;
}

}  // namespace fur::render
