// What the commands of water do.
#include <algorithm>
#include <cmath>

#include "app/stages/Mirror.h"
#include "app/stages/WaterStage.h"
#include "core/PortableMath.h"
#include "geometry/Adjacency.h"

namespace fur::app {

namespace {

// Droplets of one spray: enough to fill the brush with clumps after a few passes.
constexpr int kDropletsPerSpray = 3;
// A single droplet of the dry brush takes this share of the flow.
constexpr float kDryShare = 0.35f;
// The towel takes what stands on the fur, and this share of the flow of what it holds.
constexpr float kTowelShare = 0.5f;
// Of the hose: amount a step, how far off its nozzle is and how fast water comes from there.
constexpr float kHose = 0.012f, kHoseLength = 2.0f, kHoseSpeed = 11.5f;
// Of drops that are sprinkled: how far aside and how high over the model's middle, in radii of what holds it; how much each brings; how
// many places are tried until the model is below one.
constexpr float kSprinkleReach = 1.0f, kSprinkleHeight = 1.7f, kSprinkle = 4e-3f;
constexpr int kSprinkleTries = 100;
constexpr float kHoseSlope = 0.3f;  // it meets the skin at no less; a sine

// Clumps come in sizes: many small ones, a few large ones.
float dropletRadius(float clump, Random& random) {
  const float chance = random.uniform();
  return clump * (0.6f + 0.95f * chance * chance);
}

}  // namespace

void WaterStage::beginStroke(WaterStroke head) {
  // Each has its own chance, so that it is the same wherever it is painted again.
  strokes_.push_back(std::move(head));
  random_ = Random(strokes_.size());
  before_ = MaskImage{mask_.texels(), mask_.film()};
  if (hair_) hairBefore_ = hair_->waterState();
  groundBefore_ = water_.wetGround();
  held_.reset();
}

void WaterStage::note(Command what, float clump) {
  strokes_.push_back({.what = what, .clump = clump});
  mark({}, 1);
}

std::optional<MaskStep> WaterStage::endStroke() {
  const auto before = std::exchange(before_, std::nullopt);
  held_.reset();
  if (!before) return std::nullopt;
  if (!strokes_.empty()) {
    WaterStroke& stroke = strokes_.back();
    if (stroke.points.empty()) strokes_.pop_back();
    else if (goesOn(toolOf(stroke.what))) mark(stroke.points.back().at, 0);
  }
  std::vector<float> hair = hair_ ? hair_->waterState() : std::vector<float>();
  const bool wetHair = hair != hairBefore_;
  auto step = maskStep(*before, mask_, wetHair);
  if (wetHair) {
    step->hairBefore = std::exchange(hairBefore_, {});
    step->hairAfter = std::move(hair);
  }
  if (step) {
    step->groundBefore = std::move(groundBefore_);
    step->groundAfter = water_.wetGround();
  }
  return step;
}

void WaterStage::apply(const MaskStep& step, bool undo) {
  app::apply(step, undo, mask_);
  if (hair_ && (!step.hairBefore.empty() || !step.hairAfter.empty())) hair_->setWaterState(undo ? step.hairBefore : step.hairAfter);
  water_.clear();  // what hangs and falls came of water that is there no more
  water_.setGround(undo ? step.groundBefore : step.groundAfter);
  touch();
}

DriedParts WaterStage::onBareParts(const ShapeStage& shape) {
  DriedParts parts;
  if (mask_.isDry()) return parts;
  const auto& charts = wetting(shape).chartOfTexel();
  for (std::uint32_t i = 0; i < charts.size(); ++i) {
    const float film = mask_.filmAt(i);
    if (charts[i] != wet::SurfaceWetting::kNoChart || (mask_.texels()[i].w <= 0 && film <= 0)) continue;
    parts.texels.push_back(i);
    parts.held.push_back(mask_.texels()[i]);
    parts.film.push_back(film);
  }
  return parts;
}

void WaterStage::putBack(const DriedParts& parts) {
  if (parts.texels.empty()) return;
  app::putBack(parts, mask_);
  touch();
}

void WaterStage::hold(std::optional<geometry::SurfacePoint> at, float pressure, float height) {
  if (at) held_ = Held{*at, pressure, height};
  else held_ = held_ ? Held{held_->at, 0, held_->height} : Held{{}, 0, 0};
}

void WaterStage::dab(const ShapeStage& shape, const settings::Settings& settings, const geometry::SurfacePoint& at, float pressure, float height) {
  sinceDab_ = 0;
  strokeAt(shape, at, pressure, height);
  if (const auto other = mirrored(settings, shape, at)) strokeAt(shape, *other, pressure, height);
}

void WaterStage::strokeAt(const ShapeStage& shape, const geometry::SurfacePoint& at, float pressure, float height) {
  const WaterStroke& stroke = strokes_.back();
  if (goesOn(toolOf(stroke.what))) return;
  mark(at, pressure, height);
  if (hair_) hair_->wetBy(stroke, shape, at, pressure, height);
  if (height > 0) return touch();
  if (stroke.what == Command::Droplet || stroke.what == Command::Splash) noteLanded({&at.triangle, 1});
  const geometry::Surface& surface = shape.surface();
  const float flow = stroke.flow * pressure;
  const auto centre = [&] { return positionAt(surface, at); };
  const auto normal = [&] { return normalAt(surface, at); };
  switch (stroke.what) {
    case Command::Droplet: scatter(shape, centre(), normal(), stroke.radius, stroke.clump, flow); break;
    case Command::Dry:
      wetting(shape).dryAt(mask_, surface, shape.query(), centre(), normal(), stroke.radius, flow * kDryShare);
      break;
    case Command::Towel: {
      const wet::WetSurface on{surface, shape.query(), wetting(shape)};
      water_.prepare(on);
      water_.wipe(on, mask_, centre(), normal(), stroke.radius, flow * kTowelShare);
      break;
    }
    case Command::Splash:
      wetting(shape).addDroplet(mask_, surface, shape.query(), centre(), normal(), stroke.radius, stroke.flow);
      break;
    case Command::SplashAtlas: mask_.addDroplet({Vec2(at.weights.y, at.weights.z), stroke.radius, stroke.flow}); break;
    case Command::Soak: soak(shape, stroke.flow, stroke.clump); break;
    case Command::DryOff: mask_.dry(stroke.flow, stroke.radius); break;
    default: break;
  }
  touch();
}

void WaterStage::sprinkle(const ShapeStage& shape, const Mat4& worldFromModel, int drops) {
  const ShapeStage::Extent& extent = shape.extent();
  const Vec3 middle(worldFromModel * Vec4(extent.centre, 1));
  const Mat3 toModel = glm::transpose(Mat3(worldFromModel));
  const geometry::SurfaceQuery& shown = shape.shownQuery();
  for (int i = 0; i < drops; ++i) {
    Vec3 over(0);
    for (int tries = 0; tries < kSprinkleTries; ++tries) {
      const float angle = sprinkled_.uniform(0, 2 * kPi), reach = kSprinkleReach * std::sqrt(sprinkled_.uniform());
      over = extent.radius * Vec3(reach * portableCos(angle), kSprinkleHeight + 0.2f * sprinkled_.uniform(), reach * portableSin(angle));
      if (shown.castRay(extent.centre + toModel * over, toModel * Vec3(0, -1, 0))) break;
    }
    water_.launch(middle + over, Vec3(0), kSprinkle);
  }
  touch();
}

void WaterStage::scatter(const ShapeStage& shape, const Vec3& centre, const Vec3& normal, float radius, float clump, float amount) {
  const auto [side, up] = axesOn(normal);
  const float droplet = std::min(clump, radius);
  for (int i = 0; i < kDropletsPerSpray; ++i) {
    const float angle = random_.uniform(0, 2 * kPi);
    const float reach = (radius - droplet) * std::sqrt(random_.uniform());
    const Vec3 above = centre + reach * (portableCos(angle) * side + portableSin(angle) * up) + 0.3f * radius * normal;
    // Droplets fall onto the surface; one that falls past an edge is lost.
    const auto hit = shape.query().castRay(above + 0.5f * radius * normal, -normal);
    if (!hit || hit->distance > 2.5f * radius) continue;
    wetting(shape).addDroplet(mask_, shape.surface(), shape.query(), positionAt(shape.surface(), *hit), normalAt(shape.surface(), *hit),
                              dropletRadius(droplet, random_), amount);
  }
}

void WaterStage::soak(const ShapeStage& shape, float amount, float clump) {
  mask_.clear();
  water_.clear();
  if (amount <= 0) return;
  const geometry::Surface& surface = shape.surface();
  const wet::SurfaceWetting& wetting = this->wetting(shape);
  const auto wet = [&](const geometry::SurfacePoint& at, float radius) {
    wetting.addDroplet(mask_, surface, shape.query(), positionAt(surface, at), normalAt(surface, at), radius, amount);
  };
  // Droplets all over, by area, four deep, so that nearly no spot stays dry between them.
  std::vector<float> areaBelow;
  float total = 0;
  const auto corner = [&](std::size_t t, int k) { return surface.vertices[surface.indices[3 * t + static_cast<std::size_t>(k)]].position; };
  for (std::size_t t = 0; t < surface.triangleCount(); ++t)
    areaBelow.push_back(total += 0.5f * glm::length(glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0))));
  Random random(7);
  const int count = std::min(20000, static_cast<int>(4 * total / (kPi * clump * clump)));
  for (int i = 0; i < count; ++i) {
    const auto at = std::lower_bound(areaBelow.begin(), areaBelow.end(), total * random.uniform());
    const auto triangle = std::min<std::size_t>(static_cast<std::size_t>(at - areaBelow.begin()), areaBelow.size() - 1);
    float u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    wet({static_cast<std::uint32_t>(triangle), Vec3(1 - u - v, u, v), 0}, dropletRadius(clump, random));
  }
  // What chance has missed.
  const auto& triangles = wetting.atlas().triangleOf();
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    if (triangles[i] != geometry::kNoTriangle && mask_.texels()[i].w <= 0)
      wet({triangles[i], wetting.atlas().weightsAt(surface, triangles[i], i), 0}, clump);
  // Overlaps have added up: one wetness all over.
  std::vector<Vec4> even = mask_.texels();
  for (Vec4& texel : even)
    if (texel.w > 0) texel.w = std::min(amount, 1.0f);
  // Gutters that no droplet has met: look-ups beside a chart would find dry fur.
  for (const auto& [gutter, source] : wetting.atlas().gutter())
    if (even[gutter].w <= 0) even[gutter] = even[source];
  mask_.restore(std::move(even));
}

