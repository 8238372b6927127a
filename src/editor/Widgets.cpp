#include "editor/Widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <imgui_internal.h>  // which slider is a text box

#include "core/Math.h"
#include "editor/Theme.h"

namespace fur::editor {

namespace {

ImU32 frameColor(bool hovered, bool active) {
  return ImGui::GetColorU32(active    ? ImGuiCol_FrameBgActive
                            : hovered ? ImGuiCol_FrameBgHovered
                                      : ImGuiCol_FrameBg);
}

// Draws the bar behind a slider of that size that is about to be placed at the cursor, and makes the
// slider's own frame and grab invisible. endBar() takes that back.
void beginBar(float fraction, ImVec2 size, bool upright) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 to(from.x + size.x, from.y + size.y);
  const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, to);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  list.AddRectFilled(from, to, frameColor(hovered, hovered && ImGui::IsMouseDown(0)), rounding);
  // Clipped instead of shortened: the corners stay round at small values.
  const float share = saturate(fraction);
  if (upright)
    list.PushClipRect(ImVec2(from.x, to.y - size.y * share), to, true);
  else
    list.PushClipRect(from, ImVec2(from.x + size.x * share, to.y), true);
  if (share > 0) list.AddRectFilled(from, to, color::kFill, rounding);
  list.PopClipRect();
  for (const ImGuiCol slot : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                              ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
    ImGui::PushStyleColor(slot, IM_COL32_BLACK_TRANS);
  // A thin grab, so that the end of the bar is where the pointer is.
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 2.0f);
}

void beginBar(float fraction) { beginBar(fraction, {ImGui::CalcItemWidth(), ImGui::GetFrameHeight()}, false); }

void endBar() {
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(5);
}

// What may be typed, beside the text box, which scrolls into sight where a keyboard took its room on the screen.
template <class T>
void showRange(T low, T high, const char* format) {
  if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
  char from[32], to[32];
  std::snprintf(from, sizeof from, format, low);
  std::snprintf(to, sizeof to, format, high);
  ImGui::SetNextWindowPos(ImVec2(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + px(4)));
  ImGui::SetTooltip("%s to %s", from, to);
}

// A slider over its bar that a double click turns into a text box. ImGui's takes Ctrl+click for that; what the
// first click did is taken back.
template <class T, class Slider>
bool typedSlider(const char* id, T& value, float fraction, T low, T high, const char* format, const Slider& slider) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID item = ImGui::GetID(id);
  const ImGuiID pressedItem = ImHashStr("pressed slider"), pressedValue = ImHashStr("its value");  // of the window
  ImGuiIO& io = ImGui::GetIO();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 to(from.x + ImGui::CalcItemWidth(), from.y + ImGui::GetFrameHeight());
  const bool pressed = ImGui::IsMouseClicked(0) && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, to);
  const bool twice = pressed && io.MouseClickedCount[0] == 2 &&
                     storage.GetInt(pressedItem) == static_cast<int>(item) && !ImGui::TempInputIsActive(item);
  const T before = value;
  if (twice) value = static_cast<T>(storage.GetFloat(pressedValue));
  if (pressed) {
    storage.SetInt(pressedItem, static_cast<int>(item));
    storage.SetFloat(pressedValue, static_cast<float>(value));
  }
  const bool typing = ImGui::TempInputIsActive(item);
  if (typing)
    for (ImWchar& typed : io.InputQueueCharacters)
      if (typed == ',') typed = '.';  // as half of the world writes it
  beginBar(typing ? 0 : fraction);
  if (typing) ImGui::GetWindowDrawList()->AddRect(from, to, color::kAccent, ImGui::GetStyle().FrameRounding, 0, px(1));
  const bool control = std::exchange(io.KeyCtrl, io.KeyCtrl || twice);
  slider();
  io.KeyCtrl = control;
  endBar();
  if (ImGui::TempInputIsActive(item)) showRange(low, high, format);
  return value != before;
}

bool segmentButton(const Segment& segment, const Icon* icon, float width) {
  if (segment.chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::ColorConvertU32ToFloat4(color::kFill));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::ColorConvertU32ToFloat4(color::kFill));
  }
  const char* shownLabel = icon ? "##segment" : segment.label;
  const bool pressed = ImGui::Button(shownLabel, ImVec2(width, ImGui::GetFrameHeight() + (icon ? px(4) : 0)));
  if (segment.chosen) ImGui::PopStyleColor(2);
  if (icon) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float side = px(15), gap = px(7), text = ImGui::CalcTextSize(segment.label).x;
    const float left = (low.x + high.x - side - gap - text) * 0.5f, middle = (low.y + high.y) * 0.5f;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawIcon(list, *icon, ImVec2(left + side * 0.5f, middle), side, ImGui::GetColorU32(ImGuiCol_Text));
    list.AddText(ImVec2(left + side + gap, middle - ImGui::GetFontSize() * 0.5f),
                 ImGui::GetColorU32(ImGuiCol_Text), segment.label);
  }
  return pressed;
}

