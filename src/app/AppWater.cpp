// The half of App that water does by itself, and the tools that work for as long as they are held.
#include <algorithm>
#include <cmath>

#include "app/AppState.h"
#include "core/Json.h"
#include "core/NumberText.h"
#include "core/PortableMath.h"

namespace fur::app {

namespace {

// Places that find their neighbours between two looks at the clock.
constexpr std::uint32_t kPlacesAtOnce = 1000;
// Model radii a second in the strongest wind, and of what a hair dryer blows.
constexpr float kWindSpeed = 1.5f;
// Wetness a second under the middle of a dryer, and how hard it blows the fur about.
constexpr float kBlow = 1.6f, kBlowWind = 0.7f;
// Of the hose: amount a step, how far off its nozzle is and how fast water comes from there.
constexpr float kHose = 0.012f, kHoseLength = 2.0f, kHoseSpeed = 11.5f;
constexpr float kHoseSlope = 0.3f;  // it meets the skin at no less; a sine
// Steps between two dabs of a brush that is held still.
constexpr int kDabSteps = 8;
// For so long a key holds a tool, s.
constexpr float kKeyHold = 0.5f;

}  // namespace

bool App::State::holds(Tool one) const { return tool == one && (drag == Drag::Paint || keyHold > 0 || replaying); }

void App::State::holdByKey() {
  if (keyHold <= 0) beginStroke();
  keyHold = kKeyHold;
}

wet::Climate App::State::climate() {
  wet::Climate c;
  c.worldFromModel = motion.worldFromModel();
  c.wind = kWindSpeed * wind() * Vec3(portableSin(settings.windYaw), 0, portableCos(settings.windYaw));
  c.dryRate = settings.stayWet ? 0 : settings.dryRate;
  c.furLength = settings.furLength;
  c.clumpSize = settings.clumpSize;
  c.groundHeight = groundHeight;
  c.rain = holds(Tool::Rain) ? std::max(settings.rain, settings.brushFlow) : settings.rain;
  c.shaking = motion.shaking();
  if (!holds(Tool::Dryer)) return c;
  c.blowCentre = positionAt(surface, held.at);
  c.blowRadius = traitsOf(Tool::Dryer).reach * settings.brushRadius;
  c.blow = kBlow * settings.brushFlow * held.pressure;
  return c;
}

Vec3 App::State::dryerWind() const {
  if (!holds(Tool::Dryer)) return Vec3(0);
  return Mat3(motion.worldFromModel()) * rayThrough(heldPixel()).direction * (kBlowWind * pressure);
}

bool App::State::runWater(float dt, double budget) {
  const bool works = atWork(), pours = works && !grooms(tool);
  if (works && !replaying) {
    const auto hit = pick(heldPixel());
    held = {0, hit.value_or(held.at), hit ? pressure : 0};
  }
  wet::WetSurface on{surface, query, *wetting};
  if (pose) on.positions = skin.positions, on.normals = skin.normals;
  bool changed = false;
  // A hair early rather than a step late, as Water::step().
  for (waterDue = std::min(waterDue + dt, 1.0f); waterDue > wet::Water::kStep * 0.999f; waterDue -= wet::Water::kStep) {
    if (works && !pours) dabOn();
    if (!pours && !water.active(mask, climate())) continue;
    for (const double begun = secondsNow(); !water.prepare(on, kPlacesAtOnce);)
      if (secondsNow() - begun >= budget) {
        waterDue = 0;
        return changed;
      }
    if (pours) workOnWith();
    const wet::Climate now = climate();
    if (!water.active(mask, now)) continue;
    if (pose && !water.drops().empty()) on.shown = &shownQuery();
    changed |= water.step(on, mask, now);
    ++waterSteps;
  }
  if (keyHold > 0 && (keyHold -= dt) <= 0) endStroke();
  if (changed) maskTouched();
  return changed;
}

void App::State::readPuddles() {
  if (std::exchange(shownPuddles, water.groundRevision()) == water.groundRevision()) return;
  std::vector<std::uint8_t> now;
  bool wet = false, seen = false;
  for (const float amount : water.ground()) {
    wet |= amount > 0;
    now.push_back(static_cast<std::uint8_t>(255.0f * std::min(0.5f * amount, 1.0f)));
    // Nobody sees a ground that is drier by a step of a byte.
    const int was = puddles.empty() ? 0 : puddles[now.size() - 1];
    seen |= std::abs(now.back() - was) > 1;
  }
  if (!wet) now.clear();
  if (!seen && wet != puddles.empty()) return;
  puddles = std::move(now);
  ++puddlesRevision;
}

// A step of a brush that is held: dabs of a hand that moves count, too.
void App::State::dabOn() {
  if (++sinceDab >= kDabSteps && held.pressure > 0) dabAt(held.at);
}

// A step of a tool that is held.
void App::State::workOnWith() {
  if (!goesOn(tool)) return dabOn();
  auto& spots = strokes.back().spots;
  if (!spots.empty() && spots.back().step == waterSteps) spots.pop_back();
  if (spots.empty() || spots.back().at.triangle != held.at.triangle || spots.back().at.weights != held.at.weights ||
      spots.back().pressure != held.pressure)
    mark(held.at, held.pressure);
  if (tool == Tool::Hose) runHose();
}

// A jet onto what the pointer is at, from the right of the eye or its left, so that one sees it from the side; from the eye
// where the model is in the way of both.
void App::State::runHose() {
  const Mat3 toWorld(motion.worldFromModel());
  const Vec3 skin = shownPosition(held.at), normal = shownNormal(held.at);
  const Vec3 up = glm::transpose(toWorld) * Vec3(0, 1, 0), eye = normalizeOr(strokes.back().eye - skin, up);
  const Vec3 right = normalizeOr(glm::cross(up, eye), normal);
  Vec3 nozzle;
  for (const float side : {1.0f, -1.0f, 0.0f}) {
    const Vec3 from = 0.7f * eye + 0.8f * side * right;
    // Where fur at the outline is seen its root may face away.
    nozzle = kHoseLength * glm::normalize(from + normal * std::max(kHoseSlope - glm::dot(from, normal), 0.0f));
    const auto hit = shownQuery().castRay(skin + 0.1f * nozzle, nozzle);
    if (!hit || hit->distance > 1.0f) break;
  }
  const Vec3 at(motion.worldFromModel() * Vec4(skin, 1)), jet = toWorld * -nozzle;
  // In braces: their order is the same with every compiler.
  const Vec3 off = 0.05f * settings.brushRadius * Vec3{sprayRandom.uniform(-1, 1), sprayRandom.uniform(-1, 1), sprayRandom.uniform(-1, 1)};
  water.launch(at - jet, wet::Water::velocityFor(jet + off, kHoseLength / kHoseSpeed, climate().wind), settings.brushFlow * held.pressure * kHose,
               wet::Water::kJet);
}

// --- App's side --------------------------------------------------------------------------------

void App::shake() {
  state_->endStroke();
  state_->note(State::kShake);
  state_->motion.shake();
}

void App::stamp(std::span<const std::uint8_t> coverage, int width, int height, Vec2 centre, float across, float amount) {
  FUR_ASSERT(width > 0 && height > 0 && coverage.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
             "App::stamp()", "width * height texels", coverage.size());
  State& s = *state_;
  const render::Frame f = s.frame();
  // Clumps as fine as the letters need, and as the picture and the work allow.
  const float perTexel = across / static_cast<float>(width);
  const float step = std::max({static_cast<float>(height) / 18, static_cast<float>(width) / 120, 2 / perTexel});
  const float distance = std::max(0.2f, glm::length(f.camera.eye - f.camera.target));
  const float radius = 0.8f * step * perTexel * distance / render::pixelsPerUnit(f);
  // Two lie on every spot.
  s.beginWaterStroke(State::kSplash, radius, 0.5f * amount);
  for (float y = 0.5f * step; y < static_cast<float>(height); y += step)
    for (float x = 0.5f * step; x < static_cast<float>(width); x += step) {
      if (coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] < 128) continue;
      const auto hit = s.pick(centre + perTexel * (Vec2(x, y) - 0.5f * Vec2(width, height)));
      if (hit) s.lay(*hit);
    }
  s.endStroke();
}

