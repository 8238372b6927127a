#include <algorithm>
#include <cmath>

#include "app/AppState.h"

namespace fur::app {

namespace {

constexpr float kOrbitPerHeight = 3.6f;  // radians for a drag across the whole height
constexpr float kKeyOrbit = 0.12f, kKeyZoom = 1.12f, kWheelZoom = 1.12f;
constexpr float kCursorStep = 0.03f;  // of the picture's height
constexpr int kLeft = 1, kRight = 2;

// Model units that one pixel covers at the camera's target.
float unitsPerPixel(const render::Frame& frame) {
  return glm::length(frame.camera.eye - frame.camera.target) / render::pixelsPerUnit(frame);
}

// A step in the picture as a step in the world, in the plane that faces the camera.
Vec3 inPicturePlane(const render::Frame& frame, Vec2 pixels) {
  const Vec3 back = glm::normalize(frame.camera.eye - frame.camera.target);
  const Vec3 right = normalizeOr(glm::cross(Vec3(0, 1, 0), back), Vec3(1, 0, 0));
  return (right * pixels.x - glm::cross(back, right) * pixels.y) * unitsPerPixel(frame);
}

Drag dragFor(const PointerEvent& event, Tool tool, bool onModel, bool cameraControls) {
  const Drag elsewhere = cameraControls ? Drag::Orbit : Drag::None;
  if (event.control) return Drag::Light;
  if (event.shift) return onModel ? Drag::Spin : elsewhere;
  if (event.kind == PointerKind::Mouse && (event.buttons & kRight)) return onModel ? Drag::Grab : elsewhere;
  if (event.kind == PointerKind::Mouse && !(event.buttons & kLeft)) return elsewhere;
  const Drag own = traitsOf(tool).drag;
  return onModel && own != Drag::Orbit ? own : elsewhere;
}

}  // namespace

bool App::pointer(const PointerEvent& event) {
  State& s = *state_;
  s.pressure = event.kind == PointerKind::Pen ? glm::clamp(event.pressure, 0.0f, 1.0f) : 1.0f;
  if (!s.pointers.empty() || event.phase == PointerPhase::Down) s.idleTime = 0;
  const auto centreAndSpan = [&] {
    Vec2 centre(0);
    for (const auto& [id, at] : s.pointers) centre += at;
    centre /= static_cast<float>(std::max<std::size_t>(s.pointers.size(), 1));
    float span = 0;
    for (const auto& [id, at] : s.pointers) span += glm::length(at - centre);
    return std::pair(centre, span);
  };
  const auto letGo = [&] {
    s.endStroke();
    s.motion.release();
    s.touch.lift();
    s.drag = Drag::None;
  };

  if (event.phase == PointerPhase::Down) {
    s.pointers[event.id] = event.position;
    if (s.pointers.size() > 1) {
      letGo();
      if (s.cameraControls) s.drag = Drag::Pinch;
      std::tie(s.lastPosition, s.lastSpan) = centreAndSpan();
      return s.drag != Drag::None;
    }
    const bool onModel = s.pick(event.position).has_value() || s.onBall(s.rayThrough(event.position));
    s.drag = dragFor(event, s.tool, onModel, s.cameraControls);
    s.lastPosition = s.lastSpot = event.position;
    if (s.drag == Drag::Grab) s.motion.grab();
    if (s.drag == Drag::Touch) s.touchAt(event.position);
    if (s.drag == Drag::Paint) {
      s.beginStroke();
      s.sprayAt(event.position);
    }
    return s.drag != Drag::None;
  }

  const auto known = s.pointers.find(event.id);
  if (known == s.pointers.end()) return false;
  if (event.phase != PointerPhase::Move) {
    s.pointers.erase(known);
    letGo();
    // The finger that stays goes on orbiting.
    if (!s.pointers.empty() && s.cameraControls) s.drag = Drag::Orbit;
    s.lastPosition = centreAndSpan().first;
    return true;
  }

  known->second = event.position;
  const auto [centre, span] = centreAndSpan();
  const Vec2 step = centre - s.lastPosition;
  const auto height = static_cast<float>(s.height);
  switch (s.drag) {
    case Drag::None: return false;
    case Drag::Paint: s.paintTo(event.position); break;
    case Drag::Touch: s.touchAt(event.position); break;
    case Drag::Orbit: s.camera.orbit(-step.x / height * kOrbitPerHeight, step.y / height * kOrbitPerHeight); break;
    case Drag::Grab: s.motion.drag(inPicturePlane(s.frame(), step)); break;
    case Drag::Spin: s.motion.spin(step.x / height * kOrbitPerHeight); break;
    case Drag::Pinch:
      if (s.lastSpan > 1 && span > 1) s.camera.zoom(s.lastSpan / span);
      s.camera.pan(Vec2(-step.x, step.y) * unitsPerPixel(s.frame()));
      s.lastSpan = span;
      break;
    case Drag::Light: {
      settings::Settings next = s.settings;
      Warnings ignored;  // the horizon and the zenith are natural stops
      settings::setField(next, *settings::findField("lightYaw"),
                         std::remainder(next.lightYaw + step.x / height * kOrbitPerHeight, 2 * kPi), ignored);
      settings::setField(next, *settings::findField("lightPitch"), next.lightPitch - step.y / height * kOrbitPerHeight, ignored);
      setSettings(next);
      break;
    }
  }
  s.lastPosition = centre;
  return true;
}

bool App::wheel(float notches, Vec2) {
  if (!state_->cameraControls) return false;
  state_->idleTime = 0;
  state_->camera.zoom(std::pow(kWheelZoom, std::clamp(notches, -10.0f, 10.0f)));
  return true;
}

bool App::key(const KeyEvent& event) {
  State& s = *state_;
  s.idleTime = 0;
  if (event.control) {
    if (event.key == "z" || event.key == "Z") return event.shift ? redo() : undo();
    if (event.key == "y") return redo();
    return false;
  }
  if (event.alt) return false;
  const float step = kCursorStep * static_cast<float>(s.height);
  if (event.key == " " || event.key == "Enter") {
    const Vec2 at = s.cursorPixel();
    if (goesOn(s.tool)) {
      if (!s.pick(at)) return false;
      s.holdByKey();
      return true;
    }
    s.beginStroke();
    // A comb needs a way to go: down the picture.
    if (s.tool == Tool::Comb) s.sprayAt(at - Vec2(0, step));
    const bool hit = s.sprayAt(at);
    s.endStroke();
    return hit;
  }
  if (paints(s.tool) && (event.shift || !s.cameraControls)) {
    const Vec2 way(event.key == "ArrowRight" ? 1 : event.key == "ArrowLeft" ? -1 : 0,
                   event.key == "ArrowDown" ? 1 : event.key == "ArrowUp" ? -1 : 0);
    if (way != Vec2(0)) {
      if (s.pick(s.cursorPixel() + step * way) || !s.pick(s.cursorPixel())) s.cursor += kCursorStep * way;
      s.cursor = glm::clamp(s.cursor, -s.cursorReach(), s.cursorReach());
      return true;
    }
  }
  if (!s.cameraControls) return false;
  if (event.key == "ArrowLeft") s.camera.orbit(-kKeyOrbit, 0);
  else if (event.key == "ArrowRight") s.camera.orbit(kKeyOrbit, 0);
  else if (event.key == "ArrowUp") s.camera.orbit(0, kKeyOrbit);
  else if (event.key == "ArrowDown") s.camera.orbit(0, -kKeyOrbit);
  else if (event.key == "+" || event.key == "=") s.camera.zoom(1 / kKeyZoom);
  else if (event.key == "-") s.camera.zoom(kKeyZoom);
  else if (event.key == "Home") resetCamera();
  else return false;
  return true;
}

Vec2 App::cursor() const { return state_->cursorPixel(); }

void App::setCameraControls(bool enabled) { state_->cameraControls = enabled; }

}  // namespace fur::app
