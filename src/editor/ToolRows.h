// Rows of the panel that choose a tool. Which tools stand in a row, and under which words, is app/tools/Tools.inc's.
#pragma once

#include <optional>
#include <vector>

#include "app/tools/Tools.h"
#include "editor/EditorModel.h"

namespace fur::editor {

std::vector<Tool> toolsIn(std::string_view row);

// Its tools side by side, the chosen one lit. Returns which was pressed. With icons: over their labels.
std::optional<Tool> toolRow(const char* row, Tool chosen);
std::optional<Tool> toolIconRow(const char* row, Tool chosen);

// A tool and its inverse, side by side. A press chooses the tool, a command, and which of the two in `edited`. The last item is that for
// a tooltip.
void drawToolAndInverse(Tool tool, const EditorModel& model, settings::Settings& edited, std::vector<Command>& commands);

}  // namespace fur::editor
