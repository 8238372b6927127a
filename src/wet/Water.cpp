#include "wet/Water.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/PortableMath.h"

namespace fur::wet {

namespace {

constexpr float kRate = Water::kStep;
// Blocks run by turns, a half of them in each step: water in fur is slow. All dry in every fourth, which looks
// continuous, and between which nothing has changed where water only dries: kDryingTurns.
constexpr std::uint32_t kTurns = 2;
constexpr float kTurnTime = kRate * kTurns;

// The film: kCling of it clings, thicker films run faster, and where it is deeper than kPool it also levels out.
constexpr float kPool = 1.2f, kFastest = 1.5f;
constexpr float kSpeed = 1.1f;        // model radii a second down a wall, of a film of 1
constexpr float kMostLeaves = 0.5f;   // share of a place's film that leaves in a turn, times kFastest
constexpr float kAbsorb = 5.0f;       // share of the film that fur takes up in a second
// Fur wetter than kField lets go of what is above, this much slower than a film runs.
constexpr float kField = 0.75f, kSeep = 0.12f;
// Fur so wet draws no more from its neighbours: what it let go of would only come back.
constexpr float kFull = kField - 0.05f;
// Along strands water creeps: from wetter to drier fur, down to a difference of kWickRest, and not out of fur that is
// only damp.
constexpr float kWick = 1.5e-4f, kWickRest = 0.02f, kDamp = 0.3f, kMostWicks = 0.1f;
// How far combed fur turns what runs, and how much better water creeps along it than across.
constexpr float kTurn = 0.7f, kAlong = 3.0f;

constexpr float kHangs = 0.4f;  // film that a drop hangs from
constexpr std::size_t kMostHanging = 256;

// 0..1, of two numbers.
float chanceOf(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a * 0x9e3779b1u ^ b * 0x85ebca77u;
  x = (x ^ x >> 15) * 0x2c1b3c6du;
  x = (x ^ x >> 12) * 0x297a2d39u;
  return static_cast<float>((x ^ x >> 15) >> 8) * (1.0f / 16777216.0f);
}

}  // namespace

bool Water::prepare(const Ground& ground, std::uint32_t places) {
  if (ready_) return true;
  if (!texels_) texels_ = std::make_unique<SurfaceTexels>(ground.surface, ground.wetting.atlas());
  if (!texels_->link(ground.surface, ground.query, places)) return false;
  const std::size_t count = texels_->places().size();
  for (auto* values : {&held_, &film_, &incoming_}) values->assign(count, 0.0f);
  ways_.assign(count, {});
  areas_.clear();
  for (const SurfaceTexels::Place& place : texels_->places()) areas_.push_back(place.area);
  hasDrop_.assign(count, 0);
  flags_.assign(texels_->blocks().size(), 0);
  stored_.assign(flags_.size(), 0);
  aimed_.assign(flags_.size(), 0);
  aim_ = 1;
  puddles_.assign(std::size_t{kGroundCells} * kGroundCells, 0.0f);
  seen_ = 0xffffffffu;
  return ready_ = true;
}

void Water::setLay(std::vector<Vec3> lay) {
  if (lay == lay_) return;
  lay_ = std::move(lay);
  ++aim_;
}

// What others have changed in the mask since the last step.
void Water::notice(const Ground& ground, WetnessMask& mask) {
  if (mask.revision() == seen_) return;
  const bool first = seen_ == 0xffffffffu;
  seen_ = mask.revision();
  double gain = 0;
  const auto& places = texels_->places();
  const auto& texels = mask.texels();
  for (std::uint32_t b = 0; b < flags_.size(); ++b) {
    const SurfaceTexels::Block& block = texels_->blocks()[b];
    for (std::uint32_t i = block.first; i < block.end; ++i) {
      const std::uint32_t at = places[i].texel;
      const float held = texels[at].w, film = mask.filmAt(at);
      if (held == held_[i] && film == film_[i]) continue;
      gain += (double{held} - held_[i] + film - film_[i]) * places[i].area;
      flags_[b] = kWet | kMoving;
      store(ground, mask, i, held, film);
    }
    // Paint meets gutters where it may, which is not always where it meets what they repeat.
    for (std::uint32_t i = block.first; i < block.end; ++i)
      texels_->forMirrors(i, [&](std::uint32_t mirror) {
        if (texels[mirror] != texels[places[i].texel]) store(ground, mask, i, held_[i], film_[i]);
      });
  }
  for (std::uint32_t at = 0; at < texels.size(); ++at)
    if (texels_->placeOf(at) == SurfaceTexels::kNone && (texels[at].w > 0.0f || mask.filmAt(at) > 0.0f)) mask.set(at, Vec4(0), 0);
  (gain > 0 || first ? accounts_.painted : accounts_.removed) += gain > 0 || first ? gain : -gain;
}

// How the water of a block runs and creeps: by gravity, the fur and the shape of the skin.
void Water::aim(const Ground& ground, std::uint32_t index) {
  aimed_[index] = aim_;
  const auto& places = texels_->places();
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  for (std::uint32_t i = block.first; i < block.end; ++i) {
    const SurfaceTexels::Place& place = places[i];
    Vec3 lay(0);
    if (!lay_.empty())
      for (std::size_t k = 0; k < 3; ++k) lay += lay_[ground.surface.indices[std::size_t{3} * place.triangle + k]] / 3.0f;
    lay -= place.normal * glm::dot(lay, place.normal);
    // Down along the skin, turned towards the line in which the strands lie.
    Vec3 down = down_ - place.normal * glm::dot(down_, place.normal);
    const float laid = glm::dot(lay, lay);
    if (laid > 1e-6f) down += kTurn * (lay * (glm::dot(lay, down) / std::sqrt(laid)) - down * std::sqrt(laid));
    Ways& ways = ways_[i];
    ways = {{i, i, i, i}, {}, {}};
    float sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t there = texels_->links()[i][k];
      if (there == SurfaceTexels::kNone) continue;
      ways.to[k] = there;
      const Vec3 way = places[there].position - place.position;
      const float squared = glm::dot(way, way);
      if (!(squared > 1e-12f)) continue;
      // Water finds its way between the locks, not straight down.
      const float chance = 0.3f + 1.4f * chanceOf(place.texel, static_cast<std::uint32_t>(k));
      ways.runs[k] = kSpeed * kTurnTime * chance * std::max(glm::dot(down, way), 0.0f) / squared;
      sum += ways.runs[k];
      const float along = glm::dot(lay, way);
      ways.wicks[k] = std::min(kWick * kTurnTime * (1.0f + kAlong * along * along / squared) / squared, kMostWicks);
    }
    if (sum > kMostLeaves)
      for (float& share : ways.runs) share *= kMostLeaves / sum;
  }
}

