// The few widgets that Dear ImGui lacks, in the panel's style. Each is an ordinary ImGui item of
// the current window: IsItemActive() and the like work on it.
#pragma once

#include <initializer_list>
#include <span>

#include <imgui.h>

#include "editor/Icons.h"

namespace fur::editor {

// A button with a drawing, as high as other widgets; width 0: square. Disabled: dim and deaf.
bool iconButton(const char* id, Icon icon, const char* tooltip, bool enabled = true, float width = 0);

struct Segment {
  const char* label;
  bool chosen;
};
// Buttons side by side over the full width, one of them lit. Returns which was pressed, or -1.
int segments(const char* id, std::span<const Segment> choices);
inline int segments(const char* id, std::initializer_list<Segment> choices) { return segments(id, std::span<const Segment>(choices.begin(), choices.size())); }
// An icon each.
int iconSegments(const char* id, std::span<const Segment> choices, std::span<const Icon> icons);

// Dim, before what stands in the same row.
void rowLabel(const char* text);

// As ImGui's, with less padding beside the arrow. Buttons may be put on it.
bool groupHeader(const char* label);

// A bar that fills with the value; drag, or double click (or Ctrl+click) to type: Enter takes what was typed,
// within the range, Escape leaves the value as it was. The second click of a double click gives the value from
// before the first. Logarithmic: equal steps multiply, for ranges over several powers (low must be above 0).
bool fillSlider(const char* id, float& value, float low, float high, const char* format, bool logarithmic);
bool fillSlider(const char* id, int& value, int low, int high);

// The same upright, low at the bottom, without its number.
bool fillSliderUpright(const char* id, int& value, int low, int high, ImVec2 size);

// A hemisphere seen from above: the middle is overhead, the rim the horizon, +z points down.
bool lightPad(const char* id, float& yaw, float& pitch, float lowestPitch, float highestPitch,
              float diameter);

}  // namespace fur::editor
