// The rigid motion of the model under the hand: it can be dragged about, springs back when let go,
// and spins on after a push.
#pragma once

#include <algorithm>

#include "core/Math.h"

namespace fur::app {

class ModelMotion {
 public:
  void grab() { held_ = true; }
  void drag(const Vec3& worldStep) { goal_ += worldStep; }
  void spin(float radians);  // turned by hand; keeps turning at that speed
  void release();
  // To and fro for a second, as a wet dog does.
  void shake() { shakeLeft_ = kShakeTime; }
  // How hard it shakes now, 0..1.
  float shaking() const { return shakeLeft_ > 0 ? std::min(1.0f, 2.5f * shakeLeft_ / kShakeTime) : 0.0f; }
  void reset() { *this = {}; }

  // Returns whether it moved.
  bool update(float dt);
  bool moving() const;
  Mat4 worldFromModel() const;

 private:
  static constexpr float kShakeTime = 1.1f;  // seconds

  bool held_ = false;
  float shakeLeft_ = 0;
  Vec3 goal_{0}, position_{0}, velocity_{0};
  float yaw_ = 0, yawVelocity_ = 0, turned_ = 0;
};

}  // namespace fur::app
