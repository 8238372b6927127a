// The editor's panel over an App, as plain C functions; in the program wet-fur-editor only. `app` is
// the handle of fur_create(). The page drives it like this:
//
//   event:  if (!fur_editor_pointer(...)) fur_pointer(...)          likewise wheel and key
//   frame:  changed = fur_tick(app, dt); changed |= fur_editor_update(app, dt);
//           if (changed) { fur_draw(app); fur_editor_draw(app); }
//           then fur_editor_command() until it gives ""
//   sleep:  when neither fur_active(app) nor fur_editor_active(app)
//
// After context loss: fur_editor_detach(app, 1), then fur_editor_attach(app) in the new context keeps
// the panel as it was. Before fur_destroy(app): fur_editor_detach(app, 0).
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/EditorHost.h"
#include "web/Boundary.h"

using namespace fur;
using app::App;
using app::EditorHost;
using web::guarded;

namespace {

std::map<App*, std::unique_ptr<EditorHost>> hosts;  // the handle is the App's, so this finds its panel
std::string commandText;
std::vector<EditorHost::Version> versions;  // those that were added and are not shown yet
std::vector<editor::OwnCoatView> ownCoats;  // likewise

// This program saves.
const bool keepsDocuments = (App::keepDocuments(&scene::kDocumentKeeping), true);

// And has a panel.
const bool describesFields = (settings::describeFieldsWith(settings::tooltipOf), true);

std::string lines(const Warnings& list) {
  std::string out;
  for (const std::string& line : list) out += line + '\n';
  return out;
}

EditorHost* hostOf(App* app) {
  const auto found = hosts.find(app);
  return found == hosts.end() ? nullptr : found->second.get();
}

// Calls for an app without a panel do nothing, so that a page can have one event path.
template <class Work>
int withHost(App* app, Work&& work) {
  EditorHost* host = hostOf(app);
  return host ? guarded([&] { return static_cast<int>(work(*host)); }) : 0;
}

editor::Modifiers modifiersOf(int bits) { return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}; }

// Of a call that names an edit of its table; `numbers`: their sum.
Status checkEdit(const char* what, const char* edit, bool known, float numbers) {
  if (!known) return Error{ErrorId::BadFile, std::string("there is no edit of ") + what + " \"" + std::string(std::string_view(edit).substr(0, 64)) + '"'};
  if (!std::isfinite(numbers)) return Error{ErrorId::BadFile, std::string(edit) + ": its numbers must be finite"};
  return Done{};
}

}  // namespace

// --- life ---

FUR_EXPORT int fur_editor_attach(App* app) {
  return guarded([&] {
    auto& host = hosts[app];
    if (!host) host = std::make_unique<EditorHost>(*app, editor::FileAccess::Dialog);
    return web::report(host->attach());
  });
}
FUR_EXPORT void fur_editor_detach(App* app, int lost) {
  withHost(app, [](EditorHost& host) { return host.detach(), 0; });
  if (!lost) hosts.erase(app);
}
// Pixels of the drawing buffer.
FUR_EXPORT void fur_editor_resize(App* app, int width, int height, float pixelRatio) {
  withHost(app, [&](EditorHost& host) { return host.resize(width, height, pixelRatio), 0; });
}

// --- input; 1: it was for the panel, the App must not get it ---
// phase, kind, id, buttons and positions as in fur_pointer(); seconds: when, on any clock; modifiers: bit 0 shift, 1 control (or
// the Mac's command key), 2 alt

FUR_EXPORT int fur_editor_pointer(App* app, int phase, int kind, int id, float x, float y, int buttons, int modifiers,
                                  double seconds) {
  app::PointerEvent event{static_cast<app::PointerPhase>(phase)};
  event.kind = static_cast<app::PointerKind>(kind);
  event.id = id;
  event.position = {x, y};
  event.buttons = buttons;
  event.shift = (modifiers & 1) != 0;
  event.control = (modifiers & 2) != 0;
  event.alt = (modifiers & 4) != 0;
  return withHost(app, [&](EditorHost& host) { return host.pointer(event, seconds); });
}
FUR_EXPORT void fur_editor_pointerLeft(App* app) {
  withHost(app, [](EditorHost& host) { return host.pointerLeft(), 0; });
}
FUR_EXPORT int fur_editor_wheel(App* app, float notches, float x, float y) {
  return withHost(app, [&](EditorHost& host) { return host.wheel(notches, {x, y}); });
}
// KeyboardEvent.key; send releases too.
FUR_EXPORT int fur_editor_key(App* app, const char* domKey, int down, int modifiers) {
  return withHost(app, [&](EditorHost& host) { return host.key(domKey, down != 0, modifiersOf(modifiers)); });
}
// Characters that were typed (a key of one character without control, or an input event).
FUR_EXPORT int fur_editor_text(App* app, const char* utf8) {
  return withHost(app, [&](EditorHost& host) { return host.text(utf8); });
}
// Clipboard text: goes into the text field with the focus, else is taken as settings.
FUR_EXPORT void fur_editor_paste(App* app, const char* utf8) {
  withHost(app, [&](EditorHost& host) { return host.paste(utf8), 0; });
}
FUR_EXPORT void fur_editor_focusLost(App* app) {
  withHost(app, [](EditorHost& host) { return host.focusLost(), 0; });
}
// bit 0: the pointer, bit 1: the keyboard, bit 2: text (show an on-screen keyboard), bit 3: which is a number
FUR_EXPORT int fur_editor_wants(App* app) {
  return withHost(app, [](EditorHost& host) {
    return (host.wantsPointer() ? 1 : 0) | (host.wantsKeyboard() ? 2 : 0) | (host.wantsText() ? 4 : 0) |
           (host.wantsNumber() ? 8 : 0);
  });
}
// A value for the CSS property cursor while the pointer is over the panel.
FUR_EXPORT const char* fur_editor_cursor(App* app) {
  const EditorHost* host = hostOf(app);
  return web::text(host ? host->cursor() : "default");
}

