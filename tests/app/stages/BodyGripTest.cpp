#include "app/stages/BodyGrip.h"

#include <gtest/gtest.h>

#include <vector>

namespace fur::app {
namespace {

const Vec3 kEye(0, 0, 5);
Vec3 towards(const Vec3& at) { return glm::normalize(at - kEye); }

TEST(BodyGrip, TakesTheBodyThatTheRayMeetsFirst) {
  const std::vector<hair::Body> bodies{{Vec3(0), Vec3(0), 0.5f}, {Vec3(0, 0, 2), Vec3(0, 0, 2), 0.2f}, {Vec3(-1, 1, 0), Vec3(1, 1, 0), 0.1f}};
  const auto front = gripAt(bodies, -1, kEye, towards(Vec3(0)), 0);
  ASSERT_TRUE(front);
  EXPECT_EQ(front->body, 1u);
  EXPECT_LT(glm::distance(front->at, Vec3(0, 0, 2.2f)), 1e-4f);
  const auto behind = gripAt(bodies, -1, kEye, towards(Vec3(0.4f, 0, 0)), 0);
  ASSERT_TRUE(behind);
  EXPECT_EQ(behind->body, 0u);
  const auto capsule = gripAt(bodies, -1, kEye, towards(Vec3(0.7f, 1, 0)), 0);
  ASSERT_TRUE(capsule);
  EXPECT_EQ(capsule->body, 2u);
  EXPECT_FALSE(gripAt(bodies, -1, kEye, towards(Vec3(3, 3, 0)), 0));
}

TEST(BodyGrip, HandlesOfTheSelectedOneComeBeforeWhatLiesInFrontOfThem) {
  const std::vector<hair::Body> bodies{{Vec3(-0.5f, 0, 0), Vec3(0.5f, 0, 0), 0.2f}, {Vec3(0, 0, 2), Vec3(0, 0, 2), 1}};
  const auto end = gripAt(bodies, 0, kEye, towards(Vec3(0.5f, 0, 0)), 0.01f);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->body, 0u);
  EXPECT_EQ(end->part, BodyGrip::Part::B);
  const auto radius = gripAt(bodies, 0, kEye, towards(radiusHandle(bodies[0], kEye)), 0.01f);
  ASSERT_TRUE(radius);
  EXPECT_EQ(radius->part, BodyGrip::Part::Radius);
}

TEST(BodyGrip, AnEndGoesWhereItIsDraggedAndTheOtherStays) {
  const hair::Body body{Vec3(0), Vec3(1, 0, 0), 0.2f};
  const hair::Body bent = dragged(body, {0, BodyGrip::Part::B, body.b}, Vec3(1, 1, 0));
  EXPECT_EQ(bent.a, body.a);
  EXPECT_EQ(bent.b, Vec3(1, 1, 0));
  const hair::Body away = dragged(body, {0, BodyGrip::Part::Whole, Vec3(0.5f, 0.2f, 0)}, Vec3(0.5f, 0.7f, 0));
  EXPECT_LT(glm::distance(away.a, Vec3(0, 0.5f, 0)) + glm::distance(away.b, Vec3(1, 0.5f, 0)), 1e-5f);
}

TEST(BodyGrip, TheRadiusIsTheDistanceOfItsHandleWithinBounds) {
  const hair::Body body{Vec3(0), Vec3(1, 0, 0), 0.2f};
  const Vec3 handle = radiusHandle(body, kEye);
  EXPECT_NEAR(dragged(body, {0, BodyGrip::Part::Radius, handle}, Vec3(0.5f, 0.6f, 0)).radius, 0.6f, 1e-5f);
  EXPECT_EQ(dragged(body, {0, BodyGrip::Part::Radius, handle}, Vec3(0.5f, 0, 0)).radius, hair::kLeastBody);
  EXPECT_EQ(dragged(body, {0, BodyGrip::Part::Radius, handle}, Vec3(0.5f, 1e5f, 0)).radius, hair::kLargestBody);
}

}  // namespace
}  // namespace fur::app
