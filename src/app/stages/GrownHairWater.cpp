// Long hair that grows, as water meets it (wet/WetHair.h, hair/HairWater.h), and what is done to it with water.
#include <algorithm>

#include "app/stages/GrownHair.h"
#include "wet/Drying.h"
#include "wet/Water.h"

namespace fur::app {

namespace {

// Changes of wetness that are seen, and that are felt: water that only dries draws the picture and wakes the hair now and then.
constexpr float kSeen = 1.0f / 256, kFelt = 1.0f / 16;
// Roots lie in the coat up to this share of their length, and are as wet as it is.
constexpr float kInCoat = 0.15f;
// Hair that holds so much looks as wet, and hangs as heavy, as hair does: more runs down it.
constexpr float kLooksSoaked = 0.65f;
// Of the flow, what droplets, the dry brush and the towel bring and take.
constexpr float kHairWetShare = 0.5f, kHairDryShare = 0.35f, kHairTowelShare = 0.5f;
constexpr float kSoakedByte = 200;  // of hair::Scalp::wetness

float farthest(std::span<const float> a, std::span<const float> b) {
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// `now` in place of `kept` where that shows.
bool follow(std::vector<float>& kept, std::span<const float> now, float least) {
  if (kept.size() == now.size() && farthest(kept, now) <= least) return false;
  kept.assign(now.begin(), now.end());
  return true;
}

}  // namespace

void GrownHair::growWater(LiveScalp& live) {
  std::vector<float> lengths;
  for (std::size_t g = 0; g < live.guides.count(); ++g) lengths.push_back(hair::lengthOf(live.guides.of(g)));
  live.water.assign(live.shown(), lengths);
}

bool GrownHair::wetnessNow(LiveScalp& live, const Inputs& inputs) {
  std::vector<float> now;
  const auto each = static_cast<std::size_t>(live.guides.nodes);
  if (!live.water.isDry())
    for (const float wetness : live.water.wetness()) now.push_back(std::min(wetness / kLooksSoaked, 1.0f));
  if (!inputs.wetness.empty()) {
    now.resize(live.guides.positions.size(), 0.0f);
    for (std::size_t g = 0; g < live.roots.size(); ++g) {
      const geometry::SurfacePoint& at = live.roots[g];
      const std::uint32_t* corner = &inputs.shape.surface().indices[std::size_t{3} * at.triangle];
      float skin = 0;
      for (int k = 0; k < 3; ++k) skin += at.weights[k] * inputs.wetness[corner[k]];
      for (std::size_t i = 0; i < each; ++i) {
        const float above = static_cast<float>(i) / (kInCoat * static_cast<float>(each - 1));
        if (above < 1.0f) now[g * each + i] = std::max(now[g * each + i], saturate(skin) * (1.0f - above));
      }
    }
  }
  const bool none = std::all_of(now.begin(), now.end(), [](float w) { return w <= 0.0f; });
  if (none) now.clear();
  follow(live.felt, now, kFelt);
  return follow(live.seen, now, kSeen);
}

bool GrownHair::isWet() const {
  return std::any_of(scalps_.begin(), scalps_.end(), [](const LiveScalp& live) { return !live.seen.empty(); });
}

double GrownHair::water() const {
  double sum = 0;
  for (const LiveScalp& live : scalps_) sum += live.water.water();
  return sum;
}

namespace {

hair::HairAir airIn(const wet::Climate& climate) {
  hair::HairAir air;
  air.dryRate = climate.dryRate * (1.0f + wet::kWindDrying * glm::length(climate.wind));
  air.blowCentre = Vec3(climate.worldFromModel * Vec4(climate.blowCentre, 1));
  air.blowRadius = climate.blowRadius;
  air.blow = climate.blow;
  return air;
}

}  // namespace

bool GrownHair::active(const wet::Climate& climate) const {
  const hair::HairAir air = airIn(climate);
  return std::any_of(scalps_.begin(), scalps_.end(), [&](const LiveScalp& live) { return live.water.active(air); });
}

float GrownHair::take(const Vec3& from, const Vec3& way, float water) {
  float left = water;
  for (LiveScalp& live : scalps_)
    if (left > 0.0f) left -= live.water.take(live.shown(), from, way, left);
  return water - left;
}

double GrownHair::step(const wet::Climate& climate, std::vector<wet::Drop>& drops) {
  static_assert(hair::HairWater::kStep == wet::Water::kStep);
  const hair::HairAir air = airIn(climate);
  std::vector<hair::HairDrop> leave;
  double dried = 0;
  for (LiveScalp& live : scalps_) dried += live.water.step(live.shown(), air, leave, wet::Water::kMostDrops - std::min(drops.size() + leave.size(), wet::Water::kMostDrops));
  for (const hair::HairDrop& drop : leave) drops.push_back({drop.position, wet::Water::dropRadius(drop.water), drop.velocity, drop.water});
  return dried;
}

void GrownHair::wetNear(const Vec3& centre, float radius, float amount) {
  const Vec3 at(worldFromModel_ * Vec4(centre, 1));
  for (LiveScalp& live : scalps_) live.water.wetNear(live.shown(), at, radius, amount);
}

void GrownHair::wetBy(const WaterStroke& stroke, const ShapeStage& shape, const geometry::SurfacePoint& at, float pressure, float height) {
  const float flow = stroke.flow * pressure;
  const auto near = [&](float amount) { wetNear(placeOf(shape, at, height), stroke.radius, amount); };
  switch (stroke.what) {
    case Command::Droplet:
    case Command::Splash: return near(kHairWetShare * flow);
    case Command::Dry: return near(-kHairDryShare * flow);
    case Command::Towel: return near(-kHairTowelShare * flow);
    case Command::Soak:
      for (LiveScalp& live : scalps_) live.water.soak(stroke.flow);
      return;
    case Command::DryOff:
      for (LiveScalp& live : scalps_) live.water.dry(stroke.flow * stroke.radius);
      return;
    default: return;
  }
}

std::optional<HairStage::Met> GrownHair::meet(const ShapeStage& shape, const Vec3& origin, const Vec3& direction, const std::optional<geometry::SurfacePoint>& hit) {
  std::optional<Met> best;
  // The hair that is rooted at the very spot may lie on it.
  const float farthest = hit ? glm::dot(shape.shownPosition(*hit) - origin, direction) : 1e9f;
  const Vec3 from(worldFromModel_ * Vec4(origin, 1)), along = Mat3(worldFromModel_) * direction;
  for (std::size_t i = 0; i < scalps_.size(); ++i) {
    LiveScalp& live = scalps_[i];
    const auto spot = live.water.meet(live.shown(), from, along);
    if (!spot) continue;
    const float distance = glm::dot(spot->position - from, along);
    if ((best && best->distance < distance) || distance > farthest) continue;
    constexpr float kReach = 1e-2f;  // wisps grow on the surface
    const hair::Wisp& wisp = live.growth.wisps[spot->wisp];
    const auto root = geometry::nearestPoint(shape.surface(), shape.query(), wisp.root, kReach, wisp.normal);
    if (root) best = Met{*root, spot->height, distance, i};
  }
  return best;
}

Vec3 GrownHair::placeOf(const ShapeStage& shape, const geometry::SurfacePoint& at, float height) const {
  const LiveScalp* nearest = nullptr;
  const hair::Wisp* wisp = nullptr;
  float least = 0;
  const Vec3 root = positionAt(shape.surface(), at);
  for (const LiveScalp& live : scalps_)
    for (const hair::Wisp& one : live.growth.wisps) {
      const float apart = glm::dot(one.root - root, one.root - root);
      if (wisp && apart >= least) continue;
      nearest = &live, wisp = &one, least = apart;
    }
  if (!wisp || height <= 0) return shape.shownPosition(at);
  const Vec3 place = hair::wispPoint(*wisp, nearest->simulation.nodes(), nearest->guides.nodes, hair::shapeOf(nearest->values), height).position;
  return Vec3(glm::inverse(worldFromModel_) * Vec4(place, 1));
}

std::span<const wet::Drop> GrownHair::withHanging(std::span<const wet::Drop> drops) {
  drops_.clear();
  for (const LiveScalp& live : scalps_)
    for (const hair::HairWater::Hanging& hanging : live.water.hanging(live.shown())) {
      const float radius = wet::Water::dropRadius(hanging.water);
      drops_.push_back({hanging.at.position - Vec3(0, 0.5f * radius, 0), radius, Vec3(0), hanging.water, 0});
    }
  if (drops_.empty()) return drops;
  drops_.insert(drops_.end(), drops.begin(), drops.end());
  return drops_;
}

// --- files ---

void GrownHair::addWetness(hair::Hairstyle& style) const {
  for (std::size_t i = 0; i < scalps_.size() && i < style.scalps.size(); ++i) {
    const hair::HairWater& water = scalps_[i].water;
    if (water.isDry() || water.wetness().size() != style.scalps[i].guides.positions.size()) continue;
    for (const float wetness : water.wetness()) style.scalps[i].wetness.push_back(static_cast<std::uint8_t>(wetness * kSoakedByte + 0.5f));
  }
}

// The wetness that the style has come with.
void GrownHair::takeWetness() {
  std::vector<float> state;
  bool wet = false;
  for (hair::Scalp& scalp : style_.scalps) {
    wet |= !scalp.wetness.empty();
    scalp.wetness.resize(scalp.guides.positions.size());
    for (const std::uint8_t wetness : std::exchange(scalp.wetness, {})) state.push_back(static_cast<float>(wetness) / kSoakedByte);
    state.resize(state.size() + scalp.guides.count());  // nothing hangs
  }
  if (wet) givenState_ = std::move(state);
}

std::vector<float> GrownHair::waterState() const {
  std::vector<float> all;
  if (std::all_of(scalps_.begin(), scalps_.end(), [](const LiveScalp& live) { return live.water.isDry(); })) return all;
  for (const LiveScalp& live : scalps_) {
    const std::vector<float> one = live.water.state();
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

void GrownHair::setWaterState(std::vector<float> state) {
  givenState_ = std::move(state);
  if (!stale_) takeState();
}

void GrownHair::takeState() {
  const auto given = std::exchange(givenState_, std::nullopt);
  if (!given) return;
  std::size_t size = 0, first = 0;
  for (const LiveScalp& live : scalps_) size += live.water.stateSize();
  for (LiveScalp& live : scalps_) {
    if (given->size() != size) {
      live.water.soak(0);
      continue;
    }
    live.water.setState(std::span(*given).subspan(first, live.water.stateSize()));
    first += live.water.stateSize();
  }
}

}  // namespace fur::app
