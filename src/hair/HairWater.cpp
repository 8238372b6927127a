#include "hair/HairWater.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"

namespace fur::hair {

namespace {

// What soaks a square model unit of wisps, seen from the side.
constexpr float kSoaks = 0.06f;
// A faster node was put where it is.
constexpr float kFastest = 40.0f;  // model units / s
// Guides of a wisp with a larger share get all of what wets it by hand.
constexpr float kMainShare = 0.5f;

// The node of a guide that lies at a spot of a wisp.
std::size_t nodeAt(const ShownHair& hair, const WispSpot& spot) {
  const float along = spot.height * hair.wisps[spot.wisp].length * static_cast<float>(hair.nodesEach - 1);
  return static_cast<std::size_t>(along + 0.5f);
}

}  // namespace

void HairWater::assign(const ShownHair& hair, std::span<const float> lengths) {
  const auto each = static_cast<std::size_t>(hair.nodesEach);
  const std::size_t guides = lengths.size();
  if (nodes_ != each || wetness_.size() != guides * each) {
    nodes_ = each;
    wetness_.assign(guides * each, 0.0f);
    drops_.assign(guides, {});
    wet_ = moves_ = false;
  }
  capacity_.assign(guides * each, 0.0f);
  std::vector<std::vector<std::uint32_t>> followers(guides);
  for (std::size_t w = 0; w < hair.wisps.size(); ++w) {
    const Wisp& wisp = hair.wisps[w];
    const float reaches = wisp.length * static_cast<float>(each - 1) + 0.5f;
    int main = 0;
    for (int k = 0; k < 3; ++k) {
      const std::size_t guide = wisp.guides[static_cast<std::size_t>(k)];
      const float segment = kSoaks * wisp.width * wisp.weights[k] * lengths[guide] / static_cast<float>(each - 1);
      for (std::size_t i = 0; i < each && static_cast<float>(i) <= reaches; ++i) capacity_[guide * each + i] += i == 0 ? 0.5f * segment : segment;
      if (wisp.weights[k] > wisp.weights[main]) main = k;
    }
    followers[wisp.guides[static_cast<std::size_t>(main)]].push_back(static_cast<std::uint32_t>(w));
  }
  followers_.clear();
  followersOf_.assign(1, 0);
  last_.assign(guides, 0);
  for (std::size_t g = 0; g < guides; ++g) {
    followers_.insert(followers_.end(), followers[g].begin(), followers[g].end());
    followersOf_.push_back(static_cast<std::uint32_t>(followers_.size()));
    for (std::size_t i = 0; i < each; ++i)
      if (capacity_[g * each + i] > 0) last_[g] = static_cast<std::uint16_t>(i);
      else wetness_[g * each + i] = 0;  // nothing grows there any more
  }
  gridStale_ = true;
  placed_ = false;
  jerks_.clear();
  moves_ = wet_;
}

void HairWater::move(std::span<const GuideNode> nodes, float seconds) {
  gridStale_ = true;
  moves_ = wet_;
  if (!wet_) return rest();
  const bool known = placed_ && seconds > 0 && positions_.size() == nodes.size();
  if (!known) {
    positions_.resize(nodes.size());
    velocities_.assign(nodes.size(), Vec3(0));
    jerks_.clear();
  } else {
    jerks_.resize(nodes.size());
  }
  const float perSecond = known ? 1.0f / seconds : 0.0f;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Vec3 velocity = (nodes[i].position - positions_[i]) * perSecond;
    if (!(glm::dot(velocity, velocity) < kFastest * kFastest)) velocity = Vec3(0);
    if (known) jerks_[i] = glm::length(velocity - velocities_[i]) * perSecond;
    velocities_[i] = velocity;
    positions_[i] = nodes[i].position;
  }
  placed_ = true;
}

const WispGrid& HairWater::grid(const ShownHair& hair) {
  if (gridStale_) grid_.assign(hair);
  gridStale_ = false;
  return grid_;
}

