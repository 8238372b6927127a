// What is seen: the camera, the size of the picture, and ways between its pixels and the model.
#pragma once

#include "app/view/OrbitCamera.h"
#include "render/Frame.h"

namespace fur::app {

struct Ray {
  Vec3 origin, direction;  // the latter unit
};

struct View {
  OrbitCamera camera;
  int width = 300, height = 150;  // pixels of the drawing buffer
  float pixelRatio = 1;
  bool autoRotate = false, cameraControls = true;

  render::CameraPose pose() const { return camera.pose(static_cast<float>(width) / static_cast<float>(height)); }
  Vec2 size() const { return Vec2(width, height); }
  Mat4 clipFromWorld() const { return render::clipFromWorld(frame()); }
  // Through a pixel, in the space of the model.
  Ray rayThrough(Vec2 pixel, const Mat4& worldFromModel) const;
  // The pixel at which a place of clip space is seen.
  Vec2 pixelAt(const Vec4& clip) const { return (Vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * size(); }
  // How much a pixel covers at a distance from the eye; model units.
  float unitsPerPixel(float distance) const { return distance / render::pixelsPerUnit(frame()); }
  float distance() const { return glm::length(pose().eye - pose().target); }  // of the camera's target
  // A step in the picture as a step in the world, in the plane through the camera's target that faces the eye.
  Vec3 stepInPlane(Vec2 pixels) const;

 private:
  render::Frame frame() const;  // camera and size alone
};

}  // namespace fur::app
