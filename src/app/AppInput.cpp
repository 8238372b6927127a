// Pointers and keys, and what the tool does where they are.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/AppState.h"
#include "app/stages/Mirror.h"
#include "core/PortableMath.h"

namespace fur::app {

namespace {

constexpr float kOrbitPerHeight = 3.6f;  // radians for a drag across the whole height
constexpr float kLookPerHeight = 1.8f;   // likewise, of a camera that turns where it is
// Keys that fly while a free camera looks round, and where to: right, up, forwards. Space is E, Control is Q, for browsers close a page
// with Ctrl+W.
constexpr char kFlyingKeys[] = {'w', 's', 'a', 'd', 'e', 'q'};
constexpr Vec3 kFlyingWays[] = {{0, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
constexpr float kFlyingSpeed = 1.2f;  // model units a second
constexpr float kKeyOrbit = 0.12f, kKeyZoom = 1.12f, kWheelZoom = 1.12f;
constexpr float kCursorStep = 0.03f;  // of the picture's height
constexpr int kLeft = 1, kRight = 2;
// For so long a key holds a tool, s.
constexpr float kKeyHold = 0.5f;
// Share of the brush radius between two dabs of a stroke.
constexpr float kSpacing = 0.35f;
// Centre of the hand above the skin, in its radii: so it reaches down to it.
constexpr float kHandHeight = 0.4f;
// Share of the fur's length that the ball is pressed into it.
constexpr float kPressed = 0.75f;
// Where a new ball waits, clear of the fur: to the right, up and to the eye; unit.
constexpr Vec3 kWaiting(0.6f, 0.45f, 0.66f);

Drag dragFor(const PointerEvent& event, Tool tool, bool onModel, Drag elsewhere) {
  const bool right = event.kind == PointerKind::Mouse && (event.buttons & kRight);
  if (right && elsewhere == Drag::Look) return elsewhere;
  if (event.control) return Drag::Light;
  if (event.shift) return onModel ? Drag::Spin : elsewhere;
  if (right) return onModel ? Drag::Grab : elsewhere;
  if (event.kind == PointerKind::Mouse && !(event.buttons & kLeft)) return elsewhere;
  const Drag ofTool = traitsOf(tool).drag;
  return !onModel || ofTool == Drag::Orbit ? elsewhere : ofTool;
}

// What a brush of the coat does to long hair.
Tool brushOfHair(Tool tool) {
  switch (tool) {
    case Tool::Comb: return Tool::HairComb;
    case Tool::Trim:
    case Tool::Cut: return Tool::HairCut;
    case Tool::Grow: return Tool::HairLength;
    default: return tool;
  }
}

// Whether the tool does something to hair that it meets beside the skin.
bool meetsHair(Tool tool) {
  const Drag drag = traitsOf(tool).drag;
  return strokeOf(tool) || brushOfHair(tool) != tool || drag == Drag::Touch || drag == Drag::Grab;
}

// The middle of all pointers, and how far they are from it, added up.
std::pair<Vec2, float> centreAndSpan(const std::map<int, Vec2>& pointers) {
  Vec2 centre(0);
  for (const auto& [id, at] : pointers) centre += at;
  centre /= static_cast<float>(std::max<std::size_t>(pointers.size(), 1));
  float span = 0;
  for (const auto& [id, at] : pointers) span += glm::length(at - centre);
  return {centre, span};
}

}  // namespace

// --- strokes -----------------------------------------------------------------------------------

void App::State::beginStroke(Vec2 pixel) {
  hand.working = hand.tool;
  if (const Tool brush = brushOfHair(hand.tool); brush != hand.tool)
    if (const auto met = hairAt(pixel, pick(pixel))) {
      beginHairStroke();
      hair->select(met->scalp);
      hand.working = brush;
      return;
    }
  if (grooms(hand.tool)) return beginGroomStroke();
  if (worksOnHair(hand.tool)) return beginHairStroke();
  if (const auto what = strokeOf(hand.tool)) beginWaterStroke(*what, settings.brushRadius, settings.brushFlow);
}

void App::State::endStroke() {
  hand.keyHold = 0;
  if (auto step = groom.endStroke()) {
    if (step->bareBefore != step->bareAfter) step->dried = water.onBareParts(shape);
    history.push(std::move(*step));
  }
  if (auto step = hair->endStroke()) history.push(std::move(*step));
  if (auto step = water.endStroke()) history.push(std::move(*step));
}

bool App::State::dabAt(Vec2 pixel) { return dabAt(pixel, pick(pixel)); }

bool App::State::dabAt(Vec2 pixel, const std::optional<geometry::SurfacePoint>& hit) {
  if (hair->stroking()) return dabHair(pixel, hit);
  if (const auto met = water.stroking() ? hairAt(pixel, hit) : std::nullopt) {
    dabAt(met->root, met->height);
    return true;
  }
  if (hit) dabAt(*hit);
  return hit.has_value();
}

void App::State::dabAt(const geometry::SurfacePoint& at, float height) {
  hand.sinceDab = 0;
  if (groom.stroking()) groom.dab(shape, settings, hand.tool, at, warnings);
  if (!water.stroking()) return;
  if (goesOn(hand.tool)) water.hold(at, hand.pressure, height);
  else water.dab(shape, settings, at, hand.pressure, height);
}

bool App::State::dabHair(Vec2 pixel, const std::optional<geometry::SurfacePoint>& hit) {
  hand.sinceDab = 0;
  const Ray ray = rayThrough(pixel);
  hair->dab({hand.working, ray.origin, glm::normalize(ray.direction), hit, groom.groomSurface(shape), groom.groom().mask, settings, shape,
             view.unitsPerPixel(view.pixelRatio)});
  return true;
}

std::optional<HairStage::Met> App::State::hairAt(Vec2 pixel, const std::optional<geometry::SurfacePoint>& hit) {
  const Ray ray = rayThrough(pixel);
  return hair->meet(shape, ray.origin, glm::normalize(ray.direction), hit);
}

bool App::State::onHair(Vec2 pixel) {
  if (worksOnHair(hand.tool)) return hair->meets(hairLook(pixel));
  return meetsHair(hand.tool) && hairAt(pixel, std::nullopt).has_value();
}

void App::State::paintTo(Vec2 pixel) {
  if (hand.tool == Tool::Whisker) {
    const Ray ray = rayThrough(pixel);
    return groom.aimWhiskers(shape, settings, ray.origin, ray.direction);
  }
  if (hand.tool == Tool::HairShape) return (void)dabHair(pixel, std::nullopt);
  const float spacing = std::max(2.0f, kSpacing * settings.brushRadius / view.unitsPerPixel(std::max(0.2f, view.distance())));
  for (Vec2 way = pixel - hand.lastDab; glm::length(way) >= spacing; way = pixel - hand.lastDab) {
    hand.lastDab += way * (spacing / glm::length(way));
    dabAt(hand.lastDab);
  }
}

// The tool that is held still works there: water by its own clock, brushes of the groom by one of the same steps.
void App::State::workWithHand(float seconds) {
  if (!toolActsWhileStill()) return;
  const auto hit = pick(heldPixel());
  if (water.stroking()) {
    if (const auto met = hairAt(heldPixel(), hit)) return water.hold(met->root, hand.pressure, met->height);
    return water.hold(hit, hit ? hand.pressure : 0);
  }
  constexpr float kStep = wet::Water::kStep;
  for (hand.due = std::min(hand.due + seconds, 1.0f); hand.due > kStep * 0.999f; hand.due -= kStep)
    if (++hand.sinceDab >= WaterStage::kDabSteps && hand.pressure > 0) dabAt(heldPixel(), hit);
}

// Has a tool that goes on work at the cursor for a moment.
void App::State::holdByKey() {
  if (hand.keyHold <= 0) {
    beginStroke(cursorPixel());
    dabAt(cursorPixel());
  }
  hand.keyHold = kKeyHold;
}

// --- touch -------------------------------------------------------------------------------------

bool App::State::onBall(const Ray& ray) const {
  const auto ball = motion.touch().ball();
  if (!ball) return false;
  const Vec3 centre(glm::inverse(worldFromModel()) * Vec4(ball->centre, 1));
  const Vec3 away = centre - ray.origin;
  const Vec3 aside = away - ray.direction * glm::dot(away, ray.direction);
  return glm::dot(aside, aside) < ball->radius * ball->radius;
}

void App::State::touchAt(Vec2 pixel) {
  const Mat4 toWorld = worldFromModel();
  const auto hit = pick(pixel);
  const Ray ray = rayThrough(pixel);
  const auto met = hairAt(pixel, hit);
  // Above the skin, or on the near side of hair.
  const auto above = [&](float height) {
    const Vec3 place = met ? ray.origin + glm::normalize(ray.direction) * (met->distance - height) : shape.shownPosition(*hit) + shape.shownNormal(*hit) * height;
    return Vec3(toWorld * Vec4(place, 1));
  };
  Touch& touch = motion.touch();
  if (hand.tool == Tool::Pet) {
    if (!hit && !met) return touch.lift();
    return touch.stroke(above(kHandHeight * settings.brushRadius), settings.brushRadius);
  }
  if (hit || met) return touch.pull(above(settings.ballSize + (1 - kPressed) * coatLength()));
  // Beside the model: in the plane through it that faces the eye.
  const render::CameraPose camera = view.pose();
  const Vec3 origin(toWorld * Vec4(ray.origin, 1)), direction = Mat3(toWorld) * ray.direction;
  const Vec3 facing = glm::normalize(camera.eye - camera.target);
  const float slope = glm::dot(direction, facing);
  if (const auto ball = touch.ball(); ball && slope < -1e-3f)
    touch.pull(origin + direction * (glm::dot(ball->centre - origin, facing) / slope));
}

void App::State::refreshTouch() {
  Touch& touch = motion.touch();
  touch.setBallSize(settings.ballSize);
  if (touch.ball().has_value() == (hand.tool == Tool::Ball)) return;
  ++changed;
  if (hand.tool != Tool::Ball) return touch.removeBall();
  const render::CameraPose camera = view.pose();
  const Vec3 back = glm::normalize(camera.eye - camera.target);
  const Vec3 right = normalizeOr(glm::cross(Vec3(0, 1, 0), back), Vec3(1, 0, 0));
  const Vec3 way = right * kWaiting.x + glm::cross(back, right) * kWaiting.y + back * kWaiting.z;
  touch.pull(shape.extent().centre + way * (0.05f + shape.extent().radius + coatLength() + settings.ballSize));
}

// --- pointers ----------------------------------------------------------------------------------

void App::State::letGo() {
  endStroke();
  motion.body().release();
  motion.touch().lift();
  hand.drag = Drag::None;
  hand.flying = 0;
}

bool App::pointer(const PointerEvent& event) {
  State& s = *state_;
  Hand& hand = s.hand;
  hand.pressure = event.kind == PointerKind::Pen ? glm::clamp(event.pressure, 0.0f, 1.0f) : 1.0f;
  if (!hand.pointers.empty() || event.phase == PointerPhase::Down) s.idleTime = 0;
  if (event.phase == PointerPhase::Down) return s.pointerDown(event);
  const auto known = hand.pointers.find(event.id);
  if (known == hand.pointers.end()) return event.phase == PointerPhase::Move && s.pointAt(event.position);
  s.pointAt(event.position);
  if (event.phase != PointerPhase::Move) {
    hand.pointers.erase(known);
    s.letGo();
    // The finger that stays goes on turning the view.
    if (!hand.pointers.empty()) hand.drag = s.turning();
    hand.lastPosition = centreAndSpan(hand.pointers).first;
    return true;
  }
  known->second = event.position;
  if (hand.drag == Drag::None) return false;
  if (hand.drag == Drag::Light) turnLight(centreAndSpan(hand.pointers).first - hand.lastPosition);
  else s.dragTo(event.position);
  std::tie(hand.lastPosition, hand.lastSpan) = centreAndSpan(hand.pointers);
  return true;
}

bool App::State::pointAt(Vec2 pixel) {
  if (!behaviour.behaves()) return false;
  hand.pointed = pixel;
  hand.sincePointed = idleTime = 0;
  return true;
}

bool App::State::pointerDown(const PointerEvent& event) {
  pointAt(event.position);
  hand.pointers[event.id] = event.position;
  if (hand.pointers.size() > 1) {
    letGo();
    if (view.cameraControls) hand.drag = Drag::Pinch;
    std::tie(hand.lastPosition, hand.lastSpan) = centreAndSpan(hand.pointers);
    return hand.drag != Drag::None;
  }
  // Beside bodies the tool that drags them turns the view, also on the model.
  const bool onModel = onHair(event.position) ||
                       (hand.tool != Tool::HairShape && (pick(event.position).has_value() || onBall(rayThrough(event.position))));
  hand.drag = dragFor(event, hand.tool, onModel, turning());
  hand.lastPosition = hand.lastDab = event.position;
  if (hand.drag == Drag::Grab) motion.body().grab();
  if (hand.drag == Drag::Touch) touchAt(event.position);
  if (hand.drag == Drag::Paint) {
    beginStroke(event.position);
    dabAt(event.position);
  }
  return hand.drag != Drag::None;
}

void App::State::dragTo(Vec2 position) {
  const auto [centre, span] = centreAndSpan(hand.pointers);
  const Vec2 step = centre - hand.lastPosition, turn = step * (kOrbitPerHeight / static_cast<float>(view.height));
  switch (hand.drag) {
    case Drag::Paint: paintTo(position); break;
    case Drag::Touch: touchAt(position); break;
    case Drag::Orbit: view.camera.orbit(-turn.x, turn.y); break;
    case Drag::Look: look(step * (kLookPerHeight / static_cast<float>(view.height))); break;
    case Drag::Grab: motion.body().drag(view.stepInPlane(step)); break;
    case Drag::Spin: motion.body().spin(turn.x); break;
    case Drag::Pinch:
      if (hand.lastSpan > 1 && span > 1) view.camera.zoom(hand.lastSpan / span);
      view.camera.pan(Vec2(-step.x, step.y) * view.unitsPerPixel(view.distance()));
      break;
    case Drag::Light:
    case Drag::None: break;
  }
}

void App::turnLight(Vec2 step) {
  const Vec2 turn = step * (kOrbitPerHeight / static_cast<float>(state_->view.height));
  settings::Settings next = state_->settings;
  Warnings ignored;  // the horizon and the zenith are natural stops
  settings::setField(next, *settings::findField("lightYaw"), std::remainder(next.lightYaw + turn.x, 2 * kPi), ignored);
  settings::setField(next, *settings::findField("lightPitch"), next.lightPitch - turn.y, ignored);
  setSettings(next);
}

bool App::wheel(float notches, Vec2) {
  if (!state_->view.cameraControls) return false;
  state_->idleTime = 0;
  state_->view.camera.zoom(std::pow(kWheelZoom, std::clamp(notches, -10.0f, 10.0f)));
  return true;
}

// --- keys --------------------------------------------------------------------------------------

bool App::key(const KeyEvent& event) {
  State& s = *state_;
  s.idleTime = 0;
  if (s.takeFlyingKey(event)) return true;
  if (!event.down) return false;
  if (event.control) {
    if (event.key == "z" || event.key == "Z") return event.shift ? redo() : undo();
    if (event.key == "y") return redo();
    return false;
  }
  if (event.alt) return false;
  if (event.key == " " || event.key == "Enter") return s.useToolAtCursor();
  if (paints(s.hand.tool) && (event.shift || !s.view.cameraControls) && s.moveCursor(event.key)) return true;
  if (!s.view.cameraControls) return false;
  if (event.key == "Home") return resetCamera(), true;
  return s.moveCamera(event.key);
}

bool App::State::useToolAtCursor() {
  const Vec2 at = cursorPixel();
  if (goesOn(hand.tool)) {
    if (!pick(at)) return false;
    holdByKey();
    return true;
  }
  beginStroke(at);
  // A comb needs a way to go: down the picture.
  if (hand.tool == Tool::Comb) dabAt(at - Vec2(0, kCursorStep * static_cast<float>(view.height)));
  const bool hit = dabAt(at);
  endStroke();
  return hit;
}

bool App::State::moveCursor(std::string_view key) {
  const Vec2 way(key == "ArrowRight" ? 1 : key == "ArrowLeft" ? -1 : 0, key == "ArrowDown" ? 1 : key == "ArrowUp" ? -1 : 0);
  if (way == Vec2(0)) return false;
  const float step = kCursorStep * static_cast<float>(view.height);
  if (pick(cursorPixel() + step * way) || !pick(cursorPixel())) hand.cursor += kCursorStep * way;
  const Vec2 reach = view.size() * (0.5f / static_cast<float>(view.height));
  hand.cursor = glm::clamp(hand.cursor, -reach, reach);
  return true;
}

void App::State::look(Vec2 turn) {
  view.camera.look(-turn.x, turn.y, view.size().x / view.size().y);
  ++changed;
}

bool App::State::takeFlyingKey(const KeyEvent& event) {
  const char given = event.key == "Control" ? 'q' : event.key == " " ? 'e' : event.key.size() == 1 ? static_cast<char>(event.key[0] | 32) : '\0';
  const char* key = std::find(std::begin(kFlyingKeys), std::end(kFlyingKeys), given);
  if (key == std::end(kFlyingKeys)) return false;
  const unsigned bit = 1u << (key - kFlyingKeys), before = hand.flying;
  hand.flying &= ~bit;
  if (event.down && looksRound()) hand.flying |= bit;
  return (hand.flying | before) != 0;
}

void App::State::fly(float seconds) {
  Vec3 way(0);
  for (unsigned i = 0; i < std::size(kFlyingKeys); ++i)
    if (hand.flying & 1u << i) way += kFlyingWays[i];
  if (hand.flying) view.camera.fly(way * (kFlyingSpeed * seconds));
}

bool App::State::moveCamera(std::string_view key) {
  if (view.camera.isFree() && key.starts_with("Arrow")) {
    const Vec2 way(key == "ArrowRight" ? 1 : key == "ArrowLeft" ? -1 : 0, key == "ArrowDown" ? 1 : key == "ArrowUp" ? -1 : 0);
    look(kKeyOrbit * way);
  } else if (key == "ArrowLeft") view.camera.orbit(-kKeyOrbit, 0);
  else if (key == "ArrowRight") view.camera.orbit(kKeyOrbit, 0);
  else if (key == "ArrowUp") view.camera.orbit(0, kKeyOrbit);
  else if (key == "ArrowDown") view.camera.orbit(0, -kKeyOrbit);
  else if (key == "+" || key == "=") view.camera.zoom(1 / kKeyZoom);
  else if (key == "-") view.camera.zoom(kKeyZoom);
  else return false;
  return true;
}

template <class Seen>
std::vector<Vec2> App::State::ring(const Vec3& centre, const Vec3& normal, float radius, Seen&& seenAt) const {
  constexpr std::size_t kCorners = App::kRingCorners;
  const auto [side, up] = axesOn(normal);
  std::array<Vec3, kCorners> places;
  for (std::size_t k = 0; k < kCorners; ++k) {
    const float angle = 2 * kPi * static_cast<float>(k) / kCorners;
    places[k] = seenAt(centre + radius * (portableCos(angle) * side + portableSin(angle) * up));
  }
  const Mat4 toClip = view.clipFromWorld() * worldFromModel();
  std::vector<Vec2> ring;
  // Between their neighbours: the model has corners.
  for (std::size_t k = 0; k < kCorners; ++k)
    ring.push_back(view.pixelAt(toClip * Vec4(0.25f * (places[(k + kCorners - 1) % kCorners] + 2.0f * places[k] + places[(k + 1) % kCorners]), 1)));
  return ring;
}

// --- App's side --------------------------------------------------------------------------------

Vec2 App::cursor() const { return state_->cursorPixel(); }

bool App::looksRound() const { return state_->looksRound(); }

void App::setCameraControls(bool enabled) { state_->view.cameraControls = enabled; }

void App::setTool(Tool tool) {
  State& s = *state_;
  s.endStroke();
  s.otherChanges += s.hand.tool != tool;
  s.hand.tool = tool;
  // The mask shows while one grooms, guides and scalps while one works on them.
  s.changed += s.groom.hasMask() || s.haired();
  s.motion.touch().lift();
  s.refreshTouch();
}

Tool App::tool() const { return state_->hand.tool; }

std::optional<Ball> App::ball() const { return state_->motion.touch().ball(); }

std::optional<Vec2> App::pick(Vec2 pixel) const {
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  return atlasAt(state_->shape.surface(), *hit);
}

std::optional<Vec3> App::placeAt(Vec2 pixel) const {
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  return positionAt(state_->shape.surface(), *hit);
}

std::vector<Vec2> App::State::ringOn(const geometry::SurfacePoint& at, float radius) const {
  const Picking picking = this->picking();
  const Vec3 centre = shape.shownPosition(at), normal = shape.shownNormal(at), lifted = picking.seenAt(at) - centre;
  return ring(centre, normal, radius, [&](const Vec3& place) {
    // On the fur over the skin there.
    const auto skin = shape.shownQuery().castRay(place + radius * normal, -normal);
    return skin && skin->distance < 2 * radius ? picking.seenAt(*skin) : place + lifted;
  });
}

std::vector<Vec2> App::brushRing(Vec2 pixel, bool ofMirror) const {
  State& s = *state_;
  const float reach = traitsOf(s.hand.tool).reach;
  if (reach <= 0) return {};
  auto hit = s.pick(pixel);
  const float radius = s.settings.brushRadius * reach;
  if (const auto met = meetsHair(s.hand.tool) && !ofMirror ? s.hairAt(pixel, hit) : std::nullopt) {  // it faces the eye
    const Ray ray = s.rayThrough(pixel);
    const Vec3 normal = -glm::normalize(ray.direction);
    return s.ring(ray.origin - normal * met->distance, normal, radius, [](const Vec3& place) { return place; });
  }
  if (hit && ofMirror) hit = mirrored(s.settings, s.shape, *hit);
  return hit ? s.ringOn(*hit, radius) : std::vector<Vec2>();
}

}  // namespace fur::app
