#include "editor/KeptRows.h"

#include <cstdio>
#include <utility>
#include <vector>

#include <imgui.h>

#include "editor/Theme.h"
#include "editor/Widgets.h"

namespace fur::editor {

namespace {

bool isFirstByte(char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }

}  // namespace

std::string nameFrom(const char* text) {
  std::string name;
  int characters = 0;
  for (const char* at = text; *at; ++at) {
    if (isFirstByte(*at) && ++characters > kMostNameCharacters) break;
    name += *at;
  }
  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return name.substr(first, name.find_last_not_of(' ') + 1 - first);
}

KeptRows::Pressed KeptRows::draw(const std::string& id, const std::string& name, const char* note, std::initializer_list<const char*> buttons) {
  const Question question = asked_ == id ? question_ : Question::None;
  Pressed pressed;
  if (question == Question::Name) {
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(justAsked_, false)) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputText("##name", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll)) {
      pressed.name = nameFrom(name_);
      question_ = Question::None;
    }
  } else {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(name.c_str());
    ImGui::PopTextWrapPos();
    const char* below = question == Question::Delete ? "Delete it for good?" : note;
    if (*below) ImGui::TextDisabled("%s", below);
  }
  const Pressed decided = question == Question::None ? drawButtons(id, name, buttons) : drawAnswers();
  return pressed.name.empty() ? decided : pressed;
}

void KeptRows::ask(Question what, const std::string& id) {
  question_ = what;
  asked_ = id;
  justAsked_ = true;
}

KeptRows::Pressed KeptRows::drawButtons(const std::string& id, const std::string& name, std::initializer_list<const char*> buttons) {
  std::vector<Segment> row;
  for (const char* label : buttons) row.push_back({label, false});
  const int own = static_cast<int>(row.size());
  row.push_back({"Rename", false});
  row.push_back({"Delete", false});
  const int pressed = segments("buttons", row);
  if (pressed == own) {
    std::snprintf(name_, sizeof name_, "%s", name.c_str());
    ask(Question::Name, id);
  }
  if (pressed == own + 1) ask(Question::Delete, id);
  return {pressed < own ? pressed : -1, {}, false};
}

KeptRows::Pressed KeptRows::drawAnswers() {
  const bool names = question_ == Question::Name;
  const int pressed = segments("answers", {{names ? "Rename" : "Delete", false}, {"Cancel", false}});
  if (pressed < 0) return {};
  question_ = Question::None;
  if (pressed == 1) return {};
  return names ? Pressed{-1, nameFrom(name_), false} : Pressed{-1, {}, true};
}

std::string NewName::draw(const char* id, const char* button, const char* standard) {
  const float width = px(64), gap = px(3);
  ImGui::SetNextItemWidth(-width - gap);
  const bool entered = ImGui::InputTextWithHint(id, standard, text_, sizeof text_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine(0, gap);
  if (!ImGui::Button(button, ImVec2(-1, 0)) && !entered) return "";
  const std::string name = nameFrom(text_);
  text_[0] = '\0';
  return name.empty() ? standard : name;
}

}  // namespace fur::editor