// --- frames ---

// Builds the panel's next frame; 1 when it looks different from the one on the screen.
FUR_EXPORT int fur_editor_update(App* app, float seconds) {
  return withHost(app, [&](EditorHost& host) { return host.update(seconds); });
}
// Over what fur_draw() has just drawn.
FUR_EXPORT void fur_editor_draw(App* app) {
  withHost(app, [](EditorHost& host) { return host.draw(), 0; });
}
// Further frames are needed although no event may come.
FUR_EXPORT int fur_editor_active(App* app) {
  return withHost(app, [](EditorHost& host) { return host.active(); });
}

// --- the panel's size ---

// What the person chose, as a text to be kept and given back the next time.
FUR_EXPORT const char* fur_editor_layout(App* app) {
  const EditorHost* host = hostOf(app);
  return web::text(host ? host->layout() : "");
}
FUR_EXPORT void fur_editor_setLayout(App* app, const char* text) {
  withHost(app, [&](EditorHost& host) { return host.setLayout(text), 0; });
}
// CSS pixels at the right that the open panel hides; 0 where it is a sheet at the bottom.
FUR_EXPORT int fur_editor_coatType(App* app) {
  return withHost(app, [](EditorHost& host) { return host.coatType(); });
}
FUR_EXPORT float fur_editor_coveredWidth(App* app) {
  const EditorHost* host = hostOf(app);
  return host ? host->coveredWidth() : 0;
}

// --- what the page must do ---

// The name of the next command (app/editor/PlatformCommands.inc), whose text is fur_editor_commandText(); "": there is none.
FUR_EXPORT const char* fur_editor_command(App* app) {
  EditorHost* host = hostOf(app);
  std::optional<app::PlatformCommand> command = host ? host->takeCommand() : std::nullopt;
  if (!command) return "";
  commandText = std::move(command->text);
  return command->name();
}
FUR_EXPORT const char* fur_editor_commandText() { return commandText.c_str(); }
// width, height, frames, frames per second, frame, top, rows, whether it is the frame's last; the rows, straight RGBA from
// the top, lie at fur_savedBytes(). Null: it was given up.
FUR_EXPORT const double* fur_editor_nextBand(App* app) {
  EditorHost* host = hostOf(app);
  if (!host || !host->studio().busy()) return nullptr;
  return guarded([&]() -> const double* {
    const app::PictureOrder order = host->studio().order();
    auto band = host->nextBand();
    if (!band) return nullptr;
    web::keepSaved(std::move(band->rgba));
    return web::numbers({double(order.width), double(order.height), double(order.frames), double(app::kFramesPerSecond),
                         double(band->frame), double(band->top), double(band->rows), double(band->lastOfFrame)});
  });
}
FUR_EXPORT void fur_editor_endPicture(App* app) {
  withHost(app, [](EditorHost& host) { return host.endPicture(), 0; });
}
// Scenes that are kept under names, newest first: all of them, then fur_editor_showVersions(). The picture has 4 * 144 * 96
// bytes.
FUR_EXPORT void fur_editor_addVersion(App* app, const char* id, const char* name, const char* when, const std::uint8_t* rgba) {
  withHost(app, [&](EditorHost&) {
    constexpr int kBytes = 4 * editor::kVersionPictureWidth * editor::kVersionPictureHeight;
    return versions.push_back({id, name, when, {rgba, rgba + kBytes}}), 0;
  });
}
FUR_EXPORT void fur_editor_showVersions(App* app) {
  withHost(app, [&](EditorHost& host) { return host.setVersions(std::exchange(versions, {})), 0; });
}
// Of the scene as it is: the number of bytes at fur_savedBytes().
FUR_EXPORT std::uint32_t fur_editor_versionPicture(App* app) {
  EditorHost* host = hostOf(app);
  return !host ? 0 : guarded([&] {
    auto picture = host->versionPicture();
    return picture ? web::keepSaved(std::move(*picture)) : static_cast<std::uint32_t>(web::fail(picture.error()));
  });
}
// Coats that the person has kept: all of them, then fur_editor_showOwnCoats().
FUR_EXPORT void fur_editor_addOwnCoat(App* app, const char* id, const char* name) {
  withHost(app, [&](EditorHost&) { return ownCoats.push_back({id, name}), 0; });
}
FUR_EXPORT void fur_editor_showOwnCoats(App* app) {
  withHost(app, [&](EditorHost& host) { return host.setOwnCoats(std::exchange(ownCoats, {})), 0; });
}
// Shown in the panel until dismissed: a warning, or a file that could not be read.
FUR_EXPORT void fur_editor_message(App* app, const char* text, int isError) {
  withHost(app, [&](EditorHost& host) { return host.message(text, isError != 0), 0; });
}

