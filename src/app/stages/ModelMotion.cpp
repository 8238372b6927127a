#include "app/stages/ModelMotion.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"

namespace fur::app {

namespace {

constexpr float kFollow = 220.0f;  // spring towards the hand (1/s^2), critically damped
constexpr float kReturn = 60.0f;   // spring home once let go, swings a little
constexpr float kSpinTime = 0.9f;  // seconds until a spin has lost 63 % of its speed
constexpr float kMaxReach = 1.2f;  // model units
constexpr float kSwing = 0.3f, kSwings = 5.0f;  // of a shake: radians, a second
constexpr float kSubStep = 1.0f / 120.0f;

}  // namespace

void ModelMotion::spin(float radians) {
  held_ = true;
  yaw_ += radians;
  turned_ += radians;
}

void ModelMotion::release() {
  held_ = false;
  goal_ = Vec3(0);
}

bool ModelMotion::moving() const {
  return held_ || glm::length(position_ - goal_) > 1e-4f || glm::length(velocity_) > 1e-3f ||
         std::abs(yawVelocity_) > 1e-3f || shakeLeft_ > 0;
}

bool ModelMotion::update(float dt) {
  if (!moving()) {
    position_ = goal_;
    velocity_ = Vec3(0);
    yawVelocity_ = 0;
    return false;
  }
  const float reach = glm::length(goal_);
  if (reach > kMaxReach) goal_ *= kMaxReach / reach;
  dt = std::min(dt, 0.1f);
  shakeLeft_ = std::max(shakeLeft_ - dt, 0.0f);
  if (held_ && dt > 0) {
    // The speed of the hand over the last frames.
    const float blend = std::min(1.0f, dt / 0.05f);
    yawVelocity_ += blend * (turned_ / dt - yawVelocity_);
    turned_ = 0;
  } else {
    yaw_ += yawVelocity_ * dt;
    yawVelocity_ *= portableExp(-dt / kSpinTime);
  }
  const float stiffness = held_ ? kFollow : kReturn;
  const float damping = (held_ ? 2.0f : 1.1f) * std::sqrt(stiffness);
  for (float rest = dt; rest > 0; rest -= kSubStep) {
    const float step = std::min(rest, kSubStep);
    velocity_ += step * (stiffness * (goal_ - position_) - damping * velocity_);
    position_ += step * velocity_;
  }
  return true;
}

Mat4 ModelMotion::worldFromModel() const {
  const float swing = kSwing * shaking() * portableSin(2 * kPi * kSwings * shakeLeft_);
  // The same bits everywhere: water goes by it.
  const float c = portableCos(yaw_ + swing), s = portableSin(yaw_ + swing);
  return {Vec4(c, 0, -s, 0), Vec4(0, 1, 0, 0), Vec4(s, 0, c, 0), Vec4(position_, 1)};
}

}  // namespace fur::app
