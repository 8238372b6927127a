#include "editor/PanelLayout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <imgui_internal.h>  // arrow keys on their way to move the focus

namespace fur::editor {

namespace {

constexpr float kNarrowCssPixels = 600;
constexpr float kRoomyCssPixels = 1280;
constexpr float kMarginCssPixels = 12;
// Below this the rows of five buttons are too narrow for their words; beyond, the lines get long to read.
constexpr float kLeastWidth = 280, kMostWidth = 720;
// The picture keeps at least the rest of the screen: the camera goes no further (OrbitCamera).
constexpr float kMostShare = 0.6f, kLeastSheet = 0.2f;
constexpr float kKeyCssPixels = 16;
constexpr float kTapCssPixels = 6;

float titleHeight() {
  return ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
}

constexpr int kTitleButtons = 4;

// From the corner of the window, over its padding, of which ImGui cuts off a half.
bool edgeButton(ImVec2 size) {
  const ImVec2 from = ImGui::GetWindowPos(), inside = ImGui::GetWindowSize();
  ImGui::SetCursorPos(ImVec2(0, 0));
  ImGui::PushClipRect(from, ImVec2(from.x + inside.x, from.y + inside.y), false);
  const bool pressed = ImGui::InvisibleButton("##edge", size);
  ImGui::PopClipRect();
  return pressed;
}

// A short bar as on other things that can be dragged.
void drawGrip(ImVec2 middle, ImVec2 size, bool lit) {
  const ImVec2 half(size.x * 0.5f, size.y * 0.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  list.AddRectFilled(ImVec2(middle.x - half.x, middle.y - half.y), ImVec2(middle.x + half.x, middle.y + half.y),
                     lit ? color::kAccent : IM_COL32(255, 255, 255, 70), px(2));
  list.PopClipRect();
}

}  // namespace

float titleButtonsWidth() {
  return kTitleButtons * ImGui::GetFrameHeight() + (kTitleButtons - 1) * px(kTitleGapCssPixels);
}

void PanelLayout::place(const ThemeScale& scale, float contentHeight) {
  screen_ = ImGui::GetIO().DisplaySize;
  narrow_ = screen_.x < kNarrowCssPixels * scale.pixelRatio;
  roomy_ = !narrow_ && screen_.y >= kRoomyCssPixels * scale.pixelRatio;
  const float margin = narrow_ ? 0 : px(kMarginCssPixels);
  const float width = narrow_ ? screen_.x : std::min(px(width_), mostWidth());
  const float most = std::floor(narrow_ ? screen_.y * sheet_ : screen_.y - 2 * margin);
  const float title = titleHeight();
  float height = most;
  if (collapsed())
    height = title;
  else if (!narrow_ && contentHeight > 0)
    height = std::min(most, title + contentHeight + ImGui::GetStyle().ItemSpacing.y);
  height = std::floor(height);
  ImGui::SetNextWindowPos(narrow_ ? ImVec2(0, screen_.y - height) : ImVec2(screen_.x - width - margin, margin));
  ImGui::SetNextWindowSize(ImVec2(width, height));
  covered_ = collapsed() ? Vec2(0) : narrow_ ? Vec2(0, most / screen_.y) : Vec2((width + margin) / screen_.x, 0);
}

float PanelLayout::mostWidth() const {
  return std::floor(std::min(px(kMostWidth), std::max(px(kLeastWidth), screen_.x * kMostShare - px(kMarginCssPixels))));
}

void PanelLayout::drawEdge() {
  if (narrow_) return resizeSheet();
  if (!collapsed()) resizeColumn();
}

// How many pixels further the arrow keys ask for while the edge has the focus.
float PanelLayout::keyStep() const {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!ImGui::IsItemFocused() || context.NavDisableHighlight || !context.NavMoveSubmitted) return 0;
  const ImGuiDir larger = narrow_ ? ImGuiDir_Up : ImGuiDir_Left, smaller = narrow_ ? ImGuiDir_Down : ImGuiDir_Right;
  const ImGuiDir pressed = context.NavMoveDir;
  if (pressed != larger && pressed != smaller) return 0;
  ImGui::NavMoveRequestCancel();
  return px(kKeyCssPixels) * (pressed == larger ? 1.0f : -1.0f);
}

void PanelLayout::resizeColumn() {
  const ImVec2 before = ImGui::GetCursorPos(), window = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float across = before.x;
  edgeButton(ImVec2(across, size.y));
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActivated()) atPress_ = size.x;
  float wanted = size.x + keyStep();
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(0)) wanted = atPress_ - ImGui::GetMouseDragDelta(0, 0).x;
  if (wanted != size.x) width_ = std::round(glm::clamp(wanted, px(kLeastWidth), mostWidth()) / px(1000) * 1000);
  if (lit && ImGui::IsMouseDoubleClicked(0)) {
    width_ = kWidth;
    ImGui::ClearActiveID();  // the drag would begin again from the width before
  }
  drawGrip(ImVec2(window.x + across * 0.5f, window.y + size.y * 0.5f), ImVec2(px(4), px(40)), lit);
  ImGui::RenderNavHighlight(ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()), ImGui::GetItemID());
  ImGui::SetCursorPos(before);
}

// Its handle is the title, up to the buttons.
void PanelLayout::resizeSheet() {
  const ImVec2 before = ImGui::GetCursorPos(), window = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float across = size.x - titleButtonsWidth() - ImGui::GetStyle().WindowPadding.x;
  const bool pressed = edgeButton(ImVec2(across, titleHeight()));
  const bool lit = ImGui::IsItemActive() || ImGui::IsItemHovered();
  const bool held = ImGui::IsMouseDown(0), dragged = (held || ImGui::IsMouseReleased(0)) && ImGui::IsMouseDragPastThreshold(0, px(kTapCssPixels));
  if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActivated()) atPress_ = size.y;
  float wanted = size.y + keyStep();
  if (ImGui::IsItemActive() && held && dragged) wanted = atPress_ - ImGui::GetMouseDragDelta(0, 0).y;
  if (wanted != size.y) {
    collapsed_ = wanted < std::min(screen_.y * kLeastSheet, titleHeight() + px(64));
    if (!collapsed_) sheet_ = glm::clamp(wanted / screen_.y, kLeastSheet, kMostShare);
  }
  if (pressed && !dragged) collapsed_ = !collapsed_;
  drawGrip(ImVec2(window.x + std::min(size.x * 0.5f, across - px(24)), window.y + px(6)), ImVec2(px(40), px(4)), lit);
  ImGui::RenderNavHighlight(ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()), ImGui::GetItemID());
  ImGui::SetCursorPos(before);
}

std::string PanelLayout::text() const {
  char text[64];
  std::snprintf(text, sizeof text, "width %.0f sheet %.3f", static_cast<double>(width_), static_cast<double>(sheet_));
  return text;
}

void PanelLayout::read(std::string_view text) {
  float width = 0, sheet = 0;
  if (std::sscanf(std::string(text).c_str(), "width %f sheet %f", &width, &sheet) != 2) return;
  if (!(width > 0 && sheet > 0)) return;
  width_ = glm::clamp(width, kLeastWidth, kMostWidth);
  sheet_ = glm::clamp(sheet, kLeastSheet, kMostShare);
}

}  // namespace fur::editor
