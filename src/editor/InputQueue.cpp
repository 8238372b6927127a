#include "editor/InputQueue.h"

#include <array>
#include <cfloat>
#include <utility>

namespace fur::editor {

namespace {

constexpr int kButtonCount = 3;
constexpr double kDoubleClickSeconds = 0.4;

constexpr std::array<std::pair<std::string_view, ImGuiKey>, 21> kKeys = {{
    {"Tab", ImGuiKey_Tab},
    {"ArrowLeft", ImGuiKey_LeftArrow},
    {"ArrowRight", ImGuiKey_RightArrow},
    {"ArrowUp", ImGuiKey_UpArrow},
    {"ArrowDown", ImGuiKey_DownArrow},
    {"PageUp", ImGuiKey_PageUp},
    {"PageDown", ImGuiKey_PageDown},
    {"Home", ImGuiKey_Home},
    {"End", ImGuiKey_End},
    {"Insert", ImGuiKey_Insert},
    {"Delete", ImGuiKey_Delete},
    {"Backspace", ImGuiKey_Backspace},
    {" ", ImGuiKey_Space},
    {"Enter", ImGuiKey_Enter},
    {"Escape", ImGuiKey_Escape},
    {"a", ImGuiKey_A},
    {"c", ImGuiKey_C},
    {"v", ImGuiKey_V},
    {"x", ImGuiKey_X},
    {"y", ImGuiKey_Y},
    {"z", ImGuiKey_Z},
}};

// With shift held a browser names the key "Z".
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

int keyCode(std::string_view name) {
  const char letter = name.size() == 1 ? lower(name[0]) : '\0';
  for (const auto& [known, code] : kKeys)
    if (name == known || (letter && known.size() == 1 && known[0] == letter)) return code;
  return -1;
}

}  // namespace

void InputQueue::mapKeys(ImGuiIO& io) {
  for (const auto& [name, code] : kKeys) io.KeyMap[code] = code;
}

void InputQueue::pointer(PointerKind kind, Vec2 position, int buttons, double seconds) {
  lastKind_ = kind;
  if (position != position_) {
    // Only the last of several moves matters to a panel.
    if (!events_.empty() && events_.back().type == Event::Type::Position) events_.pop_back();
    events_.push_back({.type = Event::Type::Position, .position = position});
    position_ = position;
  }
  if (buttons != buttons_) {
    events_.push_back({.type = Event::Type::Buttons, .code = buttons, .seconds = seconds});
    buttons_ = buttons;
  }
}

void InputQueue::pointerGone() {
  // Let go first: a slider that is held would follow the pointer to infinity.
  if (buttons_ != 0) pointer(lastKind_, position_, 0);
  pointer(lastKind_, Vec2(-FLT_MAX), 0);
}

void InputQueue::wheel(float notches) { events_.push_back({.type = Event::Type::Wheel, .notches = notches}); }

void InputQueue::key(std::string_view name, bool down, Modifiers modifiers) {
  events_.push_back({.type = Event::Type::Key, .code = keyCode(name), .down = down, .modifiers = modifiers});
}

void InputQueue::text(std::string_view utf8) {
  events_.push_back({.type = Event::Type::Text, .text = std::string(utf8)});
}

void InputQueue::releaseAll() {
  pointerGone();
  for (const auto& [name, code] : kKeys) key(name, false, {});
}

void InputQueue::feed(ImGuiIO& io) {
  bool moved = false, pressed = false, typed = false;
  while (!events_.empty()) {
    const Event& event = events_.front();
    switch (event.type) {
      case Event::Type::Position:
        if (pressed) return;
        io.MousePos = ImVec2(event.position.x, event.position.y);
        moved = true;
        break;
      case Event::Type::Buttons:
        // A press waits until the widget under the new position has been hovered for a frame.
        if (moved || pressed) return;
        if (event.code & 1 && !io.MouseDown[0]) {
          // ImGui would count frames. It looks only whether that was long ago, and whether it was here.
          io.MouseDoubleClickTime = FLT_MAX;
          if (event.seconds - lastPress_ > kDoubleClickSeconds) io.MouseClickedTime[0] = -FLT_MAX;
          lastPress_ = event.seconds;
        }
        for (int button = 0; button < kButtonCount; ++button)
          io.MouseDown[button] = (event.code >> button) & 1;
        pressed = true;
        break;
      case Event::Type::Wheel:
        if (moved || pressed) return;
        io.MouseWheel += event.notches;
        break;
      case Event::Type::Key:
        if (typed) return;
        io.KeyShift = event.modifiers.shift;
        io.KeyCtrl = event.modifiers.control;
        io.KeyAlt = event.modifiers.alt;
        if (event.code >= 0) {
          typed = io.KeysDown[event.code] != event.down;
          io.KeysDown[event.code] = event.down;
        }
        break;
      case Event::Type::Text:
        io.AddInputCharactersUTF8(event.text.c_str());
        break;
    }
    events_.pop_front();
  }
}

}  // namespace fur::editor
