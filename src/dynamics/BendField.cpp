#include "dynamics/BendField.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/Assert.h"
#include "core/PortableMath.h"
#include "dynamics/RigidMotion.h"
#include "dynamics/WetTable.h"

namespace fur::dynamics {

namespace {

// Longer than this is a pause (a hidden tab, a debugger), not a motion: the fur has come to rest.
constexpr float kLongestStep = 0.5f;  // s
// A jump of more, in bounding radii within one step, is a new place and not a throw.
constexpr float kTeleport = 1.5f;

// Chosen by eye for fur of a tenth of the model's radius.
constexpr float kDrag = 0.12f;      // force per model radius per second
constexpr float kKick = 7.0f;       // radians per second per model radius per second
constexpr float kMaxSpeed = 25.0f;  // rad/s

// The lean from which on touched fur forgets evenly, to an end.
constexpr float kForgotten = 0.03f;  // rad

// Below these nobody sees a strand of a tenth of the picture's height move.
constexpr float kStillAngle = 5e-4f;  // rad
constexpr float kStillSpeed = 5e-3f;  // rad/s

// The farthest that a point of the unit ball goes between two transforms, or a little more.
float farthestMove(const Mat4& from, const Mat4& to) {
  float turned = 0;
  for (int c = 0; c < 3; ++c) turned += glm::dot(Vec3(to[c] - from[c]), Vec3(to[c] - from[c]));
  // |R - I| in the Frobenius norm is sqrt(2) times the move of a point on the equator.
  return glm::length(Vec3(to[3] - from[3])) + std::sqrt(0.5f * turned);
}

// An affine map of rest positions to model-space vectors.
struct AffineField {
  Mat3 linear{0.0f};
  Vec3 constant{0};
  Lanes3 at(const Lanes3& p) const { return transformed(linear, p) + splat(constant); }
};

// The shortest rotation that takes the chord to the direction (Rodrigues); they are at most 0.7 rad apart.
Lanes3 uprighted(const Lanes3& force, const Lanes3& chord, const Lanes3& direction) {
  const Lanes3 axis = cross(chord, direction), once = cross(axis, force);
  return force + once + cross(axis, once) * (1.0f / (1.0f + dot(chord, direction)));
}

// Directions and tangents across them.
struct Frames {
  const Columns &directions, &tangents;
};
// The first `count` of what stands to the one frame as the result stands to the other.
void carry(Columns& vectors, std::size_t count, const Frames& from, const Frames& to) {
  for (std::size_t i = 0; i < count; i += kLanes) {
    const Lanes3 v = vectors.lanes(i), n0 = from.directions.lanes(i), t0 = from.tangents.lanes(i);
    const Lanes3 n1 = to.directions.lanes(i), t1 = to.tangents.lanes(i);
    vectors.set(i, n1 * dot(v, n0) + t1 * dot(v, t0) + cross(n1, t1) * dot(v, cross(n0, t0)));
  }
}

float largest(const Lanes& x) { return std::max(std::max(x[0], x[1]), std::max(x[2], x[3])); }

}  // namespace

// The forces that do not depend on the vertex, in model space.
struct BendField::StepForces {
  Vec3 gravity;
  WindField wind;
  AffineField drag, kick;
  // Of a vertex that moves by itself: by its velocity, and by the change of that; 1 / dt.
  float poseDrag = 0, poseKick = 0, perSecond = 0;
  float compliance;
  float forceOfKick = 0;  // that bends dry fur as fast within the step, for those who look at forces
  bool moving = false;
  std::vector<WetRow> wet;  // of each type a table

  StepForces(const Mat4& modelToWorld, const BendForces& forces, const Wind& windNow, float dt)
      : wind(windNow, modelToWorld) {
    const Mat3 toModel = glm::transpose(rotationOf(modelToWorld));
    gravity = toModel * finiteOr0(forces.gravity) * pullOf(forces.weight);
    const float stiffness = unitOr0(forces.stiffness), omega = swingOf(stiffness);
    compliance = complianceOf(stiffness);
    addTable(forces.stiffness, forces.weight, dt, 1);
    forceOfKick = massOf(forces.weight) / (omega * omega * compliance * kMaxBend * std::max(dt, 1e-6f));
  }

