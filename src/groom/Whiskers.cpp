#include "groom/Whiskers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/Random.h"
#include "core/Srgb.h"
#include "dynamics/BendField.h"

namespace fur::groom {

namespace {

constexpr float kLongest = 2.0f, kWidest = 0.05f;
// Farther off the surface than this a root belongs to another model.
constexpr float kReach = 0.01f;
// How far aside of its middle the hairs of a tuft of full spread point, of 1 forwards.
constexpr float kFan = 0.9f;
// The shortest hair of a tuft, as a share of the longest.
constexpr float kShortest = 0.55f;
// Radians that a hair turns by of its own, and how much of the way is chance.
constexpr float kLeastCurve = 0.25f, kMostCurve = 0.65f, kOwnWay = 0.6f;

Vec3 across(const Vec3& v, const Vec3& direction) { return v - direction * glm::dot(v, direction); }

}  // namespace

std::optional<geometry::SurfacePoint> rootOf(const Whisker& w, const geometry::SurfaceQuery& query) {
  auto hit = query.castRay(w.root + w.direction * kReach, -w.direction);
  if (hit && hit->distance > 2 * kReach) hit.reset();
  return hit;
}

std::vector<Whisker> readWhiskers(std::span<const std::uint8_t> bytes) {
  std::vector<Whisker> out(bytes.size() / kWhiskerBytes);
  std::copy_n(bytes.begin(), out.size() * kWhiskerBytes, reinterpret_cast<std::uint8_t*>(out.data()));
  return out;
}

bool makeSound(Whisker& w) {
  // What is unit already keeps its bits.
  if (!(std::abs(glm::dot(w.direction, w.direction) - 1.0f) < 1e-5f)) w.direction = normalizeOr(w.direction, Vec3(0));
  const float sum = w.root.x + w.root.y + w.root.z + w.length + w.width + w.spread + w.stiffness;
  const std::pair<float*, float> bounded[] = {{&w.length, kLongest}, {&w.width, kWidest}, {&w.spread, 1.0f}, {&w.stiffness, 1.0f}};
  for (const auto& [number, most] : bounded) *number = glm::clamp(*number, 0.0f, most);
  w.hairs = glm::clamp(w.hairs, 1u, kMostHairs);
  w.color &= 0xffffffu;
  return std::isfinite(sum) && w.direction != Vec3(0);
}

void keepSound(std::vector<Whisker>& whiskers, const geometry::SurfaceQuery& query) {
  std::size_t kept = 0;
  for (Whisker w : whiskers)
    if (kept < kMostWhiskers && makeSound(w) && rootOf(w, query)) whiskers[kept++] = w;
  whiskers.resize(kept);
}

Vec3 pulledDirection(const Vec3& normal, float length, const Vec3& pull) {
  // Never into the skin.
  const Vec3 up = normal * (0.3f * length - std::min(glm::dot(pull, normal), 0.0f));
  return normalizeOr(up + pull, normal);
}

std::vector<WhiskerHair> whiskerHairs(std::span<const Whisker> whiskers, const geometry::Surface& surface,
                                      const geometry::SurfaceQuery& query) {
  std::size_t most = 0, count = 0;
  for (const Whisker& w : whiskers) most += w.hairs;
  std::vector<WhiskerHair> out(most);
  for (const Whisker& w : whiskers) {
    const auto at = rootOf(w, query);
    if (!at) continue;
    const Vec2 atlas = atlasAt(surface, *at);
    const std::uint32_t* corners = &surface.indices[std::size_t{3} * at->triangle];
    WhiskerHair hair{};
    hair.width = w.width;
    hair.give = 1 - w.stiffness;
    hair.normal = normalAt(surface, *at);
    hair.color = linearColor(w.color);
    hair.vertices = Vec3(corners[0], corners[1], corners[2]);
    hair.weights = at->weights;
    hair.atlasU = atlas.x;
    hair.atlasV = atlas.y;
    Random random(w.seed);
    const auto anyWay = [&] {
      Vec3 way;
      for (int k = 0; k < 3; ++k) way[k] = random.uniform(-1, 1);
      return way;
    };
    hair.root = positionAt(surface, *at);
    for (std::uint32_t i = 0; i < w.hairs; ++i) {
      // The first in the middle and as long as can be, the others round it.
      const bool first = i == 0;
      hair.direction = normalizeOr(w.direction + (first ? 0.0f : kFan * w.spread) * across(anyWay(), w.direction), w.direction);
      hair.length = w.length * random.uniform(first ? 1.0f : kShortest, 1);
      // Further over where it leans already, and each a little otherwise.
      hair.curve = across(hair.direction - hair.normal + kOwnWay * anyWay(), hair.direction);
      hair.curve = normalizeOr(hair.curve, Vec3(0)) * random.uniform(kLeastCurve, kMostCurve);
      hair.shade = random.uniform();
      out[count++] = hair;
    }
  }
  out.erase(out.begin() + static_cast<std::ptrdiff_t>(count), out.end());
  return out;
}

Vec3 hairBend(const WhiskerHair& hair, std::span<const Vec4> bends) {
  Vec3 lean(0);
  for (int k = 0; k < 3; ++k) lean += hair.weights[k] * Vec3(bends[static_cast<std::size_t>(hair.vertices[k])]);
  return hair.curve + hair.give * across(lean, hair.direction);
}

std::array<Vec3, kHairPoints> hairPoints(const WhiskerHair& hair, std::span<const Vec4> bends) {
  const Vec3 bend = hairBend(hair, bends);
  std::array<Vec3, kHairPoints> out;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = dynamics::strandPoint(hair.root, hair.direction, bend, hair.length, static_cast<float>(i) / (kHairPoints - 1));
  return out;
}

}  // namespace fur::groom
