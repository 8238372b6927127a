// A camera on a sphere round its target, gliding to where it was sent.
#pragma once

#include "app/App.h"
#include "render/Frame.h"

namespace fur::app {

class OrbitCamera {
 public:
  static constexpr float kFovY = 0.6f;

  // That shows a sphere.
  static CameraOrbit fitting(const Vec3& centre, float radius);

  const CameraOrbit& goal() const { return goal_; }
  void setGoal(const CameraOrbit& orbit);
  void jump(const CameraOrbit& orbit);  // without gliding
  void orbit(float yaw, float pitch);
  void zoom(float factor);
  void pan(Vec2 modelUnits);  // right and up in the picture
  // See App::setCovered().
  void setCovered(Vec2 shares, bool atOnce);
  // While true, as if nothing were covered (a saved picture has no panel).
  void ignoreCovered(bool ignore) { ignoreCovered_ = ignore; }

  // Returns whether it moved.
  bool update(float dt);
  bool moving() const;
  // Stands further back when the free part of the picture is narrow, so that the model fits.
  render::CameraPose pose(float aspect) const;

 private:
  float way() const;  // how far what is shown is from where it glides

  CameraOrbit goal_, shown_;
  Vec2 coveredGoal_{0}, coveredShown_{0};
  bool ignoreCovered_ = false;
};

}  // namespace fur::app