std::string App::recordedStrokes() const {
  std::string out = "[";
  for (const State::Stroke& stroke : state_->strokes) {
    if (out.size() > 1) out += ',';
    const auto add = [&out](double value) { out.append(1, ',').append(shortDecimal(value)); };
    out.append(1, '[').append(shortDecimal(stroke.what));
    for (const float value : {stroke.radius, stroke.flow, stroke.clump, stroke.eye.x, stroke.eye.y, stroke.eye.z}) add(value);
    for (const State::StrokePoint& spot : stroke.spots) {
      add(spot.step);
      add(spot.at.triangle);
      for (const float value : {spot.at.weights.y, spot.at.weights.z, spot.pressure}) add(value);
    }
    out += ']';
  }
  return out + ']';
}

std::vector<std::uint8_t> App::saveWater() const {
  const State& s = *state_;
  ByteWriter to;
  to(kWaterLayout, s.mask.texels(), s.mask.film());
  s.water.save(to);
  to(s.waterSteps, static_cast<std::uint32_t>(s.strokes.size()));
  for (const State::Stroke& one : s.strokes) to(one.what, one.radius, one.flow, one.clump, one.eye, one.spots);
  return std::move(to.bytes);
}

Status App::restoreWater(std::span<const std::uint8_t> bytes) {
  State& s = *state_;
  s.endStroke();
  ByteReader from(bytes);
  std::vector<Vec4> texels;
  std::vector<float> film;
  wet::Water water;
  std::vector<State::Stroke> strokes;
  std::uint32_t layout = 0, steps = 0, count = 0;
  from(layout, texels, film);
  water.restore(from);
  from(steps, count);
  for (; count > 0 && from.sound(); --count) {
    State::Stroke& one = strokes.emplace_back();
    from(one.what, one.radius, one.flow, one.clump, one.eye, one.spots);
  }
  const std::size_t all = s.mask.texels().size();
  if (layout != kWaterLayout || !from.sound() || !from.atEnd() || texels.size() != all || (!film.empty() && film.size() != all))
    return Error{ErrorId::BadFile, "water of " + std::to_string(bytes.size()) + " bytes is not of this model"};
  s.water = std::move(water);
  s.shownPuddles = s.water.groundRevision() - 1;
  s.waterSteps = steps;
  s.strokes = std::move(strokes);
  restoreWetness(std::move(texels), std::move(film));
  return Done{};
}

