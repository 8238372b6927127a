#include "groom/GroomBrush.h"

#include <algorithm>
#include <cmath>

#include "core/Sort.h"

namespace fur::groom {

namespace {

// Below half a step of 8 bits a dab leaves no trace; from there on it makes one step at least, so that soft
// passes add up to all of it.
constexpr float kLeastWeight = 0.5f / 255.0f;

// Less of a lean nobody sees: upright, not ever nearer to it.
constexpr float kUpright = 1e-3f;  // radians

// Nearer to a pole of the direction than this (its sine) the fur stands up, instead of whirling.
constexpr float kPole = 0.35f;

bool usable(const Brush& brush) {
  const Vec3 sum = brush.centre + brush.normal;
  return std::isfinite(sum.x + sum.y + sum.z + brush.strength) && std::isfinite(brush.radius) && brush.radius > 0.0f;
}

float weightOf(const Brush& brush, const Vec3& at) {
  const Vec3 way = at - brush.centre;
  const float left = 1.0f - glm::dot(way, way) / (brush.radius * brush.radius);
  return left > 0.0f ? saturate(brush.strength) * left * left : 0.0f;
}

std::uint8_t towards(std::uint8_t from, int to, float weight) {
  const float step = static_cast<float>(to - from) * weight;
  return static_cast<std::uint8_t>(from + static_cast<int>(step < 0.0f ? std::floor(step) : std::ceil(step)));
}

std::vector<std::uint32_t> trianglesUnder(const Ground& ground, const Brush& brush) {
  return usable(brush) ? ground.query.trianglesWithin(brush.centre, brush.radius) : std::vector<std::uint32_t>();
}

// What a brush of the weight w makes of a texel. No template: the code of a dab is there once.
using TexelChange = GroomMap::Texel (*)(GroomMap::Texel texel, float weight, std::size_t channel);

bool dabTexels(Groom& groom, const Ground& ground, const Brush& brush, TexelChange change, std::size_t channel = 0) {
  geometry::TexelRect changed;
  const int size = groom.map.size();
  for (const std::uint32_t t : trianglesUnder(ground, brush))
    ground.atlas.forTexelsOf(ground.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const geometry::SurfacePoint point{t, weights, 0.0f};
      const float weight = weightOf(brush, positionAt(ground.surface, point));
      if (weight < kLeastWeight || glm::dot(normalAt(ground.surface, point), brush.normal) <= 0.0f) return;
      const GroomMap::Texel before = groom.map.texels()[texel];
      groom.map.set(texel, change(before, weight, channel));
      if (groom.map.texels()[texel] != before)
        changed.include(static_cast<int>(texel) % size, static_cast<int>(texel) / size);
    });
  if (!changed.empty()) groom.map.fillGutter(ground.atlas, changed);
  return !changed.empty();
}

std::uint32_t pointOf(const Ground& ground, std::uint32_t triangle, std::size_t k) {
  return ground.points.pointOf[ground.surface.indices[std::size_t{3} * triangle + k]];
}

// Ascending, each once.
std::vector<std::uint32_t> pointsOf(const Ground& ground, const std::vector<std::uint32_t>& triangles) {
  std::vector<std::uint32_t> points;
  for (const std::uint32_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) points.push_back(pointOf(ground, t, k));
  sortStably(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// goals[i] is where the comb of points[i] is drawn to.
bool dabPoints(Groom& groom, const Ground& ground, const Brush& brush, const std::vector<std::uint32_t>& points,
               const std::vector<Vec3>& goals) {
  bool changed = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec3& comb = groom.comb[points[i]];
    const float weight = weightOf(brush, ground.points.positions[points[i]]);
    if (weight <= 0.0f || glm::dot(ground.points.normals[points[i]], brush.normal) <= 0.0f) continue;
    const Vec3 before = comb;
    comb += (goals[i] - comb) * weight;
    if (glm::dot(comb, comb) < kUpright * kUpright) comb = Vec3(0);
    changed = changed || comb != before;
  }
  return changed;
}

}  // namespace

bool trim(Groom& groom, const Ground& ground, const Brush& brush) {
  return dabTexels(groom, ground, brush, [](GroomMap::Texel texel, float weight, std::size_t) {
    texel[0] = towards(texel[0], 0, weight);
    return texel;
  });
}

bool grow(Groom& groom, const Ground& ground, const Brush& brush) {
  return dabTexels(groom, ground, brush, [](GroomMap::Texel texel, float weight, std::size_t) {
    texel[0] = towards(texel[0], 255, weight);
    return texel;
  });
}

bool paintType(Groom& groom, const Ground& ground, const Brush& brush, int type) {
  const auto chosen = static_cast<std::size_t>(std::clamp(type, 1, kTypes)) - 1;
  const auto change = [](GroomMap::Texel texel, float weight, std::size_t channel) {
    int others = 0;
    for (std::size_t k = 1; k < kTypes; ++k)
      if (k != channel) others += texel[k] = towards(texel[k], 0, weight);
    // Not more than the others leave.
    const int grown = towards(texel[channel], 255, weight);
    if (channel > 0) texel[channel] = static_cast<std::uint8_t>(std::min(grown, 255 - others));
    return texel;
  };
  return dabTexels(groom, ground, brush, change, chosen);
}

Vec3 combedTo(const Vec3& direction, const Vec3& normal) {
  const Vec3 unit = normalizeOr(direction, Vec3(0));
  const Vec3 along = unit - normal * glm::dot(unit, normal);
  const float sine = std::sqrt(glm::dot(along, along));
  return normalizeOr(along, Vec3(0)) * (kMaxComb * std::min(sine / kPole, 1.0f));
}

bool comb(Groom& groom, const Ground& ground, const Brush& brush, const Vec3& direction) {
  const std::vector<std::uint32_t> points = pointsOf(ground, trianglesUnder(ground, brush));
  std::vector<Vec3> goals;
  for (const std::uint32_t point : points) {
    const Vec3 goal = combedTo(direction, ground.points.normals[point]);
    goals.push_back(goal == Vec3(0) ? groom.comb[point] : goal);
  }
  return dabPoints(groom, ground, brush, points, goals);
}

bool raise(Groom& groom, const Ground& ground, const Brush& brush) {
  const std::vector<std::uint32_t> points = pointsOf(ground, trianglesUnder(ground, brush));
  return dabPoints(groom, ground, brush, points, std::vector<Vec3>(points.size(), Vec3(0)));
}

bool smooth(Groom& groom, const Ground& ground, const Brush& brush) {
  const std::vector<std::uint32_t> triangles = trianglesUnder(ground, brush), points = pointsOf(ground, triangles);
  // Summed before anything changes: nothing depends on the order of the points.
  std::vector<Vec3> goals(points.size(), Vec3(0));
  std::vector<float> counts(points.size(), 0.0f);
  for (const std::uint32_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(
          std::lower_bound(points.begin(), points.end(), pointOf(ground, t, k)) - points.begin());
      goals[at] += groom.comb[pointOf(ground, t, (k + 1) % 3)] + groom.comb[pointOf(ground, t, (k + 2) % 3)];
      counts[at] += 2.0f;
    }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& normal = ground.points.normals[points[i]];
    goals[i] /= counts[i];
    goals[i] -= normal * glm::dot(goals[i], normal);
  }
  return dabPoints(groom, ground, brush, points, goals);
}

bool pluck(Groom& groom, const Brush& brush) {
  if (!usable(brush)) return false;
  const std::size_t before = groom.whiskers.size();
  std::size_t kept = 0;
  for (const Whisker& whisker : groom.whiskers) {
    const Vec3 way = whisker.root - brush.centre;
    // Those of the far side of an ear stay; one that lies flat may point away a little.
    const bool under = glm::dot(way, way) <= brush.radius * brush.radius && glm::dot(whisker.direction, brush.normal) > -0.5f;
    if (!under) groom.whiskers[kept++] = whisker;
  }
  groom.whiskers.resize(kept);
  return kept < before;
}

}  // namespace fur::groom
