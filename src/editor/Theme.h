// The panel's look: colours, spacing and the font, at the pixel ratio of the screen. ImGui runs in
// pixels of the drawing buffer, so text is rasterised at its true size and stays sharp.
#pragma once

#include <imgui.h>

namespace fur::editor {

struct ThemeScale {
  float pixelRatio = 1;  // pixels of the drawing buffer per CSS or desktop pixel
  bool touch = false;    // the last pointer was a finger: larger targets
  bool operator==(const ThemeScale&) const = default;
};

namespace color {
inline constexpr ImU32 kAccent = IM_COL32(104, 176, 214, 255);
inline constexpr ImU32 kFill = IM_COL32(70, 122, 152, 170);
inline constexpr ImU32 kDim = IM_COL32(160, 166, 176, 255);
inline constexpr ImU32 kText = IM_COL32(232, 235, 239, 255);
inline constexpr ImU32 kWarning = IM_COL32(226, 186, 104, 255);
inline constexpr ImU32 kError = IM_COL32(238, 122, 112, 255);
}  // namespace color

// Sets the current context's style, and rebuilds its font when the ratio changed. Returns whether
// the font's pixels are new and must be uploaded.
bool applyTheme(const ThemeScale& scale);

// A length in CSS pixels -> pixels of the drawing buffer, as of the last applyTheme() (derived from
// the font, which is the only state ImGui keeps of it).
float px(float cssPixels);

}  // namespace fur::editor
