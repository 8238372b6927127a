// The drops of Water.h, what they fall on, and the tools: all that is done once a drop or once a call.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Fnv1a.h"
#include "core/PortableMath.h"
#include "core/Random.h"
#include "wet/Clump.h"
#include "wet/Drying.h"
#include "wet/Water.h"

namespace fur::wet {

namespace {

constexpr float kRate = Water::kStep;

// Depth of what soaked fur holds on a square unit, which makes amounts into sizes of drops.
constexpr float kDepth = 0.004f;
constexpr std::size_t kMostHanging = 256;
// Amount that is too heavy to hang, at most, and the least of it that is, by place, as a share.
constexpr float kFalls = 1.6e-3f, kLeastHeld = 0.25f;
// Of a drop that hangs: how far up the wet strands, and how many of its radii below their tips. The strands that hold it hide some: it is seen as
// so much smaller.
constexpr float kHangsAt = 0.75f, kHangsBelow = 0.6f, kHangsSmaller = 0.6f;
// Where the tip of a strand is that is combed as far as strands are: a share of its length aside, and so much lower than one that stands.
constexpr float kTipAside = 0.51f, kTipLower = 0.21f;
constexpr float kGravity = 9.0f, kDrag = 0.9f;  // model radii a second squared; share of its speed that air takes in one
constexpr float kLost = 8.0f;                   // farther than that a drop is gone
constexpr float kTakes = 1.0f;                  // amount that a square unit of ground takes up

// Rain is densest over the model and thins out over the ground round it.
constexpr float kRainReach = 1.3f, kRainHeight = 1.7f;
constexpr float kRainDrops = 720.0f, kRainDrop = 1.6e-3f, kRainSpeed = 5.0f;
constexpr float kFling = 2.6f;  // model radii a second
// Of skin that moves by itself: its speed that throws off all that can be, in model radii a second; the share of that below which it
// holds its water; how much of the speed goes aside.
constexpr float kThrows = 1.4f, kHolds = 0.15f, kAside = 0.3f;
// Chance a step that a wet block lets go of water; where the skin moves by itself of more at a time, in fewer drops.
constexpr float kLetsGo = 0.08f, kLetsGoBySkin = 0.05f, kMoreBySkin = 1.5f;
// A jet has air in it: its radius is so many times that of its water. Seconds that it takes to fall apart by 1.
constexpr float kJetWidth = 1.7f, kFallsApart = 0.2f;
// Of what a drop leaves to be seen: seconds that a ring or spray lasts; how far a ring widens on dry ground, and further on wet;
// pieces of spray that a jet throws, their radius, and their share of its speed.
constexpr float kRing = 0.35f, kCrown = 0.03f, kWave = 0.1f, kSpray = 0.2f, kSprayRadius = 0.009f, kSpraySpeed = 0.12f;
constexpr int kSprayDrops = 8;

// Where a place of the skin is shown, and which way it faces there; model space.
std::pair<Vec3, Vec3> shownAt(const WetSurface& skin, const SurfaceTexels::Place& place) {
  if (skin.positions.empty()) return {place.position, place.normal};
  const geometry::SurfacePoint at{place.triangle, skin.wetting.atlas().weightsAt(skin.surface, place.triangle, place.texel), 0};
  return {valueAt(skin.surface, at, skin.positions), normalizeOr(valueAt(skin.surface, at, skin.normals), place.normal)};
}

// What can hang there: no two drops are alike.
float heaviestAt(std::uint32_t place) { return kFalls * glm::mix(kLeastHeld, 1.0f, chanceOf(place, 0)); }

// Of the skin there, model radii a second.
Vec3 velocityAt(const WetSurface& skin, const SurfaceTexels::Place& place) {
  if (skin.before.empty() || !(skin.seconds > 0)) return Vec3(0);
  const geometry::SurfacePoint at{place.triangle, skin.wetting.atlas().weightsAt(skin.surface, place.triangle, place.texel), 0};
  return (valueAt(skin.surface, at, skin.positions) - valueAt(skin.surface, at, skin.before)) / skin.seconds;
}

}  // namespace

// --- drops --------------------------------------------------------------------------------------

float Water::dropRadius(float amount) {
  return amount > 0.0f ? portableExp(portableLog(amount * (kDepth * 0.75f / kPi)) / 3.0f) : 0.0f;
}

// Not side by side: those would be one, and each drinks from its neighbours.
void Water::hangDrops(std::uint32_t index) {
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  for (std::uint32_t i = block.first; i < block.end && hanging_ < kMostHanging && drops_.size() < kMostDrops; ++i) {
    if (film_[i] <= kHangsFrom || glm::dot(texels_->places()[i].normal, down_) <= 0.25f) continue;
    const auto has = [&](std::uint32_t at) { return at != SurfaceTexels::kNone && hasDrop_[at]; };
    const auto& links = texels_->links()[i];
    if (has(i) || std::any_of(links.begin(), links.end(), has)) continue;
    drops_.push_back({Vec3(0), 0, Vec3(0), 0, i});
    hasDrop_[i] = 1;
    ++hanging_;
  }
}

// Hanging drops drink the film round them until they are too heavy.
void Water::feedHanging(const WetSurface& skin, WetnessMask& mask, const Climate& climate) {
  if (hanging_ == 0) return;
  const auto& places = texels_->places();
  std::size_t kept = 0;
  for (std::size_t d = 0; d < drops_.size(); ++d) {
    Drop drop = drops_[d];
    if (drop.hangs()) {
      const SurfaceTexels::Place& place = places[drop.place];
      const auto drink = [&](std::uint32_t from) {
        if (from == SurfaceTexels::kNone || film_[from] <= kCling + kLeast) return;
        const float left = film_[from] - 0.3f * (film_[from] - kCling);
        drop.water += (film_[from] - left) * places[from].area;
        store(skin, mask, from, held_[from], left);
        flags_[texels_->blockOf(from)] |= kMoving;
      };
      drink(drop.place);
      for (const std::uint32_t link : texels_->links()[drop.place]) drink(link);
      const float dries = std::min(drop.water, kDropDrying * climate.dryRate * kRate);
      accounts_.evaporated += double{drop.water} - (drop.water - dries);
      drop.water -= dries;
      drop.radius = kHangsSmaller * dropRadius(drop.water);
      // From the tips, as far as wet fur stands.
      const auto [root, normal] = shownAt(skin, place);
      Vec3 lay = lay_.empty() ? Vec3(0) : meanAt(skin, place, lay_);
      lay -= normal * glm::dot(lay, normal);
      lay *= kTipAside;
      const float stands = (1.0f - kTipLower / (kTipAside * kTipAside) * glm::dot(lay, lay)) * standsTo(held_[drop.place], glm::length(lay));
      const float length = climate.furLength * (lengths_.empty() ? 1.0f : meanAt(skin, place, lengths_));
      const Vec3 at = Vec3(climate.worldFromModel * Vec4(root + kHangsAt * length * (lay + normal * stands) + kHangsBelow * drop.radius * down_, 1));
      changed_ |= at != drop.position;
      drop.position = at;
      if (drop.water > heaviestAt(drop.place) || glm::dot(normal, down_) < 0.0f || climate.shaking > 0.0f) {
        hasDrop_[drop.place] = 0;
        --hanging_;
        drop.radius /= kHangsSmaller;
        drop.place = Drop::kNoPlace;
        drop.velocity = Vec3(0);
      } else if (drop.water <= 0.0f) {
        hasDrop_[drop.place] = 0;
        --hanging_;
        continue;
      }
    }
    drops_[kept++] = drop;
  }
  drops_.resize(kept);
}

void Water::fall(const WetSurface& skin, const Climate& climate) {
  if (drops_.size() == hanging_) return;
  changed_ = true;
  const Mat3 toWorld(climate.worldFromModel);
  const Mat3 toModel = glm::transpose(toWorld);
  const Vec3 middle(climate.worldFromModel[3]);
  const geometry::SurfaceQuery& shown = skin.shown ? *skin.shown : skin.query;
  std::size_t kept = 0;
  for (std::size_t d = 0; d < drops_.size(); ++d) {
    Drop drop = drops_[d];
    if (drop.splash > 0.0f) {
      const bool flies = drop.velocity != Vec3(0);
      if ((drop.splash += kRate / (flies ? kSpray : kRing)) > 1.0f) continue;
      if (flies) drop.velocity.y -= kGravity * kRate;
      drop.position += drop.velocity * kRate;
    } else if (!drop.hangs()) {
      if (drop.jet > 1.0f) drop.jet = std::max(drop.jet - kRate / kFallsApart, 1.0f);
      drop.velocity += (Vec3(0, -kGravity, 0) + (climate.wind - drop.velocity) * kDrag) * kRate;
      const Vec3 way = drop.velocity * kRate;
      const auto hit = shown.castRay(toModel * (drop.position - middle), toModel * way, nullptr, 1.0f);
      const Vec3 to = drop.position + way;
      if (skin.hair && meetHair(*skin.hair, drop, hit ? way * hit->distance : way)) continue;
      if (hit) {
        landed_.push_back(hit->triangle);
        const Vec3 at = positionAt(skin.surface, *hit), normal = normalAt(skin.surface, *hit);
        splash(at, normal, (drop.jet > 0.0f ? 1.6f : 1.0f) * climate.clumpSize, drop.water, texels_->placeAt(atlasAt(skin.surface, *hit)));
        if (drop.jet > 0.0f) spray(drop.position + way * hit->distance, toWorld * normal, kSpraySpeed * glm::length(drop.velocity));
        continue;
      }
      if (to.y <= climate.groundHeight) {
        // A crown where it is dry, a wave where water stands.
        drop.radius = kCrown + kWave * wetGround(to, drop.water);
        drop.position = Vec3(to.x, climate.groundHeight, to.z);
        drop.velocity = Vec3(0);
        drop.water = drop.jet = 0;
        drop.splash = kRate;
      } else if (glm::dot(to, to) > kLost * kLost || !std::isfinite(glm::dot(to, to))) {
        accounts_.dripped += drop.water;
        continue;
      } else {
        drop.position = to;
      }
    }
    drops_[kept++] = drop;
  }
  drops_.resize(kept);
}

// Hair on the way takes of the drop; true: all of it.
bool Water::meetHair(WetHair& hair, Drop& drop, const Vec3& way) {
  const float taken = hair.take(drop.position, way, drop.water);
  if (!(taken > 0.0f)) return false;
  accounts_.hair += taken;
  drop.water -= taken;
  drop.radius = dropRadius(drop.water);
  if (drop.jet > 0.0f) spray(drop.position + way, Vec3(0, 1, 0), kSpraySpeed * glm::length(drop.velocity));
  drop.jet = 0;
  return !(drop.water > 0.0f);
}

// What is seen to fly off where a jet comes down; its water stays there.
void Water::spray(const Vec3& at, const Vec3& normal, float speed) {
  for (int k = 0; k < kSprayDrops && drops_.size() < kMostDrops; ++k) {
    const Vec3 off{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
    drops_.push_back({at, kSprayRadius, speed * (normal + off), 0, Drop::kNoPlace, 0, kRate});
  }
}

// Lays an amount on the places within the radius, or on the nearest.
void Water::splash(const Vec3& centre, const Vec3& normal, float radius, float amount, std::uint32_t nearest) {
  float area = 0;
  const auto& places = texels_->places();
  texels_->forPlacesWithin(centre, normal, radius, [&](std::uint32_t i) { area += places[i].area; });
  if (area > 0.0f) {
    texels_->forPlacesWithin(centre, normal, radius, [&](std::uint32_t i) { give(i, amount * (places[i].area / area)); });
  } else if (nearest != SurfaceTexels::kNone) {
    give(nearest, amount);
  } else {
    accounts_.dripped += amount;  // on a spot that has no texel
  }
}

// How much stands there then, 1 at most.
float Water::wetGround(const Vec3& at, float amount) {
  accounts_.dripped += amount;
  // On the four cells round it, by how near they are.
  constexpr float kCell = 2.0f * kGroundReach / kGroundCells;
  const Vec2 in = Vec2(at.x, at.z) / kCell + (0.5f * kGroundCells - 0.5f), low = glm::floor(in), share = in - low;
  if (!(low.x >= 0 && low.y >= 0 && low.x < kGroundCells - 1 && low.y < kGroundCells - 1)) return 0;
  float* cell = &puddles_[static_cast<std::size_t>(low.y) * kGroundCells + static_cast<std::size_t>(low.x)];
  amount /= kCell * kCell;
  for (int k = 0; k < 4; ++k)
    cell[(k >> 1) * kGroundCells + (k & 1)] += amount * (k & 1 ? share.x : 1 - share.x) * (k >> 1 ? share.y : 1 - share.y);
  ++groundRevision_;
  groundWet_ = groundMoves_ = true;
  return std::min(*cell, 1.0f);
}

// What the ground does not take up spreads over it, and all of it dries.
float Water::seepGround(float dries) {
  groundWet_ = groundMoves_ = false;
  const std::vector<float> before = puddles_;
  constexpr std::size_t kRow = kGroundCells, kLast = kRow * (kRow - 1) - 1;
  for (std::size_t i = kRow + 1; i < kLast; ++i) {
    const float much = 0.1f * std::max(puddles_[i] - kTakes, 0.0f);
    if (much < 4 * kLeast) continue;
    groundMoves_ = true;
    puddles_[i] -= 4 * much;
    for (const std::size_t there : {i - 1, i + 1, i - kRow, i + kRow}) puddles_[there] += much;
  }
  float most = 0;
  for (std::size_t i = 0; i < puddles_.size(); ++i) {
    puddles_[i] = std::max(puddles_[i] - dries, 0.0f);
    groundWet_ |= puddles_[i] > 0.0f;
    most = std::max(most, std::abs(seenOfPuddle(puddles_[i]) - seenOfPuddle(before[i])));
  }
  ++groundRevision_;
  return most;
}

void Water::rain(const Climate& climate) {
  if (!(climate.rain > 0.0f)) return;
  const Vec3 middle(climate.worldFromModel[3]);
  for (rainDue_ += climate.rain * kRainDrops * kRate; rainDue_ >= 1.0f; rainDue_ -= 1.0f) {
    const float angle = random_.uniform(0, 2 * kPi), reach = kRainReach * std::sqrt(-portableLog(1.0f - random_.uniform()));
    const float amount = kRainDrop * random_.uniform(0.5f, 1.5f);
    // Where it would hit in this wind.
    const Vec3 over(reach * portableCos(angle), kRainHeight, reach * portableSin(angle));
    if (drops_.size() >= kMostDrops) continue;
    drops_.push_back({middle + over - climate.wind * 0.3f, dropRadius(amount), Vec3(0, -kRainSpeed, 0) + climate.wind, amount});
    accounts_.rained += amount;
  }
}

// Most of a block's film, and of what is easily shaken out, times the share.
float Water::letGo(const WetSurface& skin, WetnessMask& mask, std::uint32_t b, float share) {
  const auto& places = texels_->places();
  const SurfaceTexels::Block& block = texels_->blocks()[b];
  const float filmLeft = 1 - 0.6f * share, ofHeld = 0.25f * share;
  float amount = 0;
  for (std::uint32_t i = block.first; i < block.end; ++i) {
    const float film = filmLeft * film_[i], held = held_[i] > 0.3f ? held_[i] - ofHeld * (held_[i] - 0.3f) : held_[i];
    const float lost = (film_[i] - film) + (held_[i] - held);
    if (lost <= kLeast) continue;
    amount += lost * places[i].area;
    store(skin, mask, i, held, film);
  }
  if (amount > 0.0f) flags_[b] |= kMoving;
  return amount;
}

// Out of the fur at a place: as the skin moves there, or where that is not known, away from it.
void Water::fling(const WetSurface& skin, const Climate& climate, const SurfaceTexels::Place& from, float amount) {
  const auto [root, normal] = shownAt(skin, from);
  const Vec3 off{random_.uniform(-1, 1), random_.uniform(-0.5f, 1), random_.uniform(-1, 1)};
  const float strength = random_.uniform(0.6f, 1.2f);
  const Mat3 toWorld(climate.worldFromModel);
  const Vec3 moves = velocityAt(skin, from);
  const Vec3 velocity = skin.before.empty() ? (normal + 0.5f * off) * (kFling * climate.shaking * strength)
                                            : moves * (0.5f + 0.5f * strength) + (normal + 0.5f * off) * (kAside * glm::length(moves));
  launch(Vec3(climate.worldFromModel * Vec4(root + climate.furLength * normal, 1)), toWorld * velocity, amount);
  accounts_.painted -= amount;
}

// Some blocks a step let go of their water; of a model that moves by itself those that move fast.
void Water::shake(const WetSurface& skin, WetnessMask& mask, const Climate& climate) {
  if (!(climate.shaking > 0.0f)) return;
  const float chance = (skin.before.empty() ? kLetsGo : kLetsGoBySkin) * climate.shaking;
  for (std::uint32_t b = 0; b < flags_.size(); ++b) {
    if (!(flags_[b] & kWet) || random_.uniform() >= chance || drops_.size() >= kMostDrops) continue;
    const SurfaceTexels::Block& block = texels_->blocks()[b];
    const std::uint32_t first = block.first + static_cast<std::uint32_t>(random_.uniform() * static_cast<float>(block.end - block.first));
    const SurfaceTexels::Place& from = texels_->places()[first];
    const float share = skin.before.empty() ? 1 : kMoreBySkin * saturate(glm::length(velocityAt(skin, from)) / kThrows);
    if (share < kHolds) continue;
    if (const float amount = letGo(skin, mask, b, share); amount > 0.0f) fling(skin, climate, from, amount);
  }
}

// --- tools --------------------------------------------------------------------------------------

void Water::pour(const WetSurface& skin, WetnessMask& mask, const Vec3& centre, const Vec3& normal, float radius, float amount) {
  if (!ready_ || !(amount > 0.0f)) return;
  notice(skin, mask);
  const auto hit = nearestPoint(skin.surface, skin.query, centre, radius, normal);
  if (!hit) return;
  accounts_.painted += amount;
  splash(centre, normal, radius, amount, texels_->placeAt(atlasAt(skin.surface, *hit)));
  for (std::uint32_t b = 0; b < flags_.size(); ++b)
    if (flags_[b] & kReceived) receive(skin, mask, nullptr, b);
  touch(mask);
}

Vec3 Water::velocityFor(const Vec3& way, float seconds, const Vec3& wind) {
  const Vec3 straight = way / seconds;
  return straight - 0.5f * (seconds + kRate) * (Vec3(0, -kGravity, 0) + (wind - straight) * kDrag);
}

void Water::launch(const Vec3& position, const Vec3& velocity, float amount, float jet) {
  if (!(amount > 0.0f) || drops_.size() >= kMostDrops) return;
  accounts_.painted += amount;
  drops_.push_back({position, (jet > 0.0f ? kJetWidth : 1.0f) * dropRadius(amount), velocity, amount, Drop::kNoPlace, jet});
}

void Water::wipe(const WetSurface& skin, WetnessMask& mask, const Vec3& centre, const Vec3& normal, float radius, float share) {
  if (!ready_) return;
  notice(skin, mask);
  texels_->forPlacesWithin(centre, normal, radius, [&](std::uint32_t i) {
    const float left = std::max(held_[i] - share, 0.0f);
    if (left == held_[i] && film_[i] == 0.0f) return;
    const SurfaceTexels::Place& place = texels_->places()[i];
    accounts_.removed += (double{held_[i]} - left + film_[i]) * place.area;
    store(skin, mask, i, left, 0);
    flags_[texels_->blockOf(i)] |= kMoving;
  });
  touch(mask);
}

void Water::clear() {
  for (const Drop& drop : drops_) accounts_.removed += drop.water;
  drops_.clear();
  hanging_ = 0;
  std::fill(hasDrop_.begin(), hasDrop_.end(), std::uint8_t{0});
  for (float& amount : incoming_) accounts_.removed += std::exchange(amount, 0.0f);
  setGround({});
}

void Water::setGround(const std::vector<float>& puddles) {
  std::fill(std::copy(puddles.begin(), puddles.end(), puddles_.begin()), puddles_.end(), 0.0f);
  groundWet_ = groundMoves_ = !puddles.empty();
  ++groundRevision_;
}

Accounts Water::accounts() const {
  Accounts sum = accounts_;
  for (std::size_t i = 0; texels_ && i < texels_->places().size() && i < held_.size(); ++i) {
    const double area = texels_->places()[i].area;
    sum.held += held_[i] * area;
    sum.film += film_[i] * area + incoming_[i];
  }
  for (const Drop& drop : drops_) sum.drops += drop.water;
  return sum;
}

void Water::save(ByteWriter& to) const {
  // What is in the mask counts as painted where it is noticed.
  Accounts without = accounts_;
  const Accounts all = accounts();
  without.painted -= all.held + all.film + all.hair;
  without.hair = 0;
  for (const float amount : incoming_) without.painted += amount;
  to(drops_, puddles_, incoming_, groundWet_, groundMoves_, random_, rainDue_, steps_, without);
}

void Water::restore(ByteReader& from) {
  reset();
  std::uint8_t groundWet = 0, groundMoves = 0;  // a bool has two values, a byte of a file more
  from(drops_, puddles_, incoming_, groundWet, groundMoves, random_, rainDue_, steps_, accounts_);
  groundWet_ = groundWet != 0;
  groundMoves_ = groundMoves != 0;
  drops_.resize(std::min(drops_.size(), kMostDrops));
  if (!isSound()) from.fail();
}

bool Water::isSound() const {
  const auto bounded = [](double value) { return std::abs(value) <= double{kMostAmount}; };
  const Accounts& a = accounts_;
  const double lost = a.dripped + a.evaporated + a.removed;
  return rainDue_ >= 0 && rainDue_ <= 1 && std::isfinite(a.painted + a.rained + a.drops + lost) &&
         std::all_of(puddles_.begin(), puddles_.end(), bounded) && std::all_of(incoming_.begin(), incoming_.end(), bounded) &&
         std::all_of(drops_.begin(), drops_.end(), [&](const Drop& drop) {
           const Vec3 &p = drop.position, &v = drop.velocity;
           const float numbers[] = {p.x, p.y, p.z, drop.radius, v.x, v.y, v.z, drop.water, drop.jet, drop.splash};
           return std::all_of(std::begin(numbers), std::end(numbers), bounded);
         });
}

std::uint64_t Water::hash(const WetnessMask& mask) const {
  Fnv1a hash;
  hash.add(mask.hash());
  hash.addAll(mask.film());
  hash.addAll(drops_);
  hash.addAll(puddles_);
  return hash.value();
}

}  // namespace fur::wet
