#include "render/Frame.h"

#include <algorithm>
#include <cmath>

#include "render/Samples.h"

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
  const Vec2 aside = 2.0f * sampleOffset(frame.sample) / Vec2(frame.width, frame.height);
  return glm::translate(Mat4(1), Vec3(aside, 0)) * projection * glm::lookAt(frame.camera.eye, frame.camera.target, Vec3(0, 1, 0));
}

}  // namespace fur::render
