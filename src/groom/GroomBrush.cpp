#include "groom/GroomBrush.h"

#include <algorithm>
#include <cmath>

#include "core/Sort.h"

namespace fur::groom {

namespace {

// Below half a step of 8 bits a dab leaves no trace; from there on it makes one step at least, so that soft
// passes add up to all of it.
constexpr float kLeastWeight = 0.5f / 255.0f;

// So far round what is painted its colour goes on, as none of it: filtered look-ups meet no other one.
constexpr float kRim = 0.04f;

// Nearer to a pole of the direction than this (its sine) the fur stands up, instead of whirling.
constexpr float kPole = 0.35f;

bool usable(const Brush& brush) {
  const Vec3 sum = brush.centre + brush.normal;
  return std::isfinite(sum.x + sum.y + sum.z + brush.strength) && std::isfinite(brush.radius) && brush.radius > 0.0f;
}

std::uint8_t towards(std::uint8_t from, int to, float weight) {
  const float step = static_cast<float>(to - from) * weight;
  return static_cast<std::uint8_t>(from + static_cast<int>(step < 0.0f ? std::floor(step) : std::ceil(step)));
}

// Of Groom::shape: its last channel is the greatest of the others.
GroomMap::Texel shapedTexel(GroomMap::Texel texel, std::size_t channel, std::uint8_t value) {
  texel[channel] = value;
  texel[3] = std::max({texel[0], texel[1], texel[2]});
  return texel;
}

std::vector<std::uint32_t> trianglesUnder(const GroomSurface& skin, const Brush& brush) {
  return usable(brush) ? skin.query.trianglesWithin(brush.centre, brush.radius) : std::vector<std::uint32_t>();
}

// What a brush of the weight w makes of a texel; `given` is the brush's own. No template: the code of a dab is there once.
using TexelChange = GroomMap::Texel (*)(GroomMap::Texel texel, float weight, std::uint32_t given);

// `mask`: what it protects stays; `rim`: so far round it `change` is called with the weight 0 where the last channel is 0.
bool dabMap(GroomMap& map, const GroomMap* mask, float rim, const GroomSurface& skin, const Brush& brush, TexelChange change, std::uint32_t given) {
  if (!usable(brush)) return false;
  geometry::TexelRect changed;
  const int size = map.size();
  Brush reach = brush;
  reach.radius += rim;
  for (const std::uint32_t t : trianglesUnder(skin, reach))
    skin.atlas.forTexelsOf(skin.surface, t, [&](std::uint32_t texel, const Vec3& weights) {
      const geometry::SurfacePoint point{t, weights, 0.0f};
      float weight = weightOf(brush, positionAt(skin.surface, point));
      if (mask) weight *= static_cast<float>(255 - mask->texels()[texel][3]) / 255.0f;
      const bool inRim = rim > 0 && map.texels()[texel][3] == 0 && weightOf(reach, positionAt(skin.surface, point)) > 0;
      if ((weight < kLeastWeight && !inRim) || glm::dot(normalAt(skin.surface, point), brush.normal) <= 0.0f) return;
      const GroomMap::Texel before = map.texels()[texel];
      map.set(texel, change(before, weight, given));
      if (map.texels()[texel] != before) changed.include(static_cast<int>(texel) % size, static_cast<int>(texel) / size);
    });
  if (!changed.empty()) map.fillGutter(skin.atlas, changed);
  return !changed.empty();
}

bool dabTexels(Groom& groom, const GroomSurface& skin, const Brush& brush, TexelChange change, std::uint32_t given = 0,
               GroomMap Groom::*painted = &Groom::map) {
  return dabMap(groom.*painted, painted == &Groom::mask ? nullptr : &groom.mask, painted == &Groom::paint ? kRim : 0, skin, brush, change, given);
}

std::uint32_t vertexOf(const GroomSurface& skin, std::uint32_t triangle, std::size_t k) {
  return skin.surface.indices[std::size_t{3} * triangle + k];
}
std::uint32_t pointOf(const GroomSurface& skin, std::uint32_t triangle, std::size_t k) {
  return skin.points.pointOf[vertexOf(skin, triangle, k)];
}

// A point of the surface under a brush, and one of its vertices.
struct PointUnder {
  std::uint32_t point, vertex;
  bool operator<(const PointUnder& other) const { return point < other.point; }
  bool operator==(const PointUnder& other) const { return point == other.point; }
};

// Ascending, each once.
std::vector<PointUnder> pointsOf(const GroomSurface& skin, const std::vector<std::uint32_t>& triangles) {
  std::vector<PointUnder> points;
  for (const std::uint32_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) points.push_back({pointOf(skin, t, k), vertexOf(skin, t, k)});
  sortStably(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Vec3 bendAt(const Groom& groom, const GroomSurface& skin, std::size_t point) { return bendAt(groom, skin.lie, point); }

// goals[i] is where the comb of points[i] is drawn to.
bool dabPoints(Groom& groom, const GroomSurface& skin, const Brush& brush, const std::vector<PointUnder>& points,
               const std::vector<Vec3>& goals) {
  bool changed = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [point, vertex] = points[i];
    Vec3& comb = groom.comb[point];
    float weight = weightOf(brush, skin.points.positions[point]);
    if (weight <= 0.0f || glm::dot(skin.points.normals[point], brush.normal) <= 0.0f) continue;
    weight *= 1.0f - groom.mask.at(skin.surface.vertices[vertex].atlas).w;
    const Vec3 before = comb, bend = bendAt(groom, skin, point);
    comb = combOf(bend + (goals[i] - bend) * weight, skin.lie, point);
    changed = changed || comb != before;
  }
  return changed;
}

}  // namespace

float weightOf(const Brush& brush, const Vec3& at) {
  const Vec3 way = at - brush.centre;
  const float squared = glm::dot(way, way) / (brush.radius * brush.radius);
  return squared < 1.0f ? saturate(brush.strength) * falloffAt(brush.falloff, squared) : 0.0f;
}

float falloffAt(Falloff falloff, float squared) {
  const float left = 1.0f - std::sqrt(squared), smooth = 1.0f - squared;
  switch (falloff) {
    case Falloff::Linear: return left;
    case Falloff::Sharp: return left * left;
    case Falloff::Flat: return 1.0f;
    case Falloff::Smooth: break;
  }
  return smooth * smooth;
}

bool trim(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  return dabTexels(groom, skin, brush, [](GroomMap::Texel texel, float weight, std::uint32_t) {
    texel[0] = towards(texel[0], 0, weight);
    return texel;
  });
}

bool grow(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  return dabTexels(groom, skin, brush, [](GroomMap::Texel texel, float weight, std::uint32_t) {
    texel[0] = towards(texel[0], 255, weight);
    return texel;
  });
}

bool cutTo(Groom& groom, const GroomSurface& skin, const Brush& brush, float share) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t length) {
    if (texel[0] > length) texel[0] = towards(texel[0], static_cast<int>(length), weight);
    return texel;
  };
  return dabTexels(groom, skin, brush, change, static_cast<std::uint32_t>(saturate(share) * 255.0f + 0.5f));
}

