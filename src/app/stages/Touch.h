// What a person touches the fur with: a hand that strokes it, and a ball that can be dragged about. World space.
#pragma once

#include <optional>
#include <span>

#include "dynamics/Contact.h"

namespace fur::app {

struct Ball {
  Vec3 centre{0};
  float radius = 0;
};

class Touch {
 public:
  // The hand goes there, or comes down there.
  void stroke(const Vec3& at, float radius);
  void lift() { handGoal_.reset(); }
  const std::optional<Vec3>& hand() const { return handGoal_; }
  // The ball follows to there; there is none until then.
  void pull(const Vec3& to);
  void setBallSize(float radius) { ballRadius_ = radius; }
  void removeBall() { ballGoal_.reset(), ball_.reset(); }
  std::optional<Ball> ball() const;

  // Whether the next update() changes what touches the fur.
  bool moving() const;
  // One step of dt > 0 seconds. Returns whether the ball has moved.
  bool update(float dt);
  // Of that step.
  std::span<const dynamics::Contact> contacts() const { return {contacts_, count_}; }

 private:
  std::optional<Vec3> hand_, handGoal_, ball_, ballGoal_;
  float handRadius_ = 0, ballRadius_ = 0.25f;
  dynamics::Contact contacts_[2];
  std::size_t count_ = 0;
};

}  // namespace fur::app
