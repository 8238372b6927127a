// A camera on a sphere round its target, gliding to where it was sent. The free one is kept as the same numbers: it turns where it
// is, and takes its target along.
#pragma once

#include "app/App.h"
#include "render/Frame.h"

namespace fur::app {

// In the order of the setting "cameraMode".
enum class CameraMode { Orbit, Free };

class OrbitCamera {
 public:
  static constexpr float kFovY = 0.6f;  // unless it is set
  // What the camera takes to go round the model while nobody is there.
  static constexpr float kTurnSeconds = 64;
  // The yaw that a turn of so many seconds, or the other way round of less than none, goes through in `seconds`.
  static constexpr float turned(float seconds, float secondsPerTurn) { return -2 * kPi * seconds / secondsPerTurn; }

  // That shows a sphere.
  static CameraOrbit fitting(const Vec3& centre, float radius);

  const CameraOrbit& goal() const { return goal_; }
  // From free to orbit it glides back to where one may be.
  void setMode(CameraMode mode);
  bool isFree() const { return mode_ == CameraMode::Free; }
  void setGoal(const CameraOrbit& orbit);
  void jump(const CameraOrbit& orbit);  // without gliding
  void orbit(float yaw, float pitch);
  void zoom(float factor);  // a free one goes as far forwards or back
  void pan(Vec2 modelUnits);  // right and up in the picture
  // Of a free one: turns where it is, as it moves; and goes right, up (in the world) and forwards.
  void look(float yaw, float pitch, float aspect);
  void fly(const Vec3& modelUnits);
  void turn(float yaw);  // as it moves, without gliding
  void setFov(float radians);
  // See App::setPadding() and setCovered(). left, top, right, bottom
  void setPadding(const Vec4& shares, bool atOnce);
  void setCovered(Vec2 shares, bool atOnce);
  // Of the free part, as shares of the picture from its left and top edge.
  Vec2 middle() const;
  // While true, as if nothing were covered (a saved picture has no panel).
  void ignoreCovered(bool ignore) { ignoreCovered_ = ignore; }

  // Returns whether it moved.
  bool update(float dt);
  bool moving() const;
  // Stands further back when the free part of the picture is narrow, so that the model fits.
  render::CameraPose pose(float aspect) const;

 private:
  float way() const;  // how far what is shown is from where it glides
  Vec4 covered() const;
  CameraOrbit limited(CameraOrbit orbit) const;
  // From the orbit's target: the eye, and what is in the middle of the picture.
  struct Reach {
    Vec3 eye, middle;
  };
  Reach reachOf(const CameraOrbit& orbit, float aspect) const;

  CameraOrbit goal_, shown_;
  CameraMode mode_ = CameraMode::Orbit;
  float fovY_ = kFovY;
  Vec2 panel_{0};
  Vec4 padding_{0}, coveredShown_{0};  // the latter: of both
  bool ignoreCovered_ = false;
};

}  // namespace fur::app
