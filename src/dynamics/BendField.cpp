#include "dynamics/BendField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/Assert.h"

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
constexpr float kDryDamping = 0.4f;  // of critical: a quarter of overshoot, gone after one swing
constexpr float kWetDamping = 0.9f;
constexpr float kWaterMass = 1.5f;   // of soaked fur, in masses of dry fur
constexpr float kWetWind = 0.5f;     // share of the wind that a soaked coat no longer catches
constexpr float kShelter = 0.4f;     // share of the wind on the lee side

// Below these nobody sees a strand of a tenth of the picture's height move.
constexpr float kStillAngle = 5e-4f;  // rad
constexpr float kStillSpeed = 5e-3f;  // rad/s

constexpr int kWetLevels = 16;

Vec3 finiteOr0(const Vec3& v) { return std::isfinite(v.x + v.y + v.z) ? v : Vec3(0); }
float unitOr0(float x) { return x > 0.0f ? std::min(x, 1.0f) : 0.0f; }

bool finite(const Mat4& m) {
  float sum = 0;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) sum += m[c][r];
  return std::isfinite(sum);
}

// The rotation of a rigid (perhaps uniformly scaled) transform.
Mat3 rotationOf(const Mat4& m) {
  return Mat3(normalizeOr(Vec3(m[0]), Vec3(1, 0, 0)), normalizeOr(Vec3(m[1]), Vec3(0, 1, 0)),
              normalizeOr(Vec3(m[2]), Vec3(0, 0, 1)));
}

// The farthest that a point of the unit ball goes between two transforms, or a little more.
float farthestMove(const Mat4& from, const Mat4& to) {
  float turned = 0;
  for (int c = 0; c < 3; ++c) turned += glm::dot(Vec3(to[c] - from[c]), Vec3(to[c] - from[c]));
  // |R - I| in the Frobenius norm is sqrt(2) times the move of a point on the equator.
  return glm::length(Vec3(to[3] - from[3])) + std::sqrt(0.5f * turned);
}

// One step of x'' = -omega^2 x - 2 zeta omega x', exactly: any dt is stable, and n steps of dt
// lead where one step of n dt does.
struct Swing {
  float xx, xv, vx, vv;
  Swing() = default;
  Swing(float omega, float zeta, float dt) {
    const float turning = omega * std::sqrt(1.0f - zeta * zeta);
    const float decay = std::exp(-zeta * omega * dt), c = std::cos(turning * dt), s = std::sin(turning * dt);
    const float lean = zeta * omega / turning * s;
    xx = decay * (c + lean);
    xv = decay * s / turning;
    vx = -decay * omega * omega / turning * s;
    vv = decay * (c - lean);
  }
};

using SwingTable = std::array<Swing, kWetLevels + 1>;

SwingTable swingTable(const BendForces& forces, float dt) {
  SwingTable table;
  const float omega = 6.0f * std::pow(4.0f, unitOr0(forces.stiffness));  // 1 to 4 swings a second
  for (int level = 0; level <= kWetLevels; ++level) {
    const float wet = static_cast<float>(level) / kWetLevels;
    const float mass = (0.6f + 0.8f * unitOr0(forces.weight)) * (1.0f + kWaterMass * wet);
    table[static_cast<std::size_t>(level)] =
        Swing(omega / std::sqrt(mass), kDryDamping + (kWetDamping - kDryDamping) * wet, dt);
  }
  return table;
}

Vec3 across(const Vec3& v, const Vec3& direction) { return v - direction * glm::dot(v, direction); }

Vec3 capped(const Vec3& v, float limit) {
  const float squared = glm::dot(v, v);
  return squared > limit * limit ? v * (limit / std::sqrt(squared)) : v;
}

// An affine map of rest positions to model-space vectors.
struct Flow {
  Mat3 linear{0.0f};
  Vec3 constant{0};
  Vec3 at(const Vec3& p) const { return linear * p + constant; }
};