  // Of the other types, against type 0.
  void addTypes(const BendForces& forces, float dt) {
    const float pull = glm::length(finiteOr0(forces.gravity)) * pullOf(forces.weight);
    for (const TypeForces& type : forces.others) addTable(type.stiffness, type.weight, dt, pull > 0 ? unitOr0(type.gravity) * pullOf(type.weight) / pull : 0);
  }

 private:
  // Sheppard 5.2.1 gives every coat a floor of weight, the rest is the type's own.
  static float pullOf(float weight) { return 0.5f + unitOr0(weight); }
  static float complianceOf(float stiffness) { return 2.5f * powerOf(0.16f, stiffness); }  // 2.5 soft, 1 at 0.5, 0.4 stiff
  void addTable(float stiffness, float weight, float dt, float heavier) {
    const float yields = wet.empty() ? 1 : complianceOf(unitOr0(stiffness)) / compliance;
    for (WetRow row : wetTable(stiffness, weight, dt)) {
      row.weight *= heavier;
      row.yields = yields;
      wet.push_back(row);
    }
  }
};

void BendField::reset(const std::vector<Vec3>& positions, const std::vector<Vec3>& directions,
                      const std::vector<Vec3>& tangents) {
  FUR_ASSERT(positions.size() == directions.size(), "BendField::reset()", "a direction for every position",
             directions.size());
  count_ = positions.size();
  positions_.assign(positions, Vec3(0));
  directions_.assign(directions, Vec3(0, 1, 0));
  bends_.assign(count_, Vec3(0));
  velocities_.assign(count_, Vec3(0));
  lengths_.assign(Columns::padded(count_), 1.0f);
  wetness_.clear();
  types_.clear();
  levels_.clear();
  out_.assign(count_, Vec4(0, 0, 0, 1));
  shownForces_.clear();
  for (Columns* columns : {&rests_, &chords_, &sets_, &tangents_, &firstRests_, &firstChords_}) columns->clear();
  posed_ = false;
  poseFelt_ = 0;
  if (tangents.size() == count_) tangents_.assign(tangents, Vec3(1, 0, 0));
  blocks_.assign(Columns::padded(count_) / Columns::kBlock, {});
  boundBlocks();
  lastVelocity_ = {};
  lastPresses_.clear();
  hasLast_ = false;
  atRest_ = true;
}

void BendField::boundBlocks() {
  boundsStale_ = false;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const std::size_t first = b * Columns::kBlock, last = std::min(count_, first + Columns::kBlock);
    Vec3 low(1e30f), high(-1e30f);
    for (std::size_t i = first; i < last; ++i) {
      low = glm::min(low, positions_.at(i));
      high = glm::max(high, positions_.at(i));
    }
    blocks_[b].centre = 0.5f * (low + high);
    blocks_[b].radius = 0.5f * glm::length(high - low);
  }
}

void BendField::wake() {
  for (Block& block : blocks_) block.awake = true;
}

void BendField::showForces(bool show) {
  if (show != shownForces_.empty()) return;
  shownForces_.assign(show ? count_ : 0, Vec4(0));
  wake();
}

void BendField::setRest(const std::vector<Vec3>& rests, const std::vector<float>& lengths) {
  const auto fits = [this](std::size_t count) { return count == 0 || count == count_; };
  FUR_ASSERT(fits(rests.size()) && fits(lengths.size()), "BendField::setRest()", "one of each a vertex, or none", rests.size());
  rests_.clear();
  chords_.clear();
  if (!rests.empty()) {
    rests_.assign(rests, Vec3(0));
    chords_.assign(count_, Vec3(0, 1, 0));
    const Columns& upright = posed_ ? firstDirections_ : directions_;
    for (std::size_t i = 0; i < count_; ++i) {
      const Vec3 direction = upright.at(i);
      Vec3 rest = finiteOr0(rests[i]);
      rest -= direction * glm::dot(rest, direction);
      const float angle = glm::length(rest);
      if (angle > kMaxBend) rest *= kMaxBend / angle;
      const float half = 0.5f * std::min(angle, kMaxBend);
      rests_.set(i, rest);
      chords_.set(i, direction * portableCos(half) + normalizeOr(rest, Vec3(0)) * portableSin(half));
    }
  }
  if (posed_) {
    firstRests_ = rests_;
    firstChords_ = chords_;
    placeRests();
  }
  for (std::size_t i = 0; i < count_; ++i) out_[i].w = lengths_[i] = lengths.empty() ? 1.0f : unitOr0(lengths[i]);
  wake();
}

