// What time does: the stages are updated one after another (README.md).
#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/AppState.h"
#include "core/Clock.h"
#include "core/Fnv1a.h"

namespace fur::app {

namespace {

// Seconds without anybody there.
constexpr float kRestBeforeTurning = 3;
// Changes of a picture: so many a second, and how many together, are seldom.
constexpr float kSeldom = 8;
// How hard a hair dryer blows the fur about: strength of the wind.
constexpr float kDryerWind = 0.7f;
// An animal minds a pointer for so long after it moved, s, and looks as far along its ray as this share of the way to the model.
constexpr float kMindsPointer = 4, kPointedAt = 0.7f;

static_assert(sizeof(furgen::FurParameters) % sizeof(float) == 0 && alignof(furgen::FurParameters) == sizeof(float));  // no padding

std::uint64_t numberOf(const CoatParameters& types, const GivenCoats& given) {
  Fnv1a hash;
  hash.addAll(types);
  for (const GivenCoat& one : given) hash.add(one.get());
  return hash.value();
}

}  // namespace

// Hands the layers of a coat to the renderer.
struct App::State::LayerUpload final : CoatReceiver {
  explicit LayerUpload(State& state) : s(state) {}
  void prepare() override {
    s.upload();
    s.renderer->begin(s.frame());
    s.warm = false;
    s.warmUpWhenReady();
  }
  void begin(const furgen::CoatShape& shape) override { s.renderer->beginFur(shape); }
  void setLayer(int type, int layer, std::span<const furgen::PackedLevel> levels) override { s.renderer->setFurLayer(type, layer, levels); }
  void setFin(int type, std::span<const furgen::PackedLevel> levels) override { s.renderer->setFinMap(type, levels); }
  void show(std::span<const float> densities) override { s.renderer->showFur(densities); }
  void share(const std::shared_ptr<const WholeCoat>& coat) override {
    if (!s.context) return;
    s.renderer->shownFur()->of = coat;
    s.context->coats.add(numberOf(coat->types, coat->given), s.renderer->shownFur());
  }
  std::shared_ptr<const WholeCoat> showShared(const CoatParameters& types, const GivenCoats& given) override {
    auto textures = std::static_pointer_cast<render::FurTextures::Coat>(s.context ? s.context->coats.find(numberOf(types, given)) : nullptr);
    auto coat = std::static_pointer_cast<const WholeCoat>(textures ? textures->of : nullptr);
    if (!coat || !coat->isFor(types, given)) return nullptr;
    s.renderer->showFur(std::move(textures));
    return coat;
  }

