// Where the panel stands and how large it is: a column at the right, or below 600 CSS pixels of width a sheet at
// the bottom; and the edge by which a person makes it larger. Both sizes can be kept as a text.
#pragma once

#include <string>
#include <string_view>

#include <imgui.h>

#include "core/Math.h"
#include "editor/Theme.h"

namespace fur::editor {

inline constexpr float kTitleGapCssPixels = 2;
// Of the row of buttons at the right end of the title.
float titleButtonsWidth();

class PanelLayout {
 public:
  // Places the window that begins next. contentHeight: of what the column would show if it could, in pixels of
  // the drawing buffer, 0 while that is unknown; the sheet is as high as it was made.
  void place(const ThemeScale& scale, float contentHeight);

  // The edge of the window that place() was for, from its inside: drag it, or give it the focus and press the
  // arrow keys. A double click on the column's gives its first width back; a tap on the sheet's opens and closes it.
  void drawEdge();

  bool narrow() const { return narrow_; }  // a sheet
  bool roomy() const { return roomy_; }    // high enough that pictures leave room for the settings below them
  bool collapsed() const { return collapsed_; }
  // Until set: closed to its title on narrow screens, else open.
  void setCollapsed(bool collapsed) { collapsed_ = collapsed; }

  // What the panel hides of the screen: see Editor::covered().
  Vec2 covered() const { return covered_; }

  // The sizes that a person chose, for the next time: "width 336 sheet 0.45", the column's in CSS pixels, the
  // sheet's as a share of the screen's height. Reading clamps, and leaves what it cannot read.
  std::string text() const;
  void read(std::string_view text);

 private:
  void resizeColumn();
  void resizeSheet();
  float keyStep() const;
  float mostWidth() const;

  float width_ = kWidth, sheet_ = kSheet;
  bool collapsed_ = false;
  bool narrow_ = false, roomy_ = false;
  float atPress_ = 0;  // the size that is dragged, in pixels, as it was when the drag began
  ImVec2 screen_{0, 0};
  Vec2 covered_{0};

  static constexpr float kWidth = 336, kSheet = 0.45f;
};

}  // namespace fur::editor
