#include "furgen/StrandPath.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"
#include "furgen/Strand.h"

namespace fur::furgen {

namespace {

constexpr float kMaxMagnitude = 4.0f;  // radii (Sheppard 3.3.3)
constexpr float kWaveReach = 0.12f;    // volume heights, at wave 1
constexpr float kWaveTurn = 8.0f;      // radians of a wave over a height
constexpr float kFrizzReach = 0.6f;    // radii for each of three waves, at frizz 1
constexpr float kFrizzTurns[3] = {19.0f, 31.0f, 47.0f};  // radians over a height
constexpr float kCoilReach = 0.16f;    // radius of a coil in volume heights, at coil 1
constexpr float kCoilTilt = 0.87f;     // sine of the tilt of a coil's circles against the skin: 60 degrees
constexpr int kCoilSamples = 56;
constexpr int kCoilPhases = 64;
constexpr float kPhaseSpread = 2.0f;  // radians; coils that all began alike would fill some heights and leave others
constexpr float kRollTurn = 4.0f * kPi;  // radians over a height, at roll 1
// The share of the skin that strands could cover and still find room (equal discs at random jam at 0.547).
constexpr float kTightest = 0.42f;
// How near to touching the strands of a lock are drawn: below 1, so that rounding never makes them touch.
constexpr float kLockTightness = 0.95f;

float smoothstep(float low, float high, float x) {
  const float t = saturate((x - low) / (high - low));
  return t * t * (3.0f - 2.0f * t);
}

float strandsPerLock(float lockSize) { return 6.0f + 54.0f * lockSize * lockSize; }

}  // namespace

SmoothField::SmoothField(std::uint32_t seed, std::uint64_t stream, int size)
    : turns_(static_cast<float>(std::max(size / 256, 1))) {
  Random random(seed, stream);
  for (int i = 0; i < kWaves; ++i) {
    phase_[i] = random.uniform(0.0f, 2.0f * kPi);
    weight_[i] = random.uniform(0.25f, 0.5f) * std::min(static_cast<float>(size) / 256.0f, 1.0f);
  }
}

float SmoothField::at(const Vec2& tile) const {
  // Waves in 256 texels, in x and y: long ones only, in every direction.
  constexpr int kx[kWaves] = {1, 0, 1, 1, 2}, ky[kWaves] = {0, 1, 1, -2, 1};
  float sum = 0.0f;
  for (int i = 0; i < kWaves; ++i)
    sum += weight_[i] * portableSin(2.0f * kPi * turns_ * (static_cast<float>(kx[i]) * tile.x + static_cast<float>(ky[i]) * tile.y) + phase_[i]);
  return sum;
}

Locks::Locks(const FurParameters& p, int strandsOfFullCoat) : size_(static_cast<float>(p.size)) {
  const float count = static_cast<float>(std::max(strandsOfFullCoat, 1)) / strandsPerLock(p.lockSize);
  side_ = std::max(2, static_cast<int>(std::sqrt(count) + 0.5f));
  Random random(p.seed, 0);
  const float cell = size_ / static_cast<float>(side_);
  centres_.reserve(static_cast<std::size_t>(side_) * side_);
  for (int y = 0; y < side_; ++y)
    for (int x = 0; x < side_; ++x) {
      const float u = random.uniform(), v = random.uniform();
      centres_.push_back({(static_cast<float>(x) + u) * cell, (static_cast<float>(y) + v) * cell});
    }
}

// Two cells away is enough: the own cell's centre is never farther than its diagonal.
Vec2 Locks::towardsNearest(const Vec2& root) const {
  const int cx = static_cast<int>(root.x / size_ * static_cast<float>(side_));
  const int cy = static_cast<int>(root.y / size_ * static_cast<float>(side_));
  Vec2 best{0};
  float bestSquared = 1e30f;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const int x = ((cx + dx) % side_ + side_) % side_, y = ((cy + dy) % side_ + side_) % side_;
      const Vec2& c = centres_[static_cast<std::size_t>(y * side_ + x)];
      const Vec2 way{torusDelta(c.x, root.x, size_), torusDelta(c.y, root.y, size_)};
      const float squared = way.x * way.x + way.y * way.y;
      if (squared < bestSquared) bestSquared = squared, best = way;
    }
  return best;
}

