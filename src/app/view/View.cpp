#include "app/view/View.h"

namespace fur::app {

render::Frame View::frame() const {
  render::Frame f;
  f.camera = pose();
  f.width = width;
  f.height = height;
  return f;
}

Ray View::rayThrough(Vec2 pixel, const Mat4& worldFromModel) const {
  const Mat4 modelFromClip = glm::inverse(clipFromWorld() * worldFromModel);
  const Vec2 ndc(2 * pixel.x / static_cast<float>(width) - 1, 1 - 2 * pixel.y / static_cast<float>(height));
  const Vec4 nearPoint = modelFromClip * Vec4(ndc, -1, 1), farPoint = modelFromClip * Vec4(ndc, 1, 1);
  const Vec3 origin = Vec3(nearPoint) / nearPoint.w;
  return {origin, normalizeOr(Vec3(farPoint) / farPoint.w - origin, Vec3(0, 0, -1))};
}

Vec3 View::stepInPlane(Vec2 pixels) const {
  const render::CameraPose camera = pose();
  const Vec3 back = glm::normalize(camera.eye - camera.target);
  const Vec3 right = normalizeOr(glm::cross(Vec3(0, 1, 0), back), Vec3(1, 0, 0));
  return (right * pixels.x - glm::cross(back, right) * pixels.y) * unitsPerPixel(distance());
}

}  // namespace fur::app
