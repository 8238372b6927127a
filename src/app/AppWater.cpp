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
constexpr std::uint32_t kPlacesAtOnce = 4000;
// Model radii a second in the strongest wind, and of what a hair dryer blows.
constexpr float kWindSpeed = 1.5f;
// Wetness a second under the middle of a dryer, and how hard it blows the fur about.
constexpr float kBlow = 1.6f, kBlowWind = 0.7f;
// Of the hose: amount a second, drops a second, how far off they start and how fast they come.
constexpr float kHose = 0.25f, kHoseDrops = 90.0f, kHoseReach = 0.5f, kHoseSpeed = 3.5f;

}  // namespace

bool App::State::holds(Tool held) const { return drag == Drag::Paint && tool == held; }

wet::Climate App::State::climate() {
  wet::Climate c;
  c.worldFromModel = motion.worldFromModel();
  c.wind = kWindSpeed * wind() * Vec3(portableSin(settings.windYaw), 0, portableCos(settings.windYaw));
  c.dryRate = settings.dryRate;
  c.furLength = settings.furLength;
  c.clumpSize = settings.clumpSize;
  c.groundHeight = groundHeight;
  c.rain = holds(Tool::Rain) ? std::max(settings.rain, settings.brushFlow) : settings.rain;
  c.shaking = motion.shaking();
  if (!holds(Tool::Dryer)) return c;
  if (const auto hit = pick(lastPosition)) {
    c.blowCentre = positionAt(surface, *hit);
    c.blowRadius = 1.5f * settings.brushRadius;
    c.blow = kBlow * settings.brushFlow * pressure;
  }
  return c;
}

Vec3 App::State::dryerWind() const {
  if (!holds(Tool::Dryer)) return Vec3(0);
  return Mat3(motion.worldFromModel()) * rayThrough(lastPosition).direction * (kBlowWind * pressure);
}

bool App::State::runWater(float dt, double budget) {
  if (holds(Tool::Hose)) runHose(dt);
  const wet::Climate now = climate();
  if (!water.active(mask, now)) return false;
  const wet::Ground on{surface, query, *wetting};
  for (const double begun = secondsNow(); !water.prepare(on, kPlacesAtOnce);)
    if (secondsNow() - begun >= budget) return false;
  if (!water.step(on, mask, dt, now)) return false;
  maskTouched();
  return true;
}

void App::State::readPuddles() {
  if (std::exchange(shownPuddles, water.groundRevision()) == water.groundRevision()) return;
  puddles.clear();
  bool wet = false;
  for (const float amount : water.ground()) {
    wet |= amount > 0;
    puddles.push_back(static_cast<std::uint8_t>(255.0f * std::min(amount, 1.0f)));
  }
  if (!wet) puddles.clear();
}

// A jet from the eye's side onto what the pointer is at.
void App::State::runHose(float dt) {
  const auto hit = pick(lastPosition);
  if (!hit) return;
  const Mat4 toWorld = motion.worldFromModel();
  const Vec3 at = Vec3(toWorld * Vec4(shownPosition(*hit), 1));
  const Vec3 way = Mat3(toWorld) * rayThrough(lastPosition).direction;
  for (hoseDue += dt * kHoseDrops; hoseDue >= 1; hoseDue -= 1) {
    const Vec3 off = 0.25f * settings.brushRadius * Vec3(sprayRandom.uniform(-1, 1), sprayRandom.uniform(-1, 1), sprayRandom.uniform(-1, 1));
    const float size = sprayRandom.uniform(0.5f, 1.5f);
    water.launch(at - kHoseReach * sprayRandom.uniform(0.6f, 1.0f) * way + off, kHoseSpeed * way,
                 size * settings.brushFlow * pressure * (kHose / kHoseDrops / 0.35f));
  }
}

// --- App's side --------------------------------------------------------------------------------

void App::shake() { state_->motion.shake(); }

