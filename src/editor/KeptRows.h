// Rows of what is kept under names: a few buttons of the caller's, then Rename and Delete, which ask first.
#pragma once

#include <initializer_list>
#include <string>

#include "editor/EditorModel.h"

namespace fur::editor {

// The text's first characters, as many as a name may have, without spaces round them.
std::string nameFrom(const char* text);

class KeptRows {
 public:
  struct Pressed {
    int button = -1;        // of the caller's
    std::string name{};     // the new one; "": it keeps its own
    bool deletes = false;
  };
  // `note`: below the name; ImGui's stack has an id of the row's own.
  Pressed draw(const std::string& id, const std::string& name, const char* note, std::initializer_list<const char*> buttons);

 private:
  enum class Question { None, Name, Delete };

  void ask(Question what, const std::string& id);
  Pressed drawButtons(const std::string& id, const std::string& name, std::initializer_list<const char*> buttons);
  Pressed drawAnswers();

  char name_[4 * kMostNameCharacters + 1] = "";  // four bytes a character, and the end
  Question question_ = Question::None;           // about the row `asked_`
  std::string asked_;
  bool justAsked_ = false;
};

// A field for a name and a button beside it: the name that was entered, or `standard` where it was empty; "": nothing was.
class NewName {
 public:
  std::string draw(const char* id, const char* button, const char* standard);

 private:
  char text_[4 * kMostNameCharacters + 1] = "";
};

}  // namespace fur::editor
