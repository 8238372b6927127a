#include "app/stages/Touch.h"

#include "core/PortableMath.h"

namespace fur::app {

namespace {

constexpr float kBallFollow = 18.0f;  // 1/s: how fast the ball comes to where it is pulled
constexpr float kArrived = 1e-4f;
constexpr float kBallGrip = 0.4f, kHandGrip = 1.0f;

}  // namespace

void Touch::stroke(const Vec3& at, float radius) {
  if (!handGoal_) hand_ = at;
  handGoal_ = at;
  handRadius_ = radius;
}

void Touch::pull(const Vec3& to) {
  ballGoal_ = to;
  if (!ball_) ball_ = to;
}

std::optional<Ball> Touch::ball() const {
  if (!ball_) return std::nullopt;
  return Ball{*ball_, ballRadius_};
}

bool Touch::moving() const {
  const std::size_t touching = (handGoal_ ? 1u : 0u) + (ball_ ? 1u : 0u);
  return touching != count_ || (handGoal_ && *hand_ != *handGoal_) || (ball_ && *ball_ != *ballGoal_) ||
         (count_ > 0 && contacts_[0].from != contacts_[0].to);
}

bool Touch::update(float dt) {
  count_ = 0;
  if (handGoal_) {
    contacts_[count_++] = {*hand_, *handGoal_, handRadius_, kHandGrip, dynamics::kMaxBend};
    hand_ = handGoal_;
  }
  if (!ball_) return false;
  const Vec3 before = *ball_, way = *ballGoal_ - before;
  ball_ = glm::length(way) < kArrived ? *ballGoal_ : before + way * (1.0f - portableExp(-std::min(kBallFollow * dt, 80.0f)));
  contacts_[count_++] = {before, *ball_, ballRadius_, kBallGrip};
  return *ball_ != before;
}

}  // namespace fur::app