void Water::give(std::uint32_t place, float amount) {
  incoming_[place] += amount;
  flags_[texels_->blockOf(place)] |= kReceived;
}

void Water::flow(std::uint32_t index) {
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  for (std::uint32_t i = block.first; i < block.end; ++i) {
    const float film = film_[i], held = held_[i];
    const float mobile = film > kCling + kLeast ? film - kCling : 0.0f;
    if (mobile == 0.0f && held <= kDamp) continue;
    const float runs = mobile * std::min(0.25f + mobile, kFastest);
    const float seeps = held > kField + kLeast ? kSeep * (held - kField) : 0.0f;
    const bool pools = film > kPool, damp = held > kDamp;
    const float area = areas_[i];
    const Ways& ways = ways_[i];
    float outFilm = 0, outHeld = 0, out[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t there = ways.to[k];
      const float thereHeld = held_[there], drier = held - thereHeld - kWickRest;
      float fromFilm = runs * ways.runs[k], fromHeld = seeps * ways.runs[k];
      if (drier > kLeast && damp && thereHeld < kFull) fromHeld += drier * ways.wicks[k];
      if (pools && film > film_[there]) fromFilm += (film - film_[there]) * 0.05f;
      outFilm += fromFilm;
      outHeld += fromHeld;
      out[k] = fromFilm + fromHeld;
    }
    // So that water comes to rest, and is at rest wherever it is taken to.
    if (outFilm + outHeld < kLeast) continue;
    flags_[index] |= kFlows;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t there = ways.to[k];
      incoming_[there] += out[k] * area;
      if (there < block.first || there >= block.end) flags_[texels_->blockOf(there)] |= kReceived;
    }
    // A film changes at the end of the step, so that it does not run on through all the places behind.
    incoming_[i] -= outFilm * area;
    held_[i] -= outHeld;
  }
}

