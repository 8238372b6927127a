#include "render/Frame.h"

#include <algorithm>
#include <cmath>

namespace fur::render {

float pixelsPerUnit(const Frame& frame) {
  return static_cast<float>(frame.height) / (2 * std::tan(frame.camera.fovY / 2));
}

Mat4 clipFromWorld(const Frame& frame) {
  const float aspect = static_cast<float>(frame.width) / static_cast<float>(std::max(frame.height, 1));
  // A free camera's target is anywhere; the model is round the origin.
  const bool isFree = frame.settings.cameraMode > 0;
  const float distance = glm::length(frame.camera.eye - (isFree ? Vec3(0) : frame.camera.target));
  const Mat4 projection = glm::perspective(frame.camera.fovY, aspect, std::max(0.02f, distance - 3.0f - frame.reach), distance + 7.0f + frame.reach);
  return projection * glm::lookAt(frame.camera.eye, frame.camera.target, Vec3(0, 1, 0));
}

}  // namespace fur::render
