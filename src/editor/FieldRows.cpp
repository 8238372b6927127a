#include "editor/FieldRows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <imgui.h>

#include "core/NumberText.h"
#include "editor/Theme.h"
#include "editor/Widgets.h"
#include "settings/LightRigs.h"

namespace fur::editor {

using settings::Field;
using settings::FieldRow;
using settings::FieldType;
using settings::Settings;

namespace {

// A slider cannot hit one of more than about this many whole numbers; such fields are dragged.
constexpr double kMostSliderSteps = 1000;
// From this ratio of its ends on, a range is shown logarithmically: its small values matter as much.
constexpr double kLogarithmicRatio = 40;
constexpr float kLabelShare = 0.42f;

bool contains(std::string_view text, std::string_view part) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::search(text.begin(), text.end(), part.begin(), part.end(),
                     [&](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

void assign(Settings& settings, const Field& field, double value) {
  Warnings clamped;  // what was typed past the range shows as the end of the range
  settings::setField(settings, field, value, clamped);
}

bool isStandard(const Settings& settings, const Field& field) {
  static const Settings standard;
  return field.get(settings) == field.get(standard);
}

void reset(Settings& settings, const Field& field) { field.set(settings, field.get(Settings{})); }

void resetGroup(Settings& settings, std::string_view group) {
  for (const Field& field : settings::fields())
    if (field.group == group) reset(settings, field);
}

// As printf formats: "%.2f /s". A percent sign in a unit would need doubling; none has one.
std::string numberFormat(const FieldRow& field, double range) {
  const int decimals = range >= 90 ? 0 : range >= 10 ? 1 : range > 0.5 ? 2 : 3;
  std::string unit = field.unit;
  // Model radii are explained by the tooltip; beside every number they would only be noise.
  if (unit == "r" || unit == "/r") unit.clear();
  return "%." + decimal(decimals) + "f" + (unit.empty() || unit.front() == '/' ? unit : ' ' + unit);
}

// Each draws the widget of a value; a new one where the person has changed it.
using Changed = std::optional<double>;

Changed editAngle(const FieldRow& field, double value) {
  constexpr double kDegrees = 180.0 / 3.14159265358979;
  float degrees = static_cast<float>(value * kDegrees);
  if (fillSlider("##value", degrees, static_cast<float>(field.low * kDegrees),
                 static_cast<float>(field.high * kDegrees), "%.0f\xc2\xb0", false))
    return degrees / kDegrees;
  return {};
}

Changed editFloat(const FieldRow& field, double from) {
  if (std::string_view(field.unit) == "rad") return editAngle(field, from);
  float value = static_cast<float>(from);
  const bool logarithmic = field.low > 0 && field.high / field.low >= kLogarithmicRatio;
  if (fillSlider("##value", value, static_cast<float>(field.low), static_cast<float>(field.high),
                 numberFormat(field, field.high - field.low).c_str(), logarithmic))
    return value;
  return {};
}

Changed editInt(const FieldRow& field, double from) {
  int value = static_cast<int>(from);
  const int low = static_cast<int>(field.low), high = static_cast<int>(field.high);
  const bool changed =
      field.high - field.low > kMostSliderSteps
          ? ImGui::DragInt("##value", &value, 0.2f, low, high, "%d", ImGuiSliderFlags_AlwaysClamp)
          : fillSlider("##value", value, low, high);
  return changed ? Changed(value) : Changed();
}

Changed editColor(double from) {
  const auto rgb = static_cast<std::uint32_t>(from);
  float channels[3];
  for (int i = 0; i < 3; ++i) channels[i] = static_cast<float>((rgb >> (16 - 8 * i)) & 255u) / 255.0f;
  constexpr ImGuiColorEditFlags kFlags = ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_InputRGB |
                                         ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions;
  if (!ImGui::ColorEdit3("##value", channels, kFlags)) return {};
  std::uint32_t packed = 0;
  for (const float channel : channels)
    packed = packed << 8u | static_cast<std::uint32_t>(channel * 255.0f + 0.5f);
  return packed;
}

Changed editChoice(const FieldRow& field, double from) {
  const int chosen = static_cast<int>(from);
  if (!ImGui::BeginCombo("##value", std::string(settings::optionName(field, chosen)).c_str())) return {};
  Changed changed;
  for (int index = 0; index <= static_cast<int>(field.high); ++index)
    if (ImGui::Selectable(std::string(settings::optionName(field, index)).c_str(), index == chosen)) changed = index;
  ImGui::EndCombo();
  return changed;
}

Changed editValue(const FieldRow& field, double value) {
  switch (field.type) {
    case FieldType::Float: return editFloat(field, value);
    case FieldType::Int: return editInt(field, value);
    case FieldType::Color: return editColor(value);
    case FieldType::Choice: return editChoice(field, value);
    case FieldType::Bool: break;
  }
  bool on = value != 0;
  return ImGui::Checkbox("##value", &on) ? Changed(on) : Changed();
}

// By its name; and a button that holds it.
void editAnimation(Settings& settings, const Field& field, std::span<const std::string> names) {
  const float button = px(44);
  const auto nameOf = [&](std::size_t i) {
    if (i > names.size()) i = 0;
    return i == 0 ? "none" : names[i - 1].empty() ? "Animation " + decimal(i) : names[i - 1];
  };
  ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - button - px(2));
  const auto chosen = static_cast<std::size_t>(field.get(settings));
  if (ImGui::BeginCombo("##value", nameOf(chosen).c_str())) {
    for (std::size_t i = 0; i <= names.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::Selectable(nameOf(i).c_str(), i == chosen)) assign(settings, field, static_cast<double>(i));
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine(0, px(2));
  const bool held = settings.animationSpeed == 0;
  if (ImGui::Button(held ? "Play###hold" : "Hold###hold", ImVec2(button, 0)))
    assign(settings, *settings::findField("animationSpeed"), held ? 1 : 0);
}

void editValue(Settings& settings, const Field& field, std::span<const std::string> animations) {
  if (!animations.empty() && std::string_view(field.name) == "animation") return editAnimation(settings, field, animations);
  if (const Changed changed = editValue(field, field.get(settings))) assign(settings, field, *changed);
}

std::string unitText(const FieldRow& field) {
  const std::string unit = field.unit;
  if (unit == "r") return " model radii";
  if (unit == "/r") return " per model radius";
  return unit.empty() || unit.front() == '/' ? unit : ' ' + unit;
}

void rowTooltip(const FieldRow& field, const char* tooltip, const char* menu) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(280));
  ImGui::TextUnformatted(tooltip);
  if (field.type == FieldType::Float || field.type == FieldType::Int)
    ImGui::TextDisabled("%g to %g%s, default %s. Double click to type.", field.low, field.high,
                        unitText(field).c_str(), settings::valueText(field, field.standard).c_str());
  ImGui::TextDisabled("%s", menu);
  ImGui::TextDisabled("%s", field.name);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void rowMenu(Settings& settings, Frequent& frequent, const Field& field) {
  if (!ImGui::BeginPopup("menu")) return;
  const std::string standard = settings::fieldText(Settings{}, field);
  if (ImGui::MenuItem(("Reset to " + standard).c_str(), nullptr, false, !isStandard(settings, field)))
    reset(settings, field);
  if (ImGui::MenuItem((std::string("Reset all of ") + field.group).c_str()))
    resetGroup(settings, field.group);
  ImGui::Separator();
  if (ImGui::MenuItem(frequent.has(field) ? "Remove from frequently used" : "Add to frequently used")) frequent.toggle(field);
  if (!frequent.isStandard() && ImGui::MenuItem("Frequently used as at first")) frequent.reset();
  ImGui::EndPopup();
}

// A finger that has been held for so long there, without moving; true once.
bool heldIn(ImVec2 from, ImVec2 size) {
  constexpr float kSeconds = 0.5f;
  const ImGuiIO& io = ImGui::GetIO();
  return ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, ImVec2(from.x + size.x, from.y + size.y)) && ImGui::IsMouseDown(0) && io.MouseDownDuration[0] >= kSeconds && io.MouseDownDuration[0] - io.DeltaTime < kSeconds &&
         io.MouseDragMaxDistanceSqr[0] < px(10) * px(10);
}

void drawRow(Settings& settings, Frequent& frequent, const Field& field, bool tooltips, std::span<const std::string> animations) {
  ImGui::PushID(field.name);
  const float width = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float icon = px(18);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, isStandard(settings, field) ? color::kDim : color::kText);
  ImGui::TextUnformatted(field.label);
  ImGui::PopStyleColor();
  const bool onLabel = ImGui::IsItemHovered(), held = heldIn(from, ImVec2(width * kLabelShare, ImGui::GetFrameHeight()));
  ImGui::SameLine(left + width * kLabelShare);
  ImGui::SetNextItemWidth(width * (1 - kLabelShare) - icon - px(2));
  ImGui::BeginGroup();
  editValue(settings, field, animations);
  ImGui::EndGroup();
  if (held || ((onLabel || ImGui::IsItemHovered()) && ImGui::IsMouseReleased(ImGuiMouseButton_Right)))
    ImGui::OpenPopup("menu");
  if (onLabel && tooltips) rowTooltip(field, settings::tooltipOf(field), "Right click to reset it, or to have it among those frequently used or not.");
  rowMenu(settings, frequent, field);
  if (!isStandard(settings, field)) {
    ImGui::SameLine(left + width - icon);
    const std::string hint = "Reset to " + settings::fieldText(Settings{}, field);
    if (iconButton("##reset", Icon::Reset, tooltips ? hint.c_str() : "", true, icon)) reset(settings, field);
  }
  ImGui::PopID();
}

}  // namespace

