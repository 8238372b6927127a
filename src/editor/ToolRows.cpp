#include "editor/ToolRows.h"

#include "core/Assert.h"
#include "editor/Widgets.h"

namespace fur::editor {

namespace {

std::vector<Segment> segmentsOf(const std::vector<Tool>& tools, Tool chosen) {
  std::vector<Segment> out;
  for (const Tool tool : tools) out.push_back({app::wordsOf(tool).label, tool == chosen});
  return out;
}

std::optional<Tool> pressedOf(const std::vector<Tool>& tools, int pressed) {
  return pressed < 0 ? std::nullopt : std::optional(tools[static_cast<std::size_t>(pressed)]);
}

}  // namespace

std::vector<Tool> toolsIn(std::string_view row) {
  std::vector<Tool> out;
  for (std::size_t i = 0; i < app::kToolCount; ++i)
    if (row == app::wordsOf(static_cast<Tool>(i)).row) out.push_back(static_cast<Tool>(i));
  return out;
}

std::optional<Tool> toolRow(const char* row, Tool chosen) {
  const std::vector<Tool> tools = toolsIn(row);
  return pressedOf(tools, segments(row, segmentsOf(tools, chosen)));
}

std::optional<Tool> toolIconRow(const char* row, Tool chosen) {
  const std::vector<Tool> tools = toolsIn(row);
  std::vector<Icon> icons;
  for (const Tool tool : tools) {
    const auto icon = iconNamed(app::wordsOf(tool).icon);
    FUR_ASSERT(icon, "toolIconRow()", "a tool with an icon", std::string(app::nameOf(tool)));
    icons.push_back(*icon);
  }
  return pressedOf(tools, iconSegments(row, segmentsOf(tools, chosen), icons));
}

void drawToolAndInverse(Tool tool, const EditorModel& model, settings::Settings& edited, std::vector<Command>& commands) {
  const app::ToolWords& words = app::wordsOf(tool);
  const auto chosen = [&](bool erases) { return model.tool == tool && edited.brushErases == erases; };
  const int pressed = segments(words.label, {{words.label, chosen(false)}, {words.inverseLabel, chosen(true)}});
  if (pressed < 0) return;
  commands.push_back(command::SetTool{tool});
  edited.brushErases = pressed == 1;
}

}  // namespace fur::editor