// Rests and chords of the first shape become those of the shape now.
void BendField::placeRests() {
  if (firstRests_.empty()) return;
  rests_ = firstRests_;
  chords_ = firstChords_;
  for (Columns* columns : {&rests_, &chords_})
    carry(*columns, count_, {firstDirections_, firstTangents_}, {directions_, tangents_});
}

void BendField::setPose(std::span<const Vec3> positions, std::span<const Vec3> directions, std::span<const Vec3> tangents) {
  FUR_ASSERT(positions.size() == count_ && directions.size() == count_ && tangents.size() == count_ && !tangents_.empty(),
             "BendField::setPose()", "one of each a vertex, and tangents at reset()", positions.size());
  if (!posed_) {
    posed_ = true;
    firstDirections_ = directions_;
    firstTangents_ = tangents_;
    firstRests_ = rests_;
    firstChords_ = chords_;
    lastPositions_.assign(positions, Vec3(0));
    lastMoves_.assign(count_, Vec3(0));
  }
  const Columns directionsBefore = directions_, tangentsBefore = tangents_;
  positions_.take(positions);
  directions_.take(directions);
  tangents_.take(tangents);
  for (Columns* columns : {&bends_, &velocities_, &sets_})
    if (!columns->empty()) carry(*columns, count_, {directionsBefore, tangentsBefore}, {directions_, tangents_});
  placeRests();
  boundsStale_ = true;
  poseFelt_ = 2;  // its motion, and that it has ended
  atRest_ = false;
}

BendField::RigidVelocity BendField::follow(const Mat4& modelToWorld, float dt) {
  const RigidVelocity before = lastVelocity_;
  if (!hasLast_ || farthestMove(lastTransform_, modelToWorld) > kTeleport) {
    lastVelocity_ = {};
    lastTransform_ = modelToWorld;
    hasLast_ = true;
    return {};  // neither a motion nor a change of one
  }
  const float perSecond = 1.0f / dt;
  for (int c = 0; c < 3; ++c) lastVelocity_.linear[c] = Vec3(modelToWorld[c] - lastTransform_[c]) * perSecond;
  lastVelocity_.constant = Vec3(modelToWorld[3] - lastTransform_[3]) * perSecond;
  lastTransform_ = modelToWorld;
  return {lastVelocity_.linear - before.linear, lastVelocity_.constant - before.constant};
}

// Four strands in a step. The parts of advanceBlock() below work on it; all are inlined there.
struct BendField::FourStrands {
  std::size_t first;  // vertex
  Lanes3 position, direction, chord;
  WetLanes water;
  Lanes3 force, kick{};    // kick: a change of velocity
  Lanes3 target;           // bend in equilibrium, with what touch has left
  Lanes3 targetUntouched;  // without
  Lanes touched{};         // what touch has left, squared
  Lanes3 before, bend, speed, left;  // bend before and after; left: from the bend to its target
};

[[gnu::always_inline]] inline void BendField::findForces(FourStrands& four, const StepForces& common, bool swings) {
  const Lanes3& p = four.position;
  four.force = splat(common.gravity) * four.water.weight + common.wind.at(p) * (common.wind.exposure(four.chord) * four.water.catching);
  if (swings && common.moving) {
    four.force = four.force + common.drag.at(p);
    four.kick = common.kick.at(p);
    if (posed_) {
      const Lanes3 move = clampLength((p - lastPositions_.lanes(four.first)) * splat(common.perSecond), kMaxSpeed);
      four.force = four.force + move * splat(common.poseDrag);
      four.kick = four.kick + (move - lastMoves_.lanes(four.first)) * splat(common.poseKick);
      lastPositions_.set(four.first, p);
      lastMoves_.set(four.first, move);
    }
  }
  if (shownForces_.empty()) return;
  const Lanes3 shown = four.force + four.kick * (four.water.weight * splat(common.forceOfKick));
  for (std::size_t k = 0; k < std::min(kLanes, count_ - std::min(four.first, count_)); ++k)
    shownForces_[four.first + k] = Vec4(shown.x[k], shown.y[k], shown.z[k], lengths_[four.first + k]);
}