std::optional<double> drawValue(const FieldRow& field, double value, const char* tooltip) {
  ImGui::PushID(field.name);
  const float width = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX(), icon = px(18);
  const bool standard = value == field.standard;
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, standard ? color::kDim : color::kText);
  ImGui::TextUnformatted(field.label);
  ImGui::PopStyleColor();
  if (*tooltip && ImGui::IsItemHovered()) rowTooltip(field, tooltip, "The arrow resets it.");
  ImGui::SameLine(left + width * kLabelShare);
  ImGui::SetNextItemWidth(width * (1 - kLabelShare) - icon - px(2));
  Changed changed = editValue(field, value);
  if (!standard) {
    ImGui::SameLine(left + width - icon);
    if (iconButton("##reset", Icon::Reset, "", true, icon)) changed = field.standard;
  }
  ImGui::PopID();
  return changed;
}

namespace {

void drawLightPad(Settings& settings) {
  const Field &yaw = *settings::findField("lightYaw"), &pitch = *settings::findField("lightPitch");
  const float diameter = px(92);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + (ImGui::GetContentRegionAvail().x - diameter) * 0.5f);
  float yawValue = settings.lightYaw, pitchValue = settings.lightPitch;
  if (lightPad("##lightPad", yawValue, pitchValue, static_cast<float>(pitch.low),
               static_cast<float>(pitch.high), diameter)) {
    assign(settings, yaw, yawValue);
    assign(settings, pitch, pitchValue);
  }
  ImGui::Dummy(ImVec2(0, px(2)));
}

