#include "editor/VersionsPanel.h"

#include <cstdio>
#include <utility>

#include <imgui.h>

#include "editor/Theme.h"
#include "editor/Widgets.h"

namespace fur::editor {

namespace {

constexpr float kPictureWidth = 72, kPictureHeight = 48;  // CSS pixels

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

std::vector<Command> VersionsPanel::draw(const EditorModel& model) {
  commands_.clear();
  if (!groupHeader("Versions")) return {};
  drawNew(model);
  for (const VersionView& version : model.versions) drawVersion(version);
  ImGui::Dummy(ImVec2(0, px(2)));
  return std::exchange(commands_, {});
}

void VersionsPanel::drawNew(const EditorModel& model) {
  const float button = px(64), gap = px(3);
  char standard[32];
  std::snprintf(standard, sizeof standard, "Version %d", static_cast<int>(model.versions.size()) + 1);
  ImGui::SetNextItemWidth(-button - gap);
  const bool entered = ImGui::InputTextWithHint("##versionName", standard, newName_, sizeof newName_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine(0, gap);
  if (!ImGui::Button("Keep", ImVec2(-1, 0)) && !entered) return;
  const std::string name = nameFrom(newName_);
  commands_.push_back(command::KeepVersion{name.empty() ? standard : name});
  newName_[0] = '\0';
}

void VersionsPanel::drawVersion(const VersionView& version) {
  ImGui::PushID(version.id.c_str());
  const ImVec2 size(px(kPictureWidth), px(kPictureHeight));
  if (version.picture) ImGui::Image(version.picture, size);
  else ImGui::Dummy(size);
  ImGui::SameLine(0, px(8));
  ImGui::BeginGroup();
  const Question question = asked_ == version.id ? question_ : Question::None;
  if (question == Question::Name) {
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(justAsked_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputText("##name", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (entered && *nameFrom(name_).c_str()) commands_.push_back(command::RenameVersion{version.id, nameFrom(name_)});
    if (entered) question_ = Question::None;
  } else {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(version.name.c_str());
    ImGui::PopTextWrapPos();
    ImGui::TextDisabled("%s", question == Question::Delete ? "Delete it for good?" : version.when.c_str());
  }
  drawButtons(version);
  ImGui::EndGroup();
  ImGui::PopID();
}

void VersionsPanel::drawButtons(const VersionView& version) {
  const Question question = asked_ == version.id ? question_ : Question::None;
  const auto ask = [&](Question what) {
    question_ = what;
    asked_ = version.id;
    justAsked_ = true;
  };
  if (question == Question::None) {
    const int pressed = segments("buttons", {{"Go back", false}, {"Rename", false}, {"Delete", false}});
    if (pressed == 0) commands_.push_back(command::OpenVersion{version.id});
    if (pressed == 1) {
      std::snprintf(name_, sizeof name_, "%s", version.name.c_str());
      ask(Question::Name);
    }
    if (pressed == 2) ask(Question::Delete);
    return;
  }
  const bool names = question == Question::Name;
  const int pressed = segments("answers", {{names ? "Rename" : "Delete", false}, {"Cancel", false}});
  if (pressed < 0) return;
  question_ = Question::None;
  if (pressed == 1) return;
  if (!names) commands_.push_back(command::DeleteVersion{version.id});
  else if (const std::string name = nameFrom(name_); !name.empty()) commands_.push_back(command::RenameVersion{version.id, name});
}

}  // namespace fur::editor