  State& s;
};

BehaviourStage::Inputs App::State::behaviourInputs(float seconds) {
  BehaviourStage::Inputs inputs{.shape = shape, .settings = settings};
  const Mat4 toModel = glm::inverse(worldFromModel());
  const Ray ray = rayThrough(hand.pointed);
  inputs.camera = Vec3(toModel * Vec4(view.pose().eye, 1));
  if (hand.sincePointed < kMindsPointer) inputs.pointer = ray.origin + ray.direction * (kPointedAt * glm::length(ray.origin - shape.extent().centre));
  if (const auto& petting = motion.touch().hand()) inputs.hand = Vec3(toModel * Vec4(*petting, 1));
  inputs.landed = water.landed();
  if (behaviour.behaves() && !water.mask().isDry()) {
    const std::vector<float>& wetness = water.vertexWetness(shape);
    inputs.wetness = std::accumulate(wetness.begin(), wetness.end(), 0.0f) / static_cast<float>(std::max<std::size_t>(wetness.size(), 1));
  }
  inputs.idleTime = idleTime;
  inputs.reducedMotion = reducedMotion;
  inputs.seconds = seconds;
  return inputs;
}

ShapeStage::Inputs App::State::shapeInputs(float seconds) const {
  return {seconds, shape.animationOf(settings.animation), reducedMotion ? 0 : settings.animationSpeed, behaviour.mix(), behaviour.revision(), behaviour.played()};
}

MotionStage::Inputs App::State::motionInputs(float seconds) {
  MotionStage::Inputs inputs{.shape = shape, .groom = groom, .water = water, .coatWeights = coat.weights(), .settings = settings, .coatLength = coatLength()};
  inputs.seconds = seconds;
  inputs.idleTime = idleTime;
  inputs.reducedMotion = reducedMotion;
  inputs.showForces = showsForces();
  if (water.holds(Tool::Dryer))
    inputs.dryer = Mat3(worldFromModel()) * rayThrough(heldPixel()).direction * (kDryerWind * hand.pressure);
  return inputs;
}

WaterStage::Inputs App::State::waterInputs(float seconds, double budget) const {
  WaterStage::Inputs inputs{.shape = shape, .groom = groom, .settings = settings, .coatLength = coatLength()};
  inputs.worldFromModel = worldFromModel();
  inputs.wind = reducedMotion ? 0 : settings.wind;
  inputs.shaking = std::max(motion.body().shaking(), behaviour.shaking());
  inputs.bySkin = behaviour.shaking() > 0;
  inputs.seconds = seconds;
  inputs.budget = budget;
  return inputs;
}

HairStage::Inputs App::State::hairInputs(float seconds) {
  return {.shape = shape, .settings = settings, .worldFromModel = worldFromModel(), .wind = motion.windNow(),
          .contacts = motion.touch().contacts(),
          .wetness = water.mask().isDry() || hair->style().scalps.empty() ? std::span<const float>() : water.vertexWetness(shape), .seconds = seconds};
}

bool App::State::updateShape(float seconds) {
  const CameraOrbit before = homeView();
  behaviour.update(behaviourInputs(seconds));
  water.forgetLanded();
  const bool moved = shape.update(shapeInputs(seconds));
  keepInView(before, false);
  return moved;
}

bool App::State::warmUpWhenReady() {
  if (warm || coat.shown()) return true;
  warm = renderer->ready();
  if (warm) renderer->warmUp(frame());
  return warm;
}

// The shaders that a first picture does without: those of shadows, and when these are compiled those of fins.
void App::State::beginRest() {
  render::Frame f = frame();
  f.castsShadows = true;
  f.settings.fins = casts && settings.fins;
  renderer->begin(f);
  if (casts || !renderer->ready()) return;
  casts = true;
  ++changed;
}

void App::State::workOnCoat(double budget, bool coarseFirst) {
  if (!renderer) return;
  if (coat.growing()) warmUpWhenReady();
  // The first picture, which is drawn where there is no budget, waits for no shadow; those after it have some as soon as they need not wait.
  if (coarseFirst || budget <= 0) casts = false;
  else if (coat.isCoarse()) beginRest();
  LayerUpload receiver(*this);
  CoatStage::Inputs inputs = coatInputs();
  inputs.receiver = &receiver;
  inputs.budget = budget;
  inputs.coarseFirst = coarseFirst;
  if (coat.update(inputs, warnings)) governor.forget();
}

Work App::workOnPicture(float seconds, bool coarse) {
  State& s = *state_;
  s.groom.update(s.groomInputs());  // it says which types there are
  for (const double begun = secondsNow(); !s.hair->workOnGrowth(s.hairInputs(0));)
    if (secondsNow() - begun > seconds) return Work::GoesOn;
  if (!s.renderer) return Work::Done;
  const auto isDone = [&] { return coarse ? s.coat.shows(s.coatInputs()) : !s.coat.active(s.coatInputs()); };
  if (!isDone()) {
    s.workOnCoat(seconds, coarse);
    if (isDone()) s.settleMotion(false);  // as strands of all its types lie
  }
  if (!isDone() || !s.chooseShellCount(false, seconds)) return Work::GoesOn;
  return s.renderer->ready() ? Work::Done : Work::Waits;
}

void App::State::finishCoat() {
  groom.update(groomInputs());  // it says which types there are
  coat.dropUnlessFor(coatInputs());
  workOnCoat(1e9);
}

void App::State::settleMotion(bool withHair) {
  updateShape(0);
  groom.update(groomInputs());
  motion.settle(motionInputs(0));
  if (withHair) hair->settle(hairInputs(0));
  ++changed;
}

void App::State::advance(float seconds, double coatBudget) {
  sinceSettingChange += seconds;
  idleTime += seconds;
  hand.sincePointed += seconds;
  if (turns() && idleTime > kRestBeforeTurning && seconds > 0) {
    view.camera.turn(OrbitCamera::turned(seconds, OrbitCamera::kTurnSeconds));
    ++changed;
  }
  fly(seconds);
  if (view.camera.update(seconds)) ++changed;
  if (seconds > 0) updateShape(seconds);
  groom.update(groomInputs());
  workOnCoat(coatBudget);
  // Water goes where the model is now; motion feels the water of the last step.
  motion.update(motionInputs(seconds));
  hair->update(hairInputs(seconds));
  workWithHand(seconds);
  water.update(waterInputs(seconds, coatBudget));
  if (hand.keyHold > 0 && (hand.keyHold -= seconds) <= 0) endStroke();
}

std::uint64_t App::State::pictureRevision() const { return revisionButWater() + water.revision() + motion.revision(); }
std::uint64_t App::State::revisionButWater() const { return changed + shape.revision() + groom.revision() + coat.revision() + hair->revision(); }

// --- App's side --------------------------------------------------------------------------------

// Fur that dries changes every few seconds by what nobody sees. A picture that stays is gathered to its end, and stays until that is gathered,
// too, or its grain would come and go. Where water runs and drops fall, and nothing else moves, the picture is a mean that follows them.
bool App::tick(float seconds, float coatBudget) {
  State& s = *state_;
  const bool told = s.pictureRevision() != s.noticed;
  const std::uint64_t others = s.revisionButWater(), water = s.water.revision();
  if (!s.paused) s.advance(std::max(seconds, 0.0f), coatBudget);
  s.bustle = std::max(s.bustle - kSeldom * seconds, 0.0f);
  if (!s.noticeChanges()) return false;
  const bool sways = !s.motion.swaysUnseen(s.motionInputs(0)), byWater = !told && others == s.revisionButWater();
  // Both may change at each of their steps, of which one tick of a slow machine holds many.
  const float steps = std::max(seconds / wet::Water::kStep, 1.0f);
  s.bustle = std::min(s.bustle + std::max(static_cast<float>(s.water.revision() - water), sways ? steps : 0), 2 * kSeldom);
  const bool slight = byWater && s.bustle <= kSeldom;
  if (slight) return s.stale = true, false;
  if (!byWater || sways) return s.forgetSamples(), true;
  if (s.flowsBeside != others) s.bandsDrawn = 0;  // of another picture
  s.flowsBeside = others;
  s.stale = false;
  return true;
}

void App::settle() {
  state_->finishCoat();
  state_->settleMotion();
}

bool App::active() const {
  State& s = *state_;
  return s.pictureRevision() != s.noticed || s.view.camera.moving() || s.hand.flying || s.turns() || s.toolActsWhileStill() || s.behaviour.active(s.behaviourInputs(0)) || s.shape.active(s.shapeInputs(0)) ||
         s.groom.active(s.groomInputs()) || s.coat.active(s.coatInputs()) || s.motion.active(s.motionInputs(0)) || s.hair->active(s.hairInputs(0)) ||
         s.water.active(s.waterInputs(0, 0));
}

void App::setReducedMotion(bool reduced) { state_->reducedMotion = reduced; }
void App::setStanding(bool stands) { state_->paused = stands; }
void App::invalidate() { ++state_->changed; }

void App::finishCoat() { state_->finishCoat(); }

bool advanceFrame(App& app, float seconds, float coatBudget) {
  constexpr float kLongestStep = 0.1f, kLongestFrame = 0.5f, kBudgetShare = 0.25f;
  const float steps = seconds > kLongestFrame ? 1 : std::max(std::ceil(seconds / kLongestStep - 1e-3f), 1.0f);
  const float budget = std::max(coatBudget, kBudgetShare * seconds);
  bool moved = false;
  for (int i = 0; i < static_cast<int>(steps); ++i) moved |= app.tick(seconds / steps, budget / steps);
  return moved;
}

void advanceFilm(App& app, float seconds) {
  constexpr float kStep = 1.0f / 60;
  const int steps = std::max(1, static_cast<int>(std::ceil(seconds / kStep - 1e-3f)));
  for (int i = 0; i < steps; ++i) app.tick(seconds / static_cast<float>(steps));
}

}  // namespace fur::app