int segmentRow(const char* id, std::span<const Segment> choices, const Icon* icons) {
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(3), ImGui::GetStyle().ItemSpacing.y));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, ImGui::GetStyle().FramePadding.y));
  const float count = static_cast<float>(choices.size());
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(3) * (count - 1)) / count);
  int pressed = -1, index = 0;
  for (const Segment& segment : choices) {
    if (index > 0) ImGui::SameLine();
    ImGui::PushID(index);
    // The last one takes what rounding left over.
    const bool last = index + 1 == static_cast<int>(choices.size());
    if (segmentButton(segment, icons ? icons + index : nullptr,
                      last ? ImGui::GetContentRegionAvail().x : width))
      pressed = index;
    ImGui::PopID();
    ++index;
  }
  ImGui::PopStyleVar(2);
  ImGui::PopID();
  return pressed;
}

}  // namespace

void rowLabel(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
  ImGui::TextUnformatted(text);
  ImGui::PopStyleColor();
  ImGui::SameLine(px(80));
}

bool iconButton(const char* id, Icon icon, const char* tooltip, bool enabled, float width) {
  const float height = ImGui::GetFrameHeight();
  if (width <= 0) width = height;
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(width, height));
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered) list.AddRectFilled(low, high, frameColor(true, active), ImGui::GetStyle().FrameRounding);
  drawIcon(list, icon, ImVec2((low.x + high.x) * 0.5f, (low.y + high.y) * 0.5f),
           std::fmin(std::fmin(width, height) * 0.6f, px(14)),
           ImGui::GetColorU32(hovered ? color::kText : color::kDim));
  ImGui::EndDisabled();
  if (hovered && !active && *tooltip) ImGui::SetTooltip("%s", tooltip);
  return pressed;
}

int segments(const char* id, std::span<const Segment> choices) {
  return segmentRow(id, choices, nullptr);
}

int iconSegments(const char* id, std::span<const Segment> choices, std::span<const Icon> icons) {
  return segmentRow(id, choices, icons.data());
}

bool groupHeader(const char* label) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(5), ImGui::GetStyle().FramePadding.y));
  const bool open = ImGui::CollapsingHeader(label, ImGuiTreeNodeFlags_AllowItemOverlap);
  ImGui::PopStyleVar();
  return open;
}

bool fillSlider(const char* id, float& value, float low, float high, const char* format, bool logarithmic) {
  const float fraction =
      logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return typedSlider(id, value, fraction, low, high, format, [&] {
    return ImGui::SliderFloat(id, &value, low, high, format,
                              ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
  });
}

bool fillSlider(const char* id, int& value, int low, int high) {
  const float fraction = static_cast<float>(value - low) / static_cast<float>(high - low);
  return typedSlider(id, value, fraction, low, high, "%d", [&] {
    return ImGui::SliderInt(id, &value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
  });
}

bool fillSliderUpright(const char* id, int& value, int low, int high, ImVec2 size) {
  beginBar(static_cast<float>(value - low) / static_cast<float>(std::max(high - low, 1)), size, true);
  const bool changed = ImGui::VSliderInt(id, size, &value, low, high, "");
  endBar();
  return changed;
}

bool lightPad(const char* id, float& yaw, float& pitch, float lowestPitch, float highestPitch,
              float diameter) {
  ImGui::InvisibleButton(id, ImVec2(diameter, diameter));
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const ImVec2 low = ImGui::GetItemRectMin();
  const float radius = diameter * 0.5f;
  const Vec2 center(low.x + radius, low.y + radius);

  bool changed = false;
  if (active) {
    const Vec2 offset = (Vec2(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y) - center) / radius;
    const float distance = glm::min(glm::length(offset), 1.0f);
    const float newPitch = glm::clamp(std::acos(distance), lowestPitch, highestPitch);
    // Overhead there is no direction: the old one stays.
    const float newYaw = distance > 0.02f ? std::atan2(offset.x, offset.y) : yaw;
    changed = newYaw != yaw || newPitch != pitch;
    yaw = newYaw;
    pitch = newPitch;
  }

  const Vec2 light = Vec2(std::sin(yaw), std::cos(yaw)) * std::cos(pitch) * radius;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // A ball lit from there: circles that shrink and brighten towards the highlight.
  constexpr int kRings = 32;
  for (int ring = 0; ring < kRings; ++ring) {
    const float t = static_cast<float>(ring) / kRings;
    const Vec2 middle = center + light * (0.55f * t);
    const int grey = 38 + static_cast<int>(150 * t * t);
    list.AddCircleFilled(ImVec2(middle.x, middle.y), radius * (1 - 0.94f * t),
                         IM_COL32(grey, grey + 3, grey + 8, 255), 48);
  }
  list.AddCircle(ImVec2(center.x, center.y), radius, IM_COL32(255, 255, 255, hovered || active ? 110 : 50),
                 48, px(1));
  const Vec2 dot = center + light * 0.93f;
  list.AddCircleFilled(ImVec2(dot.x, dot.y), px(active ? 6 : 5), IM_COL32(255, 226, 150, 255), 20);
  list.AddCircle(ImVec2(dot.x, dot.y), px(active ? 6 : 5), IM_COL32(30, 26, 18, 200), 20, px(1));
  return changed;
}

}  // namespace fur::editor
