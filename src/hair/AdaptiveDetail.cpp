#include "hair/AdaptiveDetail.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/Sort.h"

namespace fur::hair {

namespace {

// Of acceleration times radius, model units^2 / s^2. A swing of a tenth of a unit and once a second over a cluster of the same
// radius has 0.4.
constexpr float kHalf = 0.4f, kQuarter = 0.12f;
constexpr float kMergeBelow = 0.5f;  // of those
constexpr int kCalmSteps = 30;
constexpr float kMostOffset = 0.02f;  // model units
constexpr float kFade = 0.985f;       // of an offset, a step: half a second
constexpr float kAlike = 0.05f;       // of wetness

constexpr std::size_t kGuides = AdaptiveDetail::kBlocks * kLanes;  // of a cluster

// Bits of x at every third place.
std::uint32_t spreadBits(std::uint32_t x) {
  std::uint32_t out = 0;
  for (std::uint32_t bit = 0; bit < 10; ++bit) out |= (x >> bit & 1u) << (3 * bit);
  return out;
}

float mostAllowed(std::size_t simulated) { return simulated >= 4 ? 1e30f : simulated == 2 ? kHalf : kQuarter; }

}  // namespace

std::vector<std::uint32_t> clusteredOrder(std::span<const Vec3> roots, std::span<const std::uint8_t> flags) {
  Vec3 low(1e30f), high(-1e30f);
  for (const Vec3& root : roots) {
    low = glm::min(low, root);
    high = glm::max(high, root);
  }
  const Vec3 span = high - low;
  const float scale = 1023.0f / std::max({span.x, span.y, span.z, 1e-6f});
  std::vector<std::uint32_t> keys(roots.size()), order(roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Vec3 at = (roots[i] - low) * scale;
    const auto bits = [](float x) { return spreadBits(static_cast<std::uint32_t>(std::clamp(x, 0.0f, 1023.0f))); };
    keys[i] = bits(at.x) | bits(at.y) << 1u | bits(at.z) << 2u | ((flags[i] & kStatic) ? 1u << 30u : 0u);
  }
  std::iota(order.begin(), order.end(), 0u);
  sortStably(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  // Along a cluster the blocks take turns: 0 2 1 3.
  constexpr std::size_t kBlockOf[4] = {0, 2, 1, 3};
  std::vector<std::uint32_t> out = order;
  for (std::size_t first = 0; first + kGuides <= order.size(); first += kGuides)
    for (std::size_t i = 0; i < kGuides; ++i) out[first + kBlockOf[i % 4] * kLanes + i / 4] = order[first + i];
  return out;
}

void AdaptiveDetail::reset(const GuideBlocks& guides) {
  clusters_.assign(guides.guides / kGuides, {});
  shares_.assign(clusters_.size() * kBlocks * 12, Lanes{});
  offsets_.assign(clusters_.size() * kBlocks * static_cast<std::size_t>(guides.nodes), Lanes3{});
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    const auto root = [&](std::size_t guide) { return laneOf(guides.roots[c * kBlocks + guide / kLanes].origin, guide % kLanes); };
    for (std::size_t i = 0; i < kGuides; ++i) {
      clusters_[c].radius = std::max(clusters_[c].radius, 0.5f * glm::length(root(i) - root(0)));
      for (const std::size_t leaders : {1, 2}) {
        float shares[8], sum = 0;
        for (std::size_t k = 0; k < leaders * kLanes; ++k) {
          const Vec3 apart = root(i) - root(k);
          sum += shares[k] = 1.0f / (glm::dot(apart, apart) + 1e-8f);
        }
        for (std::size_t k = 0; k < leaders * kLanes; ++k)
          shares_[(c * kBlocks + i / kLanes) * 12 + (leaders - 1) * 4 + k][i % kLanes] = shares[k] / sum;
      }
    }
  }
  takeWetness(guides);
}

void AdaptiveDetail::takeWetness(const GuideBlocks& guides) {
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    Lanes least = splat(1.0f), most = splat(0.0f);
    bool moves = true;
    for (std::size_t b = c * kBlocks; b < (c + 1) * kBlocks; ++b) {
      moves = moves && !any(guides.still[b]);
      for (std::size_t i = guides.first(b); i < guides.first(b + 1); ++i) {
        least = min(least, guides.wetness[i]);
        most = max(most, guides.wetness[i]);
      }
    }
    clusters_[c].alike = moves && largest(most) + largest(-least) < kAlike;
  }
}

Lanes3 AdaptiveDetail::led(const GuideBlocks& guides, std::size_t block, std::size_t leaders, std::size_t node) const {
  Lanes3 sum{};
  const Lanes* shares = &shares_[block * 12 + (leaders - 1) * 4];
  for (std::size_t b = 0; b < leaders; ++b) {
    const std::size_t leader = block / kBlocks * kBlocks + b, at = guides.first(leader) + node;
    const Lanes3 apart = guides.roots[leader].turnedBack(guides.positions[at] - guides.goals[at]);
    for (std::size_t k = 0; k < kLanes; ++k) sum = sum + Lanes3{splat(apart.x[k]), splat(apart.y[k]), splat(apart.z[k])} * shares[b * kLanes + k];
  }
  return sum;
}

// Whether what is to follow lies so near to where it would that it may.
bool AdaptiveDetail::merge(const GuideBlocks& guides, std::size_t cluster, std::size_t leaders) {
  const auto n = static_cast<std::size_t>(guides.nodes);
  Lanes farthest{};
  for (std::size_t b = cluster * kBlocks + leaders; b < (cluster + 1) * kBlocks; ++b)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t at = guides.first(b) + i;
      const Lanes3 offset = guides.roots[b].turnedBack(guides.positions[at] - guides.goals[at]) - led(guides, b, leaders, i);
      offsets_[b * n + i] = offset;
      farthest = max(farthest, dot(offset, offset));
    }
  return largest(farthest) < kMostOffset * kMostOffset;
}

std::size_t AdaptiveDetail::choose(const GuideBlocks& guides, std::size_t cluster, bool mayMerge) {
  Cluster& c = clusters_[cluster];
  const float motion = c.acceleration * c.radius;
  if (!mayMerge || !c.alike) {
    c.calmSteps = 0;
    return c.simulated = kBlocks;
  }
  while (motion > mostAllowed(c.simulated)) c.simulated *= 2;
  if (c.simulated == 1) return 1;
  c.calmSteps = motion < kMergeBelow * mostAllowed(c.simulated / 2) ? c.calmSteps + 1 : 0;
  if (c.calmSteps < kCalmSteps) return c.simulated;
  c.calmSteps = 0;
  if (merge(guides, cluster, c.simulated / 2)) c.simulated /= 2;
  return c.simulated;
}

void AdaptiveDetail::follow(const GuideBlocks& guides, std::size_t block, const FrameLanes& root, Lanes3* next) {
  const std::size_t n = static_cast<std::size_t>(guides.nodes), leaders = clusters_[block / kBlocks].simulated;
  for (std::size_t i = 2; i < n; ++i) {
    Lanes3& offset = offsets_[block * n + i];
    offset = offset * splat(kFade);
    next[i] = root.placed(guides.rests[guides.first(block) + i] + led(guides, block, leaders, i) + offset);
  }
}

}  // namespace fur::hair
