// The section "Versions" of the panel: scenes that are kept under names, with the way back to each.
#pragma once

#include <string>
#include <vector>

#include "editor/EditorModel.h"

namespace fur::editor {

class VersionsPanel {
 public:
  // Draws the section into the current window.
  std::vector<Command> draw(const EditorModel& model);

 private:
  void drawNew(const EditorModel& model);
  void drawVersion(const VersionView& version);
  void drawButtons(const VersionView& version);

  // What is asked about the version `asked_`.
  enum class Question { None, Name, Delete };

  std::vector<Command> commands_;
  // Four bytes a character, and the end.
  char name_[4 * kMostNameCharacters + 1] = "", newName_[4 * kMostNameCharacters + 1] = "";
  Question question_ = Question::None;
  std::string asked_;
  bool justAsked_ = false;
};

// The text's first characters, as many as a name may have, without spaces round them.
std::string nameFrom(const char* text);

}  // namespace fur::editor
