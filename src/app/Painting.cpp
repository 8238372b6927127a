#include <algorithm>
#include <cmath>
#include <utility>

#include "app/AppState.h"
#include "core/PortableMath.h"
#include "geometry/Adjacency.h"

namespace fur::app {

namespace {

// Droplets of one spray: enough to fill the brush with clumps after a few passes.
constexpr int kDropletsPerSpray = 3;
// Share of the brush radius between two sprays of a stroke.
constexpr float kSpacing = 0.35f;
// A single droplet of the dry brush takes this share of the flow.
constexpr float kDryShare = 0.35f;
// The towel takes what stands on the fur, and this share of the flow of what it holds.
constexpr float kTowelShare = 0.5f;

}  // namespace

std::pair<Vec3, Vec3> axesOn(const Vec3& normal) {
  const Vec3 side = normalizeOr(glm::cross(normal, std::abs(normal.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0)), Vec3(1, 0, 0));
  return {side, glm::cross(normal, side)};
}

void App::State::maskTouched() {
  vertexWetnessStale = forcesChanged = pictureChanged = true;
}

const std::vector<float>& App::State::wetnessOfVertices() {
  if (!std::exchange(vertexWetnessStale, false)) return vertexWetness;
  // Vertices of one point weigh the same, whichever charts they are of: where they bent apart, the coat would crack.
  if (!points) points.emplace(surface);
  std::vector<Vec2> sums(points->count(), Vec2(0));
  for (std::size_t i = 0; i < vertexWetness.size(); ++i) {
    const Vec2 atlas = surface.vertices[i].atlas;
    sums[points->pointOf[i]] += Vec2(mask.at(atlas.x, atlas.y).w, 1);
  }
  for (std::size_t i = 0; i < vertexWetness.size(); ++i) {
    const Vec2& sum = sums[points->pointOf[i]];
    vertexWetness[i] = sum.x / sum.y;
  }
  return vertexWetness;
}

void App::State::beginStroke() {
  if (grooms(tool)) return beginGroomStroke();
  beginWaterStroke(static_cast<int>(tool), settings.brushRadius, settings.brushFlow);
}

void App::State::note(int deed) {
  strokes.push_back({deed, 0, 0, settings.clumpSize, Vec3(0), {}});
  mark();
}

void App::State::mark(const geometry::SurfacePoint& at, float pressed) { strokes.back().spots.push_back({waterSteps, at, pressed}); }

void App::State::beginWaterStroke(int what, float radius, float flow) {
  endStroke();
  const Vec3 eye(glm::inverse(motion.worldFromModel()) * Vec4(frame().camera.eye, 1));
  // Each has its own chance, so that it is the same wherever it is painted again.
  strokes.push_back({what, radius, flow, settings.clumpSize, eye, {}});
  sprayRandom = Random(strokes.size());
  strokeBefore = MaskImage{mask.texels(), mask.film()};
}

void App::State::endStroke() {
  endGroomStroke();
  keyHold = 0;
  if (!strokeBefore) return;
  if (!strokes.empty()) {
    Stroke& stroke = strokes.back();
    if (stroke.spots.empty()) strokes.pop_back();
    else if (stroke.what < kSplash && goesOn(static_cast<Tool>(stroke.what))) mark(stroke.spots.back().at, 0);
  }
  if (auto step = maskStep(*strokeBefore, mask)) history.push(std::move(*step));
  strokeBefore.reset();
}

void App::State::scatter(const Vec3& centre, const Vec3& normal, float radius, float amount) {
  const auto [side, up] = axesOn(normal);
  const float droplet = std::min(settings.clumpSize, radius);
  for (int i = 0; i < kDropletsPerSpray; ++i) {
    const float angle = sprayRandom.uniform(0, 2 * kPi);
    const float reach = (radius - droplet) * std::sqrt(sprayRandom.uniform());
    const Vec3 above = centre + reach * (portableCos(angle) * side + portableSin(angle) * up) + 0.3f * radius * normal;
    // Droplets fall onto the surface; one that falls past an edge is lost.
    const auto hit = query.castRay(above + 0.5f * radius * normal, -normal);
    if (!hit || hit->distance > 2.5f * radius) continue;
    wetting->addDroplet(mask, surface, query, positionAt(surface, *hit), normalAt(surface, *hit),
                        droplet * sprayRandom.uniform(0.75f, 1.25f), amount);
  }
}

bool App::State::sprayAt(Vec2 pixel) {
  const auto hit = pick(pixel);
  if (hit) dabAt(*hit);
  return hit.has_value();
}

void App::State::dabAt(const geometry::SurfacePoint& at) {
  sinceDab = 0;
  if (grooms(tool)) return groomAt(at);
  sprayOn(at);
  if (const auto other = mirrored(at)) sprayOn(*other);
}

void App::State::sprayOn(const geometry::SurfacePoint& at) {
  if (goesOn(tool)) return;
  if (strokeBefore && !strokes.empty()) mark(at, pressure);
  const Vec3 centre = positionAt(surface, at), normal = normalAt(surface, at);
  const float flow = settings.brushFlow * pressure;
  if (tool == Tool::Dry) {
    wetting->dryAt(mask, surface, query, centre, normal, settings.brushRadius, flow * kDryShare);
  } else if (tool == Tool::Towel) {
    const wet::WetSurface on{surface, query, *wetting};
    water.prepare(on);
    water.wipe(on, mask, centre, normal, settings.brushRadius, flow * kTowelShare);
  } else if (tool == Tool::Droplet) {
    scatter(centre, normal, settings.brushRadius, flow);
  }
  maskTouched();
}

void App::State::paintTo(Vec2 pixel) {
  if (tool == Tool::Whisker) return aimWhisker(pixel);
  const render::Frame f = frame();
  const float distance = std::max(0.2f, glm::length(f.camera.eye - f.camera.target));
  const float spacing = std::max(2.0f, kSpacing * settings.brushRadius * render::pixelsPerUnit(f) / distance);
  for (Vec2 way = pixel - lastSpot; glm::length(way) >= spacing; way = pixel - lastSpot) {
    lastSpot += way * (spacing / glm::length(way));
    sprayAt(lastSpot);
  }
}

void App::State::dryOff(float seconds, float rate) {
  beginWaterStroke(kDryOff, rate, seconds);
  mark();
  mask.dry(seconds, rate);
  maskTouched();
  endStroke();
}

void App::State::lay(const geometry::SurfacePoint& at) {
  mark(at);
  const Stroke& stroke = strokes.back();
  wetting->addDroplet(mask, surface, query, positionAt(surface, at), normalAt(surface, at), stroke.radius, stroke.flow);
  maskTouched();
}

void App::State::soak(float amount) {
  mask.clear();
  water.clear();
  if (amount <= 0) return maskTouched();
  // Droplets all over, by area, four deep, so that nearly no spot stays dry between them.
  std::vector<float> areaBelow;
  float total = 0;
  const auto corner = [&](std::size_t t, int k) { return surface.vertices[surface.indices[3 * t + static_cast<std::size_t>(k)]].position; };
  for (std::size_t t = 0; t < surface.triangleCount(); ++t)
    areaBelow.push_back(total += 0.5f * glm::length(glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0))));
  Random random(7);
  const float droplet = settings.clumpSize;
  const int count = std::min(20000, static_cast<int>(4 * total / (kPi * droplet * droplet)));
  for (int i = 0; i < count; ++i) {
    const auto at = std::lower_bound(areaBelow.begin(), areaBelow.end(), total * random.uniform());
    const auto triangle = std::min<std::size_t>(static_cast<std::size_t>(at - areaBelow.begin()), areaBelow.size() - 1);
    float u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const geometry::SurfacePoint point{static_cast<std::uint32_t>(triangle), Vec3(1 - u - v, u, v), 0};
    wetting->addDroplet(mask, surface, query, positionAt(surface, point), normalAt(surface, point),
                        droplet * random.uniform(0.75f, 1.25f), amount);
  }
  // What chance has missed.
  const auto& triangles = wetting->atlas().triangleOf();
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] == geometry::kNoTriangle || mask.texels()[i].w > 0) continue;
    const geometry::SurfacePoint point{triangles[i], wetting->atlas().weightsAt(surface, triangles[i], i), 0};
    wetting->addDroplet(mask, surface, query, positionAt(surface, point), normalAt(surface, point), droplet, amount);
  }
  // Overlaps have added up: one wetness all over.
  std::vector<Vec4> even = mask.texels();
  for (Vec4& texel : even)
    if (texel.w > 0) texel.w = std::min(amount, 1.0f);
  mask.restore(std::move(even));
  maskTouched();
}

