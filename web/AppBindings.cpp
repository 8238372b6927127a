// app/App.h as plain C functions. A handle is an app::App*; a module instance may hold several.
// GL calls go to the context that JavaScript made current just before.
#include <utility>
#include <vector>

#include "Boundary.h"
#include "app/App.h"
#include "scene/FurData.h"
#include "settings/Presets.h"

using namespace fur;
using app::App;
using web::guarded;

// --- what crosses as it is ---

// What the results of the table are in C, and how they are made of what App gives.
namespace crossing {
using Nothing = void;
using Done = int;
using Truth = int;
using Number = double;
using Text = const char*;
using Lines = const char*;
using Hash = const char*;
}  // namespace crossing
#define FUR_RESULT_Nothing(call) call
#define FUR_RESULT_Done(call) guarded([&] { return web::report(call); })
#define FUR_RESULT_Truth(call) int(call)
#define FUR_RESULT_Number(call) double(call)
#define FUR_RESULT_Text(call) web::text(std::string(call))
#define FUR_RESULT_Lines(call) FUR_RESULT_Text(call)
#define FUR_RESULT_Hash(call) web::hexadecimal(call)

#define FUR_WITH_APP(...) (App * app __VA_OPT__(, ) __VA_ARGS__)
#define FUR_METHOD(name, result, parameters, arguments, ...) \
  FUR_EXPORT crossing::result fur_##name FUR_WITH_APP parameters { return FUR_RESULT_##result(app->name arguments); }
#define FUR_QUERY(name, result, ...) FUR_METHOD(name, result, (), ())
#include "web/Methods.inc"
#undef FUR_METHOD
#undef FUR_QUERY

// --- life ---

FUR_EXPORT App* fur_create() {
  static const auto models = app::makeModelShelf();
  return guarded([] { return new App(models); });
}
FUR_EXPORT void fur_destroy(App* app) { delete app; }
// Of the context that JavaScript has just made current. Apps that are attached with it outlive it: what they share is theirs, too.
FUR_EXPORT app::Context* fur_createContext(int linksTold) { return new app::Context(linksTold != 0); }
FUR_EXPORT void fur_useContext(const app::Context* context) { context->use(); }
FUR_EXPORT void fur_destroyContext(app::Context* context) { delete context; }
FUR_EXPORT int fur_attach(App* app, const app::Context* context) {
  return guarded([&] { return web::report(app->attach(context)); });
}
FUR_EXPORT void fur_detach(App* app, int lost) { app->detach(lost != 0); }

// --- model ---

FUR_EXPORT int fur_loadModel(App* app, const std::uint8_t* bytes, std::uint32_t size, const char* name,
                             int keepState) {
  return guarded([&] { return web::report(app->loadModel({bytes, size}, name, web::takeStagedFiles(), keepState != 0)); });
}
FUR_EXPORT int fur_beginModel(App* app, const std::uint8_t* bytes, std::uint32_t size, const char* name) {
  return guarded([&] { return web::report(app->beginModel({bytes, size}, name, web::takeStagedFiles())); });
}
// 1: all is done, 2: not yet, 3: it waits for the driver, 0: an error.
FUR_EXPORT int fur_workOnComing(App* app, float seconds) {
  return guarded([&] { return 2 - app->workOnComing(seconds); });
}
FUR_EXPORT int fur_workOnPicture(App* app, float seconds, int coarse) {
  return guarded([&] { return 1 + static_cast<int>(app->workOnPicture(seconds, coarse != 0)); });
}
// As fur_saveGroom() gives its bytes.
FUR_EXPORT std::uint32_t fur_saveSurface(App* app) {
  return guarded([&] { return web::keepSaved(app->saveSurface()); });
}
FUR_EXPORT int fur_loadTypeSet(App* app, const std::uint8_t* bytes, std::uint32_t size, const char* name, int type) {
  return guarded([&] { return web::report(app->loadTypeSet({bytes, size}, name, type)); });
}
// As fur_saveGroom() gives its bytes.
FUR_EXPORT std::uint32_t fur_saveTypeFiles(App* app) {
  return guarded([&] { return web::keepSaved(app->saveTypeFiles()); });
}
FUR_EXPORT int fur_restoreTypeFiles(App* app, const std::uint8_t* bytes, std::uint32_t size) {
  return guarded([&] { return web::report(app->restoreTypeFiles({bytes, size})); });
}
FUR_EXPORT int fur_setTypePicture(App* app, int type, const std::uint8_t* bytes, std::uint32_t size, int width, int height, const std::uint8_t* rgba) {
  return guarded([&] {
    return web::report(app->setTypePicture(type, {bytes, bytes + size}, width, height, {rgba, rgba + std::size_t(width) * std::size_t(height) * 4}));
  });
}
// too-large: it is a picture with more pixels than are read. What it is else is for the browser to say.
FUR_EXPORT int fur_checkPicture(const std::uint8_t* bytes, std::uint32_t size, const char* name) {
  return guarded([&] {
    const auto image = scene::encodedImage({bytes, bytes + size}, name);
    return image || image.error().id != ErrorId::TooLarge ? 1 : web::report(image.error());
  });
}
// The number of a colour map that is to be decoded, 0 for none; the bytes of its file as fur_saveGroom() gives them.
FUR_EXPORT std::uint32_t fur_pendingPicture(App* app, int index) {
  const auto pending = app->pendingPictures();
  return index < int(pending.size()) ? pending[std::size_t(index)] : 0;
}
FUR_EXPORT std::uint32_t fur_typePicture(App* app, std::uint32_t number) {
  return guarded([&] { return web::keepSaved(app->typePicture(number).bytes); });
}
FUR_EXPORT int fur_provideTypePicture(App* app, std::uint32_t number, int width, int height, const std::uint8_t* rgba) {
  return guarded([&] {
    app->provideTypePicture(number, width, height, {rgba, rgba + std::size_t(width) * std::size_t(height) * 4});
    return 1;
  });
}
// The number of the bytes that this makes; they lie at fur_savedBytes() until they are forgotten.
FUR_EXPORT std::uint32_t fur_saveGroom(App* app) {
  return guarded([&] { return web::keepSaved(app->saveGroom()); });
}
FUR_EXPORT const std::uint8_t* fur_savedBytes() { return web::savedBytes().data(); }
FUR_EXPORT void fur_forgetSavedBytes() { web::keepSaved({}); }
// The next image to be decoded: type "" when there is none.
FUR_EXPORT const char* fur_imageType(App* app) { return web::text(app->pendingImage().mimeType); }
FUR_EXPORT const std::uint8_t* fur_imageBytes(App* app) { return app->pendingImage().bytes.data(); }
FUR_EXPORT const double* fur_imageInfo(App* app) {
  const scene::EncodedImage& image = app->pendingImage();
  return web::numbers({double(image.bytes.size()), double(image.width), double(image.height)});
}
FUR_EXPORT int fur_provideImage(App* app, int width, int height, const std::uint8_t* rgba) {
  return guarded([&] {
    app->provideImage(width, height, {rgba, rgba + std::size_t(width) * std::size_t(height) * 4});
    return 1;
  });
}

