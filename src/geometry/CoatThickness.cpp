#include "geometry/CoatThickness.h"

#include <algorithm>
#include <cmath>

#include "geometry/Curvature.h"

namespace fur::geometry {

float coatThickness(const SurfaceVertex& vertex, float furLength) {
  const Vec3& S = vertex.curvature;
  const float apart = 0.5f * (S.x - S.z), hollow = std::sqrt(apart * apart + S.y * S.y) - 0.5f * (S.x + S.z);
  return std::min(furLength, 0.65f / std::max(hollow, 1e-6f));
}

namespace {

constexpr int kWays = 6;
constexpr float kDeep = 0.66f;  // fur lengths that a ray is over the skin at most

// Calls visit(point) for points so many fur lengths on along rays all ways that graze the coat at a vertex.
template <class Visit>
void forGrazingRays(const SurfaceVertex& vertex, float furLength, float on, Visit visit) {
  Vec3 s, t;
  tangentAxes(vertex, s, t);
  const Vec3 outside = vertex.position + coatThickness(vertex, furLength) * vertex.normal;
  for (int way = 0; way < kWays; ++way) {
    const float turn = 2 * kPi * static_cast<float>(way) / kWays, u = std::cos(turn), v = std::sin(turn);
    // Into a hollow it is known to go.
    const bool hollow = vertex.curvature.x * u * u + 2 * vertex.curvature.y * u * v + vertex.curvature.z * v * v < 0;
    visit(outside + on * furLength * (u * s + v * t), hollow);
  }
}

// Of one vertex in so many, about `asked` in all.
std::size_t oneIn(const Surface& surface, std::size_t asked) { return std::max<std::size_t>(surface.vertices.size() / asked, 1); }

}  // namespace

float grazingShare(const Surface& surface, const SurfaceQuery& query, float furLength) {
  constexpr std::size_t kAsked = 200;
  constexpr float kOn = 2.0f;  // fur lengths that it has gone on
  int asked = 0, deep = 0;
  for (std::size_t i = 0; i < surface.vertices.size(); i += oneIn(surface, kAsked))
    forGrazingRays(surface.vertices[i], furLength, kOn, [&](const Vec3& point, bool hollow) {
      ++asked;
      deep += !hollow && query.isNear(point, kDeep * furLength);
    });
  return static_cast<float>(deep) / static_cast<float>(std::max(asked, 1));
}

CrowdedSearch::CrowdedSearch(const Surface& surface, const SurfaceQuery& query, float furLength)
    : surface_(&surface), query_(&query), furLength_(furLength), crowded_(surface.vertices.size()) {}

bool CrowdedSearch::step() {
  constexpr std::size_t kAsked = 2000, kAskedAStep = 100;
  constexpr float kInCoat = 0.8f;
  for (std::size_t i = 0; i < kAskedAStep && vertex_ < crowded_.size(); ++i, vertex_ += oneIn(*surface_, kAsked))
    for (const float on : {2.0f, 4.0f})
      forGrazingRays(surface_->vertices[vertex_], furLength_, on, [&](const Vec3& point, bool hollow) {
        if (hollow) return;
        for (const std::uint32_t triangle : query_->trianglesWithin(point, kInCoat * furLength_))
          for (std::size_t k = 0; k < 3; ++k) crowded_[surface_->indices[3 * triangle + k]] = 1;
      });
  return vertex_ >= crowded_.size();
}

}  // namespace fur::geometry
