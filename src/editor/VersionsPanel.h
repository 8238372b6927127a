// The section "Versions" of the panel: scenes that are kept under names, with the way back to each.
#pragma once

#include <vector>

#include "editor/EditorModel.h"
#include "editor/KeptRows.h"

namespace fur::editor {

class VersionsPanel {
 public:
  // Draws the section into the current window.
  std::vector<Command> draw(const EditorModel& model);

 private:
  void drawVersion(const VersionView& version, std::vector<Command>& commands);

  NewName newName_;
  KeptRows rows_;
};

}  // namespace fur::editor
