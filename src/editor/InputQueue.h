// Events on their way to Dear ImGui. 1.86 reads the state of the mouse and keys once a frame, so a
// press and release between two frames would be lost, and a finger would press before the widget
// under it is known to be hovered. The queue hands on at most so much per frame that ImGui sees
// every change in order; the rest waits for the next frame.
// Positions are pixels of the drawing buffer, origin top left.
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include <imgui.h>

#include "core/Math.h"

namespace fur::editor {

enum class PointerKind { Mouse, Touch };

struct Modifiers {
  bool shift = false, control = false, alt = false;
};

class InputQueue {
 public:
  // Buttons: bit 0 left, 1 right, 2 middle, as they are after the event. Seconds: when it was pressed, on any clock; frames
  // may be slow, and the panel sleeps between them, so only this tells a double click.
  void pointer(PointerKind kind, Vec2 position, int buttons, double seconds = 0);
  void pointerGone();         // left the window, or the finger was lifted
  void wheel(float notches);  // positive: towards the top of the panel
  // A key by its DOM name ("ArrowLeft", "z"); keys that ImGui has no use for are ignored.
  void key(std::string_view name, bool down, Modifiers modifiers);
  void text(std::string_view utf8);
  void releaseAll();  // the window lost the focus: nothing is held any more

  // Call right before ImGui::NewFrame().
  void feed(ImGuiIO& io);
  bool empty() const { return events_.empty(); }
  PointerKind lastKind() const { return lastKind_; }

  // Tells ImGui which slot of io.KeysDown belongs to which of its keys.
  static void mapKeys(ImGuiIO& io);

 private:
  struct Event {
    enum class Type { Position, Buttons, Wheel, Key, Text } type;
    Vec2 position{0};
    int code = 0;  // buttons, or the ImGuiKey
    double seconds = 0;
    bool down = false;
    float notches = 0;
    Modifiers modifiers = {};
    std::string text = {};
  };

  std::deque<Event> events_;
  Vec2 position_{-1};
  int buttons_ = 0;
  double lastPress_ = -1e9;  // of the left button, in seconds
  PointerKind lastKind_ = PointerKind::Mouse;
};

}  // namespace fur::editor
