#include "wet/Water.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wet/Drying.h"

namespace fur::wet {

const SurfaceTexels& Water::texelsOf(const WetSurface& skin) {
  if (!texels_) texels_ = std::make_unique<SurfaceTexels>(skin.surface, skin.wetting.atlas());
  return *texels_;
}

bool Water::prepare(const WetSurface& skin, std::uint32_t places, float clumpSize) {
  if (ready_) return true;
  texelsOf(skin);
  if (sites_.radius() == 0) sites_ = ClumpSites(*texels_, clumpSize);
  if (!texels_->link(skin.surface, skin.query, places) || !sites_.find(*texels_, places)) return false;
  if (ways_.empty()) makePlaces();
  // The ways of the water, too: when all of a model is wet at once they would be a pause.
  for (std::uint32_t found = 0; aimedUpTo_ < flags_.size() && found < places; ++aimedUpTo_) {
    aim(skin, aimedUpTo_);
    const SurfaceTexels::Block& block = texels_->blocks()[aimedUpTo_];
    found += block.end - block.first;
  }
  if (aimedUpTo_ < flags_.size()) return false;
  puddles_.resize(std::size_t{kGroundCells} * kGroundCells, 0.0f);
  seen_ = 0xffffffffu;
  // What was restored.
  const std::size_t count = texels_->places().size();
  for (std::uint32_t i = 0; i < count; ++i)
    if (incoming_[i] != 0.0f) flags_[texels_->blockOf(i)] |= kReceived;
  for (Drop& drop : drops_) {
    if (drop.place >= count) drop.place = Drop::kNoPlace;
    else hasDrop_[drop.place] = 1, ++hanging_;
  }
  return ready_ = true;
}

void Water::makePlaces() {
  const std::size_t count = texels_->places().size();
  for (auto* values : {&held_, &film_}) values->assign(count + kPlaces, 0.0f);
  incoming_.resize(count, 0.0f);            // what was restored
  incoming_.resize(count + kPlaces, 0.0f);  // and the room behind it
  ways_.assign(count, {});
  areas_.clear();
  texelOf_.clear();
  areas_.reserve(count + kPlaces);
  texelOf_.reserve(count);
  for (const SurfaceTexels::Place& place : texels_->places()) areas_.push_back(place.area), texelOf_.push_back(place.texel);
  areas_.resize(count + kPlaces, 1.0f);
  hasDrop_.assign(count, 0);
  flags_.assign(texels_->blocks().size(), 0);
  stored_.assign(flags_.size(), 0);
  dried_.assign(flags_.size(), 0);
  aimed_.assign(flags_.size(), 0);
  aim_ = 1;
  aimedUpTo_ = 0;
}

void Water::forgetPlaces() {
  // What stands in the mask counts as painted where it is noticed again; what was on its way to places is gone.
  const Accounts all = accounts();
  accounts_.painted -= all.held + all.film;
  for (Drop& drop : drops_) drop.place = Drop::kNoPlace;
  hanging_ = 0;
  incoming_.clear();
  held_.clear();
  film_.clear();
  ways_.clear();
  sites_ = {};
  texels_.reset();
  ready_ = false;
  seen_ = 0xffffffffu;
}

void Water::setLay(std::vector<Vec3> lay) {
  if (lay == lay_) return;
  lay_ = std::move(lay);
  ++aim_;
}

// What others have changed in the mask since the last step.
void Water::notice(const WetSurface& skin, WetnessMask& mask) {
  if (mask.revision() == seen_) return;
  const bool first = seen_ == 0xffffffffu;
  seen_ = mask.revision();
  TexelRect painted = mask.takePainted();
  if (first) painted = {0, 0, mask.size(), mask.size()};
  double gain = 0;
  const auto& places = texels_->places();
  const auto& texels = mask.texels();
  for (std::uint32_t b = 0; b < flags_.size(); ++b) {
    const SurfaceTexels::Block& block = texels_->blocks()[b];
    if (!block.rect.meets(painted)) continue;
    for (std::uint32_t i = block.first; i < block.end; ++i) {
      const std::uint32_t at = texelOf_[i];
      const float held = texels[at].w, film = mask.filmAt(at);
      if (held == held_[i] && film == film_[i]) continue;
      gain += (double{held} - held_[i] + film - film_[i]) * places[i].area;
      if (!(flags_[b] & kWet)) dried_[b] = steps_;
      flags_[b] |= kWet | kMoving;
      store(skin, mask, i, held, film);
    }
    // Paint meets gutters where it may, which is not always where it meets what they repeat.
    for (std::uint32_t i = block.first; i < block.end; ++i)
      texels_->forMirrors(i, [&](std::uint32_t mirror) {
        if (texels[mirror].w != held_[i] || mask.filmAt(mirror) != film_[i]) carryOn(mask, mirror, texels[texelOf_[i]], film_[i]);
      });
  }
  for (int y = painted.y0; y < painted.y1; ++y)
    for (int x = painted.x0; x < painted.x1; ++x) {
      const auto at = static_cast<std::uint32_t>(y * mask.size() + x);
      if (texels_->placeOf(at) == SurfaceTexels::kNone && (texels[at].w > 0.0f || mask.filmAt(at) > 0.0f)) mask.set(at, Vec4(0), 0);
    }
  (gain > 0 || first ? accounts_.painted : accounts_.removed) += gain > 0 || first ? gain : -gain;
}

// As notice(), of water that others have brought to hair or taken from it.
void Water::noticeHair(const WetHair& hair) {
  const double gain = hair.water() - accounts_.hair;
  (gain > 0 ? accounts_.painted : accounts_.removed) += std::abs(gain);
  accounts_.hair += gain;
}

void Water::give(std::uint32_t place, float amount) {
  incoming_[place] += amount;
  flags_[texels_->blockOf(place)] |= kReceived;
}

// Puts a place's water in the mask, and in the gutters that repeat it.
void Water::store(const WetSurface& skin, WetnessMask& mask, std::uint32_t index, float held, float film) {
  const std::uint32_t at = texels_->places()[index].texel;
  Vec4 texel = mask.texels()[at];
  if (held > 0.0f && texel.w <= 0.0f) {
    if (sites_.radius() != clumpSize_) {
      sites_ = ClumpSites(*texels_, clumpSize_);
      sites_.find(*texels_);
    }
    texel = Vec4(sites_.clumpOf(*texels_, skin.surface, skin.query, skin.wetting, index), held);
  }
  texel.w = held;
  if (held <= 0.0f) texel = Vec4(0);
  held_[index] = held;
  film_[index] = film;
  mask.set(at, texel, film);
  const std::uint32_t block = texels_->blockOf(index);
  stored_[block] = 1;
  flags_[block] &= static_cast<std::uint8_t>(~kSoaked);
  texels_->forMirrors(index, [&](std::uint32_t mirror) { carryOn(mask, mirror, texel, film); });
}

// A gutter has the water of the texel that it repeats, but the clump that lies there: one that paint has left, else the same,
// grown until it holds the gutter too. Outside its own clump no strand stands, and beside the border there would be a hole.
void Water::carryOn(WetnessMask& mask, std::uint32_t mirror, const Vec4& texel, float film) {
  constexpr float kReachesPast = 1.5f;
  Vec4 there = texel;
  if (const Vec4& before = mask.texels()[mirror]; before.w > 0.0f && texel.w > 0.0f) there = Vec4(Vec3(before), texel.w);
  else if (texel.w > 0.0f) there.z = std::max(there.z, kReachesPast * glm::length(mask.texelCentre(mirror) - Vec2(texel)));
  mask.set(mirror, there, film);
}

// Tells the mask where store() has been.
void Water::touch(WetnessMask& mask) {
  for (std::uint32_t b = 0; b < stored_.size(); ++b)
    if (std::exchange(stored_[b], std::uint8_t{0})) {
      mask.touch(texels_->blocks()[b].rect);
      changed_ = true;
    }
}

// --- steps --------------------------------------------------------------------------------------

bool Water::step(const WetSurface& skin, WetnessMask& mask, const Climate& climate) {
  if (!ready_) return false;
  clumpSize_ = climate.clumpSize;
  notice(skin, mask);
  const Vec3 down = glm::transpose(Mat3(climate.worldFromModel)) * Vec3(0, -1, 0);
  // A turn of two degrees makes water run another way.
  if (glm::dot(down, down_) < 0.9994f) {
    down_ = down;
    ++aim_;
    for (std::uint8_t& flags : flags_)
      if (flags & kWet) flags |= kMoving;
  }
  changed_ = false;
  change_ = 0;
  landed_.clear();
  const std::uint32_t groundBefore = groundRevision_;
  ++steps_;
  rain(climate);
  shake(skin, mask, climate);
  if (skin.hair) noticeHair(*skin.hair);
  fall(skin, climate);
  if (skin.hair) {
    const std::size_t before = drops_.size();
    const double dried = skin.hair->step(climate, drops_);
    accounts_.evaporated += dried;
    accounts_.hair -= dried;
    for (std::size_t i = before; i < drops_.size(); ++i) accounts_.hair -= drops_[i].water;
  }
  const std::uint32_t turn = steps_ % kTurns;
  int aims = kMostAimed;
  for (std::uint32_t b = turn; b < flags_.size() && aims > 0; b += kTurns)
    if (flags_[b] & kMoving && aimed_[b] != aim_) aim(skin, b), --aims;
  for (std::uint32_t b = turn; b < flags_.size(); b += kTurns)
    if (flags_[b] & kMoving) crossBorders(b), flow(b);
  for (std::uint32_t b = turn; b < flags_.size(); b += kTurns)
    if (flags_[b] & (kReceived | kMoving)) receive(skin, mask, &climate, b);
  feedHanging(skin, mask, climate);
  const std::uint32_t turns = dryingTurns(climate);
  if (steps_ % turns == 0)
    for (std::uint32_t b = 0; b < flags_.size(); ++b)
      if (flags_[b] & kWet && steps_ - dried_[b] >= turns) evaporate(skin, mask, climate, b);
  if (groundMoves_ ? steps_ % kDryingTurns == 0 : steps_ % turns == 0 && groundWet_ && climate.dryRate > 0.0f)
    change_ = std::max(change_, seepGround(kPuddleDrying * climate.dryRate * kStep * static_cast<float>(groundMoves_ ? kDryingTurns : turns)));
  touch(mask);
  if (drops_.size() > hanging_) change_ = 1;
  return changed_ || groundRevision_ != groundBefore;
}

std::uint32_t Water::dryingTurns(const Climate& climate) {
  constexpr float kSeen = 1.0f / 512;  // of wetness
  if (climate.blow > 0.0f) return kDryingTurns;
  const float turns = kSeen / std::max(climate.dryRate * kStep, 1e-9f);
  // Multiples of the least: those that move dry by it.
  return kDryingTurns * static_cast<std::uint32_t>(std::clamp(turns, 1.0f * kDryingTurns, 1.0f * kSlowestTurns) / kDryingTurns);
}

bool Water::active(const WetnessMask& mask, const Climate& climate) const {
  if (climate.rain > 0.0f || groundMoves_) return true;
  if (!ready_) return !mask.isDry() || !drops_.empty() || (groundWet_ && climate.dryRate > 0.0f);
  if (mask.revision() != seen_) return !mask.isDry() || accounts_.painted > 0;
  if (climate.dryRate > 0.0f && (groundWet_ || !mask.isDry() || hanging_ > 0)) return true;
  if (drops_.size() > hanging_ || climate.blow > 0.0f || climate.shaking > 0.0f) return !mask.isDry() || drops_.size() > hanging_;
  return std::any_of(flags_.begin(), flags_.end(), [](std::uint8_t flags) { return flags & (kMoving | kReceived); });
}

}  // namespace fur::wet
