// The editor's Edit and Whiskers modes (Sheppard 2004, 5.4.2 and 5.4.3): what the tools Edit and Whisker do while there is a panel.
// A point or a standing whisker is chosen by a press, changed by drags and keys, and shown in the panel with its numbers.
//
// Edit:    drag combs to where the pointer goes, the further the more; right button and drag up and down: length. 1 to 4: type.
// Whisker: a press on one chooses it, beside them plants one; drag aims it; right button and drag: length. Delete removes it.
// Keys:    E and W begin and leave the modes, held down they go on only so long as something is done meanwhile; B, S and F show and
//          hide skin, shells and fins. While the free camera looks round they are its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/App.h"
#include "editor/EditorModel.h"
#include "editor/InputQueue.h"

namespace fur::app {

class EditModes {
 public:
  explicit EditModes(App& app) : app_(app) {}

  // --- input; true: it was meant for them ---
  bool press(const PointerEvent& event, float pixelRatio);
  void drag(const PointerEvent& event);
  void release();
  bool key(std::string_view name, bool down, const editor::Modifiers& modifiers);
  void hover(std::optional<Vec2> pixel) { hover_ = pixel; }

  // --- the panel ---
  void describe(editor::GroomView& view);
  void set(const editor::command::SetPoint& numbers);
  void set(const editor::WhiskerView& whisker);
  void removeWhisker();
  void chooseWhisker(int step);
  // What is chosen, over the picture and under the panel.
  void draw(float pixelRatio);

 private:
  enum class Gesture { None, Comb, Length, Aim, AimPlanted, WhiskerLength };

  bool pressEdit(const PointerEvent& event);
  bool pressWhisker(const PointerEvent& event);
  void choosePoint(const FurAt& at) { point_ = at.place; }
  std::optional<std::size_t> whisker();  // the index of the chosen one
  void choose(std::size_t whisker);
  bool modeKey(std::string_view name, bool down);
  bool toggle(std::string_view name);
  bool keyOfPoint(std::string_view name, bool shift);
  bool keyOfWhisker(std::string_view name, bool shift);
  template <class Change>
  void changeWhisker(Change&& change);

  App& app_;
  std::optional<Vec3> point_;        // place of the skin, model space
  std::optional<Vec3> whiskerRoot_;  // undo may give it another index
  std::size_t whiskerIndex_ = 0;
  std::optional<Vec2> hover_;

  Gesture gesture_ = Gesture::None;
  bool moved_ = false;
  Vec2 from_{0};       // where the gesture began, pixels
  Vec3 fromPlace_{0};  // and of the skin
  float before_ = 0;   // the length then
  float pixelRatio_ = 1;

  std::string held_;                 // the key that is down
  Tool toolBefore_ = Tool::None;     // the mode
  bool used_ = false;                // something was done while the key is down
};

}  // namespace fur::app
