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

float grazingShare(const Surface& surface, const SurfaceQuery& query, float furLength) {
  constexpr std::size_t kAsked = 200;
  constexpr int kWays = 6;
  constexpr float kOn = 2.0f, kDeep = 0.66f;  // fur lengths that it has gone on; that it is over the skin there at most
  const std::size_t step = std::max<std::size_t>(surface.vertices.size() / kAsked, 1);
  int asked = 0, deep = 0;
  for (std::size_t i = 0; i < surface.vertices.size(); i += step) {
    const SurfaceVertex& vertex = surface.vertices[i];
    Vec3 s, t;
    tangentAxes(vertex, s, t);
    const Vec3 outside = vertex.position + coatThickness(vertex, furLength) * vertex.normal;
    for (int way = 0; way < kWays; ++way) {
      const float turn = 2 * kPi * static_cast<float>(way) / kWays, u = std::cos(turn), v = std::sin(turn);
      ++asked;
      // Into a hollow it is known to go.
      if (vertex.curvature.x * u * u + 2 * vertex.curvature.y * u * v + vertex.curvature.z * v * v < 0) continue;
      deep += !query.trianglesWithin(outside + kOn * furLength * (u * s + v * t), kDeep * furLength).empty();
    }
  }
  return static_cast<float>(deep) / static_cast<float>(std::max(asked, 1));
}

}  // namespace fur::geometry
