// Pointers and keys: for the panel, for the editor's modes, or for the App.
#include <utility>
#include <variant>

#include <imgui.h>
#include <imgui_internal.h>  // which windows cover a pixel, before the frame that would tell; what is typed

#include "app/editor/EditorHost.h"

namespace fur::app {

namespace {

// How far colours may be apart that are selected as one.
constexpr float kPaintTolerance = 0.12f;

editor::PointerKind panelKind(PointerKind kind) {
  return kind == PointerKind::Touch ? editor::PointerKind::Touch : editor::PointerKind::Mouse;
}

}  // namespace

bool EditorHost::covers(Vec2 position) const {
  const ImGuiContext& context = *context_;
  if (context.OpenPopupStack.Size > 0) return true;  // a click anywhere else closes it
  for (const ImGuiWindow* window : context.Windows)
    if (window->WasActive && !window->Hidden &&
        !(window->Flags & (ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_Tooltip)) &&
        window->Rect().Contains(ImVec2(position.x, position.y)))
      return true;
  return false;
}

bool EditorHost::pointer(const PointerEvent& event, double seconds) {
  const bool down = event.phase == PointerPhase::Down;
  const bool ended = event.phase == PointerPhase::Cancel || (event.phase == PointerPhase::Up && !event.buttons);
  if (down && owner_ == Owner::None) {
    owner_ = covers(event.position) || selects(event) || picksColor(event) ? Owner::Panel
             : !studio_.busy() && modes_.press(event, scale_.pixelRatio)   ? Owner::Modes
                                                                           : Owner::App;
    ownerId_ = event.id;
    if (owner_ != Owner::Panel) stopTurning();
  }
  // Two fingers move the view.
  if (down && owner_ == Owner::Modes && event.id != ownerId_) handToApp(ownerLast_);
  // The panel follows one pointer. A second finger goes where it lies, and never to both.
  if (owner_ != Owner::None && event.id != ownerId_) return owner_ == Owner::Panel || covers(event.position) || studio_.busy();
  if (owner_ == Owner::Modes) {
    ownerLast_ = event;
    if (ended) modes_.release();
    else if (!down) modes_.drag(event);
  }
  const bool captured = owner_ == Owner::Panel || owner_ == Owner::Modes || (owner_ == Owner::None && covers(event.position));
  const bool touch = event.kind == PointerKind::Touch;
  if (ended) owner_ = Owner::None;
  // ImGui also hears of what is not for it: a press on the model takes the focus from the panel.
  const bool cancelled = event.phase == PointerPhase::Cancel;  // its position means nothing
  if (!cancelled) input_.pointer(panelKind(event.kind), event.position, event.buttons, seconds);
  if (cancelled || (touch && ended)) input_.pointerGone();
  wake();
  return captured || studio_.busy();  // the scene stands still for a picture
}

// The App goes on with a pointer that the modes had; with shift, so that no tool begins there.
void EditorHost::handToApp(const PointerEvent& event) {
  modes_.release();
  owner_ = Owner::App;
  PointerEvent begun = event;
  begun.phase = PointerPhase::Down;
  begun.shift = true;
  app_.pointer(begun);
}

// Alt takes the colour from the model instead of painting it there.
bool EditorHost::picksColor(const PointerEvent& event) {
  if (!event.alt || app_.tool() != Tool::Paint) return false;
  const auto color = app_.colorAt(event.position);
  if (!color) return false;
  settings::Settings next = app_.settings();
  next.paintColor = *color;
  app_.setSettings(next);
  return true;
}

// The press that a selection waits for. Beside the model it ends the waiting, and is a press like any other.
bool EditorHost::selects(const PointerEvent& event) {
  const editor::Selects what = std::exchange(selects_, editor::Selects::Nothing);
  if (what == editor::Selects::Nothing) return false;
  const auto place = app_.placeAt(event.position);
  if (!place) return false;
  if (what == editor::Selects::Sphere || what == editor::Selects::Capsule) {
    app_.editHair(what == editor::Selects::Sphere ? HairEdit::AddSphere : HairEdit::AddCapsule, bodyRadius_, *place);
    app_.setTool(Tool::HairShape);
    return true;
  }
  const bool paint = what == editor::Selects::Paint;
  app_.groomAll(paint ? GroomEdit::SelectPaint : GroomEdit::SelectConnected, paint ? kPaintTolerance : 1, *place);
  return true;
}

void EditorHost::pointerLeft() {
  if (owner_ != Owner::None) return;  // a drag goes on outside of the window
  input_.pointerGone();
  wake();
}

bool EditorHost::wheel(float notches, Vec2 position) {
  if (!covers(position)) return false;
  input_.wheel(-notches);
  wake();
  return true;
}

bool EditorHost::key(std::string_view name, bool down, const editor::Modifiers& modifiers) {
  if (studio_.busy() && down) {
    if (name == "Escape") studio_.end();
    wake();
    return true;
  }
  const bool text = wantsText();
  if (!text && down && app_.looksRound()) return false;
  if (down && name == "Escape" && std::exchange(selects_, editor::Selects::Nothing) != editor::Selects::Nothing) {
    wake();
    return true;
  }
  const auto shortcut = editor::Editor::shortcut(name, modifiers);
  const bool saves = shortcut && std::holds_alternative<editor::command::SaveScene>(*shortcut);
  if (shortcut && (saves || !text)) {
    if (down && saves) editor_.save();
    else if (down) perform(*shortcut);
    wake();
    return true;
  }
  if (!text && (name == "Delete" || name == "Backspace") && app_.tool() == Tool::HairShape && app_.selectedBody() >= 0) {
    if (down) app_.editHair(HairEdit::RemoveBody);
    wake();
    return true;
  }
  if (!text && modes_.key(name, down, modifiers)) {
    wake();
    return true;
  }
  if (!text && !modifiers.control && resizeBrush(name, down)) return true;
  // Without a clipboard to ask, the platform's own paste must take place, and comes in as paste().
  if (text && !readClipboard_ && modifiers.control && (name == "v" || name == "V")) return false;
  const bool wanted = text || wantsKeyboard();
  // Releases always arrive, so that no key stays down; and so does what follows a click that has not
  // been seen yet, for it may be what gives a text field the focus. ImGui ignores what it has no use for.
  if (!down || wanted || !input_.empty()) {
    input_.key(name, down, modifiers);
    wake();
  }
  return wanted;
}

// [ and ] make the brush smaller and larger, with shift weaker and stronger. Shift makes braces of them on many keyboards.
bool EditorHost::resizeBrush(std::string_view name, bool down) {
  constexpr std::string_view kKeys = "[]{}";
  const std::size_t key = name.size() == 1 ? kKeys.find(name) : std::string_view::npos;
  if (key == std::string_view::npos) return false;
  if (!down) return true;
  const char* field = key < 2 ? "brushRadius" : grooms(app_.tool()) ? "groomStrength" : "brushFlow";
  settings::Settings next = app_.settings();
  Warnings ignored;  // the ends of the range are natural stops
  const settings::Field& changed = *settings::findField(field);
  const double value = changed.get(next), more = key < 2 ? 0.15 * value : 0.05;
  settings::setField(next, changed, key % 2 ? value + more : value - more, ignored);
  app_.setSettings(next);
  wake();
  return true;
}

bool EditorHost::text(std::string_view utf8) {
  if (!wantsText() && input_.empty()) return false;
  input_.text(utf8);
  wake();
  return wantsText();
}

void EditorHost::paste(const std::string& text) {
  if (wantsText())
    input_.text(text);
  else
    check(app_.setState(text));
  wake();
}

void EditorHost::focusLost() {
  input_.releaseAll();
  if (owner_ == Owner::Modes) modes_.release();
  owner_ = Owner::None;
  wake();
}

bool EditorHost::wantsKeyboard() const { return context_->IO.WantCaptureKeyboard; }
bool EditorHost::wantsText() const { return context_->IO.WantTextInput; }

bool EditorHost::wantsNumber() const { return wantsText() && context_->ActiveId && context_->ActiveId == context_->TempInputId; }

}  // namespace fur::app