void drawLightRigs(Settings& settings) {
  const settings::LightRig* chosen = settings::lightRigOf(settings);
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##lightRigs", chosen ? chosen->label : "Light rig", ImGuiComboFlags_HeightLargest)) return;
  Warnings none;
  for (const settings::LightRig& rig : settings::lightRigs())
    if (ImGui::Selectable(rig.label, &rig == chosen)) settings::applyLightRig(settings, rig.name, none);
  ImGui::EndCombo();
}

// The header; returns whether the group is open.
bool drawHeader(Settings& settings, std::string_view group, bool forceOpen) {
  const std::string name(group);
  if (forceOpen)
    ImGui::SetNextItemOpen(true);
  else
    ImGui::SetNextItemOpen(group == "Fur" || group == "Water", ImGuiCond_FirstUseEver);
  const bool open = groupHeader((name + (forceOpen ? "##filtered" : "")).c_str());
  const auto& all = settings::fields();
  const bool changed = std::any_of(all.begin(), all.end(), [&](const Field& field) {
    return field.group == group && !isStandard(settings, field);
  });
  if (changed) {
    const float icon = px(18);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - icon);
    if (iconButton(("##reset" + name).c_str(), Icon::Reset, "", true, icon)) resetGroup(settings, group);
  }
  return open;
}

}  // namespace

std::vector<std::string_view> fieldGroups() {
  std::vector<std::string_view> groups;
  for (const Field& field : settings::fields())
    if (std::find(groups.begin(), groups.end(), field.group) == groups.end()) groups.push_back(field.group);
  return groups;
}

bool matchesFilter(const Field& field, std::string_view filter) {
  return filter.empty() || contains(field.label, filter) || contains(field.name, filter) ||
         contains(field.group, filter);
}

void drawFrequent(Settings& settings, Frequent& frequent, bool tooltips) {
  ImGui::SetNextItemOpen(true, ImGuiCond_FirstUseEver);
  if (!groupHeader("Frequently used")) return;
  ImGui::PushID("frequent");
  const Frequent shown = frequent;  // a menu may change it on the way
  for (const Field& field : settings::fields())
    if (shown.has(field)) drawRow(settings, frequent, field, tooltips, {});
  if (shown.empty()) ImGui::TextWrapped("Right click a setting, or hold a finger on its name, to have it here.");
  ImGui::PopID();
  ImGui::Dummy(ImVec2(0, px(4)));
}

int drawFields(Settings& settings, Frequent& frequent, std::string_view filter, bool tooltips, std::span<const std::string> animations) {
  int shown = 0;
  for (const std::string_view group : fieldGroups()) {
    const auto rows = [&](const Field& field) {
      return field.group == group && matchesFilter(field, filter);
    };
    const auto count = std::count_if(settings::fields().begin(), settings::fields().end(), rows);
    shown += static_cast<int>(count);
    if (count == 0 || !drawHeader(settings, group, !filter.empty())) continue;
    if (group == "Light" && filter.empty()) {
      drawLightRigs(settings);
      drawLightPad(settings);
    }
    for (const Field& field : settings::fields())
      if (rows(field)) drawRow(settings, frequent, field, tooltips, animations);
    ImGui::Dummy(ImVec2(0, px(4)));
  }
  return shown;
}

}  // namespace fur::editor