StrandPath::StrandPath(const FurParameters& p)
    : parameters_(p),
      // The locks of the full coat, so that density does not move them.
      locks_(p, [&] {
        FurParameters full = p;
        full.density = 1.0f;
        return wantedStrands(full);
      }()),
      wavePhase_(p.seed, 1u << 20, p.size), waveTurn_(p.seed, 2u << 20, p.size), coilTurn_(p.seed, 3u << 20, p.size),
      coilPhase_(p.seed, 4u << 20, p.size) {
  const float radius = meanRadius(p.thickness) * strandThinning(0.0f);
  const float size = static_cast<float>(p.size);
  const float cover = kPi * radius * radius * static_cast<float>(wantedStrands(p)) / (size * size);
  lockedSpread_ = std::min(1.0f, std::sqrt(cover / kTightest));
  if (p.coil > 0.0f) windCoils();
}

// A strand of full length takes all of it, a shorter one ends on the way, so that neighbours of different
// length run side by side.
void StrandPath::windCoils() {
  const float reach = kCoilReach * parameters_.coil, turns = 2.5f + 2.0f * parameters_.coil;
  coils_.resize(static_cast<std::size_t>(kCoilPhases) * (kCoilSamples + 1));
  for (int phase = 0; phase < kCoilPhases; ++phase) {
    const float start = 2.0f * kPi * static_cast<float>(phase) / kCoilPhases;
    CoilSample* coil = &coils_[static_cast<std::size_t>(phase) * (kCoilSamples + 1)];
    float highest = 1.0f;
    for (int i = 0; i <= kCoilSamples; ++i) {
      const float way = static_cast<float>(i) / kCoilSamples;
      const float angle = start + 2.0f * kPi * turns * way, r = reach * std::min(way / 0.3f, 1.0f);
      const float cosine = portableCos(angle), sine = portableSin(angle);
      const float tilted = std::sqrt(1.0f - kCoilTilt * kCoilTilt) * r * sine;
      coil[i] = {tilted * kHeightTexels, r * (1.0f - cosine) * kHeightTexels, std::max(way + kCoilTilt * r * sine, 0.0f)};
      highest = std::max(highest, coil[i].height);
    }
    for (int i = 0; i <= kCoilSamples; ++i) coil[i].height /= highest;
  }
}

// How wide a lock is at s, against its width at the skin: its strands come nearer as they thin, and as
// far nearer as the coat has room.
float StrandPath::spreadAt(float s) const {
  const float thinning = strandThinning(s, parameters_.taper) / strandThinning(0.0f);
  const float closed = std::max(mix(1.0f, lockedSpread_, smoothstep(0.0f, 0.6f, s)) * thinning, 0.12f);
  return mix(1.0f, closed, parameters_.clump * kLockTightness);
}

StrandPath::Walk StrandPath::start(const StrandDraws& draws, bool undercoat, float calm) const {
  const FurParameters& p = parameters_;
  const float size = static_cast<float>(p.size);
  const Vec2 tile = draws.root / size;
  Walk w(*this);
  w.draws_ = draws;
  w.curl_ = kMaxMagnitude * draws.radius * p.curl * (1.0f - calm);
  w.frizz_ = kFrizzReach * draws.radius * std::min(1.0f, p.frizz + (undercoat ? 0.35f : 0.0f)) * (1.0f - calm);
  if (w.frizz_ > 0.0f)
    for (const Vec2& phase : draws.frizzPhase) w.frizzAtRoot_ += Vec2(portableSin(phase.x), portableSin(phase.y));
  if (p.wave > 0.0f) {
    w.wave_ = kWaveReach * kHeightTexels * p.wave;
    w.wavePhase_ = 1.4f * wavePhase_.at(tile);
    w.waveAtRoot_ = portableSin(w.wavePhase_);
    const float turn = 0.8f * waveTurn_.at(tile);
    w.waveWay_ = {portableCos(turn), portableSin(turn)};
  }
  const bool locked = p.clump > 0.0f && draws.bound >= p.stray;
  if (locked) w.toLock_ = locks_.towardsNearest(draws.root);
  if (p.coil > 0.0f) {
    // A lock curls as one: its strands ask the field where its centre stands.
    const Vec2 middle = (draws.root + w.toLock_) / size;
    const float turn = 0.6f * coilTurn_.at(middle);
    w.coilWay_ = {portableCos(turn), portableSin(turn)};
    const float phase = kPhaseSpread * coilPhase_.at(middle) / (2.0f * kPi);
    const int index = std::min(static_cast<int>((phase - std::floor(phase)) * kCoilPhases), kCoilPhases - 1);
    w.coil_ = &coils_[static_cast<std::size_t>(index) * (kCoilSamples + 1)];
  }
  w.opening_ = p.tipBreak * draws.tipOpening;
  return w;
}

