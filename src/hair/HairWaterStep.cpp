// What happens to water in hair within a step (HairWater.h).
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/PortableMath.h"
#include "hair/HairWater.h"

namespace fur::hair {

namespace {

// Wetness that stays where it is; what is more runs, so fast where hair is plumb.
constexpr float kClings = 0.6f, kRuns = 1.2f;  // model units / s
constexpr float kMostRuns = 0.5f;              // share of it in a step
// Water creeps along hair where wetness differs by more from node to node: a share of that in a second, faster downwards.
constexpr float kCreepsFrom = 0.08f, kCreeps = 1.5f, kCreepsDown = 6.0f;
// At the lowest node it hangs: a share in a second. Amount of a drop that is too heavy to, and of all that is let go of at once.
constexpr float kGathers = 2.5f, kFalls = 1.2e-3f, kLargest = 4e-3f;
// It hangs from some wisps, each with a third of what the one before has; the first is the next to fall.
constexpr float kHangs[] = {0.7f, 0.21f, 0.09f};
// Dry hair is so much faster than fur: at the root, and more of it to the tip, where air comes to it from all sides.
constexpr float kDriesRoot = 0.5f, kDriesTip = 1.5f;
constexpr float kDropDries = 2e-3f;  // as a drop that hangs from fur: square model units of half-wet fur that lose as much
// Harder jerks throw water out: a share in a second for as much again, of what is more than stays.
constexpr float kHolds = 30.0f;  // model units / s^2
constexpr float kThrown = 6.0f, kMostThrown = 0.4f, kStays = 0.2f;
constexpr float kSpray = 3e-4f;  // amount of a drop that flies off
constexpr float kScatters = 0.25f;  // of its speed, to all sides
constexpr float kLeast = 2e-5f;     // smaller changes of wetness in a step are none

float dries(float height) { return kDriesRoot + kDriesTip * height * height; }

}  // namespace

// As fur (wet/Drying.h), but by how thin hair is there.
double HairWater::evaporate(const ShownHair& hair, const HairAir& air, std::size_t guide) {
  const std::size_t first = guide * nodes_;
  const float toTip = 1.0f / static_cast<float>(std::max<std::size_t>(last_[guide], 1));
  double dried = 0;
  for (std::size_t i = 0; i <= last_[guide]; ++i) {
    float& wetness = wetness_[first + i];
    if (wetness <= 0.0f) continue;
    float rate = air.dryRate;
    if (air.blow > 0.0f) {
      const Vec3 apart = hair.nodes[first + i].position - air.blowCentre;
      const float left = std::max(1.0f - glm::dot(apart, apart) / (air.blowRadius * air.blowRadius), 0.0f);
      rate += air.blow * left * left;
    }
    const float loss = rate * kStep * dries(static_cast<float>(i) * toTip) * (1.4f - 0.8f * std::min(wetness, 1.0f)), after = std::max(wetness - loss, 0.0f);
    dried += (double{wetness} - after) * capacity_[first + i];
    wetness = after;
  }
  Drop& drop = drops_[guide];
  const float loss = std::min(drop.water, kDropDries * air.dryRate * kStep);
  dried += double{drop.water} - (drop.water - loss);
  drop.water -= loss;
  return dried;
}

// From node to node, the tip first: what runs makes room for what comes.
bool HairWater::run(const ShownHair& hair, std::size_t guide) {
  const std::size_t first = guide * nodes_;
  bool moves = false;
  for (std::size_t i = last_[guide]; i-- > 0;) {
    const std::size_t a = first + i, b = a + 1;
    const Vec3 way = hair.nodes[b].position - hair.nodes[a].position;
    const float length = std::max(glm::length(way), 1e-4f), fall = -way.y / length;
    const std::size_t from = fall > 0.0f ? a : b, to = fall > 0.0f ? b : a;
    const float flows = std::max(wetness_[from] - kClings, 0.0f) * std::min(kRuns * kStep * std::abs(fall) / length, kMostRuns) * capacity_[from];
    const float least = std::min(capacity_[a], capacity_[b]), apart = wetness_[from] - wetness_[to];
    const float creeps = std::max(std::abs(apart) - kCreepsFrom, 0.0f) * ((apart > 0.0f ? kCreepsDown : kCreeps) * kStep * least);
    // From `from` to `to`; back where water creeps up.
    const float wanted = flows + (apart > 0.0f ? creeps : -creeps);
    const std::size_t giver = wanted > 0.0f ? from : to, taker = wanted > 0.0f ? to : from;
    const float goes = std::min({std::abs(wanted), wetness_[giver] * capacity_[giver], (kFull - wetness_[taker]) * capacity_[taker]});
    if (goes < kLeast * least) continue;
    wetness_[giver] = std::max(wetness_[giver] - goes / capacity_[giver], 0.0f);
    wetness_[taker] = std::min(wetness_[taker] + goes / capacity_[taker], kFull);
    moves = true;
  }
  return moves;
}

// What does not cling at nodes from which no way leads down goes into the drop.
bool HairWater::gather(const ShownHair& hair, std::size_t guide) {
  const std::size_t first = guide * nodes_, last = last_[guide];
  Drop& drop = drops_[guide];
  bool moves = false;
  for (std::size_t i = 0; i <= last && drop.water < kLargest; ++i) {
    const float more = wetness_[first + i] - kClings;
    const float height = hair.nodes[first + i].position.y;
    if (more <= kLeast || (i > 0 && hair.nodes[first + i - 1].position.y < height) || (i < last && hair.nodes[first + i + 1].position.y < height)) continue;
    const float after = wetness_[first + i] - more * (kGathers * kStep);
    drop.water += (wetness_[first + i] - after) * capacity_[first + i];
    drop.node = static_cast<std::uint16_t>(i);
    wetness_[first + i] = after;
    moves = true;
  }
  return moves;
}

WispSpot HairWater::dropSpot(const ShownHair& hair, std::size_t guide, std::uint32_t which) const {
  const std::uint32_t from = followersOf_[guide], count = followersOf_[guide + 1] - from;
  const Drop& drop = drops_[guide];
  if (count == 0) return {0, 0, hair.nodes[guide * nodes_ + drop.node].position};
  WispSpot spot{followers_[from + (drop.chosen + which) % count], 0, {}};
  const Wisp& wisp = hair.wisps[spot.wisp];
  spot.height = drop.node >= last_[guide] ? 0.98f : std::min(static_cast<float>(drop.node) / (static_cast<float>(nodes_ - 1) * wisp.length), 0.98f);
  spot.position = wispPoint(wisp, hair.nodes, hair.nodesEach, hair.shape, spot.height).position;
  return spot;
}

void HairWater::drip(const ShownHair& hair, std::size_t guide, float share, std::vector<HairDrop>& drops) {
  Drop& drop = drops_[guide];
  const std::size_t node = guide * nodes_ + drop.node;
  HairDrop out{dropSpot(hair, guide, 0).position, jerks_.empty() ? Vec3(0) : velocities_[node], share * drop.water};
  // Down into the skin where hair stands on it.
  if (drop.node == 0) out.velocity += hair.nodes[node].frame * Vec3(0, -1, 0);
  drops.push_back(out);
  drop.water -= out.water;
  ++drop.chosen;
}

bool HairWater::throwOut(const ShownHair& hair, std::size_t guide, std::vector<HairDrop>& drops) {
  const std::size_t first = guide * nodes_;
  Drop& drop = drops_[guide];
  bool moves = false;
  for (std::size_t i = 1; i <= last_[guide]; ++i) {
    const float over = jerks_[first + i] / kHolds - 1.0f, more = wetness_[first + i] - kStays;
    if (over <= 0.0f || more <= kLeast || drop.water >= kLargest) continue;
    const float after = wetness_[first + i] - more * std::min(over * (kThrown * kStep), kMostThrown);
    drop.water += (wetness_[first + i] - after) * capacity_[first + i];
    drop.node = static_cast<std::uint16_t>(i);
    wetness_[first + i] = after;
    moves = true;
  }
  if (!moves || drop.water < kSpray) return moves;
  drip(hair, guide, 1, drops);
  Vec3& velocity = drops.back().velocity;
  // In braces: their order is the same with every compiler.
  const Vec3 aside{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
  velocity += aside * (kScatters * glm::length(velocity));
  return true;
}

double HairWater::step(const ShownHair& hair, const HairAir& air, std::vector<HairDrop>& drops, std::size_t most) {
  if (!active(air)) return 0;
  double dried = 0;
  bool moves = false, wet = false;
  const std::size_t guides = drops_.size(), end = drops.size() + most;
  ++steps_;
  for (std::size_t k = 0; k < guides; ++k) {
    // Another guide is the first each time, for when there is no room for all drops.
    const std::size_t guide = (k + steps_) % guides;
    const auto nodes = std::span(wetness_).subspan(guide * nodes_, last_[guide] + std::size_t{1});
    if (drops_[guide].water <= 0.0f && std::all_of(nodes.begin(), nodes.end(), [](float w) { return w <= 0.0f; })) continue;
    wet = true;
    dried += evaporate(hair, air, guide);
    moves |= run(hair, guide);
    moves |= gather(hair, guide);
    if (drops.size() >= end) continue;
    const float share = drops_[guide].node == 0 ? 1.0f : kHangs[0];
    if (share * drops_[guide].water > (drops_[guide].node == 0 ? kSpray : kFalls)) drip(hair, guide, share, drops), moves = true;
    else if (!jerks_.empty()) moves |= throwOut(hair, guide, drops);
  }
  moves_ = moves || !jerks_.empty();
  wet_ = wet;
  return dried;
}

void HairWater::dry(float drying) {
  // The long time of short steps: d(1.4 - 0.8 w) = 0.8 (1.4 - 0.8 w) dt.
  wet_ = false;
  for (std::size_t i = 0; i < wetness_.size(); ++i) {
    if (wetness_[i] <= 0.0f) continue;
    const std::size_t guide = i / nodes_;
    const float height = static_cast<float>(i % nodes_) / static_cast<float>(std::max<std::size_t>(last_[guide], 1));
    const float grows = portableExp(std::min(0.8f * drying * dries(height), 20.0f));
    wetness_[i] = std::clamp((1.4f - (1.4f - 0.8f * std::min(wetness_[i], 1.0f)) * grows) / 0.8f, 0.0f, wetness_[i]);
    wet_ = wet_ || wetness_[i] > 0.0f;
  }
  for (Drop& drop : drops_) {
    drop.water = std::max(drop.water - kDropDries * drying, 0.0f);
    wet_ = wet_ || drop.water > 0.0f;
  }
  moves_ = wet_;
}

std::vector<HairWater::Hanging> HairWater::hanging(const ShownHair& hair) const {
  constexpr float kSeen = 2e-4f;
  std::vector<Hanging> out;
  for (std::size_t g = 0; wet_ && g < drops_.size(); ++g)
    for (std::uint32_t k = 0; k < std::size(kHangs); ++k)
      if (const float water = kHangs[k] * drops_[g].water; water > kSeen) out.push_back({water, dropSpot(hair, g, k)});
  return out;
}

}  // namespace fur::hair