void App::stamp(std::span<const std::uint8_t> coverage, int width, int height, Vec2 centre, float across, float amount) {
  FUR_ASSERT(width > 0 && height > 0 && coverage.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
             "App::stamp()", "width * height texels", coverage.size());
  State& s = *state_;
  const render::Frame f = s.frame();
  // Locks as fine as the letters need, and as the picture and the work allow.
  const float perTexel = across / static_cast<float>(width);
  const float step = std::max({static_cast<float>(height) / 18, static_cast<float>(width) / 120, 2 / perTexel});
  const float distance = std::max(0.2f, glm::length(f.camera.eye - f.camera.target));
  const float radius = 0.8f * step * perTexel * distance / render::pixelsPerUnit(f);
  s.beginWaterStroke();
  for (float y = 0.5f * step; y < static_cast<float>(height); y += step)
    for (float x = 0.5f * step; x < static_cast<float>(width); x += step) {
      if (coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] < 128) continue;
      const auto hit = s.pick(centre + perTexel * (Vec2(x, y) - 0.5f * Vec2(width, height)));
      if (hit) s.wetting->addDroplet(s.mask, s.surface, s.query, positionAt(s.surface, *hit), normalAt(s.surface, *hit), radius, amount);
    }
  s.maskTouched();
  s.endStroke();
}

std::string App::recordedStrokes() const {
  std::string out = "[";
  for (const State::Stroke& stroke : state_->strokes) {
    if (out.size() > 1) out += ',';
    const auto add = [&out](double value) { out.append(1, ',').append(shortDecimal(value)); };
    out.append(1, '[').append(shortDecimal(static_cast<int>(stroke.tool)));
    for (const float value : {stroke.radius, stroke.flow, stroke.clump}) add(value);
    for (const State::Spot& spot : stroke.spots) {
      add(std::round(spot.time * 1000));
      add(spot.at.triangle);
      for (const float value : {spot.at.weights.y, spot.at.weights.z, spot.pressure}) add(value);
    }
    out += ']';
  }
  return out + ']';
}

Status App::replay(std::string_view json) {
  State& s = *state_;
  const Error unsound{ErrorId::BadFile, "these are no strokes on this model"};
  const std::vector<Json> nodes = parseJson(json);
  if (nodes.empty() || !nodes[0].isArray()) return unsound;
  // Nothing is painted of a text that is not sound all through.
  double first = -1;
  for (const Json& stroke : nodes[0]) {
    const std::size_t count = stroke.count();
    if (!stroke.isArray() || count < 4 || (count - 4) % 5 != 0) return unsound;
    std::size_t i = 0;
    for (const Json& value : stroke) {
      const double number = value.number();
      const bool isTriangle = i >= 4 && i % 5 == 0;
      // Weights may lie a hair outside their triangle.
      if (!(number >= -1e-3 && number < (isTriangle ? static_cast<double>(s.surface.triangleCount()) : 4e9))) return unsound;
      // The first begins now.
      if (i == 4 && first < 0) first = number / 1000;
      ++i;
    }
  }
  s.endStroke();
  const Tool tool = std::exchange(s.tool, Tool::Droplet);
  const settings::Settings settings = s.settings;
  const double begun = s.clock;
  for (const Json& stroke : nodes[0]) {
    auto value = stroke.begin();
    const auto next = [&value] {
      const auto number = (*value).number();
      ++value;
      return number;
    };
    s.tool = static_cast<Tool>(static_cast<int>(glm::clamp(next(), 0.0, 99.0)));
    s.settings.brushRadius = glm::clamp(static_cast<float>(next()), 0.01f, 0.5f);
    s.settings.brushFlow = glm::clamp(static_cast<float>(next()), 0.0f, 1.0f);
    s.settings.clumpSize = glm::clamp(static_cast<float>(next()), 0.01f, 0.3f);
    if (s.tool != Tool::Droplet && s.tool != Tool::Dry && s.tool != Tool::Towel) continue;
    for (bool started = false; value != stroke.end();) {
      // Ten minutes at most: a broken text must not hold the program up.
      const double until = begun + std::min(next() / 1000 - first, 600.0) - 0.5 * wet::Water::kStep;
      while (s.clock < until) tick(wet::Water::kStep);
      if (!std::exchange(started, true)) s.beginStroke();
      geometry::SurfacePoint at{static_cast<std::uint32_t>(std::max(next(), 0.0)), Vec3(0), 0};
      at.weights.y = std::min(static_cast<float>(next()), 1.0f);
      at.weights.z = std::min(static_cast<float>(next()), 1.001f - at.weights.y);
      at.weights.x = 1.0f - at.weights.y - at.weights.z;
      s.pressure = std::min(static_cast<float>(next()), 1.0f);
      s.sprayOn(at);
    }
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
