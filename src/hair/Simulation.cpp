#include "hair/Simulation.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "core/PortableMath.h"
#include "hair/ShownNodes.h"

namespace fur::hair {

namespace {

// Longer than this is a pause (a hidden tab, a debugger), not a motion.
constexpr float kLongest = 0.25f;  // s
// A jump of more, in model units within one call, is a new place and not a throw.
constexpr float kTeleport = 1.0f;
// Steps that come this near to being due are due: frames of 1/60 s and of 1/144 s then meet at the same step.
constexpr double kNearlyDue = 1e-3;

// c of k / (L c)^a, 1 / model unit: chosen by eye for a mane of half the model's radius.
constexpr float kSoftens = 6;

float unitOr(float x, float fallback) { return x >= 0.0f && x <= 1.0f ? x : x > 1.0f ? 1.0f : x < 0.0f ? 0.0f : fallback; }

MotionValues sound(MotionValues values) {
  const MotionValues usual;
  values.model = values.model == Model::Spring || values.model == Model::Forest ? values.model : Model::Cascade;
  values.stiffness = unitOr(values.stiffness, usual.stiffness);
  values.softening = std::clamp(values.softening, 1, 3);
  values.damping = unitOr(values.damping, usual.damping);
  values.weight = unitOr(values.weight, usual.weight);
  values.gravity = unitOr(values.gravity, usual.gravity);
  values.volume = unitOr(values.volume, usual.volume);
  return values;
}

dynamics::Wind sound(dynamics::Wind wind) {
  constexpr float kStrongest = 4;
  if (!finite(wind.force)) wind.force = Vec3(0);
  const float strength = glm::length(wind.force);
  if (!(strength < kStrongest)) wind.force = normalizeOr(wind.force, Vec3(0)) * kStrongest;
  wind.gust = unitOr(wind.gust, 0);
  wind.turbulence = unitOr(wind.turbulence, 0);
  if (!std::isfinite(wind.time)) wind.time = 0;
  return wind;
}

// The frame as given where it is one; else the fallback.
RootFrame soundFrame(const RootFrame& frame, const RootFrame& fallback) {
  if (!finite(frame.position) || !finite(frame.normal) || !finite(frame.tangent)) return fallback;
  if (glm::dot(frame.position, frame.position) > 1e12f) return fallback;
  const Vec3 normal = normalizeOr(frame.normal, Vec3(0));
  const Vec3 given = normalizeOr(frame.tangent, Vec3(0)), tangent = given - normal * glm::dot(normal, given);
  if (normal == Vec3(0) || glm::dot(tangent, tangent) < 1e-6f) return fallback;
  return {frame.position, normal, normalizeOr(tangent, fallback.tangent)};
}

bool sameWind(const dynamics::Wind& a, const dynamics::Wind& b) {
  return a.force == b.force && a.gust == b.gust && a.turbulence == b.turbulence;
}

}  // namespace

void Simulation::reset(const Guides& guides, std::span<const RootFrame> rootsAsMade) {
  FUR_ASSERT(rootsAsMade.size() == guides.count(), "Simulation::reset()", "a root for every guide", rootsAsMade.size());
  FUR_ASSERT(guides.positions.size() == guides.count() * static_cast<std::size_t>(guides.nodes) && guides.nodes <= kMostNodes && guides.nodes >= 2,
             "Simulation::reset()", "as many nodes for every guide", guides.nodes);
  std::vector<RootFrame> roots(rootsAsMade.begin(), rootsAsMade.end());
  for (RootFrame& root : roots) root = soundFrame(root, {});
  guides_.assign(guides, roots);
  cascade_.assign(guides_);
  crowding_.reset(guides_);
  detail_.reset(guides_);
  nodeSteps_ = 0;
  now_ = last_ = {};
  now_.roots = last_.roots = guides_.roots;
  stiffnessFor_.reset();
  pending_ = 0;
  steps_ = 0;
  lookedAt_.clear();
  asleep_ = true;
  hasRoots_ = false;
  shown_.assign(guides.positions.size(), {});
  show();
}

Simulation::Roots Simulation::takeRoots(std::span<const RootFrame> roots) {
  FUR_ASSERT(roots.size() == guides_.guides, "Simulation::advance()", "a root for every guide", roots.size());
  bool moved = false, jumped = false;
  for (std::size_t slot = 0; slot < guides_.blocks * kLanes; ++slot) {
    const std::size_t block = slot / kLanes, lane = slot % kLanes;
    const RootFrame before = last_.roots[block].at(lane), now = soundFrame(roots[guides_.guideAt[slot]], before);
    now_.roots[block].set(lane, now);
    const Vec3 move = now.position - before.position;
    jumped = jumped || glm::dot(move, move) > kTeleport * kTeleport;
  }
  for (std::size_t block = 0; block < guides_.blocks; ++block) moved = moved || !same(now_.roots[block], last_.roots[block]);
  return jumped ? Roots::Jumped : moved ? Roots::Moved : Roots::Held;
}

bool Simulation::takeWetness(std::span<const float> wetness) {
  FUR_ASSERT(wetness.empty() || wetness.size() == shown_.size(), "Simulation::advance()", "a wetness for every node, or none", wetness.size());
  bool changed = false;
  const auto n = static_cast<std::size_t>(guides_.nodes);
  for (std::size_t slot = 0; slot < guides_.blocks * kLanes; ++slot) {
    const std::size_t guide = guides_.guideAt[slot], first = guides_.first(slot / kLanes);
    for (std::size_t i = 0; i < n; ++i) {
      const float wet = wetness.empty() ? 0.0f : unitOr(wetness[guide * n + i], 0.0f);
      Lanes& held = guides_.wetness[first + i];
      changed = changed || wet != held[slot % kLanes];
      held[slot % kLanes] = wet;
      shown_[guide * n + i].wetness = wet;
    }
  }
  return changed;
}

void Simulation::takeValues(const MotionValues& values) {
  now_.values = sound(values);
  if (now_.values == stiffnessFor_) return;
  stiffnessFor_ = now_.values;
  // From 20 to 2000 at L = 1 / c: a swing takes 1.4 s to 0.14 s there.
  float k = 20.0f * portableExp(4.6052f * now_.values.stiffness);
  // The bends of segments add up along a strand: its slowest swing is that of a beam, (1.875 / n)^2 sqrt(k), or of a chain of
  // joints, (pi / 2n) sqrt(k). So it is the same for any number of nodes, and for every model.
  const auto n = static_cast<float>(guides_.nodes - 2);
  if (now_.values.model == Model::Cascade) k *= n * n * n * n / 12.36f;
  if (now_.values.model == Model::Forest) k *= n * n / 2.467f;
  for (std::size_t i = 0; i < guides_.nodeCount(); ++i)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      guides_.stiffness[i][lane] = springStiffness(k, guides_.fromRoot[i][lane], kSoftens, now_.values.softening);
}

// Whether any guide can come near any of them.
bool Simulation::meets(std::span<const Collider> colliders) {
  const std::vector<Obstacle> obstacles = obstaclesBetween(colliders, colliders, 1, 0);
  for (std::size_t block = 0; block < guides_.blocks && !obstacles.empty(); ++block) {
    findReached(obstacles, now_.roots[block].origin, guides_.reach[block], reached_);
    if (!reached_.empty()) return true;
  }
  return false;
}

// The hair goes where the roots went, as it is.
void Simulation::carry() {
  for (std::size_t block = 0; block < guides_.blocks; ++block) {
    const FrameLanes &from = guides_.roots[block], &to = now_.roots[block];
    for (std::size_t i = guides_.first(block); i < guides_.first(block + 1); ++i) {
      for (std::vector<Lanes3>* nodes : {&guides_.positions, &guides_.earlier, &guides_.before})
        (*nodes)[i] = to.placed(from.placedBack((*nodes)[i]));
      guides_.goals[i] = to.placed(guides_.rests[i]);
    }
  }
  guides_.roots = guides_.rootsBefore = now_.roots;
  last_.roots = now_.roots;
}

bool Simulation::advance(float seconds, const MotionValues& values, const Surroundings& around) {
  if (!(seconds > 0)) return false;
  const Roots roots = takeRoots(around.roots);
  takeValues(values);
  now_.up = normalizeOr(around.up, Vec3(0, 1, 0));
  now_.wind = around.wind ? sound(*around.wind) : dynamics::Wind{};
  const bool wetted = takeWetness(around.wetness);
  if (wetted) detail_.takeWetness(guides_);
  const bool blown = !sameWind(now_.wind, last_.wind);
  now_.colliders = soundColliders(around.colliders);
  const bool hit = now_.colliders != last_.colliders && (meets(now_.colliders) || meets(last_.colliders));
  const bool moved = hit || roots != Roots::Held || wetted || blown;
  const bool stirred = !hasRoots_ || moved || now_.wind.varies() || now_.values != last_.values || now_.up != last_.up;
  if (blown) last_.wind = now_.wind;
  if (!hasRoots_) {
    last_.up = now_.up;
    last_.wind = now_.wind;
    last_.colliders = now_.colliders;
  }
  if (stirred) {
    stale_ = stale_ || asleep_ || blown || now_.values != last_.values;
    asleep_ = false;
    undisturbed_ = 0;
    lookedAt_.clear();
  }
  const bool pause = seconds > kLongest;
  if (!hasRoots_ || pause || roots == Roots::Jumped) carry();
  if (pause) lieStill();
  hasRoots_ = true;
  if (asleep_) {
    last_ = now_;
    return false;
  }
  if (!pause) {
    const double before = pending_, due = static_cast<double>(seconds) / static_cast<double>(kStep);
    pending_ += due;
    for (int k = 1; pending_ > 1.0 - kNearlyDue && !asleep_; ++k) {
      pending_ -= 1.0;
      step(std::clamp(static_cast<float>((k - before) / due), 0.0f, 1.0f), static_cast<float>(1.0 / due));
      fallAsleep();
    }
  }
  last_ = now_;
  show();
  return true;
}

void Simulation::settle(const MotionValues& values, const Surroundings& around) {
  constexpr float kSeconds = 0.1f;
  constexpr int kMostCalls = 100;
  MotionValues calm = values;
  calm.damping = 0.4f;  // the least time to rest; with more, soft hair creeps
  Surroundings mean = around;
  const dynamics::Wind wind = around.wind ? around.wind->mean() : dynamics::Wind{};
  mean.wind = &wind;
  hasRoots_ = false;
  for (int i = 0; i == 0 || (i < kMostCalls && !asleep_); ++i) advance(kSeconds, calm, mean);
  lieStill();
  asleep_ = true;
  now_.values = last_.values = sound(values);
  show();
}

void Simulation::show() {
  const float share = std::clamp(static_cast<float>(pending_), 0.0f, 1.0f);
  for (std::size_t block = 0; block < guides_.blocks; ++block) showBlock(guides_, block, now_.roots[block], share, shown_);
}

}  // namespace fur::hair