// Where the forces and what touch has left lead.
[[gnu::always_inline]] inline void BendField::findTarget(FourStrands& four, const StepForces& common) {
  const bool combed = !rests_.empty();
  const Lanes3 force = combed ? uprighted(four.force, four.chord, four.direction) : four.force;
  Lanes3 target = clampLength(across(force, four.direction) * (splat(common.compliance) * four.water.yields), 1.0f) * splat(kMaxBend);
  if (combed) target = clampLength(rests_.lanes(four.first) + target, kMaxBend);
  four.target = four.targetUntouched = target;
  if (sets_.empty()) return;
  const Lanes3 old = sets_.lanes(four.first);
  const Lanes size = sqrtOf(dot(old, old));
  Lanes left = (size + kForgotten) * four.water.setLeft - kForgotten;
  left = left > kStillAngle ? left : splat(0.0f);
  const Lanes3 now = old * (left / max(size, splat(1e-6f)));
  sets_.set(four.first, now);
  four.target = clampLength(target + now, kMostPressed);
  four.touched = left * left;
}

[[gnu::always_inline]] inline void BendField::swing(FourStrands& four, const StepForces& common) {
  const Lanes3& n = four.direction;
  Lanes3 v = velocities_.lanes(four.first);
  if (common.moving) v = clampLength(v + across(rests_.empty() ? four.kick : uprighted(four.kick, four.chord, n), n), kMaxSpeed);
  four.before = bends_.lanes(four.first);
  const Lanes3 x = four.before - four.target;
  four.left = x * four.water.xx + v * four.water.xv;
  four.speed = x * four.water.vx + v * four.water.vv;
  four.bend = four.target + four.left;
  const Lanes squared = dot(four.bend, four.bend);
  // What was pressed flatter may only rise.
  const Lanes limit = max(dot(four.before, four.before), splat(kMaxBend * kMaxBend));
  const LaneMask over = squared > limit;
  if (!any(over)) return;
  // It has come to the skin, without a bounce.
  const Lanes3 outward = four.bend * (1.0f / sqrtOf(max(squared, splat(1.0f))));
  four.bend = select(over, outward * sqrtOf(limit), four.bend);
  four.speed = select(over, four.speed - outward * max(dot(four.speed, outward), splat(0.0f)), four.speed);
}

// Whether any of the four is touched.
[[gnu::always_inline]] inline bool BendField::press(FourStrands& four) {
  bool touched = false;
  for (const Press& press : presses_) {
    const LaneMask held = press.apply(four.bend, four.before, four.position, four.direction, load(&lengths_[four.first]) * lastForces_.furLength);
    if (!any(held)) continue;
    touched = true;
    four.speed = select(held, Lanes3{}, four.speed);
    four.left = select(held, four.bend - four.before, four.left);
    four.touched = held ? splat(0.0f) : four.touched;
    sets_.set(four.first, select(held, four.bend - four.targetUntouched, sets_.lanes(four.first)));
  }
  return touched;
}

