// How the water of Water.h runs, creeps, soaks in and dries: all that is done for each wet place in each turn. A block
// of places at a time, in loops that compilers make into four places at a time.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/PortableMath.h"
#include "core/Random.h"
#include "wet/Drying.h"
#include "wet/Water.h"

namespace fur::wet {

namespace {

constexpr float kTurnTime = Water::kStep * Water::kTurns;

// The film: kCling of it clings, thicker films run faster, and where it is deeper than kPool it also levels out.
constexpr float kPool = 1.2f, kFastest = 1.5f;
constexpr float kSpeed = 1.1f;        // model radii a second down a wall, of a film of 1
// But no further in a turn than so much of what a texel measures on average: not by each texel's own measures, or water would
// run at another speed in each chart.
constexpr float kFarthest = 0.4f;
constexpr float kMostLeaves = 0.53f;  // share of a place's film that leaves in a turn, times kFastest
constexpr float kAbsorb = 5.0f;       // share of the film that fur takes up in a second
// Fur wetter than kField lets go of what is above, this much slower than a film runs.
constexpr float kField = 0.75f, kSeep = 0.4f;
// Fur so wet draws no more from its neighbours: what it let go of would only come back.
constexpr float kFull = kField - 0.05f;
// Along strands water creeps: from wetter to drier fur, down to a difference of kWickRest, and not out of fur that
// holds no more than kDamp: at half of that letters of water ran together in half a minute.
constexpr float kWick = 1.5e-4f, kWickRest = 0.02f, kDamp = 0.6f, kMostWicks = 0.1f;
// How far combed fur turns what runs, and how much better water creeps along it than across.
constexpr float kTurn = 0.7f, kAlong = 3.0f;

// No steeper is no way up: over the edge of a level face fur hangs, and takes water along.
constexpr float kLevel = 1e-4f;
// Less than this, squared, leads nowhere.
constexpr float kNoWay = 1e-12f;

// One number for each link of a place.
using Four [[gnu::vector_size(16)]] = float;
float sum(const Four& x) { return ((x[0] + x[1]) + x[2]) + x[3]; }

// How much harder than others a place is to blow dry, 0..1: `at` in radii of what blows. Waves of a tuft's size, each turned aside by another, so
// that fur dries with a ragged border instead of a round one.
float sheltered(const Vec3& at) {
  const auto wave = [](float x, float y) { return portableSin(11.0f * x + 2.0f * portableSin(7.0f * y)); };
  return 0.5f + (wave(at.x, at.y) + wave(at.y, at.z) + wave(at.z, at.x)) / 6.0f;
}

}  // namespace

// How the water of a block runs and creeps: by gravity, the fur and the shape of the skin.
void Water::aim(const WetSurface& skin, std::uint32_t index) {
  aimed_[index] = aim_;
  const auto& places = texels_->places();
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  const float speed = std::min(kSpeed * kTurnTime, kFarthest * texels_->meanWidth());
  for (std::uint32_t i = block.first; i < block.end; ++i) {
    const SurfaceTexels::Place& place = places[i];
    Vec3 lay = lay_.empty() ? Vec3(0) : meanAt(skin, place, lay_);
    lay -= place.normal * glm::dot(lay, place.normal);
    // Down along the skin, turned towards the line in which the strands lie.
    Vec3 down = down_ - place.normal * glm::dot(down_, place.normal);
    const float laid = glm::dot(lay, lay);
    if (laid > 1e-6f) down += kTurn * (lay * (glm::dot(lay, down) / std::sqrt(laid)) - down * std::sqrt(laid));
    Ways& ways = ways_[i];
    ways = {{i, i}, {}, {i, i, i, i}, {}, {}};
    const SurfaceTexels::Links& links = texels_->links()[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (links[2 * k] == SurfaceTexels::kNone) continue;
      ways.beside[k] = links[2 * k];
      const Vec3 way = places[links[2 * k]].position - place.position;
      const float squared = glm::dot(way, way), along = glm::dot(lay, way);
      if (squared > kNoWay) ways.wicks[k] = std::min(kWick * kTurnTime * (1.0f + kAlong * along * along / squared) / squared, kMostWicks);
    }
    // In texels: so far along u or v, and so far along both. Water finds its way between the clumps, not straight down; but never
    // up, so that it rests where it is lowest.
    const Vec2 parts = speed * texels_->partsOf(skin.surface, i, down), size = glm::abs(parts);
    const float both = std::min(size.x, size.y);
    const int right = parts.x < 0.0f ? 4 : 0, up = parts.y < 0.0f ? 6 : 2;
    const int sides[] = {size.x > size.y ? right : up, up + ((parts.x < 0.0f) == (parts.y < 0.0f) ? -1 : 1)};
    const float shares[] = {std::max(size.x, size.y) - both, both};
    float sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const int side = sides[k];
      const std::uint32_t there = links[static_cast<std::size_t>(side)];
      if (there == SurfaceTexels::kNone) continue;
      ways.sides[k] = static_cast<std::uint8_t>(side);
      ways.down[k] = there;
      const Vec3 way = places[there].position - place.position;
      if (glm::dot(down_, way) > -kLevel * glm::length(way))
        ways.runs[k] = shares[k] * (0.5f + chanceOf(place.texel, static_cast<std::uint32_t>(side)));
      sum += ways.runs[k];
    }
    if (sum > kMostLeaves)
      for (float& share : ways.runs) share *= kMostLeaves / sum;
  }
}

