// The half of App that touches the fur and lets it breathe.
#include <algorithm>

#include "app/AppState.h"

namespace fur::app {

namespace {

// Centre of the hand above the skin, in its radii: so it reaches down to it.
constexpr float kHandHeight = 0.4f;
// Share of the fur's length that the ball is pressed into it.
constexpr float kPressed = 0.75f;
// Where a new ball waits, clear of the fur: to the right, up and to the eye; unit.
constexpr Vec3 kWaiting(0.6f, 0.45f, 0.66f);

// Idle fur stirs for so long after somebody was there, then calms down and sleeps.
constexpr float kBreathTime = 7, kCalming = 3;  // s
constexpr float kBreathWind = 0.1f;  // strength of the wind at a setting of 1

}  // namespace

float App::State::breath() const {
  if (reducedMotion || settings.wind > 0) return 0;
  return kBreathWind * settings.breath * saturate((kBreathTime - idleTime) / kCalming);
}

bool App::State::onBall(const ModelRay& ray) const {
  const auto ball = touch.ball();
  if (!ball) return false;
  const Vec3 centre(glm::inverse(motion.worldFromModel()) * Vec4(ball->centre, 1));
  const Vec3 away = centre - ray.origin;
  const Vec3 aside = away - ray.direction * glm::dot(away, ray.direction);
  return glm::dot(aside, aside) < ball->radius * ball->radius;
}

void App::State::touchAt(Vec2 pixel) {
  const Mat4 toWorld = motion.worldFromModel();
  const auto hit = pick(pixel);
  const float length = settings.furLength;
  if (tool == Tool::Pet) {
    if (!hit) return touch.lift();
    const Vec3 above = shownPosition(*hit) + shownNormal(*hit) * (kHandHeight * settings.brushRadius);
    return touch.stroke(Vec3(toWorld * Vec4(above, 1)), settings.brushRadius);
  }
  if (hit) {
    const float height = settings.ballSize + (1 - kPressed) * length;
    return touch.pull(Vec3(toWorld * Vec4(shownPosition(*hit) + shownNormal(*hit) * height, 1)));
  }
  // Beside the model: in the plane through it that faces the eye.
  const ModelRay ray = rayThrough(pixel);
  const render::Frame f = frame();
  const Vec3 origin(toWorld * Vec4(ray.origin, 1)), direction = Mat3(toWorld) * ray.direction;
  const Vec3 facing = glm::normalize(f.camera.eye - f.camera.target);
  const float slope = glm::dot(direction, facing);
  if (const auto ball = touch.ball(); ball && slope < -1e-3f)
    touch.pull(origin + direction * (glm::dot(ball->centre - origin, facing) / slope));
}

void App::State::refreshTouch() {
  touch.setBallSize(settings.ballSize);
  if (tool != Tool::Ball) {
    if (touch.ball()) pictureChanged = true;
    return touch.removeBall();
  }
  if (touch.ball()) return;
  const render::Frame f = frame();
  const Vec3 back = glm::normalize(f.camera.eye - f.camera.target);
  const Vec3 right = normalizeOr(glm::cross(Vec3(0, 1, 0), back), Vec3(1, 0, 0));
  const Vec3 way = right * kWaiting.x + glm::cross(back, right) * kWaiting.y + back * kWaiting.z;
  touch.pull(extent.centre + way * (0.05f + extent.radius + settings.furLength + settings.ballSize));
  pictureChanged = true;
}

std::optional<Ball> App::ball() const { return state_->touch.ball(); }

}  // namespace fur::app
