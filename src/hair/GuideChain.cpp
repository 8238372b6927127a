#include "hair/GuideChain.h"

#include <algorithm>

namespace fur::hair {

namespace {

// The share of the way from a to b at the point nearest to p.
float nearestShare(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const float squared = glm::dot(way, way);
  return squared > 0 ? saturate(glm::dot(p - a, way) / squared) : 0.0f;
}

}  // namespace

bool isUsable(const groom::Brush& brush) {
  return isFinite(brush.centre) && std::isfinite(brush.radius) && std::isfinite(brush.strength) && brush.radius > 0 && brush.strength > 0;
}

float weightOfLine(const groom::Brush& brush, std::span<const Vec3> chain) {
  float most = 0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    most = std::max(most, groom::weightOf(brush, glm::mix(chain[i - 1], chain[i], nearestShare(brush.centre, chain[i - 1], chain[i]))));
  return most;
}

float lengthBefore(const groom::Brush& brush, std::span<const Vec3> chain) {
  float sum = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec3 from = chain[i - 1] - brush.centre, way = chain[i] - chain[i - 1];
    const float length = glm::length(way), a = glm::dot(way, way), b = glm::dot(from, way);
    const float c = glm::dot(from, from) - brush.radius * brush.radius;
    if (c <= 0) return sum;
    const float root = b * b - a * c;
    const float share = a > 0 && root > 0 ? (-b - std::sqrt(root)) / a : -1.0f;
    if (share >= 0 && share < 1) return sum + share * length;
    sum += length;
  }
  return sum;
}

std::vector<Vec3> cutAt(std::span<const Vec3> chain, float length) {
  std::vector<Vec3> out{chain[0]};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const float each = glm::length(chain[i] - chain[i - 1]);
    if (each > length) {
      out.push_back(glm::mix(chain[i - 1], chain[i], length / each));
      return out;
    }
    out.push_back(chain[i]);
    length -= each;
  }
  return out;
}

std::vector<float> segmentLengths(std::span<const Vec3> chain) {
  std::vector<float> out;
  for (std::size_t i = 1; i < chain.size(); ++i) out.push_back(glm::length(chain[i] - chain[i - 1]));
  return out;
}

void draw(std::span<Vec3> chain, std::span<const float> lengths, std::size_t first) {
  for (std::size_t i = first; i < chain.size(); ++i) {
    const Vec3 onwards = i > 1 ? chain[i - 1] - chain[i - 2] : Vec3(0, 1, 0);
    const Vec3 way = normalizeOr(chain[i] - chain[i - 1], normalizeOr(onwards, Vec3(0, 1, 0)));
    chain[i] = chain[i - 1] + way * lengths[i - 1];
  }
}

}  // namespace fur::hair