// Puts a place's water in the mask, and in the gutters that repeat it.
void Water::store(const Ground& ground, WetnessMask& mask, std::uint32_t index, float held, float film) {
  const std::uint32_t at = texels_->places()[index].texel;
  Vec4 texel = mask.texels()[at];
  if (held > 0.0f && texel.w <= 0.0f) {
    if (sites_.radius() != clumpSize_) sites_ = ClumpSites(*texels_, clumpSize_);
    texel = Vec4(sites_.clumpOf(*texels_, ground.surface, ground.query, ground.wetting, index), held);
  }
  texel.w = held;
  if (held <= 0.0f) texel = Vec4(0);
  held_[index] = held;
  film_[index] = film;
  mask.set(at, texel, film);
  stored_[texels_->blockOf(index)] = 1;
  texels_->forMirrors(index, [&](std::uint32_t mirror) { mask.set(mirror, texel, film); });
}

// Tells the mask where store() has been.
void Water::touch(WetnessMask& mask) {
  for (std::uint32_t b = 0; b < stored_.size(); ++b)
    if (std::exchange(stored_[b], std::uint8_t{0})) {
      mask.touch(texels_->blocks()[b].rect);
      changed_ = true;
    }
}

void Water::receive(const Ground& ground, WetnessMask& mask, std::uint32_t index) {
  const auto& places = texels_->places();
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  bool wet = false, moves = flags_[index] & kFlows;
  for (std::uint32_t i = block.first; i < block.end; ++i) {
    const std::uint32_t at = places[i].texel;
    // Of a film that has all run off a rounding may be left on either side of nothing.
    float held = held_[i], film = std::max(film_[i] + incoming_[i] / areas_[i], 0.0f);
    incoming_[i] = 0.0f;
    if (film > 0.0f && held < 1.0f) {
      const float taken = std::min(film > 4 * kLeast ? film * (kAbsorb * kTurnTime) : film, 1.0f - held);
      moves = true;
      held = std::min(held + taken, 1.0f);
      film -= taken;
    }
    wet |= held > 0.0f || film > 0.0f;
    const float heldChange = held - mask.texels()[at].w, filmChange = film - mask.filmAt(at);
    if (heldChange == 0.0f && filmChange == 0.0f) continue;
    moves |= std::abs(heldChange) > kLeast || std::abs(filmChange) > kLeast;
    store(ground, mask, i, held, film);
    if (film > kHangs && !hasDrop_[i] && hanging_ < kMostHanging && drops_.size() < kMostDrops &&
        glm::dot(places[i].normal, down_) > 0.25f) {
      drops_.push_back({Vec3(0), 0, Vec3(0), 0, i});
      hasDrop_[i] = 1;
      ++hanging_;
    }
  }
  flags_[index] = static_cast<std::uint8_t>((wet ? kWet : 0) | (moves ? kMoving : 0));
}