void Water::crossBorders(std::uint32_t index) {
  const std::size_t turn = steps_ / kTurns % 2;
  for (const SurfaceTexels::Crossing& crossing : texels_->crossingsFrom(index)) {
    Ways& ways = ways_[crossing.from];
    for (std::size_t k = 0; k < 2; ++k)
      if (ways.sides[k] == crossing.side) ways.down[k] = crossing.to[turn];
  }
}

// Whether no water creeps from the block's places, as those beside them hold all that comes of itself.
bool Water::isAmongSoaked(std::uint32_t index) const {
  if (!(flags_[index] & kSoaked)) return false;
  for (const std::uint32_t block : texels_->blocksBeside(index))
    if (!(flags_[block] & kSoaked)) return false;
  return true;
}

void Water::flow(std::uint32_t index) {
  if (isAmongSoaked(index) ? flowFrom<false>(index) : flowFrom<true>(index)) flags_[index] |= kFlows;
}

// Whether any water leaves its place.
template <bool kCreeps>
bool Water::flowFrom(std::uint32_t index) {
  const std::uint32_t first = texels_->blocks()[index].first, end = texels_->blocks()[index].end;
  float* const incoming = incoming_.data();
  float* const heldOf = held_.data();
  const float *const filmOf = film_.data(), *const areas = areas_.data();
  const Ways* const waysOf = ways_.data();
  bool flows = false;
  for (std::uint32_t i = first; i < end; ++i) {
    const float film = filmOf[i], held = heldOf[i];
    const float mobile = film > kCling + kLeast ? film - kCling : 0.0f;
    if (mobile == 0.0f && held <= (kCreeps ? kDamp : kField + kLeast)) continue;
    const Ways& ways = waysOf[i];
    const std::uint32_t* const beside = ways.beside.data();
    const float runs = ways.runs[0] + ways.runs[1];
    const float filmRuns = mobile * std::min(0.25f + mobile, kFastest), heldRuns = held > kField + kLeast ? kSeep * (held - kField) : 0.0f;
    Four creeps{}, levels{};
    if (kCreeps && held > kDamp) {
      Four wicks;
      std::memcpy(&wicks, ways.wicks.data(), sizeof wicks);
      const Four there{heldOf[beside[0]], heldOf[beside[1]], heldOf[beside[2]], heldOf[beside[3]]};
      const Four drier = held - there - kWickRest;
      creeps = ((drier > kLeast) & (there < kFull)) ? drier * wicks : Four{};
    }
    if (film > kPool) {
      const Four higher = film - Four{filmOf[beside[0]], filmOf[beside[1]], filmOf[beside[2]], filmOf[beside[3]]};
      levels = higher > 0.0f ? higher * 0.05f : Four{};
    }
    const float outFilm = runs * filmRuns + sum(levels), outHeld = runs * heldRuns + sum(creeps), area = areas[i];
    // So that water comes to rest, and is at rest wherever it is taken to.
    if (outFilm + outHeld < kLeast) continue;
    flows = true;
    const auto leave = [&](std::uint32_t to, float amount) {
      incoming[to] += amount;
      if (to - first >= end - first) flags_[texels_->blockOf(to)] |= kReceived;
    };
    for (std::size_t k = 0; k < 2; ++k) leave(ways.down[k], ways.runs[k] * (filmRuns + heldRuns) * area);
    if ((kCreeps && held > kDamp) || film > kPool) {
      const Four aside = (creeps + levels) * area;
      for (std::size_t k = 0; k < 4; ++k) leave(beside[k], aside[k]);
    }
    // A film changes at the end of the step, so that it does not run on through all the places behind.
    incoming[i] -= outFilm * area;
    heldOf[i] -= outHeld;
    // What crept away may have been more than what flowed in: blocks beside may let some creep here.
    if (kCreeps && heldOf[i] < kFull) flags_[index] &= static_cast<std::uint8_t>(~kSoaked);
  }
  return flows;
}

