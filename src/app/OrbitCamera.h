// A camera on a sphere round its target, gliding to where it was sent.
#pragma once

#include "app/App.h"
#include "render/Frame.h"

namespace fur::app {

class OrbitCamera {
 public:
  static constexpr float kFovY = 0.6f;

  const CameraOrbit& goal() const { return goal_; }
  void setGoal(const CameraOrbit& orbit);
  void jump(const CameraOrbit& orbit);  // without gliding
  void orbit(float yaw, float pitch);
  void zoom(float factor);
  void pan(Vec2 modelUnits);  // right and up in the picture

  // Returns whether it moved.
  bool update(float dt);
  bool moving() const;
  // Narrow pictures stand further back, so that the model fits the width.
  render::CameraPose pose(float aspect) const;

 private:
  CameraOrbit goal_, shown_;
};

}  // namespace fur::app