bool setLength(Groom& groom, const GroomSurface& skin, const Brush& brush, float share) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t length) {
    texel[0] = towards(texel[0], static_cast<int>(length), weight);
    return texel;
  };
  return dabTexels(groom, skin, brush, change, static_cast<std::uint32_t>(saturate(share) * 255.0f + 0.5f));
}

bool paintType(Groom& groom, const GroomSurface& skin, const Brush& brush, int type) {
  const auto chosen = static_cast<std::uint32_t>(std::clamp(type, 1, kTypes)) - 1;
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t channel) {
    int others = 0;
    for (std::size_t k = 1; k < kTypes; ++k)
      if (k != channel) others += texel[k] = towards(texel[k], 0, weight);
    // Not more than the others leave.
    const int grown = towards(texel[channel], 255, weight);
    if (channel > 0) texel[channel] = static_cast<std::uint8_t>(std::min(grown, 255 - others));
    return texel;
  };
  return dabTexels(groom, skin, brush, change, chosen);
}

bool takeType(Groom& groom, const GroomSurface& skin, const Brush& brush, int type) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t channel) {
    texel[channel] = towards(texel[channel], 0, weight);
    return texel;
  };
  return dabTexels(groom, skin, brush, change, static_cast<std::uint32_t>(std::clamp(type, 2, kTypes)) - 1);
}

Vec3 combedTo(const Vec3& direction, const Vec3& normal) {
  const Vec3 unit = normalizeOr(direction, Vec3(0));
  const Vec3 along = unit - normal * glm::dot(unit, normal);
  const float sine = std::sqrt(glm::dot(along, along));
  return normalizeOr(along, Vec3(0)) * (kMaxComb * std::min(sine / kPole, 1.0f));
}

bool comb(Groom& groom, const GroomSurface& skin, const Brush& brush, const Vec3& direction) {
  const std::vector<PointUnder> points = pointsOf(skin, trianglesUnder(skin, brush));
  std::vector<Vec3> goals;
  for (const auto [point, vertex] : points) {
    const Vec3 goal = combedTo(direction, skin.points.normals[point]);
    goals.push_back(goal == Vec3(0) ? bendAt(groom, skin, point) : goal);
  }
  return dabPoints(groom, skin, brush, points, goals);
}

bool setComb(Groom& groom, const GroomSurface& skin, const Brush& brush, const Vec3& bend, std::uint32_t vertex) {
  if (!std::isfinite(bend.x + bend.y + bend.z)) return false;
  const auto goalAt = [&](std::uint32_t point) {
    const Vec3& normal = skin.points.normals[point];
    return normalizeOr(bend - normal * glm::dot(bend, normal), Vec3(0)) * std::min(std::sqrt(glm::dot(bend, bend)), kMaxComb);
  };
  const std::vector<PointUnder> points = pointsOf(skin, trianglesUnder(skin, brush));
  std::vector<Vec3> goals;
  for (const PointUnder& under : points) goals.push_back(goalAt(under.point));
  const std::uint32_t nearest = skin.points.pointOf[vertex];
  Brush there = brush;
  there.centre = skin.points.positions[nearest];
  there.normal = skin.points.normals[nearest];
  const bool changed = dabPoints(groom, skin, brush, points, goals);
  return dabPoints(groom, skin, there, {{nearest, vertex}}, {goalAt(nearest)}) || changed;
}

