// The rigid motion of the model under the hand: it can be dragged about, springs back when let go,
// and spins on after a push.
#pragma once

#include "core/Math.h"

namespace fur::app {

class ModelMotion {
 public:
  void grab() { held_ = true; }
  void drag(const Vec3& worldStep) { goal_ += worldStep; }
  void spin(float radians);  // turned by hand; keeps turning at that speed
  void release();
  void reset() { *this = {}; }

  // Returns whether it moved.
  bool update(float dt);
  bool moving() const;
  Mat4 worldFromModel() const;

 private:
  bool held_ = false;
  Vec3 goal_{0}, position_{0}, velocity_{0};
  float yaw_ = 0, yawVelocity_ = 0, turned_ = 0;
};

}  // namespace fur::app
