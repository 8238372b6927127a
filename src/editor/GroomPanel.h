// The section "Groom" of the panel: brushes that dress the fur, what can be done to all of it at once, and
// what it has become: the map, and how much of the surface carries what.
#pragma once

#include <vector>

#include "editor/EditorModel.h"

namespace fur::editor {

class GroomPanel {
 public:
  // Draws the section into the current window. Brush settings go into `edited`, everything else is a command.
  std::vector<Command> draw(const EditorModel& model, settings::Settings& edited, bool tooltips);

  // A slider of a point or whisker is held: all it does is one change.
  bool changesNumbers() const { return changes_; }
  // The panel is closed: nothing of this is on the screen.
  void hide() { shown_ = false; }
  // Whether it shows the map.
  bool shownMap() const { return shown_; }

 private:
  // Opens the section for who begins one of its modes by a key or in the page's bar. Whether it was closed.
  bool openFor(Tool tool);
  void drawPoint(const EditorModel& model);
  bool drawLean(LeanView& lean, float most, const char* what);  // degrees
  void drawWhisker(const WhiskerView& whisker);
  void drawBrush(const EditorModel& model, settings::Settings& edited);
  // A tool and its inverse, side by side.
  void givesOrTakes(Tool tool, const EditorModel& model, settings::Settings& edited);
  void drawPaint(const EditorModel& model, settings::Settings& edited);
  void drawMask(const EditorModel& model, settings::Settings& edited);
  void drawSelection(const EditorModel& model, settings::Settings& edited);
  void drawParts(const EditorModel& model);
  void drawWhiskers(const EditorModel& model, settings::Settings& edited);
  void drawLengths();
  void drawDirections();
  void drawMap(const GroomView& groom);
  void hint(const char* text) const;
  void edit(GroomEdit what, float value = 1, const Vec3& direction = Vec3(0)) {
    commands_.push_back(command::GroomAll{what, value, direction});
  }

  // In a row of its own.
  bool number(const char* label, float& value, float low, float high, const char* format);

  std::vector<Command> commands_;
  bool changes_ = false;
  Tool tool_ = Tool::None;        // of the frame before
  int scrolls_ = 0;               // frames that still bring the section to the top
  std::optional<float> wetness_;  // while its slider is held
  bool shown_ = false, tooltips_ = false;
  float patternSize_ = 1;
  float shortest_ = 0, longest_ = 0.5f;  // what "Select length" selects
};

}  // namespace fur::editor
