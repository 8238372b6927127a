#include "editor/Theme.h"

#include <cmath>
#include <iterator>

// The build writes the bytes of a font file there when it finds one.
#if __has_include("editor/FontData.inc")
#define FUR_EDITOR_HAS_FONT 1
#endif

namespace fur::editor {

namespace {

#ifdef FUR_EDITOR_HAS_FONT
constexpr float kFontCssPixels = 15.0f;
constexpr unsigned char kFont[] = {
#include "editor/FontData.inc"
};

float fontPixels(float pixelRatio) { return std::round(kFontCssPixels * pixelRatio); }
#else
// ImGui's own bitmap font: only whole multiples of its size are sharp.
constexpr float kFontCssPixels = 13.0f;

float fontPixels(float pixelRatio) { return kFontCssPixels * std::fmax(1.0f, std::round(pixelRatio)); }
#endif

void buildFont(float pixels) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  ImFontConfig config;
  config.SizePixels = pixels;
#ifdef FUR_EDITOR_HAS_FONT
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  // ImGui takes the data as not const; the atlas does not own it and only reads.
  atlas.AddFontFromMemoryTTF(const_cast<unsigned char*>(kFont), static_cast<int>(std::size(kFont)), pixels,
                             &config);
#else
  config.OversampleH = 1;
  config.PixelSnapH = true;
  atlas.AddFontDefault(&config);
#endif
  atlas.Build();
}

void setColors(ImGuiStyle& style) {
  const auto set = [&](ImGuiCol slot, int r, int g, int b, int a) {
    style.Colors[slot] = ImGui::ColorConvertU32ToFloat4(IM_COL32(r, g, b, a));
  };
  style.Colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(color::kText);
  style.Colors[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(color::kDim);
  style.Colors[ImGuiCol_CheckMark] = ImGui::ColorConvertU32ToFloat4(color::kAccent);
  style.Colors[ImGuiCol_PlotLines] = ImGui::ColorConvertU32ToFloat4(color::kAccent);
  style.Colors[ImGuiCol_NavHighlight] = ImGui::ColorConvertU32ToFloat4(color::kAccent);
  set(ImGuiCol_WindowBg, 22, 24, 28, 222);
  set(ImGuiCol_PopupBg, 30, 33, 38, 250);
  set(ImGuiCol_ChildBg, 0, 0, 0, 0);
  set(ImGuiCol_Border, 255, 255, 255, 22);
  set(ImGuiCol_FrameBg, 255, 255, 255, 20);
  set(ImGuiCol_FrameBgHovered, 255, 255, 255, 34);
  set(ImGuiCol_FrameBgActive, 255, 255, 255, 44);
  set(ImGuiCol_Button, 255, 255, 255, 22);
  set(ImGuiCol_ButtonHovered, 255, 255, 255, 42);
  set(ImGuiCol_ButtonActive, 104, 176, 214, 130);
  set(ImGuiCol_Header, 255, 255, 255, 10);
  set(ImGuiCol_HeaderHovered, 255, 255, 255, 26);
  set(ImGuiCol_HeaderActive, 255, 255, 255, 36);
  set(ImGuiCol_ScrollbarBg, 0, 0, 0, 0);
  set(ImGuiCol_ScrollbarGrab, 255, 255, 255, 36);
  set(ImGuiCol_ScrollbarGrabHovered, 255, 255, 255, 60);
  set(ImGuiCol_ScrollbarGrabActive, 255, 255, 255, 80);
  set(ImGuiCol_Separator, 255, 255, 255, 20);
  set(ImGuiCol_TextSelectedBg, 104, 176, 214, 110);
  set(ImGuiCol_PlotHistogram, 104, 176, 214, 200);
}

}  // namespace

float px(float cssPixels) { return std::round(cssPixels * ImGui::GetFontSize() / kFontCssPixels); }

bool applyTheme(const ThemeScale& scale) {
  ImGuiStyle style;
  setColors(style);
  style.WindowPadding = {12, 10};
  style.WindowRounding = 10;
  style.PopupRounding = 6;
  style.FrameRounding = 5;
  style.GrabRounding = 4;
  style.ScrollbarRounding = 4;
  style.FramePadding = {8, scale.touch ? 9.0f : 4.0f};
  style.ItemSpacing = {8, scale.touch ? 8.0f : 6.0f};
  style.ItemInnerSpacing = {6, 4};
  style.ScrollbarSize = scale.touch ? 14.0f : 8.0f;
  style.GrabMinSize = scale.touch ? 18.0f : 10.0f;
  style.TouchExtraPadding = scale.touch ? ImVec2(2, 2) : ImVec2(0, 0);
  style.WindowBorderSize = 1;
  style.ScaleAllSizes(scale.pixelRatio);
  ImGui::GetStyle() = style;

  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const float pixels = fontPixels(scale.pixelRatio);
  if (atlas.IsBuilt() && atlas.Fonts.Size == 1 && atlas.Fonts[0]->FontSize == pixels) return false;
  buildFont(pixels);
  return true;
}

}  // namespace fur::editor
