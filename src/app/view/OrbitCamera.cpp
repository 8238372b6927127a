#include "app/view/OrbitCamera.h"

#include <algorithm>
#include <cmath>

namespace fur::app {

namespace {

// Below the horizon the ground would be seen from underneath.
constexpr float kLowestPitch = -0.12f, kHighestPitch = 1.52f;
constexpr float kNearest = 1.25f, kFarthest = 14.0f, kMaxPan = 2.2f;
// Of a free camera: how far off its target may be, model units.
constexpr float kMaxRoam = 20.0f;
// Time constant of the glide, seconds.
constexpr float kGlide = 0.07f;
// However large a panel is, the model keeps the rest.
constexpr float kMostCovered = 0.6f;
constexpr float kLeastFov = kPi / 18, kMostFov = kPi / 2;

CameraOrbit within(CameraOrbit o, float lowestPitch, float maxPan) {
  o.pitch = std::clamp(o.pitch, lowestPitch, kHighestPitch);
  o.distance = std::clamp(o.distance, kNearest, kFarthest);
  o.target = glm::clamp(o.target, Vec3(-maxPan), Vec3(maxPan));
  return o;
}

float difference(const CameraOrbit& a, const CameraOrbit& b) {
  return std::abs(a.yaw - b.yaw) + std::abs(a.pitch - b.pitch) + std::abs(a.distance - b.distance) +
         glm::length(a.target - b.target);
}

Vec3 backward(const CameraOrbit& o) {
  return {std::sin(o.yaw) * std::cos(o.pitch), std::sin(o.pitch), std::cos(o.yaw) * std::cos(o.pitch)};
}

Vec3 rightOf(const Vec3& back) { return normalizeOr(glm::cross(Vec3(0, 1, 0), back), Vec3(1, 0, 0)); }

}  // namespace

CameraOrbit OrbitCamera::fitting(const Vec3& centre, float radius) {
  CameraOrbit orbit;
  // The sphere and its fur fill 80 % of the height.
  orbit.distance = (radius + 0.06f) / std::sin(std::atan(0.8f * std::tan(kFovY / 2)));
  orbit.target = centre;
  return within(orbit, kLowestPitch, kMaxPan);
}

CameraOrbit OrbitCamera::limited(CameraOrbit orbit) const {
  return isFree() ? within(orbit, -kHighestPitch, kMaxRoam) : within(orbit, kLowestPitch, kMaxPan);
}

void OrbitCamera::setMode(CameraMode mode) {
  mode_ = mode;
  goal_ = limited(goal_);
}

void OrbitCamera::setGoal(const CameraOrbit& orbit) { goal_ = limited(orbit); }

void OrbitCamera::jump(const CameraOrbit& orbit) { shown_ = goal_ = limited(orbit); }

void OrbitCamera::orbit(float yaw, float pitch) {
  goal_.yaw += yaw;
  goal_.pitch += pitch;
  goal_ = limited(goal_);
}

void OrbitCamera::look(float yaw, float pitch, float aspect) {
  for (CameraOrbit* orbit : {&goal_, &shown_}) {
    const Vec3 eye = orbit->target + reachOf(*orbit, aspect).eye;
    orbit->yaw += yaw;
    orbit->pitch += pitch;
    *orbit = limited(*orbit);
    orbit->target = eye - reachOf(*orbit, aspect).eye;
  }
}

void OrbitCamera::fly(const Vec3& units) {
  const Vec3 back = backward(goal_), up(0, 1, 0);
  goal_.target += rightOf(back) * units.x + up * units.y - back * units.z;
  goal_ = limited(goal_);
}

void OrbitCamera::zoom(float factor) {
  if (isFree()) return fly(Vec3(0, 0, goal_.distance * (1 - factor)));
  goal_.distance *= factor;
  goal_ = limited(goal_);
}

void OrbitCamera::pan(Vec2 units) {
  const Vec3 back = backward(goal_);
  const Vec3 right = rightOf(back);
  goal_.target += right * units.x + glm::cross(back, right) * units.y;
  goal_ = limited(goal_);
}

void OrbitCamera::turn(float yaw) {
  goal_.yaw += yaw;
  shown_.yaw += yaw;
  // For ever, so the numbers are kept small.
  const float rounds = 2 * kPi * std::round(goal_.yaw / (2 * kPi));
  goal_.yaw -= rounds;
  shown_.yaw -= rounds;
}

void OrbitCamera::setFov(float radians) { fovY_ = std::clamp(radians, kLeastFov, kMostFov); }

void OrbitCamera::setPadding(const Vec4& shares, bool atOnce) {
  padding_ = shares;
  if (atOnce) coveredShown_ = covered();
}

void OrbitCamera::setCovered(Vec2 shares, bool atOnce) {
  panel_ = shares;
  if (atOnce) coveredShown_ = covered();
}

// left, top, right, bottom
Vec4 OrbitCamera::covered() const {
  Vec4 c = glm::max(padding_, Vec4(0, 0, panel_.x, panel_.y));
  const Vec2 shrink = kMostCovered / glm::max(Vec2(c.x + c.z, c.y + c.w), Vec2(kMostCovered));
  return c * Vec4(shrink, shrink);
}

Vec2 OrbitCamera::middle() const {
  return ignoreCovered_ ? Vec2(0.5f) : 0.5f + 0.5f * (Vec2(coveredShown_) - Vec2(coveredShown_.z, coveredShown_.w));
}

float OrbitCamera::way() const { return difference(goal_, shown_) + glm::distance(covered(), coveredShown_); }

bool OrbitCamera::moving() const { return way() > 1e-4f; }

bool OrbitCamera::update(float dt) {
  if (way() == 0) return false;
  if (!moving()) {
    shown_ = goal_;
    coveredShown_ = covered();
    return true;
  }
  const float blend = 1 - std::exp(-dt / kGlide);
  shown_.yaw += blend * (goal_.yaw - shown_.yaw);
  shown_.pitch += blend * (goal_.pitch - shown_.pitch);
  shown_.distance += blend * (goal_.distance - shown_.distance);
  shown_.target += blend * (goal_.target - shown_.target);
  coveredShown_ += blend * (covered() - coveredShown_);
  return true;
}

OrbitCamera::Reach OrbitCamera::reachOf(const CameraOrbit& orbit, float aspect) const {
  const Vec4 c = ignoreCovered_ ? Vec4(0) : coveredShown_;
  const Vec2 free = Vec2(std::max(aspect, 0.2f), 1) * (1.0f - Vec2(c.x + c.z, c.y + c.w));  // in picture heights
  const float distance = orbit.distance * std::max(1.0f, 1.0f / std::min(free.x, free.y));
  const Vec3 back = backward(orbit), right = rightOf(back), up = glm::cross(back, right);
  // The middle of the free part lies that far left of and above the middle of all, in half pictures.
  const Vec2 shift = (1.0f - 2.0f * middle()) * Vec2(aspect, 1) * (distance * std::tan(fovY_ / 2));
  const Vec3 middle = right * shift.x - up * shift.y;
  return {middle + back * distance, middle};
}

render::CameraPose OrbitCamera::pose(float aspect) const {
  const Reach reach = reachOf(shown_, aspect);
  return {shown_.target + reach.eye, shown_.target + reach.middle, fovY_};
}

}  // namespace fur::app