// --- settings, state ---

// Text of a field; "" for an unknown name.
FUR_EXPORT const char* fur_getSetting(App* app, const char* name) {
  return web::text(settings::settingText(app->settings(), name));
}
FUR_EXPORT int fur_setSetting(App* app, const char* name, const char* value) {
  return guarded([&] { return app->setField(name, value) ? 1 : 0; });
}
FUR_EXPORT const char* fur_presetTable() { return web::text(settings::presetTableJson()); }
// The preset whose coat it is now; "" when it is none's.
FUR_EXPORT const char* fur_getPreset(App* app) {
  const settings::Preset* preset = settings::presetOf(app->settings());
  return web::text(preset ? preset->name : "");
}
// Warns of a name that is none.
FUR_EXPORT int fur_applyPreset(App* app, const char* name, int type) {
  return guarded([&] {
    return app->applyPreset(name, type) ? 1 : 0;
  });
}
// yaw, pitch (radians), distance, target x, y, z
FUR_EXPORT const double* fur_getCamera(App* app) {
  const app::CameraOrbit c = app->camera();
  return web::numbers({c.yaw, c.pitch, c.distance, c.target.x, c.target.y, c.target.z});
}
FUR_EXPORT void fur_setCamera(App* app, float yaw, float pitch, float distance, float x, float y, float z) {
  app->setCamera({yaw, pitch, distance, {x, y, z}});
}
FUR_EXPORT const char* fur_getState(App* app) {
  return guarded([&] { return web::text(app->state()); });
}
FUR_EXPORT int fur_setState(App* app, const char* json) {
  return guarded([&] { return web::report(app->setState(json)); });
}
FUR_EXPORT std::uint32_t fur_saveHistory(App* app, int leaves) {
  return guarded([&] { return web::keepSaved(app->saveHistory(leaves != 0)); });
}
FUR_EXPORT int fur_restoreHistory(App* app, const std::uint8_t* bytes, std::uint32_t size) {
  return guarded([&] { return web::report(app->restoreHistory({bytes, size})); });
}
// One warning a line.
FUR_EXPORT const char* fur_takeWarnings(App* app) {
  std::string lines;
  for (std::string& warning : app->takeWarnings()) {
    for (char& c : warning)
      if (c == '\n') c = ' ';
    lines += warning + '\n';
  }
  return web::text(lines);
}

// --- water ---

// A name that is none changes nothing.
FUR_EXPORT void fur_setTool(App* app, const char* name) {
  if (const auto tool = app::toolNamed(name)) app->setTool(*tool);
}
FUR_EXPORT const char* fur_getTool(App* app) { return web::text(std::string(app::nameOf(app->tool()))); }
FUR_EXPORT void fur_stamp(App* app, const std::uint8_t* coverage, int width, int height, float x, float y, float across, float amount) {
  app->stamp({coverage, std::size_t(width) * std::size_t(height)}, width, height, {x, y}, across, amount);
}
// held, film, drops, hair, dripped, evaporated, removed, painted, rained
FUR_EXPORT const double* fur_waterAccounts(App* app) {
  const wet::Accounts a = app->water().accounts();
  return web::numbers({a.held, a.film, a.drops, a.hair, a.dripped, a.evaporated, a.removed, a.painted, a.rained});
}
FUR_EXPORT std::uint32_t fur_saveWater(App* app) {
  return guarded([&] { return web::keepSaved(app->saveWater()); });
}
FUR_EXPORT int fur_restoreWater(App* app, const std::uint8_t* bytes, std::uint32_t size) {
  return guarded([&] { return web::report(app->restoreWater({bytes, size})); });
}
// --- groom ---

