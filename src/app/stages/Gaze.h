// Where an animal looks: its eyes go there first, head and neck follow, all within limits and no faster than an animal does.
// Angles are radians: x to its left, y up, from where the animation that plays has its head and eyes. The same bits everywhere.
#pragma once

#include <optional>

#include "core/Math.h"

namespace fur::app {

class Gaze {
 public:
  // Model space, rotations alone, as they are shown with the turns of the last update().
  struct Frame {
    Mat3 neck{1.0f}, head{1.0f};
    Vec3 eyes{0};  // the place between them
    bool hasNeck = true;
  };
  static constexpr Vec2 kHeadLimit{1.1f, 0.55f}, kEyeLimit{0.42f, 0.3f};
  static constexpr float kHeadSpeed = 2.6f, kEyeSpeed = 9;  // radians a second
  static constexpr float kBehind = 2.3f;  // further round than this it does not try

  // `target`: what it looks at, model space; none: ahead. `share`: 0..1 of what it would turn.
  void update(float seconds, const std::optional<Vec3>& target, float share, const Frame& shown);
  void reset() { *this = {}; }
  bool moving() const { return moving_; }

  Vec2 headAngles() const { return head_; }
  Vec2 eyeAngles() const { return eyes_; }
  // In the axes of each joint. The head's counts from the neck's.
  Quat neckTurn() const { return neckTurn_; }
  Quat headTurn() const { return turnOf((1 - neckShare_) * head_); }
  Quat eyeTurn() const { return turnOf(eyes_); }

 private:
  static Quat turnOf(Vec2 angles);
  Quat turn() const { return turnOf(neckShare_ * head_) * headTurn(); }  // of neck and head together
  void turnHead(float seconds, Vec2 goal);
  void turnEyes(float seconds, Vec2 goal);

  Vec2 head_{0}, headSpeed_{0}, headGoal_{0}, eyes_{0};
  Quat neckTurn_{1, 0, 0, 0};
  float neckShare_ = 0;
  bool moving_ = false, behind_ = false;
};

}  // namespace fur::app