// --- App's side --------------------------------------------------------------------------------

void App::setTool(Tool tool) {
  state_->endStroke();
  state_->otherChanges += state_->tool != tool;
  state_->tool = tool;
  // The mask shows while one grooms.
  if (!state_->groom.mask.isPlain()) state_->groomStale = state_->pictureChanged = true;
  state_->touch.lift();
  state_->refreshTouch();
}
Tool App::tool() const { return state_->tool; }

void App::splashAt(float u, float v, float radius, float amount) {
  state_->beginWaterStroke(State::kSplashAtlas, radius, amount);
  state_->mark({0, Vec3(0, u, v), 0});
  state_->mask.addDroplet({Vec2(u, v), radius, amount});
  state_->maskTouched();
  state_->endStroke();
}

bool App::splashPixel(Vec2 pixel, float radius, float amount) {
  State& s = *state_;
  const auto hit = s.pick(pixel);
  if (!hit) return false;
  s.beginWaterStroke(State::kSplash, radius, amount);
  s.lay(*hit);
  s.endStroke();
  return true;
}

void App::setWetness(float amount) {
  state_->beginWaterStroke(State::kSoak, 0, amount);
  state_->mark();
  state_->soak(amount);
  state_->endStroke();
}

void App::dry(float seconds) {
  state_->dryOff(seconds, std::max(state_->settings.dryRate, 0.02f));
}

float App::wetnessAt(float u, float v) const { return state_->mask.at(u, v).w; }
float App::meanWetness() const {
  const wet::WetnessMask& mask = state_->mask;
  if (mask.isDry()) return 0;
  double sum = 0;
  long texels = 0;
  const auto& triangles = state_->wetting->atlas().triangleOf();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] == geometry::kNoTriangle) continue;
    sum += mask.texels()[i].w;
    ++texels;
  }
  return static_cast<float>(sum / static_cast<double>(std::max(texels, 1l)));
}
std::uint64_t App::wetnessHash() const { return state_->mask.hash(); }
const wet::WetnessMask& App::wetnessMask() const { return state_->mask; }

void App::restoreWetness(std::vector<Vec4> texels, std::vector<float> film) {
  state_->mask.restore(std::move(texels), std::move(film));
  state_->maskTouched();
}

}  // namespace fur::app