bool raise(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  const std::vector<PointUnder> points = pointsOf(skin, trianglesUnder(skin, brush));
  return dabPoints(groom, skin, brush, points, std::vector<Vec3>(points.size(), Vec3(0)));
}

bool smooth(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  const std::vector<std::uint32_t> triangles = trianglesUnder(skin, brush);
  const std::vector<PointUnder> points = pointsOf(skin, triangles);
  // Summed before anything changes: nothing depends on the order of the points.
  std::vector<Vec3> goals(points.size(), Vec3(0));
  std::vector<float> counts(points.size(), 0.0f);
  for (const std::uint32_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(
          std::lower_bound(points.begin(), points.end(), PointUnder{pointOf(skin, t, k), 0}) - points.begin());
      goals[at] += bendAt(groom, skin, pointOf(skin, t, (k + 1) % 3)) + bendAt(groom, skin, pointOf(skin, t, (k + 2) % 3));
      counts[at] += 2.0f;
    }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& normal = skin.points.normals[points[i].point];
    goals[i] /= counts[i];
    goals[i] -= normal * glm::dot(goals[i], normal);
  }
  return dabPoints(groom, skin, brush, points, goals);
}

bool paint(Groom& groom, const GroomSurface& skin, const Brush& brush, std::uint32_t color) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t rgb) {
    const std::uint8_t was = texel[3];
    if (weight >= kLeastWeight) texel[3] = towards(was, 255, weight);
    // Over: of what there is then, as much is new as was not there before, and the share w of the rest.
    const float left = static_cast<float>(was) * (1.0f - weight), share = was > 0 ? 1.0f - left / static_cast<float>(texel[3]) : 1.0f;
    for (std::size_t k = 0; k < 3; ++k) texel[k] = towards(texel[k], static_cast<int>(rgb >> (16 - 8 * k) & 255u), share);
    return texel;
  };
  return brush.strength > 0.0f && dabTexels(groom, skin, brush, change, color, &Groom::paint);
}

bool unpaint(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t) {
    if (weight >= kLeastWeight) texel[3] = towards(texel[3], 0, weight);
    return texel;
  };
  return dabTexels(groom, skin, brush, change, 0, &Groom::paint);
}

bool protect(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t) {
    texel[3] = towards(texel[3], 255, weight);
    return texel;
  };
  return dabTexels(groom, skin, brush, change, 0, &Groom::mask);
}

bool unprotect(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t) {
    texel[3] = towards(texel[3], 0, weight);
    return texel;
  };
  return dabTexels(groom, skin, brush, change, 0, &Groom::mask);
}

bool paintChannel(GroomMap& map, const GroomMap& mask, const GroomSurface& skin, const Brush& brush, std::size_t channel, std::uint8_t value) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t packed) {
    texel[packed >> 8] = towards(texel[packed >> 8], static_cast<int>(packed & 255u), weight);
    return texel;
  };
  return dabMap(map, &mask, 0, skin, brush, change, static_cast<std::uint32_t>(channel) << 8 | value);
}

bool addShape(Groom& groom, const GroomSurface& skin, const Brush& brush, ShapeChannel channel) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t k) { return shapedTexel(texel, k, towards(texel[k], 255, weight)); };
  return dabTexels(groom, skin, brush, change, static_cast<std::uint32_t>(channel), &Groom::shape);
}

bool takeShape(Groom& groom, const GroomSurface& skin, const Brush& brush, ShapeChannel channel) {
  const auto change = [](GroomMap::Texel texel, float weight, std::uint32_t k) { return shapedTexel(texel, k, towards(texel[k], 0, weight)); };
  return dabTexels(groom, skin, brush, change, static_cast<std::uint32_t>(channel), &Groom::shape);
}

bool pluck(Groom& groom, const GroomSurface& skin, const Brush& brush) {
  if (!usable(brush)) return false;
  const std::size_t before = groom.whiskers.size();
  std::size_t kept = 0;
  for (const Whisker& whisker : groom.whiskers) {
    const Vec3 way = whisker.root - brush.centre;
    // Those of the far side of an ear stay; one that lies flat may point away a little.
    const bool under = glm::dot(way, way) <= brush.radius * brush.radius && glm::dot(whisker.direction, brush.normal) > -0.5f;
    const auto root = under ? rootOf(whisker, skin.query) : std::nullopt;
    if (!under || (root && groom.mask.at(atlasAt(skin.surface, *root)).w > 0.5f)) groom.whiskers[kept++] = whisker;
  }
  groom.whiskers.resize(kept);
  return kept < before;
}

}  // namespace fur::groom
