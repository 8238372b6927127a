// What views show of the simulation: where its springs pull.
#include "hair/Simulation.h"

namespace fur::hair {

namespace {

// The place of a node in the frame of the segments before it: `directions` of the block from its first node on, a lane of them.
void bendOn(const RootFrame& root, std::span<const GuideNode> chain, std::span<const Lanes3> directions, std::size_t lane, std::span<Vec3> out) {
  Vec3 x = root.tangent, y = root.normal;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    // Parallel transport to the segment up to node i.
    const Vec3 to = normalizeOr(chain[i].position - chain[i - 1].position, y), sum = y + to;
    x -= sum * (glm::dot(x, to) / std::max(1.0f + glm::dot(y, to), 0.01f));
    y = to;
    const Vec3 direction = laneOf(directions[i + 1], lane);
    out[i + 1] = chain[i].position + (x * direction.x + y * direction.y + glm::cross(x, y) * direction.z) * glm::length(chain[i + 1].position - chain[i].position);
  }
}

}  // namespace

std::vector<Vec3> Simulation::references() const {
  std::vector<Vec3> out(shown_.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = shown_[i].position;
  const auto n = static_cast<std::size_t>(guides_.nodes);
  for (std::size_t slot = 0; slot < guides_.blocks * kLanes; ++slot) {
    const std::size_t block = slot / kLanes, lane = slot % kLanes, first = guides_.first(block), guide = guides_.guideAt[slot];
    if (guides_.still[block][lane]) continue;
    const RootFrame root = now_.roots[block].at(lane);
    const std::span<Vec3> chain(&out[guide * n], n);
    if (now_.values.model != Model::Spring) {
      bendOn(root, {&shown_[guide * n], n}, {&cascade_.directions[first], n}, lane, chain);
      continue;
    }
    const Vec3 z = glm::cross(root.tangent, root.normal);
    for (std::size_t i = 2; i < n; ++i) {
      const Vec3 at = laneOf(guides_.rests[first + i], lane);
      chain[i] = root.position + root.tangent * at.x + root.normal * at.y + z * at.z;
    }
  }
  return out;
}

std::vector<std::uint8_t> Simulation::simulated() const {
  std::vector<std::uint8_t> out(guides_.guides, 0);
  for (std::size_t slot = 0; slot < guides_.blocks * kLanes; ++slot)
    if (!guides_.still[slot / kLanes][slot % kLanes] && !detail_.follows(slot / kLanes)) out[guides_.guideAt[slot]] = 1;
  return out;
}

}  // namespace fur::hair