// Swing: one step. Jump: to the equilibrium of the forces, with what touch has left.
void BendField::advanceBlock(const StepForces& common, std::size_t number, Advance how) {
  Block& block = blocks_[number];
  const bool differ = !levels_.empty(), swings = how == Advance::Swing, pressed = swings && reached(block);
  // Neighbours are as wet as each other and of one type, mostly.
  std::array<std::uint16_t, kLanes> levels{};
  FourStrands four;
  four.water = wetLanes(common.wet, levels.data());
  Lanes worstAngle = splat(0.0f), worstSpeed = splat(0.0f);  // squared
  block.touched = false;
  for (std::size_t i = number * Columns::kBlock; i < (number + 1) * Columns::kBlock; i += kLanes) {
    if (differ && std::memcmp(levels.data(), &levels_[i], sizeof levels) != 0) {
      std::memcpy(levels.data(), &levels_[i], sizeof levels);
      four.water = wetLanes(common.wet, &levels_[i]);
    }
    four.first = i;
    four.position = positions_.lanes(i);
    four.direction = directions_.lanes(i);
    four.chord = rests_.empty() ? four.direction : chords_.lanes(i);
    four.kick = Lanes3{};
    four.touched = splat(0.0f);
    findForces(four, common, swings);
    findTarget(four, common);
    if (!swings) {
      bends_.set(i, four.target);
      velocities_.set(i, Lanes3{});
      continue;
    }
    swing(four, common);
    if (pressed) block.touched |= press(four);
    worstAngle = max(worstAngle, max(dot(four.left, four.left), four.touched));
    worstSpeed = max(worstSpeed, dot(four.speed, four.speed));
    bends_.set(i, four.bend);
    velocities_.set(i, four.speed);
  }
  const float farthest = largest(worstAngle);
  left_ = std::max(left_, farthest);
  const bool still = farthest < kStillAngle * kStillAngle && largest(worstSpeed) < kStillSpeed * kStillSpeed;
  block.awake = !still || (swings && common.moving);
  // The last hair's breadth at once; what is held stays where it is held.
  if (swings && !block.awake && !block.touched) return advanceBlock(common, number, Advance::Jump);
  const std::size_t first = number * Columns::kBlock, last = std::min(count_, first + Columns::kBlock);
  for (std::size_t i = first; i < last; ++i) out_[i] = Vec4(bends_.at(i), lengths_[i]);
}

void BendField::advance(const StepForces& common, Advance how) {
  atRest_ = true;
  left_ = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!blocks_[b].awake) continue;
    advanceBlock(common, b, how);
    atRest_ &= !blocks_[b].awake;
  }
}

// None when all is dry. Returns whether it is another one.
bool BendField::takeWetness(const std::vector<float>& wetness) {
  const auto first = wetness.begin(), last = wetness.end();
  const bool wet = wetness.size() == count_ && std::any_of(first, last, [](float w) { return w > 0.0f; });
  if (wet ? wetness_ == wetness : wetness_.empty()) return false;
  wetness_ = wet ? wetness : std::vector<float>();
  findLevels();
  return true;
}

void BendField::findLevels() {
  levels_.clear();
  if (wetness_.empty() && types_.empty()) return;
  levels_.assign(Columns::padded(count_), 0);
  for (std::size_t i = 0; i < count_; ++i) {
    if (!wetness_.empty()) levels_[i] = static_cast<std::uint16_t>(unitOr0(wetness_[i]) * kWetLevels + 0.5f);
    if (!types_.empty()) levels_[i] = static_cast<std::uint16_t>(levels_[i] + types_[i] * (kWetLevels + 1));
  }
}

void BendField::setTypes(std::vector<std::uint8_t> types) {
  FUR_ASSERT(types.empty() || types.size() == count_, "BendField::setTypes()", "one a vertex, or none", types.size());
  if (types == types_) return;
  types_ = std::move(types);
  findLevels();
  wake();
}

// Seconds that passed without a motion: only what touch has left matters.
void BendField::jump(const Mat4& given, const BendForces& forces, float seconds) {
  const Mat4 modelToWorld = finite(given) ? given : lastTransform_;
  lastForces_ = forces;
  lastTransform_ = modelToWorld;
  lastVelocity_ = {};
  hasLast_ = true;
  presses_.clear();
  lastPresses_.clear();
  if (posed_) {
    lastPositions_ = positions_;
    lastMoves_.assign(count_, Vec3(0));
    poseFelt_ = 0;
  }
  wake();
  StepForces common(modelToWorld, forces, forces.wind.mean(), seconds);
  if (!types_.empty()) common.addTypes(forces, seconds);
  advance(common, Advance::Jump);
}

