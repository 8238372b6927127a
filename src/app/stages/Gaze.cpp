#include "app/stages/Gaze.h"

#include <algorithm>
#include <cmath>

#include "core/PortableMath.h"

namespace fur::app {

namespace {

constexpr float kEyesAlone = 0.12f;  // rad: for so little the head does not turn
constexpr float kFollows = 7;        // 1/s: how eagerly the head turns, critically damped
constexpr float kNeckShare = 0.4f;
constexpr float kGazeStep = 1.0f / 120;
constexpr float kGazeStill = 1e-4f;

// The angle of (x, y) from the x axis, -pi to pi.
float angleOf(float y, float x) {
  const float along = std::sqrt(x * x + y * y) + x;
  if (along > 1e-6f * std::abs(y)) return 2 * portableAtan(y / along);
  return y < 0 ? -kPi : y > 0 || x < 0 ? kPi : 0;
}

// Of a direction from straight ahead, z.
Vec2 anglesOf(const Vec3& way) {
  const Vec2 angles(angleOf(way.x, way.z), angleOf(way.y, std::sqrt(way.x * way.x + way.z * way.z)));
  return std::isfinite(angles.x + angles.y) ? angles : Vec2(0);
}

Vec2 clamped(Vec2 angles, Vec2 limit) { return glm::clamp(angles, -limit, limit); }

}  // namespace

// About its own y, then x, both of which it keeps; y up is against the right-handed turn about x.
Quat Gaze::turnOf(Vec2 angles) {
  const Vec2 half = 0.5f * angles;
  return Quat(portableCos(half.x), 0, portableSin(half.x), 0) * Quat(portableCos(half.y), -portableSin(half.y), 0, 0);
}

void Gaze::turnHead(float seconds, Vec2 goal) {
  for (float left = seconds; left > 0; left -= kGazeStep) {
    const float step = std::min(left, kGazeStep);
    headSpeed_ += step * kFollows * (kFollows * (goal - head_) - 2.0f * headSpeed_);
    const float speed = glm::length(headSpeed_);
    if (speed > kHeadSpeed) headSpeed_ *= kHeadSpeed / speed;
    head_ += step * headSpeed_;
  }
  const Vec2 within = clamped(head_, kHeadLimit);
  for (int i = 0; i < 2; ++i)
    if (within[i] != head_[i]) headSpeed_[i] = 0;
  head_ = within;
}

void Gaze::turnEyes(float seconds, Vec2 goal) {
  const Vec2 way = clamped(goal, kEyeLimit) - eyes_;
  const float far = glm::length(way), reach = kEyeSpeed * seconds;
  eyes_ += far > reach ? way * (reach / far) : way;
}

void Gaze::update(float seconds, const std::optional<Vec3>& target, float share, const Frame& shown) {
  const Vec2 headBefore = head_, eyesBefore = eyes_;
  // As the animation has them, without the turns of the last update.
  const Mat3 head = shown.head * glm::transpose(glm::mat3_cast(turn()));
  const Quat headInNeck = glm::quat_cast(glm::transpose(shown.neck) * shown.head) * glm::conjugate(headTurn());
  const Vec3 way = target ? glm::transpose(head) * (*target - shown.eyes) : Vec3(0, 0, 1);
  Vec2 want = anglesOf(way);
  // So that it does not swing from one side to the other for what is right behind it.
  behind_ = std::abs(want.x) > (behind_ ? kBehind - 0.3f : kBehind);
  const bool looks = target && !behind_;
  want = looks ? want * share : Vec2(0);
  if (!looks || glm::length(want - headGoal_) > kEyesAlone) headGoal_ = want;
  const Vec2 goal = clamped(headGoal_, kHeadLimit);
  neckShare_ = shown.hasNeck ? kNeckShare : 0;
  turnHead(std::min(seconds, 0.25f), goal);
  turnEyes(seconds, looks ? share * anglesOf(glm::transpose(glm::mat3_cast(turn())) * way) : Vec2(0));
  neckTurn_ = headInNeck * turnOf(neckShare_ * head_) * glm::conjugate(headInNeck);
  moving_ = glm::length(head_ - headBefore) + glm::length(eyes_ - eyesBefore) > kGazeStill * seconds || glm::length(goal - head_) > kGazeStill;
  // The last hair's breadth, so that it comes to rest.
  if (!moving_) head_ = goal, headSpeed_ = Vec2(0);
}

}  // namespace fur::app
