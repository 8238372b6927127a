#include "editor/VersionsPanel.h"

#include <cstdio>

#include <imgui.h>

#include "editor/Theme.h"
#include "editor/Widgets.h"

namespace fur::editor {

namespace {

constexpr float kPictureWidth = 72, kPictureHeight = 48;  // CSS pixels

}  // namespace

std::vector<Command> VersionsPanel::draw(const EditorModel& model) {
  std::vector<Command> commands;
  if (!groupHeader("Versions")) return commands;
  char standard[32];
  std::snprintf(standard, sizeof standard, "Version %d", static_cast<int>(model.versions.size()) + 1);
  if (std::string name = newName_.draw("##versionName", "Keep", standard); !name.empty()) commands.push_back(command::KeepVersion{std::move(name)});
  for (const VersionView& version : model.versions) drawVersion(version, commands);
  ImGui::Dummy(ImVec2(0, px(2)));
  return commands;
}

void VersionsPanel::drawVersion(const VersionView& version, std::vector<Command>& commands) {
  ImGui::PushID(version.id.c_str());
  const ImVec2 size(px(kPictureWidth), px(kPictureHeight));
  if (version.picture) ImGui::Image(version.picture, size);
  else ImGui::Dummy(size);
  ImGui::SameLine(0, px(8));
  ImGui::BeginGroup();
  const KeptRows::Pressed pressed = rows_.draw(version.id, version.name, version.when.c_str(), {"Go back"});
  if (pressed.button == 0) commands.push_back(command::OpenVersion{version.id});
  if (!pressed.name.empty()) commands.push_back(command::RenameVersion{version.id, pressed.name});
  if (pressed.deletes) commands.push_back(command::DeleteVersion{version.id});
  ImGui::EndGroup();
  ImGui::PopID();
}

}  // namespace fur::editor