// --- work that visitors seldom ask for, so that they need not download it ---

// These give the number of the bytes that they make, which lie at fur_savedBytes() until they are forgotten.
FUR_EXPORT std::uint32_t fur_saveTypeSet(App* app, int type) {
  return guarded([&] { return web::keepSaved(app->saveTypeSet(type)); });
}
FUR_EXPORT std::uint32_t fur_saveCoat(App* app, const char* name, int type) {
  return guarded([&] { return web::keepSaved(app->saveCoat(name, type)); });
}
FUR_EXPORT std::uint32_t fur_saveFo(App* app) {
  return guarded([&] { return web::keepSaved(app->saveFo()); });
}
// As fur_saveSurface() of any program gives it.
FUR_EXPORT int fur_giveSurface(App* app, const std::uint8_t* bytes, std::uint32_t size) {
  return guarded([&] {
    app->giveSurface({bytes, size});
    return 1;
  });
}
// What fur_saveScene() leaves out, one a line.
FUR_EXPORT const char* fur_lostBySaving(App* app) {
  return guarded([&] { return web::text(lines(app->lostBySaving())); });
}
FUR_EXPORT std::uint32_t fur_saveScene(App* app) {
  return guarded([&] { return web::keepSaved(app->saveScene()); });
}
// The maps as a .zip of pictures.
FUR_EXPORT std::uint32_t fur_saveMaps(App* app) {
  return guarded([&] { return web::keepSaved(scene::writeZip(app->saveMaps())); });
}
// `edit`: the name of an app::GroomEdit. `color`: 0xRRGGBB; below 0: that of the settings.
FUR_EXPORT int fur_groomAll(App* app, const char* edit, float value, float x, float y, float z, int color) {
  return guarded([&] {
    const auto known = app::groomEditNamed(edit);
    if (Status status = checkEdit("groom", edit, known.has_value(), value + x + y + z); !status) return web::report(status);
    app->groomAll(*known, value, {x, y, z}, color < 0 ? std::nullopt : std::optional<std::uint32_t>(color));
    return 1;
  });
}
FUR_EXPORT int fur_loadHair(App* app, const std::uint8_t* bytes, std::uint32_t size, const char* name) {
  return guarded([&] { return web::report(app->loadHair({bytes, size}, name)); });
}
// 0: the error tells why.
FUR_EXPORT std::uint32_t fur_saveHairFile(App* app) {
  return guarded([&] {
    const auto bytes = app->saveHairFile();
    return bytes ? web::keepSaved(bytes.value()) : static_cast<std::uint32_t>(web::report(bytes.error()));
  });
}
// `edit`: the name of an app::HairEdit.
FUR_EXPORT int fur_editHair(App* app, const char* edit, float value, float x, float y, float z) {
  return guarded([&] {
    const auto known = app::hairEditNamed(edit);
    if (Status status = checkEdit("hair", edit, known.has_value(), value + x + y + z); !status) return web::report(status);
    app->editHair(*known, value, {x, y, z});
    return 1;
  });
}
// `use`: the name of an app::PictureUse; `name`: of the file.
FUR_EXPORT int fur_usePicture(App* app, const char* use, const char* name, int width, int height, const std::uint8_t* rgba) {
  return guarded([&] {
    const auto known = app::pictureUseNamed(use);
    if (!known) return web::report(Error{ErrorId::BadFile, "there is no use of a picture \"" + std::string(std::string_view(use).substr(0, 64)) + '"'});
    return web::report(app->usePicture(*known, name, width, height, {rgba, std::size_t(width) * std::size_t(height) * 4}));
  });
}
// `name`: of the file, see App::groomFromFile().
FUR_EXPORT int fur_groomFromImage(App* app, int what, const char* name, int width, int height, const std::uint8_t* rgba) {
  return guarded([&] {
    app->groomFromFile(static_cast<groom::ImageOf>(what), name, width, height, {rgba, std::size_t(width) * std::size_t(height) * 4});
    return 1;
  });
}