void Water::evaporate(const Ground& ground, WetnessMask& mask, const Climate& climate, std::uint32_t index) {
  const auto& places = texels_->places();
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  const float still = climate.dryRate * (1.0f + 1.5f * std::sqrt(glm::dot(climate.wind, climate.wind)));
  const Vec3 toBlock = block.centre - climate.blowCentre;
  const float reach = block.radius + climate.blowRadius;
  const bool blown = climate.blow > 0.0f && glm::dot(toBlock, toBlock) <= reach * reach;
  if (!blown && !(still > 0.0f)) return;
  bool wet = false, moves = false;
  for (std::uint32_t i = block.first; i < block.end; ++i) {
    const float held = held_[i], film = film_[i];
    if (held <= 0.0f && film <= 0.0f) continue;
    float rate = still;
    if (blown) {
      const Vec3 apart = places[i].position - climate.blowCentre;
      const float share = glm::dot(apart, apart) / (climate.blowRadius * climate.blowRadius);
      if (share < 1.0f) rate += climate.blow * (1.0f - share);
    }
    // Damp fur is dry at the tips, where air takes the most.
    const float loss = rate * (kRate * kDryingTurns) * (1.4f - 0.8f * held);
    float heldLeft = std::max(held - loss, 0.0f), filmLeft = std::max(film - loss, 0.0f);
    if (heldLeft < kLeast && filmLeft == 0.0f) heldLeft = 0.0f;
    wet |= heldLeft > 0.0f || filmLeft > 0.0f;
    moves |= filmLeft > 0.0f;
    if (heldLeft == held && filmLeft == film) continue;
    accounts_.evaporated += (double{held} - heldLeft + film - filmLeft) * places[i].area;
    store(ground, mask, i, heldLeft, filmLeft);
  }
  flags_[index] = static_cast<std::uint8_t>((wet ? kWet : 0) | (moves ? kMoving : flags_[index] & kMoving));
}

// --- steps --------------------------------------------------------------------------------------

void Water::subStep(const Ground& ground, WetnessMask& mask, const Climate& climate) {
  ++steps_;
  rain(climate);
  shake(ground, mask, climate);
  fall(ground, climate);
  const std::uint32_t turn = steps_ % kTurns;
  for (std::uint32_t b = turn; b < flags_.size(); b += kTurns) {
    if (!(flags_[b] & kMoving)) continue;
    if (aimed_[b] != aim_) aim(ground, b);
    flow(b);
  }
  for (std::uint32_t b = turn; b < flags_.size(); b += kTurns)
    if (flags_[b] & (kReceived | kMoving)) receive(ground, mask, b);
  feedHanging(ground, mask, climate);
  if (steps_ % kDryingTurns) return;
  for (std::uint32_t b = 0; b < flags_.size(); ++b)
    if (flags_[b] & kWet) evaporate(ground, mask, climate, b);
  if (groundWet_) seepGround(climate.dryRate);
}

bool Water::step(const Ground& ground, WetnessMask& mask, float dt, const Climate& climate) {
  if (!ready_ || !(dt > 0.0f)) return false;
  clumpSize_ = climate.clumpSize;
  notice(ground, mask);
  const Vec3 down = glm::transpose(Mat3(climate.worldFromModel)) * Vec3(0, -1, 0);
  // A turn of two degrees makes water run another way.
  if (glm::dot(down, down_) < 0.9994f) {
    down_ = down;
    ++aim_;
    for (std::uint8_t& flags : flags_)
      if (flags & kWet) flags |= kMoving;
  }
  changed_ = false;
  const std::uint32_t groundBefore = groundRevision_;
  due_ = std::min(due_ + dt, 1.0f);
  // A hair early rather than a step late: 1/60 does not add up to whole seconds.
  for (; due_ > kStep * 0.999f; due_ -= kStep) subStep(ground, mask, climate);
  touch(mask);
  return changed_ || groundRevision_ != groundBefore;
}

bool Water::active(const WetnessMask& mask, const Climate& climate) const {
  if (climate.rain > 0.0f) return true;
  if (!ready_) return !mask.isDry() || !drops_.empty();
  if (mask.revision() != seen_) return !mask.isDry() || accounts_.painted > 0;
  if (climate.dryRate > 0.0f && (groundWet_ || !mask.isDry() || hanging_ > 0)) return true;
  if (drops_.size() > hanging_ || climate.blow > 0.0f || climate.shaking > 0.0f) return !mask.isDry() || drops_.size() > hanging_;
  return std::any_of(flags_.begin(), flags_.end(), [](std::uint8_t flags) { return flags & (kMoving | kReceived); });
}

}  // namespace fur::wet