// What a node takes of it.
float HairWater::add(std::size_t node, float water) {
  const float room = std::max(kFull - wetness_[node], 0.0f) * capacity_[node], taken = std::min(water, room);
  if (!(taken > 0.0f)) return 0;
  wetness_[node] = std::min(wetness_[node] + taken / capacity_[node], kFull);
  wake();
  return taken;
}

float HairWater::take(const ShownHair& hair, const Vec3& from, const Vec3& way, float water) {
  float left = water;
  grid(hair).along(from, way, [&](const Vec3& at, std::span<const WispSpot> spots, float depth) {
    if (random_.uniform() >= 1.0f - portableExp(-depth)) return false;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < spots.size(); ++i) {
      const Vec3 a = spots[i].position - at, b = spots[nearest].position - at;
      if (glm::dot(a, a) < glm::dot(b, b)) nearest = i;
    }
    // What one wisp has no room for goes to those beside it.
    for (std::size_t i = 0; i < spots.size() && left > 0.0f; ++i) {
      const WispSpot& spot = spots[(nearest + i) % spots.size()];
      const Wisp& wisp = hair.wisps[spot.wisp];
      const float share = left;
      for (int k = 0; k < 3; ++k) {
        const float wanted = k == 2 ? std::min(left, share * wisp.weights.z) : share * wisp.weights[k];
        left -= add(wisp.guides[static_cast<std::size_t>(k)] * nodes_ + nodeAt(hair, spot), std::min(wanted, left));
      }
    }
    return true;
  });
  return water - left;
}

std::optional<WispSpot> HairWater::meet(const ShownHair& hair, const Vec3& origin, const Vec3& direction) { return grid(hair).meet(origin, direction); }

void HairWater::wetNear(const ShownHair& hair, const Vec3& centre, float radius, float amount) {
  std::vector<float> most(wetness_.size(), 0.0f);
  grid(hair);
  for (const WispSpot& spot : grid_.spots()) {
    const Vec3 apart = spot.position - centre;
    const float left = 1.0f - glm::dot(apart, apart) / (radius * radius);
    if (left <= 0.0f) continue;
    const Wisp& wisp = hair.wisps[spot.wisp];
    for (int k = 0; k < 3; ++k) {
      float& here = most[wisp.guides[static_cast<std::size_t>(k)] * nodes_ + nodeAt(hair, spot)];
      here = std::max(here, left * std::min(wisp.weights[k] / kMainShare, 1.0f));
    }
  }
  for (std::size_t i = 0; i < most.size(); ++i) {
    if (most[i] <= 0.0f || capacity_[i] <= 0.0f) continue;
    wetness_[i] = glm::clamp(wetness_[i] + amount * most[i], 0.0f, kFull);
    if (amount > 0.0f) wake();
    else if (i % nodes_ == drops_[i / nodes_].node) drops_[i / nodes_].water = 0;
  }
}

void HairWater::soak(float wetness) {
  for (std::size_t i = 0; i < wetness_.size(); ++i) wetness_[i] = capacity_[i] > 0.0f ? std::min(wetness, 1.0f) : 0.0f;
  for (Drop& drop : drops_) drop = {};
  wet_ = moves_ = wetness > 0.0f;
}

double HairWater::water() const {
  double sum = 0;
  if (!wet_) return sum;
  for (std::size_t i = 0; i < wetness_.size(); ++i) sum += double{wetness_[i]} * capacity_[i];
  for (const Drop& drop : drops_) sum += drop.water;
  return sum;
}

std::vector<float> HairWater::state() const {
  std::vector<float> state = wetness_;
  for (const Drop& drop : drops_) state.push_back(drop.water);
  return state;
}

void HairWater::setState(std::span<const float> state) {
  FUR_ASSERT(state.size() == stateSize(), "HairWater::setState()", "as many numbers as state() has", state.size());
  wet_ = false;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const float sound = state[i] > 0.0f ? std::min(state[i], kFull) : 0.0f;
    if (i < wetness_.size()) wetness_[i] = capacity_[i] > 0.0f ? sound : 0.0f;
    else drops_[i - wetness_.size()] = {sound, last_[i - wetness_.size()], 0};
    wet_ = wet_ || sound > 0.0f;
  }
  moves_ = wet_;
}

}  // namespace fur::hair