Status App::replay(std::string_view json) {
  State& s = *state_;
  constexpr std::size_t kHead = 7, kSpot = 5;
  const Error unsound{ErrorId::BadFile, "these are no strokes on this model"};
  const std::vector<Json> nodes = parseJson(json);
  if (nodes.empty() || !nodes[0].isArray()) return unsound;
  // Nothing is done of a text that is not sound all through.
  std::vector<State::Stroke> strokes;
  for (const Json& read : nodes[0]) {
    const std::size_t count = read.count();
    if (!read.isArray() || count <= kHead || (count - kHead) % kSpot != 0) return unsound;
    std::vector<double> n;
    for (const Json& value : read) {
      const std::size_t i = n.size();
      const bool isEye = i >= 4 && i < kHead, isTriangle = i >= kHead && (i - kHead) % kSpot == 1;
      n.push_back(value.number());
      // Weights may lie a hair outside their triangle.
      if (!(n[i] >= (isEye ? -1e4 : -1e-3) && n[i] < (isTriangle ? static_cast<double>(s.surface.triangleCount()) : 4e9))) return unsound;
    }
    const auto at = [&n](std::size_t i, float low, float high) { return glm::clamp(static_cast<float>(n[i]), low, high); };
    State::Stroke& stroke = strokes.emplace_back(State::Stroke{
        static_cast<int>(std::min(n[0], 999.0)), at(1, 0, 10), at(2, 0, 3600), at(3, 0.01f, 0.3f), {at(4, -1e4f, 1e4f), at(5, -1e4f, 1e4f), at(6, -1e4f, 1e4f)}, {}});
    for (std::size_t i = kHead; i < count; i += kSpot) {
      const float y = at(i + 2, -1e-3f, 1), z = at(i + 3, -1e-3f, 1.001f);
      stroke.spots.push_back({static_cast<std::uint32_t>(std::max(n[i], 0.0)),
                              {static_cast<std::uint32_t>(std::max(n[i + 1], 0.0)), Vec3(1 - y - z, y, z), 0}, at(i + 4, 0, 1)});
    }
  }
  s.endStroke();
  if (strokes.empty()) return Done{};
  s.drag = Drag::None;
  const Tool tool = s.tool;
  const settings::Settings settings = s.settings;
  // The first begins now.
  const double begun = s.waterSteps, first = strokes[0].spots[0].step;
  s.waterDue = 0;
  for (const State::Stroke& stroke : strokes) {
    s.tool = static_cast<Tool>(std::min(stroke.what, static_cast<int>(Tool::None)));
    s.settings.brushRadius = stroke.radius;
    s.settings.brushFlow = stroke.flow;
    s.settings.clumpSize = stroke.clump;
    for (std::size_t i = 0; i < stroke.spots.size(); ++i) {
      // Ten minutes at most, and not where the water rests: a broken text must not hold the program up.
      const double until = begun + std::min(stroke.spots[i].step - first, 36000.0);
      for (double before = -1; s.waterSteps < until && s.waterSteps != before;) {
        before = s.waterSteps;
        tick(wet::Water::kStep);
      }
      const State::StrokePoint& spot = stroke.spots[i];
      s.pressure = spot.pressure;
      switch (stroke.what) {
        case State::kSplashAtlas: splashAt(spot.at.weights.y, spot.at.weights.z, stroke.radius, stroke.flow); break;
        case State::kSoak: setWetness(stroke.flow); break;
        case State::kDryOff: s.dryOff(stroke.flow, stroke.radius); break;
        case State::kShake: shake(); break;
        case State::kUndo: undo(); break;
        case State::kRedo: redo(); break;
        default:
          if (stroke.what != State::kSplash && (stroke.what > State::kSplash || !worksOnWater(s.tool))) break;
          if (i == 0) {
            s.beginWaterStroke(stroke.what, stroke.radius, stroke.flow);
            s.strokes.back().eye = stroke.eye;
          }
          if (stroke.what == State::kSplash) {
            s.lay(spot.at);
          } else if (goesOn(s.tool)) {
            s.held = spot;
            s.replaying = true;
          } else {
            s.sprayOn(spot.at);
          }
      }
    }
    s.replaying = false;
    s.endStroke();
  }
  s.pressure = 1;
  s.tool = tool;
  s.settings = settings;
  return Done{};
}

std::span<const wet::Drop> App::drops() const { return state_->water.drops(); }
const wet::Water& App::water() const { return state_->water; }

}  // namespace fur::app
