#include "app/App.h"

#include <algorithm>
#include <utility>

#include "app/AppState.h"
#include "core/Clock.h"
#include "core/NumberText.h"
#include "geometry/Primitives.h"
#include "geometry/SurfaceBytes.h"
#include "scene/StateJson.h"

namespace fur::app {

namespace {

// Changes of one field closer together than this are one undo step, seconds.
constexpr float kMergeTime = 0.8f;
// So near two views are the same: to what a state in text keeps of them. Model units.
constexpr float kSameView = 1e-3f;

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

std::shared_ptr<ModelShelf> makeModelShelf() { return std::make_shared<ModelShelf>(); }

App::App(std::shared_ptr<ModelShelf> models) : state_(std::make_unique<State>()) {
  state_->models = models ? std::move(models) : makeModelShelf();
  state_->water.setHair(*state_->hair);
  state_->water.setGroom(state_->groom);
  state_->view.camera.jump(state_->startView());
  geometry::Mesh square = geometry::makePlane(1);
  auto surface = state_->models->surfaceOf(square, state_->mapping());
  FUR_ASSERT(surface, "App::App()", "a square", "an error");
  state_->setModel(std::move(square), std::move(*surface), {.name = "plane"});
}

App::~App() = default;

// --- model -------------------------------------------------------------------------------------

// The file's looks higher, and at last from further off, while an animal does what would reach out of it.
CameraOrbit App::State::homeView() const {
  if (!cameraOfFile || behaviour.played().size() < 2) return cameraOfFile.value_or(startView());
  constexpr float kSeen = 0.27f;  // above its target and below, of its distance: some less than OrbitCamera::kFovY shows
  CameraOrbit home = *cameraOfFile;
  const float reach = kSeen * home.distance, need = 0.5f * (shape.top() - shape.groundHeight());
  if (shape.top() <= home.target.y + reach) return home;
  home.target.y = std::max(shape.top() - reach, home.target.y);
  if (need <= reach) return home;
  home.target.y = shape.groundHeight() + need;
  home.distance *= need / reach;
  return home;
}

void App::State::keepInView(const CameraOrbit& before, bool atOnce) {
  const CameraOrbit now = homeView();
  if (now.distance == before.distance && now.target == before.target) return;
  CameraOrbit goal = view.camera.goal();
  if (std::abs(goal.distance - before.distance) > kSameView || glm::distance(goal.target, before.target) > kSameView) return;
  goal.distance = now.distance;
  goal.target = now.target;
  if (atOnce) view.camera.jump(goal);
  else view.camera.setGoal(goal);
}

// After the shape has another surface: the other stages follow it at once.
void App::State::surfaceChanged(const CameraOrbit& viewBefore) {
  governor.forget();
  behaviour.update(behaviourInputs(0));
  shape.update(shapeInputs(0));
  keepInView(viewBefore, true);
  settleMotion();
}

std::vector<std::uint8_t> App::saveSurface() const { return geometry::surfaceBytes(state_->shape.surface()); }

void App::giveSurface(std::span<const std::uint8_t> bytes) {
  state_->givenSurface.assign(bytes.begin(), bytes.end());
  state_->readSurface = geometry::surfaceFromBytes;
}

void App::State::begin(scene::Model model, Document document) {
  expect(model.fur, document.materials);
  coming = Coming{std::move(model), std::move(document), mapping()};
  const std::vector<std::uint8_t> given = std::exchange(givenSurface, {});
  if (!given.empty())
    if (auto surface = readSurface(given, coming->model.mesh)) coming->given = ShownSurface(std::move(*surface));
  if (!coming->given) coming->surface.emplace(*models, coming->model.mesh, coming->mapping);
}

bool App::State::workOnComing(double budget) {
  FUR_ASSERT(coming, "App::workOnComing()", "a model that was begun", "none");
  coming->done |= !coming->surface;
  for (const double begun = secondsNow(); !coming->done;) {
    coming->done = coming->surface->step();
    if (secondsNow() - begun > budget) break;
  }
  return coming->done;
}

Result<ShownSurface> App::State::surfaceOfComing() {
  // Settings may have changed since it was begun.
  if (coming->mapping != mapping()) return models->surfaceOf(coming->model.mesh, mapping());
  workOnComing(1e9);
  return coming->given ? std::move(*coming->given) : coming->surface->take();
}

bool App::workOnComing(float seconds) { return state_->workOnComing(seconds); }

void App::State::setModel(geometry::Mesh mesh, ShownSurface surface, Document from, scene::Rig rig, std::vector<std::uint8_t> materialOf) {
  const CameraOrbit before = homeView();
  endStroke();
  document = std::move(from);
  cameraOfFile.reset();
  ++imageRevision, ++materialsRevision;
  std::vector<std::uint8_t> bare;
  for (const scene::Material& material : document.materials)
    if (!materialOf.empty()) bare.push_back(material.bare);
  groom.reset(std::move(bare));
  water.reset();
  motion.reset();
  hair->reset();
  history.clear();
  hand.cursor = Vec2(0);
  hand.drag = Drag::None;
  idleTime = 0;
  shape.setModel(std::move(mesh), std::move(surface), std::move(rig), std::move(materialOf));
  refreshTouch();
  surfaceChanged(before);
}

Status App::beginPrimitive(std::string_view name) {
  scene::Model model;
  geometry::Mesh& mesh = model.mesh;
  if (name == "sphere") mesh = geometry::makeSphere();
  else if (name == "torus") mesh = geometry::makeTorus();
  else if (name == "plane") mesh = geometry::makePlane();
  else return Error{ErrorId::BadFile, "there is no model called \"" + std::string(name) + '"'};
  // Their own uv are stretched, and they have no picture: charts keep droplets round.
  mesh.uv.clear();
  model.name = name;
  state_->begin(std::move(model), {.name = std::string(name)});
  return Done{};
}

Status App::loadPrimitive(std::string_view name) {
  if (Status status = beginPrimitive(name); !status) return status;
  return showComing();
}

Status App::beginModel(std::span<const std::uint8_t> bytes, const std::string& name, const scene::FileSet& others) {
  auto model = scene::importModel(bytes, name, others);
  if (!model) return model.error();
  Document from{.name = model->name};
  from.take(*model);
  if (model->isGltf) state_->keepFile(from, bytes, others);
  state_->begin(std::move(*model), std::move(from));
  return Done{};
}

Status App::loadModel(std::span<const std::uint8_t> bytes, const std::string& name, const scene::FileSet& others,
                      bool keepState) {
  if (Status status = beginModel(bytes, name, others); !status) return status;
  return showComing(keepState);
}

Status App::showComing(bool keepState) {
  State& s = *state_;
  FUR_ASSERT(s.coming, "App::showComing()", "a model that was begun", "none");
  auto surface = s.surfaceOfComing();
  auto coming = std::exchange(s.coming, std::nullopt);
  scene::Model* model = &coming->model;
  const std::string& name = model->name;
  if (!surface) return Error{surface.error().id, name + ": " + surface.error().message};
  auto files = s.shelf.addFiles(model->fur.coats, name);
  if (!files) return files.error();
  for (const std::string& warning : model->warnings) s.warnings.push_back(warning);
  Document& from = coming->document;
  s.setModel(std::move(model->mesh), std::move(*surface), std::move(from), std::move(model->rig), std::move(model->materialOf));
  if (!model->fur.wetness.empty()) s.water.readMask(model->fur.wetness, model->fur.wetnessSize);
  s.groom.read(s.shape, model->fur, s.warnings);
  if (!model->fur.hair.empty()) s.hair->setStyle(std::move(model->fur.hair));
  // Hair grows when it is to be seen: it takes long.
  s.settleMotion(false);
  // Of a mask as this program has them; else what `wetness` says of it remains.
  if (!model->fur.water.empty() && !s.water.restore(model->fur.water)) addWarning(name + ": its drops and running water are left out");
  if (keepState) return Done{};
  if (model->fur.state.empty()) {
    s.restoreOwnLook();
    s.takeFurLength(model->furLength);
    return Done{};
  }
  if (!s.ownLook) s.ownLook = State::Look{s.settings, camera()};
  // The importer has read it once: it is sound. Undo does not lead behind it.
  const Status status = setState(model->fur.state);
  settings::Settings now = s.settings;
  now.typePictures = files->pictures;
  now.typeSets = files->typeSets;
  s.applySettings(now);
  s.shelf.keepOnlyThoseOf({&s.settings, &s.ownLook->settings});
  s.settingsOfFile = s.settings;
  s.cameraOfFile = camera();
  s.history.clear();
  return status;
}

// Of a model that says nothing else of the coat.
void App::State::takeFurLength(float length) {
  if (length <= 0) return;
  ownLook = Look{settings, view.camera.goal()};
  settings::Settings next = settings;
  settings::setField(next, *settings::findField("furLength"), length, warnings);
  applySettings(next);
  settingsOfFile = settings;
}

void App::settingsCameWithModel() { state_->settingsOfFile = state_->settings; }

// Of the model before one that brought its own, unless a person has changed that since.
void App::State::restoreOwnLook() {
  const auto own = std::exchange(ownLook, std::nullopt);
  if (!own || settings != settingsOfFile) return;
  applySettings(own->settings);
  view.camera.jump(own->camera);
}

void Document::take(scene::Model& model) {
  if (!model.materials.empty()) materials = std::move(model.materials);
  main = static_cast<std::size_t>(std::max(model.mainMaterial, 0));
  for (scene::EncodedImage& image : model.images) pictures.push_back({.encoded = std::move(image), .asked = false});
}

const Document::Picture* Document::pictureOf(std::size_t material) const {
  const int image = materials[material].baseColorTexture.image;
  return image < 0 || !pictures[static_cast<std::size_t>(image)].rgba ? nullptr : &pictures[static_cast<std::size_t>(image)];
}

Document::Picture* Document::pending() {
  const auto at = std::find_if(pictures.begin(), pictures.end(), [](const Picture& picture) { return !picture.asked; });
  return at == pictures.end() ? nullptr : &*at;
}

const scene::EncodedImage& App::pendingImage() const {
  static const scene::EncodedImage none;
  const Document::Picture* picture = state_->document.pending();
  return picture ? picture->encoded : none;
}

void App::provideImage(int width, int height, std::vector<std::uint8_t> rgba) {
  FUR_ASSERT(rgba.size() == static_cast<std::size_t>(width) * height * 4, "App::provideImage()",
             "4 bytes for each of width * height texels", rgba.size());
  Document& document = state_->document;
  Document::Picture* picture = document.pending();
  if (!picture) {
    // Of a model without one: all of it has it.
    picture = &document.pictures.emplace_back();
    for (scene::Material& material : document.materials) material.baseColorTexture = {.image = static_cast<int>(document.pictures.size()) - 1};
    ++state_->materialsRevision;
  }
  picture->asked = true;
  picture->width = width;
  picture->height = height;
  picture->rgba = state_->models->pixels(std::move(rgba));
  ++state_->imageRevision;
  ++state_->changed;
}

const std::string& App::modelName() const { return state_->document.name; }
const geometry::Surface& App::surface() const { return state_->shape.surface(); }
std::uint64_t App::surfaceRevision() const { return state_->shape.surfaceRevision(); }

std::string App::animations() const {
  std::string lines;
  for (const scene::Rig::Animation& animation : state_->shape.rig().animations) lines += animation.name + '\n';
  return lines;
}

std::string App::actions() const { return state_->behaviour.actions(); }
std::string App::action() const { return state_->behaviour.behaves() ? traitsOf(state_->behaviour.action()).name : ""; }

bool App::act(std::string_view name) {
  state_->idleTime = 0;
  return state_->behaviour.act(name);
}

// --- settings and state ------------------------------------------------------------------------

const settings::Settings& App::settings() const { return state_->settings; }

void App::State::applySettings(const settings::Settings& next) {
  // The picture stays as it is until the other coat has grown.
  const bool otherCoat = coatParameters(settings, groom.types()) != coatParameters(next, groom.types());
  if (!otherCoat || !differOnlyInCoat(settings, next)) ++changed;
  const bool remapped = settings.furMapping != next.furMapping;
  settings = next;
  view.camera.setMode(static_cast<CameraMode>(settings.cameraMode));
  ++otherChanges;
  idleTime = 0;
  refreshTouch();
  if (!remapped) return;
  // Only fur coordinates change: the atlas stays, and with it what is wet.
  auto built = models->surfaceOf(shape.mesh(), mapping());
  FUR_ASSERT(built, "App::applySettings()", "a mesh that has made a surface before", "an error");
  const CameraOrbit before = homeView();
  shape.setSurface(std::move(*built));
  surfaceChanged(before);
}

// A coat from a file goes when its type is asked to grow another.
settings::Settings App::State::withoutOldFiles(settings::Settings next) const {
  for (std::size_t type = 0; type < settings::kFurTypes; ++type)
    if (next.typeSets[type] == settings.typeSets[type] && coatParametersOf(next, static_cast<int>(type)) != coatParametersOf(settings, static_cast<int>(type)))
      next.typeSets[type] = 0;
  return next;
}

void App::setSettings(const settings::Settings& wanted) {
  State& s = *state_;
  const settings::Settings next = s.withoutOldFiles(wanted);
  if (next == s.settings) return;
  if (!s.changeBefore) {
    const settings::Field* field = onlyDifference(s.settings, next);
    const bool mergeable = field && field == s.lastField && s.sinceSettingChange < kMergeTime;
    s.history.push(SettingsStep{std::make_unique<SettingsStep::Both>(SettingsStep::Both{s.settings, next})}, mergeable);
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
  if (s.changeBefore) s.endStroke();
  const auto before = std::exchange(s.changeBefore, std::nullopt);
  if (!before || *before == s.settings) return;
  s.history.push(SettingsStep{std::make_unique<SettingsStep::Both>(SettingsStep::Both{*before, s.settings})});
  s.lastField = nullptr;
}

bool App::setField(std::string_view name, std::string_view text) {
  settings::Settings next = state_->settings;
  const bool known = settings::setField(next, name, text, state_->warnings);
  setSettings(next);
  return known;
}

CameraOrbit App::camera() const { return state_->view.camera.goal(); }
void App::setCamera(const CameraOrbit& orbit) { state_->view.camera.jump(orbit), ++state_->changed; }
void App::resetCamera() { state_->view.camera.setGoal(state_->homeView()); }

std::string App::state() const {
  const CameraOrbit& c = state_->view.camera.goal();
  scene::ProgramState out;
  out.model = state_->document.name;
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
    applySettings(undo ? s->both->before : s->both->after);
  } else if (const auto* m = std::get_if<MaskStep>(&step)) {
    water.apply(*m, undo);
  } else if (const auto* g = std::get_if<GroomStep>(&step)) {
    groom.apply(shape, *g, undo);
    if (undo) water.putBack(g->dried);
  } else if (const auto* h = std::get_if<HairStep>(&step)) {
    hair->apply(*h, undo);
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
  if (step && std::holds_alternative<MaskStep>(*step)) state_->note(Command::Undo);
  if (step) state_->applyStep(*step, true);
  return step != nullptr;
}

bool App::redo() {
  const Step* step = state_->history.redo();
  if (step && std::holds_alternative<ModelStep>(*step)) return state_->askForModel(1);
  if (step && std::holds_alternative<MaskStep>(*step)) state_->note(Command::Redo);
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
  return Error{ErrorId::BadFile, "a history of " + decimal(bytes.size()) + " bytes is not of this model"};
}

unsigned App::changes() const { return state_->otherChanges + state_->history.revision(); }

Warnings App::takeWarnings() { return std::exchange(state_->warnings, {}); }

void App::addWarning(std::string text) { state_->warnings.push_back(std::move(text)); }

}  // namespace fur::app
