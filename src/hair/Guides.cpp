#include "hair/Guides.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"

namespace fur::hair {

namespace {

constexpr float kShortest = 1e-4f;  // of a segment that had no length; a hair's breadth on a model of radius 1

// The frame turned by the least angle that takes its y, the unit vector `from`, to `to`; where that is half a turn, about its x.
Quat turnedOnTo(const Quat& frame, const Vec3& from, const Vec3& to) {
  const float w = 1.0f + glm::dot(from, to);
  const Vec3 axis = w > 1e-6f ? glm::cross(from, to) : frame * Vec3(1, 0, 0);
  return glm::normalize(Quat(w > 1e-6f ? w : 0.0f, axis.x, axis.y, axis.z) * frame);
}

}  // namespace

void frameNodes(std::span<const Vec3> positions, const RootFrame& root, std::span<GuideNode> out) {
  FUR_ASSERT(out.size() == positions.size(), "frameNodes()", "a place for every node", out.size());
  Quat frame = glm::quat_cast(Mat3(root.tangent, root.normal, glm::cross(root.tangent, root.normal)));
  Vec3 along = root.normal, last = root.normal;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 next = i + 1 < positions.size() ? normalizeOr(positions[i + 1] - positions[i], last) : last;
    // Halfway between its two segments.
    const Vec3 here = i == 0 ? next : normalizeOr(last + next, next);
    frame = turnedOnTo(frame, along, here);
    along = here;
    last = next;
    out[i].position = positions[i];
    out[i].frame = frame;
  }
}

std::vector<GuideNode> restNodes(const Guides& guides, std::span<const RootFrame> roots) {
  std::vector<GuideNode> out(guides.positions.size());
  const auto each = static_cast<std::size_t>(guides.nodes);
  for (std::size_t g = 0; g < guides.count(); ++g) frameNodes(guides.of(g), roots[g], std::span(out).subspan(g * each, each));
  return out;
}

bool makeSound(Guides& guides) {
  const auto nodes = static_cast<std::size_t>(guides.nodes);
  if (guides.nodes < kLeastNodes || guides.nodes > kMostNodes || guides.count() > kMostGuides) return false;
  if (guides.positions.size() != guides.count() * nodes) return false;
  for (const Vec3& p : guides.positions)
    if (!finite(p) || std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthestNode) return false;
  for (std::size_t guide = 0; guide < guides.count(); ++guide) {
    const std::span<Vec3> chain = guides.of(guide);
    Vec3 along(0, 1, 0);
    for (std::size_t i = 1; i < nodes; ++i) {
      const Vec3 segment = chain[i] - chain[i - 1];
      along = normalizeOr(segment, along);
      if (!(glm::dot(segment, segment) >= kShortest * kShortest)) chain[i] = chain[i - 1] + along * kShortest;
    }
  }
  return true;
}

float lengthOf(std::span<const Vec3> chain) {
  float sum = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) sum += glm::length(chain[i] - chain[i - 1]);
  return sum;
}

std::vector<Vec3> resampled(std::span<const Vec3> chain, int nodes) {
  if (chain.empty() || nodes <= 0) return {};
  std::vector<Vec3> out(static_cast<std::size_t>(nodes), chain.front());
  const float whole = lengthOf(chain);
  float before = 0;  // length up to the segment from chain[s - 1] to chain[s]
  std::size_t s = 1;
  for (std::size_t i = 1; i < out.size(); ++i) {
    const float wanted = whole * static_cast<float>(i) / static_cast<float>(out.size() - 1);
    for (; s + 1 < chain.size(); ++s) {
      const float length = glm::length(chain[s] - chain[s - 1]);
      if (before + length >= wanted) break;
      before += length;
    }
    if (s >= chain.size()) continue;
    const float length = glm::length(chain[s] - chain[s - 1]);
    out[i] = glm::mix(chain[s - 1], chain[s], length > 0 ? saturate((wanted - before) / length) : 1.0f);
  }
  if (out.size() > 1) out.back() = chain.back();
  // Chords are shorter than what they span. Taken larger, the chain is as long as it was, however often it is resampled.
  const float chords = lengthOf(out);
  if (chords > 0)
    for (Vec3& p : out) p = chain.front() + (p - chain.front()) * (whole / chords);
  return out;
}

}  // namespace fur::hair
