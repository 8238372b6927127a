// Small line drawings for buttons, so that no icon font is needed.
#pragma once

#include <optional>
#include <string_view>

#include <imgui.h>

namespace fur::editor {

enum class Icon { Undo, Redo, Reset, Camera, ChevronUp, ChevronDown, Close, Droplet, Dry, Move, Orbit, Plus, Minus, Dice };

// By its name in app/tools/Tools.inc; none of another.
std::optional<Icon> iconNamed(std::string_view name);

// Fits the square of side `size` around `center`.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color);

}  // namespace fur::editor