// A step of the tool that is held.
void WaterStage::work(const Inputs& inputs) {
  WaterStroke& stroke = strokes_.back();
  if (!goesOn(toolOf(stroke.what))) {
    // Dabs of a hand that moves count, too.
    if (++sinceDab_ >= kDabSteps && held_->pressure > 0) dab(inputs.shape, inputs.settings, held_->at, held_->pressure, held_->height);
    return;
  }
  auto& points = stroke.points;
  if (!points.empty() && points.back().step == steps_) points.pop_back();
  if (points.empty() || points.back().at.triangle != held_->at.triangle || points.back().at.weights != held_->at.weights ||
      points.back().pressure != held_->pressure || points.back().height != held_->height)
    mark(held_->at, held_->pressure, held_->height);
  if (stroke.what == Command::Hose) pourFromHose(inputs);
}

// A jet onto what the pointer is at, from the right of the eye or its left, so that one sees it from the side; from the eye
// where the model is in the way of both.
void WaterStage::pourFromHose(const Inputs& inputs) {
  const WaterStroke& stroke = strokes_.back();
  const Mat3 toWorld(inputs.worldFromModel);
  const Vec3 skin = placeOfHeld(inputs.shape), normal = inputs.shape.shownNormal(held_->at);
  const Vec3 up = glm::transpose(toWorld) * Vec3(0, 1, 0), eye = normalizeOr(stroke.eye - skin, up);
  const Vec3 right = normalizeOr(glm::cross(up, eye), normal);
  Vec3 nozzle;
  for (const float side : {1.0f, -1.0f, 0.0f}) {
    const Vec3 from = 0.7f * eye + 0.8f * side * right;
    // Where fur at the outline is seen its root may face away.
    nozzle = kHoseLength * glm::normalize(held_->height > 0 ? from : from + normal * std::max(kHoseSlope - glm::dot(from, normal), 0.0f));
    const auto hit = inputs.shape.shownQuery().castRay(skin + 0.1f * nozzle, nozzle);
    if (!hit || hit->distance > 1.0f) break;
  }
  const Vec3 at(inputs.worldFromModel * Vec4(skin, 1)), jet = toWorld * -nozzle;
  // In braces: their order is the same with every compiler.
  const Vec3 off = 0.05f * stroke.radius * Vec3{random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
  water_.launch(at - jet, wet::Water::velocityFor(jet + off, kHoseLength / kHoseSpeed, climate(inputs).wind), stroke.flow * held_->pressure * kHose,
                wet::Water::kJet);
}

}  // namespace fur::app