// Puts the water of a block in the mask; whether any has changed by as much as is worth following.
bool Water::storeBlock(const WetSurface& skin, WetnessMask& mask, std::uint32_t index, const Amounts& now) {
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  const std::uint32_t* const texelOf = &texelOf_[block.first];
  const std::size_t count = block.end - block.first;
  Amounts before{};
  for (std::size_t i = 0; i < count; ++i) before.held[i] = mask.texels()[texelOf[i]].w;
  float *const heldOf = &held_[block.first], *const filmOf = &film_[block.first];
  std::copy(filmOf, filmOf + count, before.film);
  std::copy(now.held, now.held + count, heldOf);
  // As many side by side as compilers have in one instruction.
  constexpr std::size_t kSide = 8;
  static_assert(kPlaces % kSide == 0);
  float mostOf[kSide] = {};
  for (std::size_t i = 0; i < kPlaces; i += kSide)
    for (std::size_t k = 0; k < kSide; ++k)
      mostOf[k] = std::max(mostOf[k], std::max(std::abs(now.held[i + k] - before.held[i + k]), std::abs(now.film[i + k] - before.film[i + k])));
  const float most = *std::max_element(mostOf, mostOf + kSide);
  change_ = std::max(change_, most);
  bool stored = false;
  for (std::size_t i = 0; i < count; ++i) {
    const float held = now.held[i], film = now.film[i];
    if (held == before.held[i] && film == before.film[i]) continue;
    const auto place = static_cast<std::uint32_t>(block.first + i);
    if (!(before.held[i] > 0.0f && held > 0.0f)) {
      store(skin, mask, place, held, film);
      continue;
    }
    // Its clump stays.
    filmOf[i] = film;
    stored = true;
    mask.setWater(texelOf[i], held, film, before.film[i]);
    if (block.repeated) texels_->forMirrors(place, [&](std::uint32_t mirror) { carryOn(mask, mirror, mask.texels()[texelOf[i]], film); });
  }
  stored_[index] |= stored;
  return most > kLeast;
}

// What a block holds when all that has come to it has arrived, and the film has soaked in; whether any has. Loops over all places that
// a block may have read on into the next one's.
bool Water::soak(std::uint32_t index, Amounts& now) {
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  const std::size_t count = block.end - block.first;
  const float *const heldOf = &held_[block.first], *const filmOf = &film_[block.first], *const areas = &areas_[block.first];
  float* const incoming = &incoming_[block.first];
  float soaks[kPlaces];
  for (std::size_t i = 0; i < kPlaces; ++i) {
    // Of a film that has all run off a rounding may be left on either side of nothing.
    const float come = filmOf[i] + incoming[i] / areas[i], standing = come > 0.0f ? come : 0.0f, room = 1.0f - heldOf[i];
    const float soaking = standing > 4 * kLeast ? standing * (kAbsorb * kTurnTime) : standing, taken = room < soaking ? room : soaking;
    const float held = heldOf[i] + taken;
    now.held[i] = held < 1.0f ? held : 1.0f;
    now.film[i] = standing - taken;
    soaks[i] = room > 0.0f ? standing : 0.0f;
  }
  std::fill(incoming, incoming + count, 0.0f);
  std::fill(now.held + count, now.held + kPlaces, 0.0f);
  std::fill(now.film + count, now.film + kPlaces, 0.0f);
  std::fill(soaks + count, soaks + kPlaces, 0.0f);
  int any = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) any |= soaks[i] > 0.0f;
  return any;
}

