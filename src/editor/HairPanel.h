// The section "Long hair" of the panel: the scalps of the model, the brush that paints them, guides, and the numbers of the
// selected scalp.
#pragma once

#include <vector>

#include "editor/EditorModel.h"

namespace fur::editor {

class HairPanel {
 public:
  // Draws the section into the current window. Brush settings go into `edited`, everything else is a command.
  std::vector<Command> draw(const EditorModel& model, settings::Settings& edited, bool tooltips);
  // A slider of it is held: what it does is one undo step with what comes until it is let go.
  bool changesValues() const { return changed_; }

 private:
  void drawScalps(const HairView& hair);
  void drawName(const HairView& hair);
  void drawBrush(const EditorModel& model, settings::Settings& edited);
  void givesOrTakes(Tool tool, const EditorModel& model, settings::Settings& edited);
  void drawGuides(const EditorModel& model, settings::Settings& edited);
  void drawGuideCounts(const ScalpView& scalp);
  void drawBodies(const EditorModel& model);
  void drawBody(std::size_t index, const hair::Body& body);
  void drawSaving(const ScalpView& scalp);
  void drawValues(const HairView& hair);
  void hint(const char* text) const;
  void edit(HairEdit what, float value = 1, const Vec3& direction = Vec3(0)) { commands_.push_back(command::EditHair{what, value, direction}); }

  std::vector<Command> commands_;
  bool tooltips_ = false, changed_ = false;
  int guides_ = 64;           // that "Plant" plants
  std::size_t shownGuides_ = 0;  // of the scalp that was shown last
  float bodyRadius_ = 0.4f;   // that the next sphere or capsule has
  char name_[65] = {};        // of the scalp `named_`, while it is typed
  std::size_t named_ = static_cast<std::size_t>(-1);
};

}  // namespace fur::editor
