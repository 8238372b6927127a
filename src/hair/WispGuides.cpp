#include "hair/WispGuides.h"

#include <algorithm>
#include <cmath>

#include "core/Random.h"

namespace fur::hair {

namespace {

using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;

// Guides in a regular grid have several triangulations of Delaunay. Trifles that are added to the squares of distances, as a share
// of the squared spacing, decide for one, the same for all wisps.
constexpr double kTrifle = 1e-3;
constexpr int kMostRounds = 64;  // of exchanging guides; a few are enough

struct Place {
  std::uint32_t guide;
  DVec2 flat;
  double lifted;  // kSpread |p|^2
};

// A mixture of up to three places.
struct Mixture {
  int count = 0;
  const Place* places[3]{};
  double weights[3]{};

  DVec2 x() const {
    DVec2 sum(0);
    for (int k = 0; k < count; ++k) sum += places[k]->flat * weights[k];
    return sum;
  }
  double cost() const {
    const DVec2 at = x();
    double sum = glm::dot(at, at);
    for (int k = 0; k < count; ++k) sum += places[k]->lifted * weights[k];
    return sum;
  }
};

double cross(const DVec2& a, const DVec2& b) { return a.x * b.y - a.y * b.x; }

// The best mixture that has a share of each, or one of count 0.
Mixture best(const Place& a) { return {1, {&a}, {1}}; }
Mixture best(const Place& a, const Place& b) {
  const DVec2 way = b.flat - a.flat;
  const double squared = glm::dot(way, way);
  const double share = -(glm::dot(a.flat, way) + 0.5 * (b.lifted - a.lifted)) / squared;
  if (!(squared > 1e-18) || !(share > 0 && share < 1)) return {};
  return {2, {&a, &b}, {1 - share, share}};
}
Mixture best(const Place& a, const Place& b, const Place& c) {
  const DVec2 ab = b.flat - a.flat, ac = c.flat - a.flat;
  const double area = cross(ab, ac);
  if (!(std::abs(area) > 1e-18)) return {};
  // What is lifted is linear over the triangle; x is where it and |x|^2 rise alike.
  const double toB = b.lifted - a.lifted, toC = c.lifted - a.lifted;
  const DVec2 x = -0.5 * DVec2(toB * ac.y - toC * ab.y, toC * ab.x - toB * ac.x) / area - a.flat;
  const double shareB = cross(x, ac) / area, shareC = cross(ab, x) / area;
  if (!(shareB > 0 && shareC > 0 && shareB + shareC < 1)) return {};
  return {3, {&a, &b, &c}, {1 - shareB - shareC, shareB, shareC}};
}

// The best of all mixtures of these and one more.
Mixture bestWith(const Mixture& now, const Place& more) {
  Mixture out = best(more);
  double least = out.cost();
  const auto offer = [&](const Mixture& mixture) {
    if (mixture.count == 0 || !(mixture.cost() < least)) return;
    least = mixture.cost();
    out = mixture;
  };
  for (int i = 0; i < now.count; ++i) {
    offer(best(*now.places[i], more));
    for (int k = 0; k < i; ++k) offer(best(*now.places[k], *now.places[i], more));
  }
  return out;
}

std::vector<Place> layOut(std::span<const RootFrame> roots, const std::vector<double>& trifles, const Vec3& position, const Vec3& normal) {
  const Vec3 side = std::abs(normal.x) < 0.6f ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  const Vec3 x = normalizeOr(glm::cross(normal, side), Vec3(1, 0, 0)), y = glm::cross(normal, x);
  std::vector<Place> out;
  out.reserve(roots.size());
  const auto add = [&](bool anySide) {
    for (std::uint32_t g = 0; g < roots.size(); ++g) {
      if (!anySide && glm::dot(roots[g].normal, normal) < 0) continue;
      const Vec3 away = roots[g].position - position;
      // Squared distances in space: on a sphere, where normal and place are one, the triangles are those of the guides' convex
      // hull, the same for all wisps.
      out.push_back({g, {glm::dot(away, x), glm::dot(away, y)}, kSpread * (static_cast<double>(glm::dot(away, away)) + trifles[g])});
    }
  };
  add(false);
  if (out.empty()) add(true);
  return out;
}

}  // namespace

WispGuides::WispGuides(std::span<const RootFrame> roots) : roots_(roots) {
  double sum = 0;
  for (const RootFrame& a : roots_) {
    double nearest = roots_.size() > 1 ? 1e30 : 0;
    for (const RootFrame& b : roots_)
      if (&a != &b) nearest = std::min(nearest, static_cast<double>(glm::dot(a.position - b.position, a.position - b.position)));
    sum += nearest;
  }
  const double spacing = kTrifle * sum / std::max(static_cast<double>(roots_.size()), 1.0);
  for (std::uint32_t g = 0; g < roots_.size(); ++g) trifles_.push_back(spacing * static_cast<double>(Random(g, 17).uniform()));
}

Following WispGuides::at(const Vec3& position, const Vec3& normal) const {
  const std::vector<Place> places = layOut(roots_, trifles_, position, normal);
  const auto nearer = [](const Place& a, const Place& b) { return a.lifted < b.lifted; };
  Mixture now = best(*std::min_element(places.begin(), places.end(), nearer));
  double cost = now.cost();
  // The place of which a little more is worth most joins, until there is none.
  for (int round = 0; round < kMostRounds; ++round) {
    const DVec2 x = now.x();
    const auto slope = [&](const Place& p) { return 2 * glm::dot(x, p.flat) + p.lifted; };
    const auto worth = [&](const Place& a, const Place& b) { return slope(a) < slope(b); };
    const Mixture next = bestWith(now, *std::min_element(places.begin(), places.end(), worth));
    if (!(next.cost() < cost)) break;
    now = next;
    cost = now.cost();
  }
  Following out;
  out.guides.fill(now.places[0]->guide);
  DVec3 weights(0);
  for (int k = 0; k < now.count; ++k) {
    out.guides[static_cast<std::size_t>(k)] = now.places[k]->guide;
    weights[k] = now.weights[k];
  }
  out.weights = Vec3(weights);
  return out;
}

}  // namespace fur::hair
