#include "app/OrbitCamera.h"

#include <algorithm>
#include <cmath>

namespace fur::app {

namespace {

// Below the horizon the ground would be seen from underneath.
constexpr float kLowestPitch = -0.12f, kHighestPitch = 1.52f;
constexpr float kNearest = 1.25f, kFarthest = 14.0f, kMaxPan = 1.5f;
// Time constant of the glide, seconds.
constexpr float kGlide = 0.07f;

CameraOrbit limited(CameraOrbit o) {
  o.pitch = std::clamp(o.pitch, kLowestPitch, kHighestPitch);
  o.distance = std::clamp(o.distance, kNearest, kFarthest);
  o.target = glm::clamp(o.target, Vec3(-kMaxPan), Vec3(kMaxPan));
  return o;
}

float difference(const CameraOrbit& a, const CameraOrbit& b) {
  return std::abs(a.yaw - b.yaw) + std::abs(a.pitch - b.pitch) + std::abs(a.distance - b.distance) +
         glm::length(a.target - b.target);
}

Vec3 backward(const CameraOrbit& o) {
  return {std::sin(o.yaw) * std::cos(o.pitch), std::sin(o.pitch), std::cos(o.yaw) * std::cos(o.pitch)};
}

}  // namespace

void OrbitCamera::setGoal(const CameraOrbit& orbit) { goal_ = limited(orbit); }

void OrbitCamera::jump(const CameraOrbit& orbit) { shown_ = goal_ = limited(orbit); }

void OrbitCamera::orbit(float yaw, float pitch) {
  goal_.yaw += yaw;
  goal_.pitch += pitch;
  goal_ = limited(goal_);
}

void OrbitCamera::zoom(float factor) {
  goal_.distance *= factor;
  goal_ = limited(goal_);
}

void OrbitCamera::pan(Vec2 units) {
  const Vec3 back = backward(goal_);
  const Vec3 right = normalizeOr(glm::cross(Vec3(0, 1, 0), back), Vec3(1, 0, 0));
  goal_.target += right * units.x + glm::cross(back, right) * units.y;
  goal_ = limited(goal_);
}

bool OrbitCamera::moving() const { return difference(goal_, shown_) > 1e-4f; }

bool OrbitCamera::update(float dt) {
  if (difference(goal_, shown_) == 0) return false;
  if (!moving()) {
    shown_ = goal_;
    return true;
  }
  const float blend = 1 - std::exp(-dt / kGlide);
  shown_.yaw += blend * (goal_.yaw - shown_.yaw);
  shown_.pitch += blend * (goal_.pitch - shown_.pitch);
  shown_.distance += blend * (goal_.distance - shown_.distance);
  shown_.target += blend * (goal_.target - shown_.target);
  return true;
}

render::CameraPose OrbitCamera::pose(float aspect) const {
  const float stretch = std::max(1.0f, 1.0f / std::max(aspect, 0.2f));
  return {shown_.target + backward(shown_) * (shown_.distance * stretch), shown_.target, kFovY};
}

}  // namespace fur::app
