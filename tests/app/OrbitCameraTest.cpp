// Where the camera shows its target, and how it moves by itself.
#include "app/view/OrbitCamera.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace fur::app {
namespace {

constexpr float kAspect = 1.6f;

// As shares of the picture, from its left and top edge.
Vec2 shownAt(const OrbitCamera& camera, const Vec3& world) {
  const render::CameraPose pose = camera.pose(kAspect);
  const Vec4 clip = glm::perspective(pose.fovY, kAspect, 0.1f, 50.0f) * glm::lookAt(pose.eye, pose.target, Vec3(0, 1, 0)) * Vec4(world, 1);
  return Vec2(0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w);
}

OrbitCamera fitted() {
  OrbitCamera camera;
  CameraOrbit orbit = OrbitCamera::fitting(Vec3(0), 1);
  orbit.yaw = 0.7f;
  camera.jump(orbit);
  return camera;
}

TEST(OrbitCamera, ShowsItsTargetInTheMiddleOfWhatIsFree) {
  for (const Vec4& padding : {Vec4(0), Vec4(0.1f, 0, 0.2f, 0), Vec4(0, 0.2f, 0, 0), Vec4(0, 0, 0, 0.25f), Vec4(0.1f, 0.05f, 0.3f, 0.2f)}) {
    OrbitCamera camera = fitted();
    camera.setPadding(padding, true);
    const Vec2 at = shownAt(camera, Vec3(0));
    EXPECT_NEAR(at.x, (padding.x + 1 - padding.z) / 2, 1e-4f);
    EXPECT_NEAR(at.y, (padding.y + 1 - padding.w) / 2, 1e-4f);
    EXPECT_NEAR(glm::distance(at, camera.middle()), 0, 1e-4f);
  }
}

TEST(OrbitCamera, KeepsTheModelClearOfWhatCoversTheEdges) {
  for (const Vec4& padding : {Vec4(0.08f, 0, 0.08f, 0), Vec4(0, 0, 0, 0.3f), Vec4(0, 0.15f, 0.4f, 0)}) {
    OrbitCamera camera = fitted();
    camera.setPadding(padding, true);
    const render::CameraPose pose = camera.pose(kAspect);
    const Vec3 back = glm::normalize(pose.eye - pose.target), right = glm::normalize(glm::cross(Vec3(0, 1, 0), back));
    for (const Vec3& way : {right, -right, glm::cross(back, right), -glm::cross(back, right)}) {
      const Vec2 at = shownAt(camera, way);
      EXPECT_GT(at.x, padding.x);
      EXPECT_GT(at.y, padding.y);
      EXPECT_LT(at.x, 1 - padding.z);
      EXPECT_LT(at.y, 1 - padding.w);
    }
  }
}

TEST(OrbitCamera, OfAPanelAndWhatElseCoversAnEdgeTheLargerCounts) {
  OrbitCamera both = fitted(), panel = fitted();
  both.setPadding(Vec4(0, 0, 0.1f, 0.1f), true);
  both.setCovered(Vec2(0.4f, 0), true);
  panel.setPadding(Vec4(0, 0, 0, 0.1f), true);
  panel.setCovered(Vec2(0.4f, 0), true);
  EXPECT_EQ(both.middle(), panel.middle());
}

TEST(OrbitCamera, LeavesTheModelSomeRoomHoweverMuchIsCovered) {
  OrbitCamera camera = fitted();
  camera.setPadding(Vec4(0, 0.9f, 0, 0.9f), true);
  EXPECT_NEAR(camera.middle().y, 0.5f, 1e-5f);
  EXPECT_LT(camera.pose(kAspect).eye.y, 20);
}

TEST(OrbitCamera, IgnoresTheEdgesWhileAskedTo) {
  OrbitCamera camera = fitted();
  camera.setPadding(Vec4(0.3f, 0, 0, 0), true);
  camera.ignoreCovered(true);
  EXPECT_NEAR(shownAt(camera, Vec3(0)).x, 0.5f, 1e-5f);
}

TEST(OrbitCamera, TurnsForDaysWithoutLosingPrecision) {
  OrbitCamera camera = fitted();
  for (int i = 0; i < 100000; ++i) camera.turn(-1);
  EXPECT_LE(std::abs(camera.goal().yaw), 3.2f);
  EXPECT_FALSE(camera.moving());
}

TEST(OrbitCamera, AWiderFieldOfViewShowsTheModelSmaller) {
  const auto width = [](float fov) {
    OrbitCamera camera = fitted();
    camera.setFov(fov);
    return glm::distance(shownAt(camera, Vec3(0, 0.1f, 0)), shownAt(camera, Vec3(0, -0.1f, 0)));
  };
  EXPECT_GT(width(0.3f), width(0.6f));
  EXPECT_GT(width(0.6f), width(1.2f));
  EXPECT_EQ(width(0.01f), width(0.1f)) << "10 degrees are the least";
  EXPECT_EQ(width(2), width(3)) << "90 the most";
}

TEST(OrbitCamera, AFreeOneTurnsWhereItIsAndFliesAlongItsView) {
  for (const Vec4& padding : {Vec4(0), Vec4(0, 0, 0.3f, 0)}) {
    OrbitCamera camera = fitted();
    camera.setMode(CameraMode::Free);
    camera.setPadding(padding, true);
    const render::CameraPose before = camera.pose(kAspect);
    camera.look(0.6f, -0.8f, kAspect);
    const render::CameraPose after = camera.pose(kAspect);
    EXPECT_NEAR(glm::distance(after.eye, before.eye), 0, 1e-4f);
    EXPECT_LT(glm::dot(glm::normalize(after.target - after.eye), glm::normalize(before.target - before.eye)), 0.8f);
    EXPECT_LT(camera.goal().pitch, -0.2f) << "also upwards";
    camera.fly(Vec3(0, 0, 1));
    while (camera.update(0.1f)) {}
    const Vec3 way = camera.pose(kAspect).eye - after.eye;
    EXPECT_NEAR(glm::length(way), 1, 1e-3f);
    EXPECT_GT(glm::dot(way, glm::normalize(after.target - after.eye)), 0.9f);
  }
}

TEST(OrbitCamera, FromFreeToOrbitItComesBackToWhereOneMayBe) {
  OrbitCamera camera = fitted();
  camera.setMode(CameraMode::Free);
  camera.look(0, -1.2f, kAspect);
  camera.fly(Vec3(9, 9, 0));
  EXPECT_GT(glm::length(camera.goal().target), 5);
  camera.setMode(CameraMode::Orbit);
  EXPECT_GE(camera.goal().pitch, -0.13f);
  EXPECT_LE(glm::length(camera.goal().target), 2.2f * std::sqrt(3.0f) + 1e-3f);
}

}  // namespace
}  // namespace fur::app