// The forces that do not depend on the vertex, in model space.
struct Climate {
  Vec3 gravity, wind, windDirection;
  Flow drag, kick;
  float compliance;
  bool moving = false;

  Vec3 forceAt(const Vec3& position, const Vec3& direction, float wet) const {
    const float facing = saturate(0.5f - 0.5f * glm::dot(direction, windDirection));
    const float exposure = (kShelter + (1.0f - kShelter) * facing) * (1.0f - kWetWind * wet);
    Vec3 force = gravity * (1.0f + kWaterMass * wet) + wind * exposure;
    if (moving) force += drag.at(position);
    return force;
  }
  // The bend in which this force is held by an upright strand.
  Vec3 bendBy(const Vec3& force, const Vec3& direction) const {
    return capped(across(force, direction) * compliance, 1.0f) * kMaxBend;
  }
};

Climate climateIn(const Mat4& modelToWorld, const BendForces& forces) {
  const Mat3 toModel = glm::transpose(rotationOf(modelToWorld));
  Climate climate;
  // Sheppard 5.2.1 gives every coat a floor of weight, the rest is the type's own.
  climate.gravity = toModel * finiteOr0(forces.gravity) * (0.5f + unitOr0(forces.weight));
  climate.wind = toModel * finiteOr0(forces.wind);
  climate.windDirection = normalizeOr(climate.wind, Vec3(0));
  climate.compliance = 2.5f * std::pow(0.16f, unitOr0(forces.stiffness));  // 2.5 soft, 1 at 0.5, 0.4 stiff
  return climate;
}

float wetAt(const std::vector<float>& wetness, std::size_t i) { return wetness.empty() ? 0.0f : unitOr0(wetness[i]); }

}  // namespace

void BendField::reset(const std::vector<Vec3>& positions, const std::vector<Vec3>& directions) {
  FUR_ASSERT(positions.size() == directions.size(), "BendField::reset()", "a direction for every position",
             directions.size());
  positions_ = positions;
  directions_ = directions;
  velocities_.assign(positions.size(), Vec3(0));
  bends_.assign(positions.size(), Vec4(0, 0, 0, 1));
  rests_.clear();
  chords_.clear();
  lastVelocity_ = {};
  hasLast_ = false;
  atRest_ = true;
}

void BendField::setRest(std::vector<Vec3> rests, const std::vector<float>& lengths) {
  const auto fits = [this](std::size_t count) { return count == 0 || count == positions_.size(); };
  FUR_ASSERT(fits(rests.size()) && fits(lengths.size()), "BendField::setRest()", "one of each a vertex, or none", rests.size());
  rests_ = std::move(rests);
  chords_.clear();
  chords_.reserve(rests_.size());
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    rests_[i] = capped(across(finiteOr0(rests_[i]), directions_[i]), kMaxBend);
    const float half = 0.5f * glm::length(rests_[i]);
    chords_.push_back(directions_[i] * std::cos(half) + normalizeOr(rests_[i], Vec3(0)) * std::sin(half));
  }
  for (std::size_t i = 0; i < bends_.size(); ++i) bends_[i].w = lengths.empty() ? 1.0f : unitOr0(lengths[i]);
}

// The shortest rotation that takes the chord to the direction (Rodrigues); they are at most 0.7 rad apart.
Vec3 BendField::uprighted(const Vec3& force, std::size_t i) const {
  if (chords_.empty()) return force;
  const Vec3 axis = glm::cross(chords_[i], directions_[i]), once = glm::cross(axis, force);
  return force + once + glm::cross(axis, once) / (1.0f + glm::dot(chords_[i], directions_[i]));
}

