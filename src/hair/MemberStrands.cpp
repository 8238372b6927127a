#include "hair/MemberStrands.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "core/Random.h"

namespace fur::hair {

namespace {

// Of so many strands one leads a finer lock, to which those round it are drawn towards the tip, by at most this share of the way.
constexpr int kStrandsOfLock = 6;
constexpr float kLeastDrawn = 0.4f, kMostDrawn = 0.85f;
constexpr float kRim = 0.94f;          // roots stay within it, for the strand's own width
constexpr float kOwnWay = 0.1f;        // how far a tip strays from that, in half widths
constexpr int kCandidates = 24;        // places of which the one farthest from the others is taken (Mitchell 1991)
constexpr float kLeastFrizz = 0.03f, kMostFrizz = 0.3f;
constexpr float kLeastStrandLength = 0.1f;
constexpr float kStrayed = 1.2f;       // strays end so far out
constexpr float kLeastTurns = 1.2f, kMoreTurns = 1.6f;  // of a strand's waves
constexpr float kOwnPhase = 0.12f;     // strands of one lock wave together, but for so many turns

Vec2 inDisc(Random& random) {
  for (;;) {
    const float x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Vec2 p(x, y);
    if (glm::dot(p, p) <= 1.0f) return p;
  }
}

// `count` places in the unit disc, each the farthest of some from those before it.
std::vector<Vec2> spread(int count, Random& random) {
  std::vector<Vec2> places;
  for (int i = 0; i < count; ++i) {
    Vec2 best(0);
    float farthest = -1;
    for (int k = 0; k < kCandidates; ++k) {
      const Vec2 place = inDisc(random);
      // From the rim half as much as from others, so that they do not line it.
      float distance = i == 0 ? 1.0f - glm::length(place) : 4.0f;
      for (const Vec2& other : places) distance = std::min(distance, glm::dot(place - other, place - other));
      if (distance > farthest) farthest = distance, best = place;
    }
    places.push_back(best);
  }
  return places;
}

std::size_t nearestOf(const std::vector<Vec2>& places, std::size_t count, const Vec2& to) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i)
    if (glm::dot(places[i] - to, places[i] - to) < glm::dot(places[best] - to, places[best] - to)) best = i;
  return best;
}

// Denser in the middle: the distance r from it becomes r^1.25.
Vec2 drawnInwards(const Vec2& place) { return place * std::sqrt(std::sqrt(glm::length(place))) * kRim; }

void appendKind(std::vector<MemberStrand>& out, int count, const HairValues& values, Random random) {
  const std::vector<Vec2> roots = spread(count, random);
  const auto leaders = static_cast<std::size_t>((count + kStrandsOfLock - 1) / kStrandsOfLock);
  std::vector<float> lockLengths, lockDrawn, lockPhases;
  for (std::size_t i = 0; i < leaders; ++i) {
    lockLengths.push_back(i == 0 ? 0.0f : random.uniform());
    lockDrawn.push_back(random.uniform(kLeastDrawn, kMostDrawn));
    lockPhases.push_back(random.uniform());
  }
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const std::size_t lock = nearestOf(roots, leaders, roots[i]);
    MemberStrand s;
    s.random = random.uniform();
    s.phase = lockPhases[lock] + kOwnPhase * random.uniform();
    s.frizz = (kLeastFrizz + kMostFrizz * values.frizz) * random.uniform(0.4f, 1.0f);
    s.root = drawnInwards(roots[i]);
    const float drawn = lockDrawn[lock] * random.uniform(0.6f, 1.0f);
    const Vec2 ownWay = kOwnWay * inDisc(random), away = inDisc(random);
    s.tip = glm::mix(s.root, drawnInwards(roots[lock]), drawn) + ownWay;
    const bool strays = random.uniform() < values.stray;
    // Where it was going already, or where chance takes it.
    if (strays) s.tip = normalizeOr(Vec3(s.root + 0.7f * away, 0), Vec3(1, 0, 0)) * kStrayed * random.uniform(0.75f, 1.0f);
    const float own = random.uniform();
    const float shorter = i == 0 ? 0.0f : 0.5f * lockLengths[lock] + 0.5f * own * (strays ? 1.0f : own);
    s.length = std::max(1 - values.tipVariation * shorter, kLeastStrandLength);
    out.push_back(s);
  }
}

}  // namespace

std::vector<MemberStrand> memberStrands(int count, const HairValues& values) {
  std::vector<MemberStrand> out;
  for (int kind = 0; kind < kWispKinds; ++kind)
    appendKind(out, std::max(count, 1), values, Random(static_cast<std::uint64_t>(values.seed), static_cast<std::uint64_t>(kind) + 101));
  return out;
}

Vec2 memberOffset(const MemberStrand& s, float t) {
  // Straight out of the skin, and side by side again at the tip.
  const Vec2 middle = glm::mix(s.root, s.tip, t * t * (3 - 2 * t));
  const float turns = kLeastTurns + kMoreTurns * s.phase, grown = s.frizz * t * (2 - t);
  const float x = portableSin(2 * kPi * (turns * t + s.phase)) + 0.5f * portableSin(2 * kPi * (2.3f * turns * t + 3 * s.phase));
  const float z = portableSin(2 * kPi * (turns * t + s.phase + 0.3f));
  return glm::clamp(middle + grown * Vec2(x, z), Vec2(-kStripReach), Vec2(kStripReach));
}

float memberWidth(const MemberStrand& s, float t) {
  const float u = t / s.length;
  return u < 1 ? (1 - 0.3f * u) * (1 - u * u * u * u) : 0.0f;
}

}  // namespace fur::hair
