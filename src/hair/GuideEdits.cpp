#include "hair/GuideEdits.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "hair/GuideChain.h"

namespace fur::hair {

namespace {

constexpr int kReachRounds = 24;  // of FABRIK; drags are small steps, for which a few are enough

// Calls edit(guide, chain, w) for each guide that is shown and meets the ball; whether one of them changed anything.
template <class Edit>
bool forTouched(Guides& guides, const groom::Brush& brush, Edit edit) {
  bool changed = false;
  if (!isUsable(brush)) return false;
  for (std::size_t g = 0; g < guides.count(); ++g) {
    if (guides.flags[g] & kHidden) continue;
    const float w = weightOfLine(brush, guides.of(g));
    if (w > 0) changed |= edit(g, guides.of(g), w);
  }
  return changed;
}

// Puts the chain's segments in the directions that turned(segment, direction) gives, which need not be unit; as long as they were.
template <class Turned>
bool turnSegments(std::span<Vec3> chain, Turned turned) {
  bool changed = false;
  Vec3 before = chain[0];
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec3 segment = chain[i] - before;
    const float length = glm::length(segment);
    const Vec3 direction = normalizeOr(segment, Vec3(0, 1, 0)), now = normalizeOr(turned(i, direction), direction);
    before = chain[i];
    const Vec3 to = chain[i - 1] + (now == direction ? segment : now * length);
    changed |= to != chain[i];
    chain[i] = to;
  }
  return changed;
}

float segmentWeight(const groom::Brush& brush, const Vec3& a, const Vec3& b) {
  const Vec3 ends[] = {a, b};
  return weightOfLine(brush, ends);
}

Vec3 rotated(const Vec3& v, const Vec3& axis, float angle) {
  const float c = portableCos(angle), s = portableSin(angle);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

// Root and lengths stay; node `last` comes to `to`, or as near as can be.
void reach(std::span<Vec3> chain, std::span<const float> lengths, std::size_t last, const Vec3& to) {
  const Vec3 root = chain[0];
  for (int round = 0; round < kReachRounds; ++round) {
    chain[last] = to;
    for (std::size_t i = last; i-- > 0;) chain[i] = chain[i + 1] + lengths[i] * normalizeOr(chain[i] - chain[i + 1], Vec3(0, 1, 0));
    chain[0] = root;
    for (std::size_t i = 1; i <= last; ++i) chain[i] = chain[i - 1] + lengths[i - 1] * normalizeOr(chain[i] - chain[i - 1], Vec3(0, 1, 0));
  }
}

}  // namespace

bool moveNode(Guides& guides, std::size_t guide, std::size_t node, const Vec3& to) {
  if (guide >= guides.count() || node == 0 || node >= static_cast<std::size_t>(guides.nodes) || !isFinite(to)) return false;
  const std::span<Vec3> chain = guides.of(guide);
  if (chain[node] == to) return false;
  const std::vector<Vec3> before(chain.begin(), chain.end());
  const std::vector<float> lengths = segmentLengths(chain);
  reach(chain, lengths, node, to);
  draw(chain, lengths, node + 1);
  return !std::equal(chain.begin(), chain.end(), before.begin());
}

bool comb(Guides& guides, const groom::Brush& brush, const Vec3& move) {
  if (!isFinite(move) || move == Vec3(0)) return false;
  return forTouched(guides, brush, [&](std::size_t, std::span<Vec3> chain, float) {
    const std::vector<float> lengths = segmentLengths(chain);
    bool changed = false;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const float w = groom::weightOf(brush, chain[i]);
      chain[i] += move * w;
      changed |= w > 0;
    }
    if (changed) draw(chain, lengths, 1);
    return changed;
  });
}

bool cut(Guides& guides, const groom::Brush& brush) {
  return forTouched(guides, brush, [&](std::size_t, std::span<Vec3> chain, float) {
    const float whole = lengthOf(chain), kept = std::max(lengthBefore(brush, chain), kLeastGuideLength);
    if (kept >= whole) return false;
    const std::vector<Vec3> shorter = resampled(cutAt(chain, kept), static_cast<int>(chain.size()));
    std::copy(shorter.begin(), shorter.end(), chain.begin());
    return true;
  });
}

bool lengthen(Guides& guides, const groom::Brush& brush, float factor) {
  if (!std::isfinite(factor) || factor <= 0) return false;
  return forTouched(guides, brush, [&](std::size_t, std::span<Vec3> chain, float w) {
    const float length = std::max(lengthOf(chain), 1e-6f);
    const float scale = glm::clamp(length * glm::mix(1.0f, factor, w), kLeastGuideLength, kMostGuideLength) / length;
    for (Vec3& p : chain.subspan(1)) p = chain[0] + (p - chain[0]) * scale;
    return scale != 1.0f;
  });
}

bool straighten(Guides& guides, const groom::Brush& brush) {
  return forTouched(guides, brush, [&](std::size_t, std::span<Vec3> chain, float) {
    const std::vector<Vec3> was(chain.begin(), chain.end());
    const Vec3 line = normalizeOr(chain.back() - chain[0], Vec3(0));
    return turnSegments(chain, [&](std::size_t i, const Vec3& way) { return glm::mix(way, line, segmentWeight(brush, was[i - 1], was[i])); });
  });
}

bool curl(Guides& guides, std::span<const RootFrame> roots, const groom::Brush& brush, float turns, float slant) {
  if (!std::isfinite(turns) || !std::isfinite(slant)) return false;
  const float aside = portableSin(glm::clamp(slant, 0.0f, 1.4f)) / portableCos(glm::clamp(slant, 0.0f, 1.4f));
  return forTouched(guides, brush, [&](std::size_t g, std::span<Vec3> chain, float) {
    const std::vector<Vec3> was(chain.begin(), chain.end());
    std::vector<GuideNode> nodes(chain.size());
    frameNodes(was, roots[g], nodes);
    return turnSegments(chain, [&](std::size_t i, const Vec3& way) {
      const float angle = glm::clamp(turns, -64.0f, 64.0f) * 2 * kPi * (static_cast<float>(i) - 0.5f) / static_cast<float>(chain.size() - 1);
      const Vec3 out = nodes[i].frame * Vec3(portableCos(angle), 0, portableSin(angle));
      return way + out * (aside * segmentWeight(brush, was[i - 1], was[i]));
    });
  });
}

bool twist(Guides& guides, const groom::Brush& brush, float angle) {
  if (!std::isfinite(angle)) return false;
  return forTouched(guides, brush, [&](std::size_t, std::span<Vec3> chain, float w) {
    const Vec3 axis = normalizeOr(chain.back() - chain[0], Vec3(0));
    const float each = glm::clamp(angle, -64.0f, 64.0f) * w / static_cast<float>(chain.size() - 1);
    return turnSegments(chain, [&](std::size_t i, const Vec3& way) { return rotated(way, axis, each * static_cast<float>(i)); });
  });
}

}  // namespace fur::hair