// Takes from a block what goes since it has last dried; whether any film is left.
bool Water::dry(const Climate& climate, std::uint32_t index, Amounts& now) {
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  const std::size_t count = block.end - block.first;
  const float time = kStep * static_cast<float>(std::min(steps_ - std::exchange(dried_[index], steps_), dryingTurns(climate) + kDryingTurns));
  const float still = climate.dryRate * (1.0f + kWindDrying * std::sqrt(glm::dot(climate.wind, climate.wind)));
  const Vec3 toBlock = block.centre - climate.blowCentre;
  const float reach = block.radius + climate.blowRadius;
  const bool blown = climate.blow > 0.0f && glm::dot(toBlock, toBlock) <= reach * reach;
  if (!blown && !(still > 0.0f)) return false;
  float drying[kPlaces];
  std::fill(drying, drying + kPlaces, still * time);
  for (std::size_t i = 0; blown && i < count; ++i) {
    const Vec3& place = texels_->places()[block.first + i].position;
    const Vec3 apart = (place - climate.blowCentre) / climate.blowRadius;
    const float far = glm::dot(apart, apart);
    if (!(far < 1.0f)) continue;
    const float left = std::max(1.0f - far * (1.0f + 1.5f * sheltered(place / climate.blowRadius)), 0.0f);
    drying[i] += climate.blow * left * left * time;
  }
  const float* const areas = &areas_[block.first];
  float lost[kPlaces];
  int film = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const float held = now.held[i], loss = dryingLoss(held, drying[i]), heldLess = held - loss, filmLess = now.film[i] - loss;
    const float heldLeft = heldLess > 0.0f ? heldLess : 0.0f, filmLeft = filmLess > 0.0f ? filmLess : 0.0f;
    now.held[i] = ((heldLeft < kLeast) & (filmLeft == 0.0f)) ? 0.0f : heldLeft;
    lost[i] = ((held - now.held[i]) + (now.film[i] - filmLeft)) * areas[i];
    now.film[i] = filmLeft;
    film |= filmLeft > 0.0f;
  }
  double all[4] = {};
  for (std::size_t i = 0; i < kPlaces; i += 4)
    for (std::size_t k = 0; k < 4; ++k) all[k] += lost[i + k];
  accounts_.evaporated += (all[0] + all[1]) + (all[2] + all[3]);
  return film;
}

// Notes of a block whether it is wet and moves; whether a drop may hang from the film on it.
bool Water::rest(std::uint32_t index, const Amounts& now, bool moves) {
  const auto count = static_cast<int>(texels_->blocks()[index].end - texels_->blocks()[index].first);
  int wet = 0, deep = 0, full = 0;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    wet |= int{now.held[i] > 0.0f} | int{now.film[i] > 0.0f};
    deep |= now.film[i] > kHangsFrom;
    full += now.held[i] >= kFull;
  }
  const int kept = flags_[index] & kChanged;
  flags_[index] = static_cast<std::uint8_t>((wet ? kWet : 0) | (moves ? kMoving : 0) | (full == count ? kSoaked : 0) | kept);
  return deep;
}

// Beside a block that is drier now than before, water may run that was at rest.
void Water::wakeBeside(std::uint32_t index) {
  for (const std::uint32_t block : texels_->blocksBeside(index))
    if (flags_[block] & kWet) flags_[block] |= kMoving;
}

void Water::evaporate(const WetSurface& skin, WetnessMask& mask, const Climate& climate, std::uint32_t index) {
  const SurfaceTexels::Block& block = texels_->blocks()[index];
  Amounts now{};
  std::copy(&held_[block.first], &held_[block.first] + (block.end - block.first), now.held);
  std::copy(&film_[block.first], &film_[block.first] + (block.end - block.first), now.film);
  const bool moves = dry(climate, index, now) || flags_[index] & kMoving;
  storeBlock(skin, mask, index, now);
  rest(index, now, moves);
}

void Water::receive(const WetSurface& skin, WetnessMask& mask, const Climate* climate, std::uint32_t index) {
  Amounts now{};
  bool moves = soak(index, now) || flags_[index] & kFlows;
  if (!(flags_[index] & kWet)) dried_[index] = steps_;
  if (climate && steps_ - dried_[index] >= kDryingTurns) moves |= dry(*climate, index, now);
  moves |= storeBlock(skin, mask, index, now) || (flags_[index] & kMoving && aimed_[index] != aim_);
  if (moves) flags_[index] |= kChanged;
  const bool deep = rest(index, now, moves);
  if (!moves && flags_[index] & kChanged) {
    flags_[index] &= static_cast<std::uint8_t>(~kChanged);
    wakeBeside(index);
  }
  if (deep) hangDrops(index);
}

}  // namespace fur::wet
