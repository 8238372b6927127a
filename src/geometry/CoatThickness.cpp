#include "geometry/CoatThickness.h"

#include <algorithm>
#include <cmath>

#include "geometry/Curvature.h"

namespace fur::geometry {

namespace {

constexpr float kShareOfRadius = 0.65f;
constexpr float kRise = 0.6f;  // room for a unit of way from a crease: by 1 the outside of long coats was still folded
constexpr int kMostSweeps = 16;

// The longest fur as a share of the body's radius; any body may have fur of kAnyBody.
constexpr float kShareOfBody = 1.1f, kAnyBody = 0.12f;

// The largest curvature: of a round part (`side` 1) or of a crease (-1).
float mostCurved(const Vec3& S, float side) {
  const float apart = 0.5f * (S.x - S.z);
  return std::sqrt(apart * apart + S.y * S.y) + 0.5f * side * (S.x + S.z);
}

// Of the crease that the curvature has.
float roomOf(const Vec3& S) { return kShareOfRadius / std::max(mostCurved(S, -1), kShareOfRadius / kAnyThickness); }

// How long fur may be on a body whose radius half of the skin, by area, has at least. Found by halves among some triangles.
float roomOnBody(const Surface& surface, const std::vector<std::uint32_t>& triangles) {
  constexpr std::size_t kAsked = 2000;
  constexpr int kHalvings = 12;
  const std::size_t count = triangles.size() / 3, stride = std::max<std::size_t>(count / kAsked, 1);
  float low = 0, high = kShareOfBody / kAnyBody;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5f * (low + high);
    float rounder = 0;
    for (std::size_t t = 0; t < count; t += stride) {
      const SurfaceVertex &a = surface.vertices[triangles[3 * t]], &b = surface.vertices[triangles[3 * t + 1]], &c = surface.vertices[triangles[3 * t + 2]];
      const float area = glm::length(glm::cross(b.position - a.position, c.position - a.position));
      rounder += mostCurved(a.curvature, 1) > middle ? area : -area;
    }
    (rounder > 0 ? low : high) = middle;
  }
  return kShareOfBody / std::max(high, kShareOfBody / kAnyThickness);
}

// Strands at its ends meet at that height.
float roomOf(const SurfaceVertex& a, const SurfaceVertex& b) {
  const Vec3 edge = b.position - a.position;
  const float together = -glm::dot(edge, b.normal - a.normal), squared = glm::dot(edge, edge);
  return together * kAnyThickness > kShareOfRadius * squared ? kShareOfRadius * squared / together : kAnyThickness;
}

}  // namespace

void measureRoom(Surface& surface, const std::vector<std::uint32_t>& triangles, const Weld& weld) {
  std::vector<float> rooms(weld.count, roomOnBody(surface, triangles));
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) rooms[weld.idOf[i]] = std::min(rooms[weld.idOf[i]], roomOf(surface.vertices[i].curvature));
  const auto forEdges = [&](std::size_t triangle, auto visit) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[3 * triangle + k], b = triangles[3 * triangle + (k + 1) % 3];
      visit(surface.vertices[a], surface.vertices[b], rooms[weld.idOf[a]], rooms[weld.idOf[b]]);
    }
  };
  const std::size_t count = triangles.size() / 3;
  for (std::size_t t = 0; t < count; ++t)
    forEdges(t, [](const SurfaceVertex& a, const SurfaceVertex& b, float& ofA, float& ofB) {
      const float room = roomOf(a, b);
      ofA = std::min(ofA, room);
      ofB = std::min(ofB, room);
    });
  // Forwards and backwards, as most meshes are written piece by piece.
  bool changes = true;
  for (int sweep = 0; sweep < kMostSweeps && changes; ++sweep) {
    changes = false;
    for (std::size_t t = 0; t < count; ++t)
      forEdges(sweep % 2 ? count - 1 - t : t, [&](const SurfaceVertex& a, const SurfaceVertex& b, float& ofA, float& ofB) {
        const float way = glm::distance(a.position, b.position);
        if (std::abs(ofA - ofB) <= kRise * way) return;
        (ofA > ofB ? ofA : ofB) = std::min(ofA, ofB) + kRise * way;
        changes = true;
      });
  }
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) surface.vertices[i].room = rooms[weld.idOf[i]];
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