template <class Climate>
Vec3 BendField::targetAt(const Climate& climate, std::size_t i, float wet) const {
  const Vec3& direction = chords_.empty() ? directions_[i] : chords_[i];
  const Vec3 bend = climate.bendBy(uprighted(climate.forceAt(positions_[i], direction, wet), i), directions_[i]);
  return rests_.empty() ? bend : capped(rests_[i] + bend, kMaxBend);
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

void BendField::step(float dt, const Mat4& given, const BendForces& forces, const std::vector<float>& wetness) {
  if (!(dt > 0.0f)) return;
  const Mat4 modelToWorld = finite(given) ? given : lastTransform_;
  const std::vector<float> none;
  const std::vector<float>& wet = wetness.size() == positions_.size() ? wetness : none;
  if (dt > kLongestStep) return settle(modelToWorld, forces, wet);

  const RigidVelocity change = follow(modelToWorld, dt);
  const Mat3 toModel = glm::transpose(rotationOf(modelToWorld));
  const float inertia = unitOr0(forces.inertia);
  Climate climate = climateIn(modelToWorld, forces);
  climate.moving = lastVelocity_.any() || change.any();
  const Mat3 drag = toModel * (-kDrag * inertia), kick = toModel * (-kKick * inertia);
  climate.drag = {drag * lastVelocity_.linear, drag * lastVelocity_.constant};
  climate.kick = {kick * change.linear, kick * change.constant};
  const SwingTable swings = swingTable(forces, dt);
  float worstAngle = 0, worstSpeed = 0;  // squared
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const float water = wetAt(wet, i);
    const Swing& swing = swings[static_cast<std::size_t>(water * kWetLevels + 0.5f)];
    const Vec3 target = targetAt(climate, i, water);
    Vec3 v = velocities_[i];
    if (climate.moving) v = capped(v + across(uprighted(climate.kick.at(positions_[i]), i), directions_[i]), kMaxSpeed);
    const Vec3 x = Vec3(bends_[i]) - target;
    const Vec3 left = swing.xx * x + swing.xv * v, speed = swing.vx * x + swing.vv * v;
    worstAngle = std::max(worstAngle, glm::dot(left, left));
    worstSpeed = std::max(worstSpeed, glm::dot(speed, speed));
    velocities_[i] = speed;
    bends_[i] = Vec4(capped(target + left, kMaxBend), bends_[i].w);
  }
  const bool still = worstAngle < kStillAngle * kStillAngle && worstSpeed < kStillSpeed * kStillSpeed;
  // A moving model may balance its fur for a moment, but will not stop without swinging it.
  atRest_ = still && !climate.moving;
  if (atRest_) settle(modelToWorld, forces, wet);
}

void BendField::settle(const Mat4& given, const BendForces& forces, const std::vector<float>& wetness) {
  const Mat4 modelToWorld = finite(given) ? given : lastTransform_;
  const Climate climate = climateIn(modelToWorld, forces);
  const bool wet = wetness.size() == positions_.size();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    bends_[i] = Vec4(targetAt(climate, i, wet ? wetAt(wetness, i) : 0.0f), bends_[i].w);
    velocities_[i] = Vec3(0);
  }
  lastTransform_ = modelToWorld;
  lastVelocity_ = {};
  hasLast_ = true;
  atRest_ = true;
}

Vec2 arcBend(float theta, float t) {
  const float turn = theta * t;
  // The series holds to 1e-9 here, where the quotients have lost half their digits.
  if (std::abs(theta) < 1e-2f) return {t * (1.0f - turn * turn / 6.0f), t * turn * (0.5f - turn * turn / 24.0f)};
  return {std::sin(turn) / theta, (1.0f - std::cos(turn)) / theta};
}

Vec3 strandPoint(const Vec3& root, const Vec3& normal, const Vec3& bend, float length, float h) {
  const float theta = glm::length(bend);
  const Vec2 arc = arcBend(theta, h) * length;
  return root + normal * arc.x + (theta > 1e-5f ? bend * (arc.y / theta) : Vec3(0));
}

Vec2 windBend(float force, float t) {
  const float f = saturate(force);
  const float across = 0.861986f * f - 0.176676f * f * f;
  const float along = 1.0f - 0.04743f * f - 0.36726f * f * f;
  // The listing multiplies by the unnormalised force once more; the direction is a unit vector.
  return {t * (1.0f - t) + t * t * along, t * t * across};
}

}  // namespace fur::dynamics
