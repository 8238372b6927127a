#include "app/App.h"

#include <algorithm>
#include <cmath>

#include "app/AppState.h"
#include "core/PortableMath.h"
#include "geometry/CoatThickness.h"
#include "geometry/Primitives.h"
#include "scene/StateJson.h"

namespace fur::app {

namespace {

// Changes of one field closer together than this are one undo step, seconds.
constexpr float kMergeTime = 0.8f;
// Seconds without anybody there.
constexpr float kRestBeforeTurning = 3;

// The field in which the two differ, nullptr when it is none or several.
const settings::Field* onlyDifference(const settings::Settings& a, const settings::Settings& b) {
  const settings::Field* only = nullptr;
  for (const settings::Field& field : settings::fields())
    if (field.get(a) != field.get(b)) {
      if (only) return nullptr;
      only = &field;
    }
  return only;
}

}  // namespace

App::App() : state_(std::make_unique<State>()) {
  state_->camera.jump(state_->startView());
  geometry::Mesh square = geometry::makePlane(1);
  auto surface = geometry::buildSurface(square, state_->mapping());
  FUR_ASSERT(surface, "App::App()", "a square", "an error");
  state_->adopt(std::move(square), std::move(*surface), "plane");
}

App::~App() = default;

// --- GL ----------------------------------------------------------------------------------------

Status App::attach() {
  gl::setContextAlive(true);
  gl::rememberPlatformFramebuffer();
  auto renderer = render::Renderer::create();
  if (!renderer) return renderer.error();
  state_->renderer.emplace(std::move(*renderer));
  state_->uploadScene();
  return Done{};
}

void App::detach(bool lost) {
  gl::setContextAlive(!lost);
  state_->renderer.reset();
  gl::setContextAlive(true);
}

void App::resize(int width, int height, float pixelRatio) {
  if (width != state_->width || height != state_->height) state_->governor.forget();
  state_->width = std::max(width, 1);
  state_->height = std::max(height, 1);
  state_->pixelRatio = pixelRatio;
  state_->pictureChanged = true;
}

void App::setSaved(bool saved, bool transparent) {
  state_->camera.ignoreCovered(saved);
  state_->saved = saved;
  state_->transparent = transparent;
  state_->refreshPaint();
  state_->pictureChanged = true;
}

void App::setCovered(Vec2 shares, bool atOnce) {
  state_->camera.setCovered(shares, atOnce);
  if (atOnce) state_->pictureChanged = true;
}

void App::setPadding(const Vec4& shares, bool atOnce) {
  state_->camera.setPadding(shares, atOnce);
  if (atOnce) state_->pictureChanged = true;
}

void App::setAutoRotate(bool enabled) { state_->autoRotate = enabled; }

void App::setFieldOfView(float radians) {
  state_->camera.setFov(radians);
  state_->pictureChanged = true;
}

void App::State::uploadMask(const wet::TexelRect& changed) {
  renderer->updateMask(wet::encodeMask(mask, changed, {wetting->chartOfTexel(), wetting->atlas().triangleOf()}));
}

void App::State::uploadScene() {
  renderer->setSurface(surface, pose ? std::span<const Vec3>(firstTangents) : std::span<const Vec3>());
  renderer->setBaseColor(imageWidth, imageHeight, image);
  uploadMask({0, 0, mask.size(), mask.size()});
  uploadBends();
  uploadGroom({0, 0, groom.map.size(), groom.map.size()});
  uploadPaint({0, 0, groom.map.size(), groom.map.size()});
  uploadShape({0, 0, groom.map.size(), groom.map.size()});
  uploadWhiskers();
  uploadPose();
  uploadCoat();
  pictureChanged = true;
}

// --- model -------------------------------------------------------------------------------------

void App::State::takeSurface(geometry::Surface built) {
  governor.forget();
  surface = std::move(built);
  ++surfaceRevision;
  query = geometry::SurfaceQuery(surface);
  wetting.emplace(surface, mask.size());
  std::vector<Vec3> positions, normals;
  for (const auto& v : surface.vertices) {
    positions.push_back(v.position);
    normals.push_back(v.normal);
  }
  takeRig();
  measure(true);
  bends.reset(positions, normals, firstTangents);
  points.reset();
  groomAtlas.reset();
  readGroomMap();
  groomStale = true;
  vertexWetness.assign(surface.vertices.size(), 0.0f);
  vertexWetnessStale = true;
  shellCountFor = -1;
  if (renderer) uploadScene();
  settleBends();
  pictureChanged = true;
}

void App::State::adopt(geometry::Mesh source, geometry::Surface built, std::string name, scene::Rig moved) {
  mesh = std::move(source);
  rig = std::move(moved);
  modelName = std::move(name);
  mask.clear();
  water.reset();
  strokes.clear();
  waterDue = 0;
  waterSteps = 0;
  cursor = Vec2(0);
  held = {};
  newGroom();
  strokeBefore.reset();  // a stroke on the old model ends here
  drag = Drag::None;
  history.clear();
  motion.reset();
  touch = {};
  refreshTouch();
  idleTime = 0;
  pendingImage = sourceImage = {};
  lostOfFile.clear();
  imageWidth = imageHeight = 0;
  image.clear();
  baseColorFactor = Vec4(1);
  takeSurface(std::move(built));
}

Status App::loadPrimitive(std::string_view name) {
  geometry::Mesh mesh;
  if (name == "sphere") mesh = geometry::makeSphere();
  else if (name == "torus") mesh = geometry::makeTorus();
  else if (name == "plane") mesh = geometry::makePlane();
  else return Error{ErrorId::BadFile, "there is no model called \"" + std::string(name) + '"'};
  // Their own uv are stretched, and they have no picture: charts keep droplets round.
  mesh.uv.clear();
  auto surface = geometry::buildSurface(mesh, state_->mapping());
  if (!surface) return surface.error();
  state_->adopt(std::move(mesh), std::move(*surface), std::string(name));
  state_->restoreOwnLook();
  return Done{};
}

namespace {
scene::FindLosses* findLosses = nullptr;
}
void App::findLossesWith(scene::FindLosses* find) { findLosses = find; }

Status App::loadModel(std::span<const std::uint8_t> bytes, const std::string& name, const scene::FileSet& others,
                      bool keepState) {
  auto model = scene::importModel(bytes, name, others);
  if (!model) return model.error();
  auto surface = geometry::buildSurface(model->mesh, state_->mapping());
  if (!surface) return Error{surface.error().id, name + ": " + surface.error().message};
  for (const std::string& warning : model->warnings) state_->warnings.push_back(warning);
  Warnings lost = findLosses ? findLosses(*model, bytes, others) : Warnings();
  state_->adopt(std::move(model->mesh), std::move(*surface), model->name, std::move(model->rig));
  state_->lostOfFile = std::move(lost);
  state_->pendingImage = std::move(model->baseColor);
  state_->baseColorFactor = model->baseColorFactor;
  state_->takeFur(model->fur);
  state_->settleBends();
  if (keepState) return Done{};
  if (model->fur.state.empty()) {
    state_->restoreOwnLook();
    return Done{};
  }
  if (!state_->ownLook) state_->ownLook = State::Look{state_->settings, camera()};
  // The importer has read it once: it is sound. Undo does not lead behind it.
  const Status status = setState(model->fur.state);
  state_->settingsOfFile = state_->settings;
  state_->history.clear();
  return status;
}

void App::State::restoreOwnLook() {
  const auto own = std::exchange(ownLook, std::nullopt);
  if (!own || settings != settingsOfFile) return;
  applySettings(own->settings);
  camera.jump(own->camera);
}

const scene::EncodedImage& App::pendingImage() const { return state_->pendingImage; }

void App::provideImage(int width, int height, std::vector<std::uint8_t> rgba) {
  FUR_ASSERT(rgba.size() == static_cast<std::size_t>(width) * height * 4, "App::provideImage()",
             "4 bytes for each of width * height texels", rgba.size());
  State& s = *state_;
  s.sourceImage = std::exchange(s.pendingImage, {});
  s.imageWidth = width;
  s.imageHeight = height;
  s.image = std::move(rgba);
  if (s.renderer) s.renderer->setBaseColor(width, height, s.image);
  s.pictureChanged = true;
}

const std::string& App::modelName() const { return state_->modelName; }
const geometry::Surface& App::surface() const { return state_->surface; }
std::uint64_t App::surfaceRevision() const { return state_->surfaceRevision; }

// --- settings and state ------------------------------------------------------------------------

const settings::Settings& App::settings() const { return state_->settings; }

void App::State::applySettings(const settings::Settings& next) {
  const CoatParameters before = coatParameters(settings, furTypes), after = coatParameters(next, furTypes);
  const bool otherCoat = before != after;
  if (before[0] != after[0]) given.reset();
  const bool remapped = settings.furMapping != next.furMapping;
  furChanged |= otherCoat;
  // The picture stays as it is until the other coat has grown.
  if (!otherCoat || !differOnlyInCoat(settings, next)) forcesChanged = pictureChanged = true;
  settings = next;
  ++otherChanges;
  idleTime = 0;
  refreshTouch();
  groomStale |= furTypes > 1;  // heights of the types
  if (!remapped) return;
  // Only fur coordinates change: the atlas stays, and with it what is wet.
  auto built = geometry::buildSurface(mesh, mapping());
  FUR_ASSERT(built, "App::applySettings()", "a mesh that has made a surface before", "an error");
  takeSurface(std::move(*built));
}

void App::setSettings(const settings::Settings& next) {
  State& s = *state_;
  if (next == s.settings) return;
  if (!s.changeBefore) {
    const settings::Field* field = onlyDifference(s.settings, next);
    const bool mergeable = field && field == s.lastField && s.sinceSettingChange < kMergeTime;
    s.history.push(SettingsStep{s.settings, next}, mergeable);
    s.lastField = field;
    s.sinceSettingChange = 0;
  }
  s.applySettings(next);
}

void App::beginChange() {
  endChange();
  state_->changeBefore = state_->settings;
}

void App::endChange() {
  State& s = *state_;
  const auto before = std::exchange(s.changeBefore, std::nullopt);
  if (!before || *before == s.settings) return;
  s.history.push(SettingsStep{*before, s.settings});
  s.lastField = nullptr;
}

bool App::setField(std::string_view name, std::string_view text) {
  settings::Settings next = state_->settings;
  const bool known = settings::setField(next, name, text, state_->warnings);
  setSettings(next);
  return known;
}

CameraOrbit App::camera() const { return state_->camera.goal(); }
void App::setCamera(const CameraOrbit& orbit) { state_->camera.jump(orbit), state_->pictureChanged = true; }
void App::resetCamera() { state_->camera.setGoal(state_->startView()); }

std::string App::state() const {
  const CameraOrbit& c = state_->camera.goal();
  scene::ProgramState out;
  out.model = state_->modelName;
  out.settings = state_->settings;
  out.camera = scene::CameraState{c.yaw, c.pitch, c.distance, c.target};
  return scene::writeState(out);
}

Status App::setState(std::string_view json) {
  auto read = scene::readState(json);
  if (!read) return read.error();
  for (std::string& warning : read->warnings) state_->warnings.push_back(std::move(warning));
  setSettings(read->settings);
  if (read->camera) setCamera({read->camera->yaw, read->camera->pitch, read->camera->distance, read->camera->target});
  return Done{};
}

void App::State::applyStep(const Step& step, bool undo) {
  lastField = nullptr;
  if (const auto* s = std::get_if<SettingsStep>(&step)) {
    applySettings(undo ? s->before : s->after);
  } else if (const auto* m = std::get_if<MaskStep>(&step)) {
    apply(*m, undo, mask);
    if (mask.isDry()) water.clear();  // what hangs and falls came of it
    maskTouched();
  } else if (const auto* g = std::get_if<GroomStep>(&step)) {
    applyGroomStep(*g, undo);
  }
}

// The step itself stays as it is: it belongs to this model, and another is about to take its place.
bool App::State::askForModel(int way) {
  way < 0 ? history.redo() : history.undo();
  modelStep = way;
  return true;
}

bool App::undo() {
  state_->endStroke();
  endChange();
  const Step* step = state_->history.undo();
  if (step && std::holds_alternative<ModelStep>(*step)) return state_->askForModel(-1);
  if (step && std::holds_alternative<MaskStep>(*step)) state_->note(State::kUndo);
  if (step) state_->applyStep(*step, true);
  return step != nullptr;
}

bool App::redo() {
  const Step* step = state_->history.redo();
  if (step && std::holds_alternative<ModelStep>(*step)) return state_->askForModel(1);
  if (step && std::holds_alternative<MaskStep>(*step)) state_->note(State::kRedo);
  if (step) state_->applyStep(*step, false);
  return step != nullptr;
}

bool App::canUndo() const { return state_->history.canUndo(); }
bool App::canRedo() const { return state_->history.canRedo(); }

int App::takeModelStep() { return std::exchange(state_->modelStep, 0); }
void App::followModel() { state_->history.push(ModelStep{}); }

std::vector<std::uint8_t> App::saveHistory(bool leaves) const {
  ByteWriter to;
  state_->history.save(to, leaves);
  return std::move(to.bytes);
}

Status App::restoreHistory(std::span<const std::uint8_t> bytes) {
  state_->lastField = nullptr;
  if (state_->history.restore(bytes)) return Done{};
  return Error{ErrorId::BadFile, "a history of " + std::to_string(bytes.size()) + " bytes is not of this model"};
}

unsigned App::changes() const { return state_->otherChanges + state_->history.revision(); }

Warnings App::takeWarnings() { return std::exchange(state_->warnings, {}); }

void App::addWarning(std::string text) { state_->warnings.push_back(std::move(text)); }

// --- time --------------------------------------------------------------------------------------

dynamics::BendForces App::State::forces() const {
  dynamics::BendForces f;
  f.gravity = Vec3(0, -settings.gravity, 0);
  const float idle = breath();
  f.wind.force = (wind() + idle) * Vec3(portableSin(settings.windYaw), 0.08f, portableCos(settings.windYaw)) + dryerWind();
  f.wind.gust = idle > 0 ? 1 : settings.gust;
  f.wind.turbulence = idle > 0 ? 1 : settings.turbulence;
  f.wind.time = windClock;
  f.stiffness = settings.stiffness;
  f.inertia = settings.inertia;
  f.weight = coat.weight();
  f.furLength = settings.furLength;
  return f;
}

bool App::tick(float dt, float coatBudget) {
  State& s = *state_;
  if (s.stands) return std::exchange(s.pictureChanged, false);
  dt = std::max(dt, 0.0f);
  s.sinceSettingChange += dt;
  s.idleTime += dt;
  s.refreshGroom();
  s.workOnCoat(coatBudget);
  bool changed = std::exchange(s.pictureChanged, false);
  if (s.turns() && s.idleTime > kRestBeforeTurning && dt > 0) {
    s.camera.turn(OrbitCamera::turned(dt, OrbitCamera::kTurnSeconds));
    changed = true;
  }
  changed |= s.camera.update(dt);
  const bool moved = s.motion.update(dt);
  changed |= moved;

  const bool posed = dt > 0 && s.refreshPose(dt);
  if (s.wind() > 0 || s.breath() > 0) s.windClock += dt;
  if (dt > 0 && (moved || posed || s.gusty() || s.forcesChanged || s.touch.moving() || s.holds(Tool::Dryer) || !s.bends.atRest())) {
    s.touch.update(dt);
    s.bends.showForces(s.showsForces());
    s.bends.step(dt, s.motion.worldFromModel(), s.forces(), s.wetnessOfVertices(), s.touch.contacts());
    s.uploadBends();
    s.forcesChanged = false;
    changed = true;
  }

  changed |= s.runWater(dt, coatBudget);
  return changed || std::exchange(s.pictureChanged, false);
}

void App::State::settleBends() {
  refreshPose(0);
  refreshGroom();
  bends.showForces(showsForces());
  bends.settle(motion.worldFromModel(), forces(), wetnessOfVertices());
  uploadBends();
  forcesChanged = false;
  pictureChanged = true;
}

void App::State::uploadBends() {
  if (renderer) renderer->updateBends(bends.forces().empty() ? bends.bends() : bends.forces());
}

void App::settle() {
  state_->finishCoat();
  state_->settleBends();
}

bool App::active() const {
  State& s = *state_;
  return s.pictureChanged || s.furChanged || s.coatWork || s.forcesChanged || s.camera.moving() || s.motion.moving() ||
         !s.bends.atRest() || s.touch.moving() || s.gusty() || s.animates() || s.turns() || s.atWork() ||
         s.water.active(s.mask, s.climate());
}

void App::setReducedMotion(bool reduced) {
  state_->reducedMotion = reduced;
  state_->forcesChanged = true;
}

void App::invalidate() { state_->pictureChanged = true; }

// Each further shell costs 0.4 of a frame; by pictures a coat has visible holes without them from kCrowded on: on a torus with
// fur of 0.3, 0.2 % of all pixels show skin in the hole of the ring instead of fur.
void App::State::chooseShellCount() {
  constexpr float kCrowded = 0.024f;
  constexpr int kCrowdedShells = 3;
  if (std::exchange(shellCountFor, settings.furLength) == settings.furLength) return;
  shellCount = settings.furLength * geometry::grazingShare(surface, query, settings.furLength) > kCrowded ? kCrowdedShells : 1;
}

render::Frame App::State::frame(int level) const {
  const QualityLevel& quality = qualityLevels()[static_cast<std::size_t>(level)];
  render::Frame f;
  f.settings = settings;
  f.settings.fins &= quality.fins;
  f.settings.shadows = std::min(f.settings.shadows, quality.shadows);
  f.pixelScale = quality.pixelScale;
  f.stepLength = quality.stepLength;
  f.shellCount = shellCount;
  f.worldFromModel = motion.worldFromModel();
  f.camera = camera.pose(static_cast<float>(width) / static_cast<float>(height));
  f.width = width;
  f.height = height;
  f.transparent = transparent;
  f.bottomRow = bottomRow;
  f.groundHeight = groundHeight;
  f.reach = glm::length(extent.centre) + extent.radius;
  f.wet = !mask.isDry();
  f.groomed = groomed;
  f.painted = painted;
  f.shaped = shaped;
  f.types = shownTypes > 1;
  if (const auto ball = touch.ball()) f.ball = Vec4(ball->centre, ball->radius);
  f.baseColorFactor = baseColorFactor;
  f.drops = water.drops();
  f.puddles = {puddles, puddlesRevision};
  return f;
}

render::Frame App::frame() const { return state_->frame(); }
const furgen::Coat* App::grownCoat() const { return state_->coat.grown(); }
std::span<const Vec4> App::bends() const { return state_->bends.bends(); }

Status App::draw(Picture picture) {
  State& s = *state_;
  s.drawnLevel = s.levelFor(picture);
  return s.drawBand(s.drawnLevel, 0, 1);
}

Status App::State::drawBand(int level, int band, int bands) {
  FUR_ASSERT(renderer.has_value(), "App::draw()", "an attached context", "none");
  refreshGroom();
  if (!coatUploaded) finishCoat();
  chooseShellCount();
  for (const wet::TexelRect& part : mask.takeChangedParts()) uploadMask(part);
  readPuddles();
  render::Frame f = frame(level);
  f.band = band;
  f.bands = bands;
  const Status status = renderer->draw(f);
  uploadedBytes = renderer->takeUploadedBytes();
  pictureChanged = false;
  const bool shown = band + 1 == bands;
  bandsDrawn = shown ? 0 : band + 1;
  framesDrawn += shown;
  return status;
}

App::Stats App::stats() const {
  const State& s = *state_;
  Stats out{};
  out.vertices = static_cast<int>(s.surface.trueVertexCount);
  out.triangles = static_cast<int>(s.mesh.triangleCount());
  out.strands = s.coat.strandCount();
  out.layers = s.settings.layers;
  out.finEdges = static_cast<int>(s.surface.edges.size());
  out.cpuBytes = s.surface.vertices.size() * (sizeof(geometry::SurfaceVertex) + 5 * sizeof(Vec4)) +
                 s.surface.indices.size() * sizeof(std::uint32_t) * 4 +
                 s.surface.edges.size() * sizeof(geometry::SurfaceEdge) + s.mask.texels().size() * sizeof(Vec4) +
                 s.groom.map.texels().size() * sizeof(groom::GroomMap::Texel) * std::size(groom::kMaps) +
                 s.image.size();
  out.gpuBytes = s.renderer ? s.renderer->gpuBytes() : 0;
  out.uploadedBytes = s.uploadedBytes;
  out.framesDrawn = s.framesDrawn;
  out.level = s.drawnLevel;
  out.pixels = s.renderer ? s.renderer->drawnPixels() : 0;
  out.frameTime = s.governor.frameTime();
  return out;
}

}  // namespace fur::app
