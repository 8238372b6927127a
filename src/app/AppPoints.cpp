// Single places of the skin and single whiskers, which the editor's modes show and change.
#include <algorithm>
#include <cmath>

#include "app/AppState.h"
#include "app/stages/Mirror.h"

namespace fur::app {

namespace {

// A dab of the dry brush takes this share of its flow (WaterTools.cpp).
constexpr float kDryDab = 0.35f;

// Distance of a point from a line between two others.
float distanceTo(Vec2 point, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  const float along = glm::clamp(glm::dot(point - from, way) / std::max(glm::dot(way, way), 1e-6f), 0.0f, 1.0f);
  return glm::distance(point, from + along * way);
}

}  // namespace

std::optional<FurAt> App::furAt(Vec2 pixel) const {
  const auto hit = state_->pick(pixel);
  if (!hit) return std::nullopt;
  FurAt out = state_->groom.numbersAt(state_->shape, *hit);
  const Vec2 atlas = atlasAt(state_->shape.surface(), *hit);
  out.wetness = saturate(state_->water.mask().at(atlas.x, atlas.y).w);
  return out;
}

std::optional<FurAt> App::furAt(const Vec3& place) const {
  const auto at = state_->shape.nearest(place);
  if (!at) return std::nullopt;
  FurAt out = state_->groom.numbersAt(state_->shape, *at);
  const Vec2 atlas = atlasAt(state_->shape.surface(), *at);
  out.wetness = saturate(state_->water.mask().at(atlas.x, atlas.y).w);
  return out;
}

void App::setFurAt(const Vec3& place, FurNumber what, float value, const Vec3& bend) {
  State& s = *state_;
  const auto at = s.shape.nearest(place);
  if (!at || !std::isfinite(value + bend.x + bend.y + bend.z)) return;
  if (what == FurNumber::Wetness) return s.setWetnessAt(*at, saturate(value));
  s.changeGroom([&] { s.groom.setNumber(s.shape, s.settings, what, *at, value, bend); });
}

// By strokes, which a replay does again: a droplet as large as the brush, or dabs that dry it.
void App::State::setWetnessAt(const geometry::SurfacePoint& at, float wetness) {
  const Vec2 atlas = atlasAt(shape.surface(), at);
  const auto missing = [&] { return wetness - saturate(water.mask().at(atlas.x, atlas.y).w); };
  if (missing() > 0) return strokeOnce(Command::Splash, settings.brushRadius, missing(), at);
  beginWaterStroke(Command::Dry, settings.brushRadius, 1);
  for (int dab = 0; dab < 4 && missing() < -0.01f; ++dab) water.strokeAt(shape, at, std::min(-missing() / kDryDab, 1.0f));
  endStroke();
}

std::vector<Vec2> App::ringRound(const Vec3& place) const {
  const auto at = state_->shape.nearest(place);
  return at ? state_->ringOn(*at, state_->settings.brushRadius) : std::vector<Vec2>();
}

Vec2 App::pixelOf(const Vec3& place) const {
  const State& s = *state_;
  const auto at = s.shape.nearest(place);
  return s.view.pixelAt(s.view.clipFromWorld() * s.worldFromModel() * Vec4(at ? s.picking().seenAt(*at) : place, 1));
}

std::vector<Vec2> App::whiskerLine(std::size_t whisker) const {
  const State& s = *state_;
  const auto& whiskers = s.groom.groom().whiskers;
  std::vector<Vec2> line;
  if (whisker >= whiskers.size()) return line;
  const auto hairs = s.groom.hairsOf(s.shape, {&whiskers[whisker], 1});
  if (hairs.empty()) return line;
  const Mat4 toClip = s.view.clipFromWorld() * s.worldFromModel();
  for (const Vec3& point : groom::hairPoints(hairs[0], s.motion.bends())) line.push_back(s.view.pixelAt(toClip * Vec4(point, 1)));
  return line;
}

std::optional<std::size_t> App::whiskerAt(Vec2 pixel, float reach) const {
  const State& s = *state_;
  const Ray ray = s.rayThrough(pixel);
  const auto hit = s.pick(pixel);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < s.groom.groom().whiskers.size(); ++i) {
    // One that is rooted behind the model is not seen there, or hardly.
    const groom::Whisker& whisker = s.groom.groom().whiskers[i];
    if (hit && glm::distance(ray.origin, whisker.root) > hit->distance + whisker.length + s.coatLength()) continue;
    const std::vector<Vec2> line = whiskerLine(i);
    for (std::size_t k = 1; k < line.size(); ++k) {
      const float distance = distanceTo(pixel, line[k - 1], line[k]);
      if (distance < reach) reach = distance, best = i;
    }
  }
  return best;
}

std::optional<std::size_t> App::plantWhisker(Vec2 pixel) {
  State& s = *state_;
  const auto hit = s.pick(pixel);
  if (!hit) return std::nullopt;
  const std::size_t before = whiskerCount();
  s.changeGroom([&] { s.groom.dab(s.shape, s.settings, Tool::Whisker, *hit, s.warnings); });
  return whiskerCount() > before ? std::optional(before) : std::nullopt;
}

void App::setWhisker(std::size_t whisker, const groom::Whisker& to) {
  state_->changeGroom([&] { state_->groom.setWhisker(whisker, to); });
}

void App::removeWhisker(std::size_t whisker) {
  state_->changeGroom([&] { state_->groom.removeWhisker(whisker); });
}

void App::aimWhisker(std::size_t whisker, Vec2 pixel) {
  if (whisker >= whiskerCount()) return;
  const Ray ray = state_->rayThrough(pixel);
  groom::Whisker to = groom().whiskers[whisker];
  to.direction = state_->groom.aimed(state_->shape, to, ray.origin, ray.direction);
  setWhisker(whisker, to);
}

void App::aimPlanted(Vec2 pixel) {
  const Ray ray = state_->rayThrough(pixel);
  state_->groom.aimWhiskers(state_->shape, state_->settings, ray.origin, ray.direction);
}

}  // namespace fur::app
