#include "geometry/FurDensity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/Sort.h"

namespace fur::geometry {

namespace {

using Weighted = std::vector<std::pair<double, double>>;  // value, area

float percentile(const Weighted& sorted, double part) {
  double total = 0.0, sum = 0.0;
  for (const auto& [value, area] : sorted) total += area;
  for (const auto& [value, area] : sorted)
    if ((sum += area) >= part * total) return static_cast<float>(value);
  return 0.0f;
}

// Lengths along the two principal directions after flattening, for one unit on the surface.
std::pair<double, double> principalScales(const SurfaceVertex& a, const SurfaceVertex& b, const SurfaceVertex& c) {
  const glm::dvec3 e1 = glm::dvec3(b.position) - glm::dvec3(a.position), e2 = glm::dvec3(c.position) - glm::dvec3(a.position);
  const glm::dvec3 x = glm::normalize(e1), y = glm::normalize(glm::cross(glm::cross(e1, e2), x));
  const glm::dmat2 onSurface(glm::dot(e1, x), glm::dot(e1, y), glm::dot(e2, x), glm::dot(e2, y));
  const glm::dmat2 flat(glm::dvec2(b.fur) - glm::dvec2(a.fur), glm::dvec2(c.fur) - glm::dvec2(a.fur));
  const glm::dmat2 j = flat * glm::inverse(onSurface);
  // Singular values of j: the eigenvalues of its square.
  const double p = glm::dot(j[0], j[0]), q = glm::dot(j[1], j[1]), mixed = glm::dot(j[0], j[1]);
  const double half = std::sqrt((p - q) * (p - q) / 4 + mixed * mixed);
  return {std::sqrt(std::max(0.0, (p + q) / 2 - half)), std::sqrt((p + q) / 2 + half)};
}

}  // namespace

FurDensity measureFurDensity(const Surface& surface) {
  Weighted scales, lengths;
  FurDensity out;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    const SurfaceVertex &a = surface.vertices[surface.indices[i]], &b = surface.vertices[surface.indices[i + 1]],
                        &c = surface.vertices[surface.indices[i + 2]];
    const glm::dvec3 cross = glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position), glm::dvec3(c.position) - glm::dvec3(a.position));
    const double area = std::sqrt(glm::dot(cross, cross));
    const auto [least, most] = principalScales(a, b, c);
    scales.emplace_back(std::sqrt(least * most), area);
    lengths.emplace_back(least, area);
    lengths.emplace_back(most, area);
    const double stretch = least > 0.0 ? most / least : std::numeric_limits<double>::infinity();
    out.worstStretch = std::max(out.worstStretch, static_cast<float>(stretch));
  }
  sortStably(scales.begin(), scales.end());
  sortStably(lengths.begin(), lengths.end());
  out.low = percentile(scales, 0.05);
  out.median = percentile(scales, 0.5);
  out.high = percentile(scales, 0.95);
  out.lowLength = percentile(lengths, 0.05);
  out.highLength = percentile(lengths, 0.95);
  return out;
}

}  // namespace fur::geometry