FUR_EXPORT std::uint32_t fur_saveHair(App* app) {
  return guarded([&] { return web::keepSaved(app->saveHair()); });
}
FUR_EXPORT int fur_restoreHair(App* app, const std::uint8_t* bytes, std::uint32_t size, int undoable) {
  return guarded([&] { return web::report(app->restoreHair({bytes, size}, undoable != 0)); });
}
FUR_EXPORT int fur_restoreGroom(App* app, const std::uint8_t* bytes, std::uint32_t size, int undoable) {
  return guarded([&] { return web::report(app->restoreGroom({bytes, size}, undoable != 0)); });
}

// (u, v), or null off the model
FUR_EXPORT const double* fur_pick(App* app, float x, float y) {
  const std::optional<Vec2> hit = app->pick({x, y});
  return hit ? web::numbers({hit->x, hit->y}) : nullptr;
}

// App::kRingCorners points (x, y), or null
FUR_EXPORT const float* fur_brushRing(App* app, float x, float y) {
  static std::vector<Vec2> ring;
  ring = app->brushRing({x, y});
  return ring.empty() ? nullptr : &ring[0].x;
}
FUR_EXPORT const double* fur_cursor(App* app) { return web::numbers({app->cursor().x, app->cursor().y}); }

// --- input (modifiers: bit 0 shift, 1 control, 2 alt) ---

// phase 0 down, 1 move, 2 up, 3 cancel; kind 0 mouse, 1 touch, 2 pen
FUR_EXPORT int fur_pointer(App* app, int phase, int kind, int id, float x, float y, int buttons, int modifiers, float pressure) {
  app::PointerEvent event{static_cast<app::PointerPhase>(phase)};
  event.kind = static_cast<app::PointerKind>(kind);
  event.id = id;
  event.position = {x, y};
  event.buttons = buttons;
  event.shift = modifiers & 1;
  event.control = modifiers & 2;
  event.alt = modifiers & 4;
  event.pressure = pressure;
  return guarded([&] { return app->pointer(event) ? 1 : 0; });
}
FUR_EXPORT int fur_key(App* app, const char* name, int modifiers) {
  app::KeyEvent event{name};
  event.shift = modifiers & 1;
  event.control = modifiers & 2;
  event.alt = modifiers & 4;
  event.down = !(modifiers & 8);
  return guarded([&] { return app->key(event) ? 1 : 0; });
}
// Shares of the picture, from its left, top, right and bottom edge.
FUR_EXPORT void fur_setPadding(App* app, float left, float top, float right, float bottom, int atOnce) {
  app->setPadding({left, top, right, bottom}, atOnce != 0);
}
// 0: as it is seen; 1: for a picture that is saved; 3: without what is behind the model
FUR_EXPORT void fur_setSaved(App* app, int how) { app->setSaved(how, how & 2); }

// --- time ---

FUR_EXPORT int fur_tick(App* app, float seconds, float coatBudget) {
  return guarded([&] { return app::advanceFrame(*app, seconds, coatBudget) ? 1 : 0; });
}
// 0 best, 1 moving, 2 still, as app::Picture
FUR_EXPORT int fur_draw(App* app, int picture, int samples) {
  return guarded([&] { return web::report(app->draw(static_cast<app::Picture>(picture), samples)); });
}
FUR_EXPORT void fur_setQuality(App* app, int best, int governed) { app->setQuality(best, governed != 0); }
// 1: the framebuffer has another picture; 2: not yet.
FUR_EXPORT int fur_improve(App* app) {
  return guarded([&] {
    const Result<bool> shown = app->improve();
    return shown ? 2 - shown.value() : web::report(shown.error());
  });
}
// 1: the framebuffer has the picture; 2: it is to be drawn.
FUR_EXPORT int fur_showAgain(App* app) {
  return guarded([&] {
    const Result<bool> shown = app->showAgain();
    return shown ? 2 - shown.value() : web::report(shown.error());
  });
}
// vertices, triangles, strands, layers, finEdges, cpuBytes, gpuBytes, uploadedBytes, framesDrawn, level, pixels,
// frameTime
FUR_EXPORT const double* fur_stats(App* app) {
  const App::Stats s = app->stats();
  return web::numbers({double(s.vertices), double(s.triangles), double(s.strands), double(s.layers),
                       double(s.finEdges), double(s.cpuBytes), double(s.gpuBytes), double(s.uploadedBytes),
                       double(s.framesDrawn), double(s.level), double(s.pixels), double(s.frameTime)});
}