void BendField::step(float dt, const Mat4& given, const BendForces& forces, const std::vector<float>& wetness,
                     std::span<const Contact> contacts) {
  if (!(dt > 0.0f)) return;
  const bool otherWetness = takeWetness(wetness);
  if (dt > kLongestStep) return jump(given, forces, dt);

  const Mat4 modelToWorld = finite(given) ? given : lastTransform_, before = lastTransform_;
  const RigidVelocity change = follow(modelToWorld, dt);
  const float inertia = unitOr0(forces.inertia);
  // What comes and goes is taken as it is in the middle of the step; the velocity changes where the step begins.
  Wind wind = forces.wind;
  wind.time -= 0.5 * static_cast<double>(dt);
  const Mat4 middle = (lastVelocity_.any() ? before + modelToWorld : 2.0f * modelToWorld) * 0.5f;
  const Mat3 toModel = glm::transpose(rotationOf(middle));
  const Mat3 toModelBefore = lastVelocity_.any() ? glm::transpose(rotationOf(before)) : toModel;
  StepForces common(middle, forces, wind, dt);
  if (!types_.empty()) common.addTypes(forces, dt);
  common.moving = lastVelocity_.any() || change.any() || poseFelt_ > 0;
  poseFelt_ = std::max(poseFelt_ - 1, 0);
  common.poseDrag = -kDrag * inertia;
  common.poseKick = -kKick * inertia;
  common.perSecond = 1.0f / dt;
  const Mat3 drag = toModel * common.poseDrag, kick = toModelBefore * common.poseKick;
  common.drag = {drag * lastVelocity_.linear, drag * lastVelocity_.constant};
  common.kick = {kick * change.linear, kick * change.constant};

  BendForces same = forces;
  same.wind.time = lastForces_.wind.time;
  if (common.moving || otherWetness || modelToWorld != before || wind.varies() || !(same == lastForces_)) wake();
  lastForces_ = forces;
  presses_.clear();
  for (const Contact& contact : contacts) presses_.emplace_back(contact, modelToWorld, forces.furLength);
  if (boundsStale_ && !presses_.empty()) boundBlocks();
  if (presses_ != lastPresses_)
    for (Block& block : blocks_) block.awake |= block.touched || reached(block);
  lastPresses_ = presses_;
  if (!presses_.empty() && sets_.empty()) sets_.assign(count_, Vec3(0));

  advance(common, Advance::Swing);
  if (atRest_ && presses_.empty()) sets_.clear();
}

bool BendField::reached(const Block& block) const {
  return std::any_of(presses_.begin(), presses_.end(),
                     [&](const Press& press) { return press.reaches(block.centre, block.radius); });
}

void BendField::settle(const Mat4& modelToWorld, const BendForces& forces, const std::vector<float>& wetness) {
  takeWetness(wetness);
  sets_.clear();
  jump(modelToWorld, forces, 0);
}

Vec2 arcBend(float theta, float t) {
  const float turn = theta * t;
  // The series holds to 1e-9 here, where the quotients have lost half their digits.
  if (std::abs(theta) < 1e-2f) return {t * (1.0f - turn * turn / 6.0f), t * turn * (0.5f - turn * turn / 24.0f)};
  return {std::sin(turn) / theta, (1.0f - std::cos(turn)) / theta};
}

Vec3 strandPoint(const Vec3& root, const Vec3& normal, const Vec3& bend, float length, float h, BendCurve curve) {
  const float theta = glm::length(bend);
  const Vec2 at = length * (curve == BendCurve::Arc ? arcBend(theta, h) : windBend(theta / kMaxBend, h));
  return root + normal * at.x + (theta > 1e-5f ? bend * (at.y / theta) : Vec3(0));
}

Vec2 windBend(float force, float t) {
  const float f = saturate(force);
  const float across = 0.861986f * f - 0.176676f * f * f;
  const float along = 1.0f - 0.04743f * f - 0.36726f * f * f;
  // The listing multiplies by the unnormalised force once more; the direction is a unit vector.
  return {t * (1.0f - t) + t * t * along, t * t * across};
}

}  // namespace fur::dynamics
