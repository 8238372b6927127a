#include "hair/WispGrid.h"

#include <algorithm>
#include <cmath>

namespace fur::hair {

namespace {

// A wisp is seen through: of its area that much stops what comes.
constexpr float kStops = 0.5f;

// The middle line straight between nodes, without curls.
Vec3 straightPoint(const Wisp& wisp, const ShownHair& hair, const Vec3& offset, float height) {
  const auto each = static_cast<std::size_t>(hair.nodesEach);
  const float node = height * wisp.length * static_cast<float>(hair.nodesEach - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(node), each - 2);
  const float share = node - static_cast<float>(first);
  Vec3 at = offset;
  for (std::size_t k = 0; k < 3; ++k) {
    const GuideNode* nodes = &hair.nodes[wisp.guides[k] * each + first];
    at += glm::mix(nodes[0].position, nodes[1].position, share) * (wisp.weights[static_cast<int>(k)] + wisp.magnet[static_cast<int>(k)] * height);
  }
  return at;
}

}  // namespace

void WispGrid::assign(const ShownHair& hair) {
  const std::size_t wisps = std::min(hair.wisps.size(), kMostSpots / kHeights), each = static_cast<std::size_t>(hair.nodesEach);
  std::vector<WispSpot> all;
  std::vector<float> area, reach;
  all.reserve(wisps * kHeights);
  Vec3 high(-1e30f);
  low_ = Vec3(1e30f);
  for (std::size_t w = 0; w < wisps; ++w) {
    const Wisp& wisp = hair.wisps[w];
    const Quat frame = blendFrames({hair.nodes[wisp.guides[0] * each].frame, hair.nodes[wisp.guides[1] * each].frame, hair.nodes[wisp.guides[2] * each].frame}, wisp.weights);
    const Vec3 offset = frame * wisp.offset;
    Vec3 before = straightPoint(wisp, hair, offset, 0);
    for (std::size_t k = 0; k < kHeights; ++k) {
      const float height = (static_cast<float>(k) + 1.0f) / static_cast<float>(kHeights);
      const Vec3 at = straightPoint(wisp, hair, offset, height);
      const float length = glm::length(at - before);
      all.push_back({static_cast<std::uint32_t>(w), height, at});
      area.push_back(wisp.width * length);
      reach.push_back(std::max(0.5f * wisp.width, 0.5f * length));
      low_ = glm::min(low_, at);
      high = glm::max(high, at);
      before = at;
    }
  }
  spots_.resize(all.size());
  reach_.resize(all.size());
  if (all.empty()) return;
  const Vec3 span = high - low_;
  side_ = std::max(std::max({span.x, span.y, span.z}) / static_cast<float>(kMostCells), 1e-3f);
  for (int c = 0; c < 3; ++c) cells_[c] = 1 + static_cast<int>(span[c] / side_);
  const std::size_t count = static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(cells_[2]);
  starts_.assign(count + 2, 0);
  density_.assign(count, 0.0f);
  std::vector<std::uint32_t> cellOf;
  const float perVolume = kStops * static_cast<float>(hair.wisps.size()) / (static_cast<float>(wisps) * side_ * side_ * side_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t cell = cellAt(all[i].position).value_or(0);
    cellOf.push_back(static_cast<std::uint32_t>(cell));
    ++starts_[cell + 2];
    density_[cell] += area[i] * perVolume;
  }
  for (std::size_t cell = 2; cell < starts_.size(); ++cell) starts_[cell] = static_cast<std::uint16_t>(starts_[cell] + starts_[cell - 1]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint16_t to = starts_[cellOf[i] + 1]++;
    spots_[to] = all[i];
    reach_[to] = reach[i];
  }
}

std::optional<std::size_t> WispGrid::cellAt(const Vec3& point) const {
  std::size_t cell = 0;
  if (spots_.empty()) return std::nullopt;
  for (int c = 2; c >= 0; --c) {
    const float along = std::floor((point[c] - low_[c]) / side_);
    if (!(along >= 0 && along < static_cast<float>(cells_[c]))) return std::nullopt;
    cell = cell * static_cast<std::size_t>(cells_[c]) + static_cast<std::size_t>(along);
  }
  return cell;
}

std::optional<WispSpot> WispGrid::meet(const Vec3& origin, const Vec3& direction) const {
  std::optional<WispSpot> best;
  float nearest = 0;
  for (std::size_t i = 0; i < spots_.size(); ++i) {
    const Vec3 way = spots_[i].position - origin;
    const float along = glm::dot(way, direction);
    const Vec3 aside = way - direction * along;
    if (along <= 0 || glm::dot(aside, aside) > reach_[i] * reach_[i] || (best && along > nearest)) continue;
    best = spots_[i];
    nearest = along;
  }
  return best;
}

}  // namespace fur::hair