// Sideways, from what depends on the height alone.
Vec2 StrandPath::Walk::shiftAt(float height) const {
  Vec2 shift{0};
  if (curl_ > 0.0f)
    for (int curve = 0; curve < 2; ++curve)
      for (int axis = 0; axis < 2; ++axis)
        shift[axis] += curl_ * draws_.magnitude[curve][axis] * portableSin(draws_.phase[curve][axis] * height);
  if (frizz_ > 0.0f) {
    Vec2 sum{0};
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 2; ++axis) sum[axis] += portableSin(kFrizzTurns[k] * height + draws_.frizzPhase[k][axis]);
    shift += (sum - frizzAtRoot_) * (frizz_ * std::min(3.0f * height, 1.0f));
  }
  if (wave_ > 0.0f) shift += waveWay_ * (wave_ * (portableSin(kWaveTurn * height + wavePhase_) - waveAtRoot_));
  if (toLock_.x != 0.0f || toLock_.y != 0.0f) {
    const float s = std::min(height / draws_.length, 1.0f);
    const float spread = mix(path_.spreadAt(s), 1.0f, opening_ * smoothstep(0.6f, 1.0f, s));
    const float turn = kRollTurn * path_.parameters_.roll * height * smoothstep(0.05f, 0.5f, height);
    const float cosine = portableCos(turn), sine = portableSin(turn);
    // The strand turns round the lock's centre, nearer to it.
    const Vec2 from = -toLock_;
    shift += Vec2(cosine * from.x - sine * from.y, sine * from.x + cosine * from.y) * spread - from;
  }
  return shift;
}

// Texels sideways, volume heights up.
Vec3 StrandPath::Walk::pointAt(int sample) const {
  const CoilSample& coil = coil_[sample];
  const Vec2 across(-coilWay_.y, coilWay_.x);
  const Vec2 side = shiftAt(static_cast<float>(sample) / kCoilSamples) + coilWay_ * coil.along + across * coil.across;
  return Vec3(side, coil.height);
}

Node StrandPath::Walk::nodeAt(const Vec3& point, float way) const {
  return {Vec2(point), point.z, draws_.radius * strandThinning(std::min(way / draws_.length, 1.0f), path_.parameters_.taper)};
}

bool StrandPath::Walk::nextUpright(std::vector<Node>& nodes) {
  if (step_ < 0) return false;
  const float plane = static_cast<float>(step_) / kPlanes;
  // A tip just over a plane would make a piece too short to have a direction: the strand ends on the plane.
  const bool tip = plane > draws_.length - 0.1f / kPlanes;
  const float h = std::min(plane, draws_.length);
  nodes.push_back(nodeAt(Vec3(shiftAt(h), h), h));
  step_ = tip ? -1 : step_ + 1;
  return true;
}

bool StrandPath::Walk::nextFree(std::vector<Node>& nodes) {
  const float way = static_cast<float>(step_) / kCoilSamples, before = way - 1.0f / kCoilSamples;
  // The skin, and one sample more at least.
  if (step_ > std::max(1, static_cast<int>(draws_.length * kCoilSamples + 0.5f))) return false;
  const Vec3 point = pointAt(step_++);
  if (nodes.empty()) {
    nodes.push_back(nodeAt(point, 0));
    last_ = point;
    return true;
  }
  const int from = static_cast<int>(last_.z * kPlanes), to = static_cast<int>(point.z * kPlanes);
  const int up = to > from ? 1 : -1;
  // Where the piece passes planes it gets a node on each.
  for (int k = from; k != to; k += up) {
    const float plane = static_cast<float>(up > 0 ? k + 1 : k) / kPlanes;
    const float t = (plane - last_.z) / (point.z - last_.z);
    if (t > 0.0f && t < 1.0f)
      nodes.push_back(nodeAt(Vec3(Vec2(last_) + (Vec2(point) - Vec2(last_)) * t, plane), before + t / kCoilSamples));
  }
  nodes.push_back(nodeAt(point, way));
  last_ = point;
  return true;
}

bool StrandPath::Walk::next(std::vector<Node>& nodes) {
  return coil_ ? nextFree(nodes) : nextUpright(nodes);
}

}  // namespace fur::furgen
